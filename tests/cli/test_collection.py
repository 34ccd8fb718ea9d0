"""fixtures/collection is whole, its certificates hold, and the runner tells right from wrong.

    test_collection.py TOOL ROOT          a sample of the certificates and of lcpush's own scores
    test_collection.py TOOL ROOT --all    all of them, the problems made again, the page's rows found again
"""
import hashlib
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import unittest

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
EVERY = 1 if "--all" in sys.argv else 12
ROWS = ["lcpush"] + sys.argv[4:]  # of the table, which other solvers' packages reproduce
del sys.argv[1:]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/collection"))
import collection_scenes


def module(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / f"docs/check/{name}.py")
    spec.loader.exec_module(loaded := importlib.util.module_from_spec(spec))
    return loaded


CHECKER, RUNNER = module("lcpush_check"), module("run_collection")
INDEX = json.loads((RUNNER.FOLDER / "index.json").read_text())


class Collection(unittest.TestCase):
    def test_the_index_is_complete(self):
        self.assertEqual(INDEX["licence"], "CC0-1.0")
        files = {path.stem: path for path in RUNNER.FOLDER.glob("*.json") if path.stem != "index"}
        self.assertEqual(sorted(files), sorted(entry["name"] for entry in INDEX["problems"]))
        self.assertEqual(len(files), 300)
        for entry in INDEX["problems"]:
            text = files[entry["name"]].read_bytes()
            self.assertEqual(hashlib.sha256(text).hexdigest(), entry["sha256"], entry["name"])
            problem = json.loads(text)
            for key in ("name", "tags", "provenance", "expected"):
                self.assertEqual(problem[key], entry[key])
            self.assertTrue(problem["tags"] and problem["provenance"])
            self.assertEqual((len(problem["q"]), len(problem["M"]), len(problem["free"])), (entry["n"], entry["n"], entry["free"]))
            self.assertEqual("scene" in problem, entry["kind"] == "scene")

    def test_certificates_are_accepted(self):
        for problem in RUNNER.load()[::EVERY]:
            texts = [problem["scene"]] if "scene" in problem else RUNNER.texts(problem)
            with self.subTest(problem["name"]):
                CHECKER.check(problem["certificate"], [text.encode() for text in texts])
                if "scene" not in problem:
                    continue
                L, q0, q1, free, _ = CHECKER.scene_problem(problem["scene"], problem["certificate"]["facets"])
                self.assertEqual([i + 1 for i in free], problem["free"])
                self.assertEqual([float(a + b) for a, b in zip(q0, q1)], problem["q"])
                self.assertEqual([{j - 1: v for j, v in row} for row in problem["M"]],
                                 [{j: float(v) for j, v in row.items() if v} for row in L])

    def test_the_certified_answer_is_right_and_a_changed_one_is_not(self):
        for problem in RUNNER.load()[::EVERY]:
            if problem["expected"] != "answer":
                continue
            x = [float(CHECKER.F(v)) for v in problem["certificate"]["x"]]
            with self.subTest(problem["name"]):
                self.assertTrue(RUNNER.is_right(problem, x))
                for i, value in enumerate(x):
                    if value and any(j == i + 1 and abs(v * value) > 1e-4 * abs(q) > 0
                                     for row, q in zip(problem["M"], problem["q"]) for j, v in row):
                        self.assertFalse(RUNNER.is_right(problem, x[:i] + [-value] + x[i + 1:]), i)

    def test_verdicts(self):
        problem = next(p for p in RUNNER.load() if p["expected"] == "answer" and "random" in p["tags"])
        unsolvable = next(p for p in RUNNER.load("unsolvable"))
        for given, solve, said in ((problem, lambda p: None, "missed"), (unsolvable, lambda p: None, "right"),
                                   (problem, lambda p: [0.0] * len(p["q"]), "wrong"),
                                   (unsolvable, lambda p: [0.0] * len(p["q"]), "wrong"),
                                   (problem, lambda p: 1 / 0, "missed (ZeroDivisionError)")):
            self.assertEqual(RUNNER.verdict(given, solve), said)

    def test_lcpush_is_right(self):
        command = RUNNER.by_command(f"{TOOL} lcp {{M}} {{q}} [--free {{free}}] --json")
        for problem in RUNNER.load()[::EVERY]:
            self.assertEqual(RUNNER.verdict(problem, command, 60), "right", problem["name"])

    def test_shipped_scenes_are_those_of_today(self):
        """Told here within a second; that the whole collection is made again takes the deep tests."""
        plain = collection_scenes.without_comments
        found = 0
        for problem in RUNNER.load():
            if scene := re.match(r"(fixtures/\S+\.toml) of lcpush", problem["provenance"]):
                found += 1
                self.assertEqual(plain(problem["scene"]), plain((ROOT / scene[1]).read_text()), problem["name"])
        self.assertGreater(found, 20)

    def test_the_runner_is_short(self):
        self.assertLessEqual(len((ROOT / "docs/check/run_collection.py").read_text().splitlines()), 60)

    @unittest.skipIf(EVERY > 1, "made again in the deep tests")
    def test_it_is_what_its_generator_and_its_page_say(self):
        for words in ([ROOT / "tests/collection/make_collection.py", TOOL, ROOT, "--check"],
                      [ROOT / "docs/check/collection_table.py", TOOL, "--check", *ROWS]):
            result = subprocess.run([sys.executable, *words], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


unittest.main()
