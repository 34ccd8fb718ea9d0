"""The Python package: the tool's answers byte for byte, located errors, arrays, words, pictures."""
import dataclasses
import fractions
import json
import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

from built import TOOL, lcpush
from lcpush import _toml

SLIDE, JAM, TIPPING = (f"fixtures/scenes/{name}.toml"
                       for name in ("straight_slide", "jam", "tipping"))


def printed(*words):
    return subprocess.run([TOOL, *words], capture_output=True, text=True, timeout=100).stdout


def listed(numbers):
    return numbers.tolist() if hasattr(numbers, "tolist") else numbers


class SameJson(unittest.TestCase):
    def test_of_every_scene(self):
        scenes = sorted(map(str, pathlib.Path("fixtures/scenes").glob("*.toml")))
        self.assertGreater(len(scenes), 15)
        for path in scenes:
            scene = lcpush.read(path)
            self.assertEqual(scene.solve(check=False).json, printed("solve", path, "--json"), path)
            self.assertEqual(lcpush.Scene(scene.to_dict(), path).solve(check=False).to_dict(),
                             scene.solve(check=False).to_dict(), path)

    def test_of_every_question(self):
        scene = lcpush.read(TIPPING)
        pusher = scene.names[-1]
        self.assertEqual(scene.break_().json, printed("break", TIPPING, "--json"))
        self.assertEqual(scene.spread(paths_only=True).json,
                         printed("spread", TIPPING, "--paths", "--json"))
        self.assertEqual(scene.move(time=0.1, frames=5).json,
                         printed("move", TIPPING, "--time", "0.1", "--frames", "5", "--json"))
        for more, words in (({}, []), ({"steps": 4}, ["--steps", "4"]),
                            ({"pressure": "rigid"}, ["--pressure", "rigid"])):
            path = f"{pusher}.friction"
            self.assertEqual(scene.sweep(path, 0.1, 0.5, **more).json,
                             printed("sweep", TIPPING, "--vary", f"{path}=0.1:0.5", "--json",
                                     *words))
        both = scene.sweep("object.mass", 0.1, 0.5, steps=3, over=(f"{pusher}.friction", 0.1, 0.5))
        self.assertEqual(both.json,
                         printed("sweep", TIPPING, "--vary", "object.mass=0.1:0.5", "--vary",
                                 f"{pusher}.friction=0.1:0.5", "--steps", "3", "--json"))
        several = scene.sweep(f"{pusher}.friction", 0.1, 0.5, steps=3, each=("facets", [4, 8]))
        words = ("sweep", TIPPING, "--vary", f"{pusher}.friction=0.1:0.5", "--steps", "3", "--each",
                 "facets=4,8")
        self.assertEqual(several.json, printed(*words, "--json"))
        self.assertEqual(several._repr_html_(), printed(*words, "--format", "svg"))
        self.assertEqual([curve.each_value for curve in several.curves], [4, 8])
        self.assertEqual(json.dumps(scene.matrices().to_dict()),
                         json.dumps(json.loads(printed("matrices", TIPPING, "--json"))))
        asked = r"<div><dt>Asked</dt>.*\n" # the words of a command line
        self.assertEqual(scene.report(), re.sub(asked, "", printed("report", TIPPING)))
        self.assertEqual(scene.picture("top"),
                         printed("report", TIPPING, "--format", "svg", "--picture", "top"))

    def test_of_other_values(self):
        path, changes = "docs/guide/held_block.toml", {"object.mass": "150 g", "pin.friction": 0.4, "gravity": [0, -9, 1]}
        other = lcpush.read(path).with_values(changes)
        self.assertEqual(other.title, f"{path}, with object.mass=\"150 g\", pin.friction=0.4, gravity=[0, -9, 1]")
        set_ = [word for key, value in changes.items() for word in ("--set", f"{key}={value}")]
        self.assertEqual(other.solve().contacts[0].normal_force,
                         json.loads(printed("solve", path, *set_, "--json"))["contacts"][0]["normal_force"])
        with self.assertRaisesRegex(lcpush.InputError, "did you mean"):
            other.with_values({"pin.fricton": 1})

    def test_of_holding(self):
        path = "docs/guide/off_centre.toml"
        hold = lcpush.read(path).hold(at=(0.1, 0, 0), directions=["moment 0 1 0"])
        words = ("hold", path, "--at", "0.1 0 0", "--direction", "moment 0 1 0")
        self.assertEqual(hold.json, printed(*words, "--json"))
        self.assertEqual(hold._repr_html_(), printed(*words, "--format", "svg"))
        self.assertTrue(hold and repr(hold).startswith("Held with 1.4 times the grip it needs"))
        self.assertEqual(hold.weakest.moment["first"], ["left", "right"])
        self.assertRegex(repr(hold.least_grip), "^<Record force=[0-9.]+, factor=0.71[0-9]+, .*, of='per finger'>$")
        for of_box in (lcpush.read(path).hold(tolerance="*.friction=5%"), lcpush.read("docs/guide/uncertain_slide.toml").cone(),
                       lcpush.read("docs/guide/uncertain_slide.toml").hold()):
            self.assertIn(" for every ", repr(of_box))
            self.assertIn(repr(of_box), of_box.text())

    def test_of_designs(self):
        path = "docs/guide/narrow_wall.toml"
        funnel = lcpush.read("docs/check/block.toml").funnel((0, 0.002, 0.09))
        self.assertTrue(funnel)
        self.assertGreater(funnel.along[1], 0.002)
        design = lcpush.read(path).design({"wall.center[1]": (-0.012, 0.012)}, push=(0.01, 0, 0))
        words = ("design", path, "--choose", "wall.center[1]=-0.012:0.012", "--push", "0.01 0 0")
        self.assertEqual(design.json, printed(*words, "--json"))
        self.assertEqual(design._repr_html_(), printed(*words, "--format", "svg"))
        self.assertTrue(design and repr(design).startswith("With wall.center[1] = -0.005336"))

    def test_of_cones_and_plans(self):
        path = "docs/guide/square.toml"
        scene = lcpush.read(path)
        pusher = scene.names[-1]
        self.assertEqual(scene.cone(pusher=pusher).json,
                         printed("cone", path, "--pusher", pusher, "--json"))
        cone = scene.cone((0.002, 0.01, 1), pusher=pusher)
        words = ("cone", path, "--pusher", pusher, "--twist", "0.002 0.01 1")
        self.assertEqual(cone.json, printed(*words, "--json"))
        self.assertEqual(cone._repr_html_(), printed(*words, "--format", "svg"))
        plan = scene.plan((-0.01, 0, 0))
        words = ("plan", path, "--to", "-0.01 0 0")
        self.assertEqual(plan.json, printed(*words, "--json"))
        for part in (cone.edges[0], plan.pushes[0] if plan else cone.edges[-1]):
            self.assertIsInstance(part, lcpush.Record)
            self.assertEqual({key: listed(getattr(part, key)) for key in part}, part.to_dict())
            self.assertEqual(dict(part), part.to_dict())
        if plan:
            self.assertEqual(plan.page(), printed(*words, "--format", "html"))
            self.assertEqual(lcpush.Scene(plan.scene).text, printed(*words, "--format", "toml"))

    def test_of_work_that_is_shown(self):
        scene = lcpush.read(SLIDE)
        for more, words in (({}, []), ({"facets": 8, "pressure": "rigid"},
                                       ["--facets", "8", "--pressure", "rigid"]),
                            ({"as_solved": True}, ["--as-solved"])):
            self.assertEqual(scene.pivots(**more).json, printed("pivots", SLIDE, *words, "--json"))
        typed = ("pivots", "--M", "2 1; 1 1/2", "--q", "-5 -6", "--exact")
        raw = lcpush.pivots([[2, 1], ["1", fractions.Fraction(1, 2)]], (-5, -6), exact=True)
        self.assertEqual(raw.json, printed(*typed, "--json"))
        self.assertEqual(raw.latex(), printed(*typed, "--format", "latex"))
        self.assertEqual(raw.page(), printed(*typed, "--format", "html"))
        self.assertIn("srcdoc", raw._repr_html_())
        self.assertIn("pivots: solved", repr(raw))
        with tempfile.TemporaryDirectory() as folder:
            mine, tools = pathlib.Path(folder, "mine"), pathlib.Path(folder, "tools")
            printed("export", SLIDE, "-o", str(tools))
            mine.joinpath("fclib").mkdir(parents=True)
            names = scene.export(mine)
            self.assertEqual(sorted(names), sorted(str(path.relative_to(tools)) for path
                                                   in tools.rglob("*") if path.is_file()))
            for name in names:
                self.assertEqual((mine / name).read_bytes(), (tools / name).read_bytes(), name)

    def test_of_certificates_which_a_stranger_accepts(self):
        with tempfile.TemporaryDirectory() as folder:
            path, proof, tools = (pathlib.Path(folder, name) for name in ("s.toml", "p.json", "t.json"))
            for name, breaking in ((SLIDE, False), (SLIDE, True), (JAM, False)):
                scene = lcpush.Scene(lcpush.read(name).to_dict())
                scene.save(path)
                certificate = scene.certify(breaking=breaking)
                certificate.save(proof)
                printed("break" if breaking else "solve", str(path), "--certify", str(tools))
                self.assertEqual(certificate.json, tools.read_text(encoding="utf-8"))
                if sys.version_info < (3, 11):
                    continue  # the checker reads TOML by Python's own reader
                accepted = subprocess.run([sys.executable, "docs/check/lcpush_check.py", str(proof),
                                           str(path)], capture_output=True, text=True)
                self.assertEqual(accepted.returncode, 0, accepted.stdout + accepted.stderr)
                self.assertIn(certificate.statement, repr(certificate))

    def test_of_raw_problems(self):
        self.assertEqual(lcpush.lcp([[2, 1], [1, 2]], [-5, -6]).json,
                         printed("lcp", "--M", "2 1; 1 2", "--q", "-5 -6", "--json"))
        boxed = lcpush.lcp([[2, 1], [1, 2]], [-5, -6], lo=0, hi=[1, float("inf")])
        self.assertEqual(boxed.json, printed("lcp", "--M", "2 1; 1 2", "--q", "-5 -6", "--lo", "0",
                                             "--hi", "1 inf", "--json"))
        free = lcpush.lcp([[2, 1], [1, 2]], [5, -6], free=[0])
        self.assertEqual(free.json, printed("lcp", "--M", "2 1; 1 2", "--q", "5 -6", "--free", "1",
                                            "--json"))
        self.assertLess(free.z[0], 0)


