"""lcpush break says from which grip force on the grasp holds, without and with the pusher."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/support"))
from random_scenes import random_scene
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


def actuator(name, body, direction, amount):
    return (f'[[actuator]]\nname = "{name}"\nbodies = ["{body}"]\n'
            f"twists = [{[*direction, 0, 0, 0]}]\n{amount}\n")


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

    def answer(self, text, *words):
        answer = json.loads(self.run_tool(text, "--json", *words))
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
        self.assertIn("the grasp holds the object; it holds down to 1.962 N per finger (of 20 N).",
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
        self.assertIn("It would hold from 1.962 N per finger (of 1 N).", text)
        self.assertIn("The grasp does not hold", text)

    def test_a_sheet_below_carries_what_the_fingers_do_not(self):
        rolling = (SCENES / "rolling.toml").read_text()
        answer = self.answer(rolling)
        self.assertIs(answer["holds_without_push"], False)
        self.assertIs(answer["holds_at_rest"], True)
        self.assertAlmostEqual(answer["smallest_grip"], 8.175, 8) # per finger of parallel jaws
        self.assertEqual(answer["smallest_grip_at_rest"], 0)
        self.assertIn("With the pusher in place, at rest, it holds; it holds without any grip force",
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
        self.assertIn("down to a force of 3.924 (of 40) of actuator hand.", self.text(text))

    def test_an_actuator_is_no_pair_of_jaws_by_its_name(self):
        hand = "gravity = [0, 0, -9.81]\n" + (SCENES / "three_finger_hand.toml").read_text()
        for name in ("tendon", "jaws"):
            renamed = hand.replace('name = "tendon"', f'name = "{name}"')
            self.assertAlmostEqual(self.answer(renamed)["smallest_grip"], 1.308, 8)
            self.assertIn(f"down to a force of 1.308 (of 24) of actuator {name}, the others in "
                          "proportion.", self.text(renamed))

    def test_parallel_jaws_are_read_per_finger(self):
        text = scene(pinch(), '[gripper]\njaws = "parallel"\n')
        self.assertAlmostEqual(self.answer(text)["smallest_grip"], 1.962, 8)
        self.assertIn("down to 1.962 N per finger (of 20 N)", self.text(text))

    def test_an_actuator_without_force_is_not_the_one_spoken_of(self):
        idle = actuator("idle", "stop", [1, 0, 0], "force = 0\ninertia = 0.1")
        stop = finger("stop", [[-0.05, 0, 0]], -1, None).replace("[0, 0, 1]", "[1, 0, 0]")
        hand = (actuator("l", "left", [0, 0, -1], "force = 1") +
                actuator("r", "right", [0, 0, 1], "force = 1"))
        text = scene(stop + pinch(left=None, right=None), idle + hand)
        self.assertAlmostEqual(self.answer(text)["smallest_grip"], 1.962, 6)
        self.assertIn("from a force of 1.962 (of 1) of actuator l, the others in proportion.",
                      self.text(text))

    def test_a_fall_that_is_slow_beside_a_huge_grip_is_a_fall(self):
        slippery = pinch(left=1e4, right=1e4).replace("friction = 0.5", "friction = 0")
        light = scene(slippery, gravity=(0, -0.09, 0)).replace("mass = 0.2", "mass = 0.001")
        for pressure in ("pad", "even", "rigid"):
            for solver in ("lemke", "hybrid", "gauss-seidel"):
                text = light.replace('"pad"', f'"{pressure}"')
                answer = self.answer(text, "--solver", solver)
                self.assertEqual(answer["status"], "does_not_hold", (pressure, solver))
                self.assertIs(answer["holds_without_push"], False)
                self.assertIs(answer["holds_at_rest"], False)
                self.assertAlmostEqual(answer["rest_acceleration"][1], -0.09, 5)
        self.assertIn("does NOT hold the object: it accelerates at 0.09 m/s^2", self.text(light))

    def test_a_huge_grip_with_friction_still_holds(self):
        held = scene(pinch(left=1e4, right=1e4), gravity=(0, -0.09, 0)).replace("0.2", "0.001", 1)
        for pressure in ("pad", "even", "rigid"):
            answer = self.answer(held.replace('"pad"', f'"{pressure}"'))
            self.assertEqual(answer["status"], "solved")
            self.assertIs(answer["holds_without_push"], True)

    def test_a_finger_that_moves_is_at_rest_before_the_push(self):
        thumb = finger("thumb", [[-0.05, 0, 0]], -1, None).replace("[0, 0, 1]", "[1, 0, 0]")
        hand = (actuator("l", "left", [0, 0, -1], "force = 20") +
                actuator("r", "right", [0, 0, 1], "force = 20") +
                actuator("t", "thumb", [1, 0, 0], "acceleration = 0.1"))
        text = scene(pinch(left=None, right=None) + thumb, hand)
        text = text.replace("center = [-0.05, 0, 0]\nnormal = [1, 0, 0]\nfriction = 0\n"
                            "acceleration = [0.1, 0, 0]",
                            "center = [0, 0.015, 0]\nnormal = [0, -1, 0]\nfriction = 0\n"
                            "acceleration = [0, 0, 0]")
        answer = self.answer(text)
        self.assertIs(answer["holds_without_push"], True)
        self.assertAlmostEqual(answer["smallest_grip"], 1.962, 6)

    def test_where_more_drops_the_load_too_there_is_no_from(self):
        below = finger("below", [[0, -0.015, 0]], -1, 1).replace("[0, 0, 1]", "[0, 1, 0]")
        for force in (1, 3):
            text = scene(below.replace("grip_force = 1", f"grip_force = {force}"))
            self.assertAlmostEqual(self.answer(text)["smallest_grip"], 1.962, 6)
            self.assertIn(f"It would hold only at about 1.962 N at below (of {force} N).",
                          self.text(text))

    def test_what_compliance_leaves_of_a_motion_is_no_fall(self):
        # A hair above the least grip these two were called falling at 1e-8 m/s^2, and at 0.1 % less not.
        for seed, least in ((16, 0.02822077078110312), (112, 1.3007331747683242)):
            text = random_scene(seed)
            for factor in (0.999, 1, 1.001, 1.002, 1.02):
                scaled = re.sub(r"grip_force = (\S+)", lambda m: f"grip_force = {float(m[1]) * least * factor!r}", text)
                file = pathlib.Path(self.folder.name) / "scene.toml"
                file.write_text(scaled)
                result = subprocess.run([TOOL, "solve", file, "--json"], capture_output=True, text=True)
                self.assertIs(json.loads(result.stdout)["holds_without_push"], factor >= 1, (seed, factor))

    def test_a_fall_slower_than_the_slowest_push_is_a_fall_and_no_pull(self):
        # 2 mu 2 N carries 1.962 N from mu = 0.4905 on. The object slips as the rod moves, whatever it weighs, so
        # that pushes taken back to none left no fall but a rod that pulls: -0.000274 N, called solved.
        dropped = (SCENES / "dropped.toml").read_text()
        for pressure in ("pad", "rigid", "even"):
            for solver in ("lemke", "hybrid", "gauss-seidel"):
                for friction in (0.4904717, 0.49049, 0.490499, 0.490501, 0.49051):
                    text = re.sub("(?m)^friction = .*$", f"friction = {friction}", dropped)
                    answer = self.answer(f'pressure = "{pressure}"\n' + text, "--solver", solver)
                    told = (pressure, solver, friction, answer["status"])
                    self.assertEqual(answer["status"] == "solved", friction > 0.4905, told)
                    self.assertIs(answer["smallest_grip_at_rest_factor"] <= 1, friction > 0.4905, told)
                    if friction > 0.4905: # along the edge of the pyramid, 22.5 degrees off
                        self.assertAlmostEqual(answer["break_force"], (4 * friction - 1.962) * (1 + 2**0.5), 9)
                        continue
                    self.assertEqual(answer["status"], "does_not_hold", told)
                    self.assertAlmostEqual(answer["rest_acceleration"][1], (4 * friction - 1.962) / 0.2, 7)

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
