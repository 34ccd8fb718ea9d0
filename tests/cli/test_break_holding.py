"""lcpush break says from which grip force on the grasp holds, without and with the pusher."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENES = SOURCE / "fixtures/scenes"
SLIDE_TEXT = (SCENES / "straight_slide.toml").read_text()
KEYS = ("smallest_grip", "smallest_grip_factor", "smallest_grip_from", "holds_at_rest",
        "smallest_grip_at_rest", "smallest_grip_at_rest_factor", "smallest_grip_at_rest_from")


def finger(name, points, side, force):
    grip = "" if force is None else f"grip_force = {force}\n"
    return (f'[[finger]]\nname = "{name}"\nshape = "points"\npoints = {points}\n'
            f"normal = [0, 0, {-side}]\nfriction = 0.5\n{grip}")


def scene(fingers, extra="", pressure="pad", gravity=(0, -9.81, 0)):
    """A box of 0.2 kg; the pusher is a point that only just touches it at the side."""
    return (f'gravity = {list(gravity)}\npressure = "{pressure}"\n'
            "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n" + fingers + extra +
            '[[pusher]]\nname = "rod"\nshape = "point"\ncenter = [-0.05, 0, 0]\n'
            "normal = [1, 0, 0]\nfriction = 0\nacceleration = [0.1, 0, 0]\n")


def pinch(points=([0, 0],), left=20, right=20):
    return (finger("left", [[*p, 0.005] for p in points], 1, left) +
            finger("right", [[*p, -0.005] for p in points], -1, right))


class Holding(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def run_tool(self, text, *words):
        file = pathlib.Path(self.folder.name) / "scene.toml"
        file.write_text(text)
        result = subprocess.run([TOOL, "break", str(file), *words], capture_output=True, text=True,
                                timeout=60)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return result.stdout

    def answer(self, text):
        answer = json.loads(self.run_tool(text, "--json"))
        for key in KEYS:
            self.assertIn(key, answer)
        return answer

    def text(self, text):
        return " ".join(self.run_tool(text).split())

    def test_a_grasp_that_holds_says_down_to_which_force(self):
        answer = self.answer(SLIDE_TEXT)
        self.assertIs(answer["holds_at_rest"], True)
        for key in ("smallest_grip", "smallest_grip_at_rest"):
            self.assertAlmostEqual(answer[key], 0.2 * 9.81 / (2 * 0.5), 8)
            self.assertAlmostEqual(answer[key + "_factor"] * 20, answer[key], 12)
            self.assertEqual(answer[key + "_from"], "statics")
        self.assertIn("the grasp holds the object; it would down to 1.962 N per finger (of 20 N).",
                      self.text(SLIDE_TEXT))

    def test_a_grasp_that_drops_its_load_says_from_which_force_on_it_would_hold(self):
        weak = scene(pinch(left=1, right=1))
        answer = self.answer(weak)
        self.assertEqual(answer["status"], "does_not_hold")
        self.assertIs(answer["holds_without_push"], False)
        self.assertIs(answer["holds_at_rest"], False)
        self.assertAlmostEqual(answer["smallest_grip_factor"], 1.962, 8)
        self.assertAlmostEqual(answer["smallest_grip_at_rest"], 1.962, 8)
        text = self.text(weak)
        self.assertIn("It would from 1.962 N per finger (of 1 N).", text)
        self.assertIn("DOES NOT HOLD", text)

    def test_a_sheet_below_carries_what_the_fingers_do_not(self):
        rolling = (SCENES / "rolling.toml").read_text()
        answer = self.answer(rolling)
        self.assertIs(answer["holds_without_push"], False)
        self.assertIs(answer["holds_at_rest"], True)
        self.assertAlmostEqual(answer["smallest_grip"], 8.175, 8) # per finger of parallel jaws
        self.assertEqual(answer["smallest_grip_at_rest"], 0)
        self.assertIn("With the pusher in place, at rest, it holds; it would without any grip force",
                      self.text(rolling))

    def test_no_grip_force_holds_without_friction_and_that_is_proved(self):
        slippery = scene(pinch().replace("friction = 0.5", "friction = 0"))
        answer = self.answer(slippery)
        self.assertIsNone(answer["smallest_grip"])
        self.assertIsNone(answer["smallest_grip_factor"])
        self.assertEqual(answer["smallest_grip_from"], "no_grip")
        self.assertEqual(answer["smallest_grip_at_rest_from"], "no_grip")
        self.assertIn("No grip force would hold it.", self.text(slippery))

    def test_the_pads_pressure_may_need_more_than_statics(self):
        # Under the centre of mass and beside it: the point beside it cannot help with the weight,
        # yet a pad leaves half of the force there; statics would move it all to the other one.
        beside = scene(pinch(points=([0, 0], [0.01, 0])))
        for pressure, factor in (("pad", 2), ("even", 2), ("rigid", None)):
            answer = self.answer(beside.replace('"pad"', f'"{pressure}"'))
            if factor:
                self.assertAlmostEqual(answer["smallest_grip"], factor * 1.962, 6)
                source = "search" if pressure == "pad" else "statics"
                self.assertEqual(answer["smallest_grip_from"], source)
        self.assertIn("That is this pressure law's limit; statics alone would allow 1.962 N",
                      self.text(beside))

    def test_unequal_fingers_are_scaled_together(self):
        stop = finger("stop", [[0, 0, -0.005]], -1, None).replace("friction = 0.5", "friction = 0")
        text = scene(pinch(left=30), stop)
        self.assertAlmostEqual(self.answer(text)["smallest_grip"], 1.5 * 1.962, 6)
        self.assertIn("down to 2.943 N at left, the others in proportion (of 30 N)",
                      self.text(text))

    def test_a_hand_is_scaled_by_its_actuator(self):
        hand = ('[[actuator]]\nname = "hand"\nbodies = ["left", "right"]\n'
                "twists = [[0, 0, -1, 0, 0, 0], [0, 0, 1, 0, 0, 0]]\nforce = 40\n")
        text = scene(pinch(left=None, right=None), hand)
        self.assertAlmostEqual(self.answer(text)["smallest_grip"], 3.924, 8)
        self.assertIn("down to 3.924 N at hand (of 40 N)", self.text(text))

    def test_a_force_controlled_pusher_is_a_load_and_not_part_of_the_grip(self):
        lifting = scene(pinch(left=5, right=5)).replace("center = [-0.05, 0, 0]", "center = [0, -0.015, 0]")
        lifting = lifting.replace("normal = [1, 0, 0]", "normal = [0, 1, 0]\nnormal_force = 15")
        answer = self.answer(lifting)
        self.assertAlmostEqual(answer["smallest_grip"], 1.962, 8)
        self.assertAlmostEqual(answer["smallest_grip_at_rest"], 15 - 1.962, 6)
        self.assertEqual(answer["smallest_grip_at_rest_from"], "statics")

    def test_without_gravity_nothing_is_needed(self):
        answer = self.answer(scene(pinch(), gravity=(0, 0, 0)))
        self.assertEqual(answer["smallest_grip"], 0)
        self.assertEqual(answer["smallest_grip_at_rest"], 0)

    def test_a_scene_that_nothing_grips_has_no_grip_force(self):
        answer = self.answer(scene(pinch(left=None, right=None)))
        self.assertIsNone(answer["smallest_grip"])
        self.assertIsNone(answer["smallest_grip_at_rest"])

    def test_a_jam_has_every_key_too(self):
        stop = ('[[finger]]\nname = "stop"\nshape = "point"\ncenter = [0.05, 0, 0]\n'
                "normal = [-1, 0, 0]\nfriction = 0.3\n")
        answer = self.answer(scene(pinch(), stop))
        self.assertEqual(answer["status"], "ray")
        self.assertIsNone(answer["holds_at_rest"])
        self.assertAlmostEqual(answer["smallest_grip"], 1.962, 6)


unittest.main(argv=[sys.argv[0]], verbosity=1)