class Answers(unittest.TestCase):
    def test_say_what_the_tool_says(self):
        scene = lcpush.read(SLIDE)
        solution = scene.solve()
        self.assertIn("Push with 20.1 N", repr(solution))
        told = " ".join(printed("solve", SLIDE).split())
        self.assertIn(repr(solution), told)
        self.assertIn("The grasp breaks at 20 N", repr(scene.break_()))
        self.assertIn("The box slides", repr(scene.move(time=0.2, frames=3)))
        self.assertIn("Solved in", repr(lcpush.lcp([[1]], [-1])))
        for answer in (solution, scene.move(time=0.2, frames=3),
                       scene.sweep("*.grip_force", 5, 30, pressure="rigid")):
            self.assertTrue(answer._repr_html_().startswith("<svg"))
        self.assertIn("<svg", scene._repr_html_())
        self.assertEqual(repr(solution.contacts[0]), "<Contact left.1>")
        self.assertRegex(repr(scene.matrices()), r"^<Record warnings=\[\], M=\{3 keys\}, w=\{3 keys\}, G=.*, rigidity=\[")
        crowded = lcpush.Scene(scene.text.replace("0.3", "30"))
        self.assertIn(crowded.warnings[0].text, repr(crowded.warnings))

    def test_have_arrays_and_names(self):
        solution = lcpush.read(SLIDE).solve()
        self.assertEqual(len(listed(solution.acceleration)), 6)
        self.assertAlmostEqual(solution.acceleration[0], 0.1, places=9)
        self.assertAlmostEqual(solution.body("wall").force[0], 20.02, places=6)
        self.assertEqual([contact.mode for contact in solution.contacts][-1], "stick")
        n = len(solution.q)
        self.assertEqual((len(solution.M), len(solution.M[0]), len(solution.names)), (n, n, n))
        again = lcpush.lcp(solution.M, solution.q, free=solution.free)
        self.assertLess(again.residual, 1e-9)
        with self.assertRaises(AttributeError):
            solution.no_such_key  # noqa: B018

    def test_of_sweeps_and_motions_are_columns(self):
        scene = lcpush.read(SLIDE)
        sweep = scene.sweep("*.grip_force", 5, 30, steps=6)
        self.assertEqual(len(listed(sweep.values)), len(listed(sweep.break_force)))
        self.assertAlmostEqual(sweep.break_force[-1], 30, places=6)
        exact = scene.sweep("*.grip_force", 5, 30, pressure="rigid")
        self.assertEqual(listed(exact.values)[0], 5)
        self.assertAlmostEqual(exact.force[-1][0], 30.02, places=6)
        motion = scene.move(time=1, frames=11)
        self.assertAlmostEqual(motion.positions[-1][0], 0.05, places=6)
        self.assertEqual([len(listed(motion.times)), len(listed(motion.rotations))], [11, 11])
        self.assertEqual(listed(motion.rotations[0]), [[1, 0, 0], [0, 1, 0], [0, 0, 1]])


    def test_go_through_pickle(self):
        solution = pickle.loads(pickle.dumps(lcpush.read(SLIDE).solve()))
        self.assertIn("Push with 20.1 N", repr(solution))
        self.assertEqual(len(solution.M), len(solution.names))
        raw = pickle.loads(pickle.dumps(lcpush.lcp([[2, 1], [1, 2]], [-5, -6])))
        self.assertIn("Solved in", repr(raw))


