"""The guide's programs run and say what they should; so do the examples in docstrings; types hold
where mypy is installed.

    python3 test_guide.py TOOL LIBRARY SOURCE
"""
import doctest
import importlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL, LIBRARY, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
PACKAGE = SOURCE / "src/python"
os.environ.update(LCPUSH_LIBRARY=LIBRARY, PYTHONPATH=str(PACKAGE), PYTHONDONTWRITEBYTECODE="1")
sys.path.insert(0, str(PACKAGE))
os.chdir(SOURCE)
import lcpush  # noqa: E402


def run(*words, folder=None):
    result = subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True,
                            timeout=100, cwd=folder)
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout


class Guide(unittest.TestCase):
    def test_programs_say_what_they_find(self):
        with tempfile.TemporaryDirectory() as folder:
            slide = run(SOURCE / "docs/guide/python_slide.py", folder=folder)
            for words in ("The grasp breaks at 20 N", "pushes with 20.02 N", "slides 12.5 mm",
                          "x = 12.50 mm", "of mine.toml: pusher \"wall\": friction must be >= 0"):
                self.assertIn(words, slide)
            check = run(SOURCE / "docs/guide/python_check.py", folder=folder)
            for words in ("z = [1.3333, 2.3333]", "0.001 m/s^2 (1 %) too much", "unknowns: normal of left.1"):
                self.assertIn(words, check)
            sweep = run(SOURCE / "docs/guide/python_sweep.py", "plot.png", folder=folder)
            self.assertIn("30.000 N  breaks at  30.000 N", sweep)
            self.assertEqual(len(list(pathlib.Path(folder).glob("plot.*"))), 1)

    def test_names_what_there_is(self):
        page = (SOURCE / "docs/guide/python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", page, flags=re.S)
        names = {"lcpush": lcpush, "print": lambda *_: None}
        exec(blocks[0], names)
        push = names["push"]
        names.update(M=push.M, q=push.q, z=[0] * len(push.q), a=push.acceleration,
                     contacts=[contact.to_dict() for contact in push.contacts])
        exec(blocks[1], names)
        self.assertAlmostEqual(names["by"]["*.grip_force"].pushers[0].normal_force, 1)
        exec(blocks[2], names)
        self.assertFalse(names["verdict"])
        for question in re.findall(r"^\| `(\w+)\(", page, flags=re.M):
            self.assertTrue(callable(getattr(lcpush.Scene, question)), question)


    def test_has_every_question_of_the_library(self):
        from lcpush import _library
        with self.assertRaises(lcpush.InputError) as caught:
            _library.ask("nothing", {})
        questions = re.split(r", | and ", caught.exception.message.split("there are ")[1])
        self.assertGreater(len(questions), 15)
        page = (SOURCE / "docs/embed/desktop.md").read_text(encoding="utf-8")
        header = (SOURCE / "include/lcpush/lcpush_desktop.h").read_text(encoding="utf-8")
        for question in questions:
            self.assertIn(f"`{question}`", page)
            self.assertRegex(header, rf"\b{question}\b")


class Docstrings(unittest.TestCase):
    def test_examples_hold(self):
        tried = 0
        for path in sorted((PACKAGE / "lcpush").glob("*.py")):
            module = importlib.import_module("lcpush" if path.stem == "__init__"
                                             else f"lcpush.{path.stem}")
            failed, count = doctest.testmod(module)
            self.assertEqual(failed, 0, path)
            tried += count
        self.assertGreaterEqual(tried, 8)

    def test_everything_public_has_one(self):
        for name in lcpush.__all__:
            thing = getattr(lcpush, name)
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type):
                for member, value in vars(thing).items():
                    if not member.startswith("_"):
                        self.assertTrue(getattr(value, "__doc__", None), f"{name}.{member}")

    def test_types_hold(self):
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed")
        result = subprocess.run(["mypy", "--strict", "--cache-dir", os.devnull,
                                 str(PACKAGE / "lcpush")], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_types_are_seen_from_outside(self):
        """A program of a user's, with a mistake in its third line and its last."""
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed")
        program = ('import lcpush\n'
                   'push: lcpush.Solution = lcpush.read("a.toml").solve(solver="lemke")\n'
                   'push = lcpush.read("a.toml").break_()\n'
                   'sentence: str = lcpush.lcp([[1]], [-1], free=[0]).sentence\n'
                   'curves: "list[lcpush.Curve]" = lcpush.Scene({}).sweep("a", 1, 2).curves\n'
                   'lcpush.Scene({}).sweep("a", "b", 2)\n')
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "mine.py")
            path.write_text(program, encoding="utf-8")
            result = subprocess.run(["mypy", "--strict", "--cache-dir", os.devnull, str(path)],
                                    capture_output=True, text=True,
                                    env={**os.environ, "MYPYPATH": str(PACKAGE)})
        wrong = re.findall(r"mine\.py:(\d+): error: .*\[([a-z-]+)\]", result.stdout)
        self.assertEqual(wrong, [("3", "assignment"), ("6", "arg-type")], result.stdout)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
