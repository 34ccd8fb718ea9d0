"""Forty motions against closed forms that share no code with the tool, and their judge: what it refuses, and engines."""
import importlib.util
import json
import math
import pathlib
import re
import subprocess
import sys

from tool import SOURCE, TOOL, ToolTest, main, run

FOLDER = SOURCE / "fixtures/canonical"
SCORE = FOLDER / "score.py"
PAGE = (SOURCE / "docs/check/canonical.md").read_text()
spec = importlib.util.spec_from_file_location("score", SCORE)
score = importlib.util.module_from_spec(spec)
spec.loader.exec_module(score)

MUJOCO = """
from types import SimpleNamespace as Record
class Array(list):
    T = property(lambda self: self)
    copy = ravel = lambda self: Array(self)
    reshape = lambda self, *shape: self
    __matmul__ = lambda self, other: other
    __sub__ = lambda self, other: Array(a - b for a, b in zip(self, other))
class MjModel(Record):
    from_xml_path = staticmethod(lambda path: MjModel(nkey=1, key=lambda name: Record(id=["start"].index(name)), opt=Record(timestep=2e-3)))
class MjData(Record):
    body = lambda self, name: {"object": Record(xipos=Array([self.x, 0.3, 0]), xmat=Array([1, 0, 0, 0, 1, 0, 0, 0, 1]))}[name]
    __init__ = lambda self, model: super().__init__(time=0, speed=None, x=0.2)
def mj_resetDataKeyframe(model, data, key):
    data.speed = 0
def mj_kinematics(model, data):
    pass
def mj_step(model, data):
    h, a = model.opt.timestep, ACCELERATION
    data.x, data.speed, data.time = data.x + h * data.speed + h * h * a / 2, data.speed + h * a, data.time + h
"""


def scored(*words):
    result = subprocess.run([sys.executable, SCORE, *map(str, words)], capture_output=True, text=True, cwd=SOURCE)
    return result.returncode, result.stdout