class Judging(unittest.TestCase):
    def test_of_answers(self):
        scene = lcpush.read(SLIDE)
        solution = scene.solve()
        self.assertTrue(scene.verify(solution))
        wrong = solution.to_dict()
        wrong["object"]["acceleration"][0] = 0.11
        self.assertAlmostEqual(solution.acceleration[0], 0.1, places=9)
        verdict = lcpush.verify_scene(scene, wrong)
        self.assertFalse(verdict)
        self.assertTrue(verdict.because)

    def test_contacts_take_one_friction_for_all(self):
        W, g = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [-1, 0.5, 0]
        self.assertEqual(lcpush.contacts(W, g, 0.5).json, lcpush.contacts(W, g, [0.5]).json)

    def test_of_motions(self):
        scene = lcpush.read(SLIDE)
        motion = scene.move(time=0.1, step=0.001, frames=101)
        self.assertTrue(scene.verify_motion(motion))
        frames = [{"time": t, "position": p, "rotation": [1, 0, 0, 0, 1, 0, 0, 0, 1]}
                  for t, p in zip(listed(motion.times), listed(motion.positions))]
        self.assertTrue(scene.verify_motion(frames))
        self.assertTrue(scene.verify_motion([{"t": frame["time"], "position": frame["position"], "quaternion": [1, 0, 0, 0]}
                                             for frame in frames]))
        frames[50]["position"] = [x + 1e-5 for x in frames[50]["position"]]
        self.assertEqual(scene.verify_motion(frames).verdict, "differs")
        frames = json.loads(motion.json)["frames"]
        self.assertIsNone(scene.verify_motion(frames).forces["broken"])
        frames[50]["contacts"][0]["normal_force"] *= -1
        verdict = scene.verify_motion(frames)
        self.assertEqual((bool(verdict), verdict.verdict, verdict.forces["broken"]), (False, "wrong_forces", "normal"))
        creeping = pathlib.Path("docs/guide/creeping_box.csv").read_text(encoding="utf-8")
        held = lcpush.read("docs/guide/held_box.toml")
        verdict = held.verify_motion(creeping)
        self.assertEqual(held.verify_motion(pathlib.Path("docs/guide/creeping_box.csv")).json, verdict.json)
        self.assertEqual(verdict.json,
                         printed("verify", "docs/guide/held_box.toml", "--trajectory",
                                 "docs/guide/creeping_box.csv", "--json"))
        self.assertIn("creeps", repr(verdict))

    def test_of_raw_problems(self):
        M, q = [[2, 1], [1, 2]], [-5, -6]
        self.assertTrue(lcpush.check(M, q, lcpush.lcp(M, q).z))
        verdict = lcpush.check(M, q, [1.3, 2.3])
        self.assertEqual((bool(verdict), verdict.row), (False, 1))


class WithoutAnswer(unittest.TestCase):
    def test_says_why(self):
        with self.assertRaises(lcpush.NotSolved) as caught:
            lcpush.read(JAM).solve()
        self.assertEqual(caught.exception.status, "ray")
        self.assertTrue(any(entry["name"] == "normal of wall.1" for entry in caught.exception.ray))
        self.assertIn("jam", str(caught.exception).lower())
        with self.assertRaises(lcpush.NotSolved) as caught:
            lcpush.lcp([[-1]], [-1])
        self.assertEqual(caught.exception.ray, [1])
        with self.assertRaises(lcpush.NotSolved) as caught:
            lcpush.read("fixtures/scenes/dropped.toml").break_()
        self.assertEqual(caught.exception.status, "does_not_hold")

    def test_is_nothing_where_that_is_asked_for(self):
        jam = lcpush.read(JAM).solve(check=False)
        self.assertEqual((jam.acceleration, jam.contacts, jam.bodies), (None, [], []))
        self.assertRaisesRegex(KeyError, "there is no answer", jam.body, "wall")
        fall = lcpush.read("fixtures/scenes/dropped.toml").break_(check=False)
        self.assertEqual((fall.break_force, fall.closings), (None, {}))
        self.assertIsNone(lcpush.lcp([[-1]], [-1], check=False).z)