class Canonical(ToolTest):
    def test_forty_motions_are_within_their_tolerance_and_most_of_them_far_within(self):
        status, text = scored(TOOL)
        self.assertEqual((status, text.splitlines()[-1]), (0, "43 of 43 within their tolerance"), text)
        self.assertEqual(len({motion["scene"] for motion in score.MOTIONS}), 40)
        used = {line.split()[0]: abs(float(off) / float(allowed)) for line in text.splitlines()[:-1]
                for off, allowed in re.findall(r"(\S+) of (\d\S+) ", line)}
        self.assertEqual({name for name, part in used.items() if part > 0.1}, {"slides_and_spins", "thrown_cube_rest"})
        self.assertEqual({path.name for path in FOLDER.glob("*.toml")},
                         {motion["scene"] for motion in score.MOTIONS if "/" not in motion["scene"]})

    def test_formulas_have_the_values_that_a_pocket_calculator_has(self):
        for name, value in (("thrown_cube", 3.669725), ("thrown_cube_rest", 1.223242), ("ramp_20_03", 0.0737128),
                            ("ramp_20_05", 0), ("pendulum", 0.144294), ("pressed_from_above", 100 / 3)):
            self.assertAlmostEqual(score.evaluated(score.BY_NAME[name])[1], value, delta=1e-6, msg=name)
        # A physical pendulum of 60 degrees takes 1.0732 times as long as a small one.
        self.assertAlmostEqual(1 / score.agm(1, 3 ** 0.5 / 2), 1.07318, delta=1e-5)

    def test_the_error_halves_with_the_step(self):
        for name, step in (("point_push", 1), ("pendulum", 0.002), ("backspin_ball", 0.002)):
            off = [float(re.search(r"(\S+) of ", scored(TOOL, name, "--step", h)[1])[1]) for h in (step, step / 2)]
            self.assertAlmostEqual(off[0] / off[1], 2, delta=0.1, msg=name)

    def test_a_trajectory_is_judged_from_csv_and_json_alike_and_a_wrong_one_refused(self):
        for name in ("ramp_20_03", "thrown_up_turns", "wedge_bears", "ramp_tips"):
            motion = score.BY_NAME[name]
            words = ("move", FOLDER / motion["scene"], "--time", motion["time"], "--frames", 401)
            rows = run(*words, "--format", "csv").stdout
            frames = score.from_text(run(*words, "--json").stdout)
            self.assertEqual(scored("--trajectory", self.file("a.csv", rows), name)[0], 0)
            bare = [{key: frame[key] for key in ("time", "position", "rotation")} for frame in frames]
            status, text = scored("--trajectory", self.file("bare.json", json.dumps({"frames": bare})), name)
            self.assertEqual((status, "does not say" in text), (1, True) if name == "wedge_bears" else (0, False))
            for frame in frames:  # one per cent off
                frame["position"] = [1.01 * x for x in frame["position"]]
                frame["time"] *= 1.01 if motion["quantity"] == "turn" else 1
                frame["twist"] = [1.01 * x for x in frame["twist"]]
                for body in frame["bodies"]:
                    body["force"] = [1.01 * x for x in body["force"]]
            got = score.measured(motion, score.series(frames))[0]
            self.assertIsNotNone(got)
            self.assertFalse(score.verdict(motion, score.evaluated(motion)[1], got)[0], name)
        for spoilt in ("", "{}", "time,x,y,z\n0,0,0,0\n", "time,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,nan,0,0,1,0,0,0\n",
                       "time,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"):
            status, text = scored("--trajectory", self.file("spoilt", spoilt), "held")
            self.assertEqual((status, " - of " in text), (1, True), spoilt)
        self.assertEqual(scored("--trajectory", self.file("a.csv", "x"), "no_such_motion")[0], 1)

    def ramp(self, place, half_turn=lambda t: 0, frames=201):
        """ramp_20_03 with the right x at the end, as CSV."""
        a = 2 * score.evaluated(score.BY_NAME["ramp_20_03"])[1] / 0.5 ** 2
        rows = ["time,x,y,z,qw,qx,qy,qz"]
        for t in (0.5 * k / (frames - 1) for k in range(frames)):
            rows.append(",".join(map(str, [t, *place(a * t * t / 2, t), math.cos(half_turn(t)), 0, 0, math.sin(half_turn(t))])))
        return "\n".join(rows) + "\n"

    def test_what_ends_in_the_right_place_by_a_wrong_path_is_refused(self):
        def verdict_of(*how, **more):
            return scored("--trajectory", self.file("path.csv", self.ramp(*how, **more)), "ramp_20_03")
        self.assertEqual(verdict_of(lambda x, t: (x, 0, 0))[0], 0)
        for words, how in (("y is", [lambda x, t: (x, 5 * t, -3 * t), lambda t: 3 * t]), ("z is", [lambda x, t: (x, 0, -3 * t)]),
                           ("turn is", [lambda x, t: (x, 0, 0), lambda t: 3 * t]),
                           ("x is", [lambda x, t: (7 * t if t < 0.4 else x, 0, 0)])):
            status, text = verdict_of(*how)
            self.assertEqual((status, f"off its path: {words}" in text), (1, True), text)
        self.assertIn("no frame from 0 to 0.5 s", verdict_of(lambda x, t: (x, 0, 0), frames=2)[1])
        for name, key, other in (("pendulum", "position", [0, 0, 5e-3]), ("ramp_tips", "time", 1.1), ("fence", "time", 1.1)):
            motion = score.BY_NAME[name]
            frames = score.from_text(run("move", FOLDER / motion["scene"], "--time", motion["time"], "--frames", 401, "--json").stdout)
            of = score.series(frames)
            moment = score.measured(motion, of)[1]
            self.assertIsNone(score.off_path(motion, of, moment), name)
            for frame in frames[1:]:
                frame[key] = frame[key] * other if key == "time" else [a + b for a, b in zip(frame[key], other)]
            self.assertIn("off its path", score.off_path(motion, score.series(frames), moment), name)

    def test_the_format_is_that_of_verify_and_what_is_none_is_said_in_words(self):
        right = self.ramp(lambda x, t: (x, 0, 0))
        rows = [row.split(",") for row in right.split()]
        for text in (right.replace("time,", "t,"), right.replace(",", " , "), "\n".join(",".join(row[:4]) for row in rows),
                     json.dumps({"frames": [{"time": float(t), "position": [float(x), 0, 0], "quaternion": [2, 0, 0, 0]}
                                            for t, x, *_ in rows[1:]]})):
            for words in ([sys.executable, SCORE, "--trajectory", self.file("a", text), "ramp_20_03"],
                          [TOOL, "verify", FOLDER / "ramp_20_03.toml", "--trajectory", self.file("a", text)]):
                result = subprocess.run(words, capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        for text, said in (("x,y,z\n0,0,0\n", "a.csv: line 1: no column time"), (right.replace(",qz", ",q"), "half a rotation"),
                           (right.replace("\n0.25,", "\n0.25s,"), "line 102, column time: '0.25s' is no number"),
                           (right + "0.6,1\n", "line 203: 2 numbers"), ('{"frames": [{"time": 0}, {}]}', "frame 0: position has to be 3")):
            self.assertIn(said, scored("--trajectory", self.file("a.csv", text), "ramp_20_03")[1])
        self.assertIn("No such file", scored("--engine", "no_such_engine", "held")[1])

    def test_the_pages_script_for_mujoco_writes_what_the_judge_reads(self):
        """With a mujoco module of its own here, which slides down the ramp: names and calls are not checked."""
        code = re.search(r"```python\n(import mujoco\n.*?)```", (SOURCE / "docs/check/motions.md").read_text(), re.S)[1]
        speeds_up = 2 * score.evaluated(score.BY_NAME["ramp_20_03"])[1] / 0.5 ** 2
        self.file("mujoco.py", MUJOCO.replace("ACCELERATION", str(speeds_up)))
        subprocess.run([sys.executable, self.file("log.py", code)], cwd=self.path, check=True)
        status, text = scored("--trajectory", self.path / "motion.csv", "ramp_20_03")
        self.assertEqual(status, 0, text)

    def test_an_engine_of_a_few_lines_is_judged_as_the_page_shows(self):
        status, text = scored("--engine", "python3 fixtures/canonical/toy_engine.py",
                              "ramp_20_03", "ramp_20_05", "thrown_cube", "thrown_up")
        self.assertEqual(status, 1)
        self.assertIn(f"```text\n{text}```", PAGE)
        self.assertLess(len((FOLDER / "toy_engine.py").read_text().splitlines()), 30)

    def test_pages_pictures_and_tables_are_what_the_scenes_make(self):
        made = subprocess.run([sys.executable, SOURCE / "docs/check/canonical_pages.py", TOOL, "--check"], capture_output=True,
                              text=True)
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        pages = {path.name for path in (SOURCE / "docs/check/canonical").iterdir()}
        scenes = {pathlib.Path(motion["scene"]).stem for motion in score.MOTIONS}
        self.assertEqual(pages, {name + end for name in scenes for end in (".md", ".svg")})

    def test_a_picture_has_no_arrow_of_rounding(self):
        # The fingers of what spins between them press across the picture.
        for name, shows in (("soft_spin_down", False), ("spinning_disc", False), ("about_a_pin", True)):
            svg = (SOURCE / f"docs/check/canonical/{name}.svg").read_text()
            self.assertEqual(bool(re.search(r"[0-9] N</text>", svg)), shows, name)

    def test_a_picture_leaves_a_table_level_under_what_tips_or_flies(self):
        for name, time in (("tray_tips", 0.2), ("thrown_up", 0.3)):
            svg = run("move", FOLDER / f"{name}.toml", "--time", time, "--format", "svg").stdout
            pad = re.search(r'class="pad [^"]*" points="([^"]*)"', svg)[1]
            heights = [float(y) for y in re.findall(r",(\S+)", pad)]
            self.assertLess(max(heights) - min(heights), 15, name)  # its thickness is 9


main()