class Scenes(unittest.TestCase):
    def test_survive_dictionaries_and_files(self):
        own = 0
        for path in sorted(pathlib.Path("fixtures/scenes").glob("*.toml")):
            text = path.read_text(encoding="utf-8")
            tables = lcpush.Scene(text, str(path)).to_dict()
            self.assertEqual(tables, tomllib.loads(text), path)
            self.assertEqual(tomllib.loads(_toml.write(tables)), tables, path)
            own += 1
        self.assertGreater(own, 15)
        awkward = {"title": 'a "b" \\ # \u00e4 \U0001f600', "gravity": [0, -9.81, 1e-300], "planar": True}
        self.assertEqual(tomllib.loads(_toml.write(awkward)), awkward)

    def test_have_names_and_texts_of_every_script(self):
        scene = lcpush.read(SLIDE)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "\u00fc \U0001f600.toml")
            lcpush.Scene({**scene.to_dict(), "title": path.name}).save(path)
            self.assertEqual(lcpush.read(path).title, path.name)
            none = os.fsencode(folder) + b"/\xe4.toml"  # as a disk may have it from elsewhere
            pathlib.Path(os.fsdecode(none)).write_text("[object]\n", encoding="utf-8")
            for given in (none, os.fsdecode(none)):
                with self.assertRaises(lcpush.InputError) as caught:
                    lcpush.read(given)
                self.assertTrue(caught.exception.file.endswith("?.toml"))

    def test_are_built_of_dataclasses(self):
        @dataclasses.dataclass
        class Point:
            name: str
            center: tuple
            normal: tuple
            friction: float = 0.5
            shape: str = "point"
            grip_force: "float | None" = None
            acceleration: "tuple | None" = None

        @dataclasses.dataclass
        class Grasp:
            object: dict
            finger: list
            pusher: list

        table = Point("table", (0, 0, 0.005), (0, 0, -1), grip_force=10)
        wall = Point("wall", (-0.05, 0, 0), (1, 0, 0), acceleration=(0.1, 0, 0))
        whole = Grasp({"mass": 0.2, "box": [0.1, 0.03, 0.01]}, [table], [wall])
        self.assertEqual(lcpush.Scene(whole).names, ["table", "wall"])
        self.assertEqual(lcpush.Scene(vars(whole)).text, lcpush.Scene(whole).text)
        self.assertRaises(lcpush.InputError, lcpush.Scene, Grasp)

    def test_tell_themselves(self):
        scene = lcpush.read(SLIDE)
        self.assertEqual(scene.names, ["left", "right", "wall"])
        self.assertIn("wall.friction", scene.parameters)
        self.assertIn("Straight slide", repr(scene))
        self.assertEqual(lcpush.__version__, printed("--version").split()[1])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
