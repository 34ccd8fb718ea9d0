"""lcpush break says from which grip force on the grasp holds, without and with the pusher."""
import json
import pathlib
import re

from tool import SCENES, ToolTest, json_of, main, run, unwrapped
from random_scenes import random_scene
from scene_tables import finger, pusher, table
SLIDE_TEXT = "facets = 8\n" + (SCENES / "straight_slide.toml").read_text()
KEYS = ("smallest_grip", "smallest_grip_factor", "smallest_grip_from", "holds_at_rest",
        "smallest_grip_at_rest", "smallest_grip_at_rest_factor", "smallest_grip_at_rest_from")


def scene(fingers, extra="", pressure="pad"):
    """A box of 0.2 kg; the pusher is a point that only just touches it at the side."""
    return (table("", facets=8, gravity=[0, -9.81, 0], pressure=pressure) +
            table("[object]", mass=0.2, box=[0.1, 0.03, 0.01]) + fingers + extra +
            pusher("rod", "point", center=[-0.05, 0, 0], normal=[1, 0, 0], friction=0, acceleration=[0.1, 0, 0]))


def pinch(points=([0, 0],), force=20):
    return "".join(finger(name, "points", points=[[*p, side * 0.005] for p in points], normal=[0, 0, -side], friction=0.5,
                          grip_force=force) for name, side in (("left", 1), ("right", -1)))


LOCKED_TWISTED = (
    table("", facets=8) +
    table("[object]", mass=0.3, inertia=[0.0008, 0.0008, 0.0009], moment=[-0.007, -0.002, 0.02]) +
    table("[gripper]", jaws="locked") +
    finger("line", "line", ends=[[0.08, -0.0003, 0.007], [0.08, 0.0003, -0.007]], points=7, normal=[-1, -0.3, -0.06],
        friction=0.28, grip_force=12.805678494638258) +
    finger("pair", "rectangle", center=[-0.08, 0, 0], size=[0.004, 0.006], points=[2, 1], normal=[9, -4, -0.5],
        friction=0.9, grip_force=12.805678494638258) +
    pusher("pin", "point", normal=[0, 0, 1], friction=0.5, acceleration=[0.3, 0.006, 0.7], center=[0.04, 0.03, -0.03])
)


class OpenFriction(ToolTest):
    def test_a_part_on_a_table_pushed_by_a_rough_finger_is_told_to_be_open(self):
        """The finger may lift or press it down by up to mu' of its force: P = mu (W - f), -mu' P <= f <= mu' P."""
        mu, rough, weight = 0.3, 0.5, 0.18 * 9.81
        text = (table("", gravity=[0, 0, -9.81]) + table("[object]", mass=0.18, box=[0.147, 0.072, 0.008])
                + finger("table", "rectangle", on="-z", size=[0.12, 0.06], friction=mu)
                + pusher("wall", "point", on="-x", friction=rough, velocity=[1e-6, 0, 0]))
        scene_file = self.file("part.toml", text)
        answer = json_of("break", scene_file)
        force = answer["break_force"]
        low, high = mu * weight / (1 + mu * rough), mu * weight / (1 - mu * rough)
        self.assertTrue(low - 1e-6 < force < high + 1e-6)
        self.assertFalse(answer["unique"]["force"])
        plain = mu * weight  # without the finger's friction, as who counts by hand
        for words in (("solve",), ("break",)):
            told = unwrapped(run(*words, scene_file).stdout)
            self.assertRegex(told, "is not unique: for instance .* or .* N. The laws leave open how much friction")
            self.assertIn(f"{plain:.3g}", told)
        told = unwrapped(run("sweep", scene_file, "--vary", "wall.friction=0.1:0.5", "--steps", 3).stdout)
        self.assertRegex(told, "That is one answer of many: .* at 0.5 0.53 N is lawful as well as ")
        told = run("sweep", scene_file, "--vary", "table.friction=0.1:0.5", "--set", "wall.friction=0", "--steps", 3).stdout
        self.assertNotIn("one answer of many", unwrapped(told))
        page = self.file("page.html", "")
        run("report", scene_file, "-o", page, "--seconds", 600)
        self.assertIn("is not unique", pathlib.Path(page).read_text(encoding="utf-8"))
        for given, is_right in ((plain, True), ((force + plain) / 2, True), (0.9 * low, False), (1.1 * high, False)):
            verdict = run("verify", scene_file, self.file("force.json", json.dumps({"break_force": given})))
            self.assertEqual(verdict.returncode, 0 if is_right else 1, (given, verdict.stdout))
        smooth = self.file("smooth.toml", text.replace("friction = 0.5", "friction = 0"))
        self.assertNotIn("not unique", run("solve", smooth).stdout)


class Holding(ToolTest):
    def run_tool(self, text, *words):
        file = self.path / "scene.toml"
        file.write_text(text)
        result = run("break", file, *words)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return result.stdout

    def answer(self, text, *words):
        answer = json.loads(self.run_tool(text, "--json", *words))
        for key in KEYS:
            self.assertIn(key, answer)
        return answer

    def text(self, text):
        return unwrapped(self.run_tool(text))

    def test_a_grasp_that_holds_says_down_to_which_force(self):
        answer = self.answer(SLIDE_TEXT)
        self.assertIs(answer["holds_at_rest"], True)
        for key in ("smallest_grip", "smallest_grip_at_rest"):
            self.assertAlmostEqual(answer[key], 0.2 * 9.81 / (2 * 0.5), 8)
            self.assertAlmostEqual(answer[key + "_factor"] * 20, answer[key], 12)
            self.assertEqual(answer[key + "_from"], "statics")
        self.assertIn("the grasp holds the object; it holds down to 1.962 N per finger (of 20 N).",
                      self.text(SLIDE_TEXT))

    def test_the_bound_under_round_friction_is_that_of_the_cones(self):
        answer = self.answer(SLIDE_TEXT.replace("facets = 8", 'facets = "round"'))
        self.assertAlmostEqual(answer["smallest_grip"], 0.2 * 9.81 / (2 * 0.5), 12)
        self.assertEqual(answer["smallest_grip_from"], "statics")

    def test_a_bilateral_pusher_pulls_the_grasp_apart(self):
        """It pulls with what the pads bear, as a wall pushes."""
        text = (SCENES / "straight_slide_point.toml").read_text().replace("[[pusher]]", '[[pusher]]\nfollow = "bilateral"')
        for along, force in ((0.1, 19.9), (-0.1, -19.9)):
            path = self.file("cup.toml", text.replace("acceleration = [0.1, 0, 0]", f"acceleration = [{along}, 0, 0]"))
            found = json_of("break", path)
            self.assertEqual((found["status"], found["breaks"]), ("solved", True))
            self.assertAlmostEqual(found["break_force"], force, delta=0.05)
            self.assertEqual("a pull of 19.9 N by wall" in unwrapped(run("break", path).stdout), along < 0)

    def test_a_pusher_that_keeps_its_force_is_a_load(self):
        jack = pusher("jack", "point", center=[0, -0.015, 0], normal=[0, 1, 0], friction=0, normal_force=15)
        text = scene(pinch(), jack) + "normal_force = 1e-6\n"  # of the rod, which rubs along the box from below
        text = text.replace("[-0.05, 0, 0]", "[0, -0.015, 0.001]").replace("[1, 0, 0]", "[0, 1, 0]")
        answer = self.answer(text, "--pusher", "rod")
        self.assertAlmostEqual(answer["smallest_grip_at_rest"], 15 - 1.962, 4)
        self.assertEqual(answer["smallest_grip_at_rest_from"], "statics")

    def test_a_peg_between_two_rails_breaks_as_in_its_plane(self):
        """Pushed off its axis: F (1 - 2 mu e / l) = G with the lever e over the distance l of the rails, whatever their points."""
        mu, load, across, distance = 0.3, 2.0, 0.033, 0.02
        for points in (2, 4):
            rails = "".join(finger(name, "line", ends=[[x, y, -0.005], [x, y, 0.005]], points=points, normal=[-x / 0.005, 0, 0],
                                   friction=mu) for name, x, y in (("rim", -0.005, -0.01), ("wall", 0.005, -0.03)))
            text = (table("", gravity=[0, 0, 0]) + table("[object]", mass=0.02, box=[0.01, 0.06, 0.01], force=[0, load, 0],
                                                         at=[0, 0, 0]) + rails +
                    pusher("hand", "point", center=[-across, 0.03, 0], normal=[0, -1, 0], friction=0, acceleration=[0, -0.01, 0]))
            self.assertAlmostEqual(json.loads(run("break", "-", "--json", text=text).stdout)["break_force"],
                                   load / (1 - 2 * mu * across / distance), delta=0.2, msg=points)

    def test_a_grasp_that_drops_its_load_says_from_which_force_on_it_would_hold(self):
        weak = scene(pinch(force=1))
        answer = self.answer(weak)
        self.assertEqual(answer["status"], "does_not_hold")
        self.assertIs(answer["holds_without_push"], False)
        self.assertIs(answer["holds_at_rest"], False)
        self.assertAlmostEqual(answer["smallest_grip_factor"], 1.962, 8)
        self.assertAlmostEqual(answer["smallest_grip_at_rest"], 1.962, 8)
        text = self.text(weak)
        self.assertIn("It would hold from 1.962 N per finger (of 1 N).", text)
        self.assertIn("The grasp does not hold", text)

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
        # Single points share by their place alone: no pressure law has a limit.
        corners = "".join(finger(name, "point", center=[x, y, 0], normal=[-x / 0.02, -y / 0.02, 0], friction=mu, grip_force=force)
                          for name, x, y, mu, force in (("left", 0, 0.02, 0.5, 20), ("right", 0, -0.02, 0.5, 20),
                                                        ("third", 0.02, 0, 0.5, 4), ("fourth", -0.02, 0, 0.1, 4)))
        rod = pusher("rod", "point", center=[-0.02, 0.01, 0], normal=[1, 0, 0], friction=0.1, acceleration=[1, 0, 0])
        points = (table("", gravity=[0, 0, -9.81]) + table("[object]", mass=0.2, box=[0.04, 0.04, 0.04]) + corners + rod)
        self.assertIn("Statics alone would allow 1.86042 N", self.text(points))
        self.assertNotIn("pressure law", self.text(points))

    def test_an_actuator_is_no_pair_of_jaws_by_its_name(self):
        hand = "gravity = [0, 0, -9.81]\n" + (SCENES / "three_finger_hand.toml").read_text()
        for name in ("tendon", "jaws"):
            renamed = hand.replace('name = "tendon"', f'name = "{name}"')
            self.assertAlmostEqual(self.answer(renamed)["smallest_grip"], 1.308, 8)
            self.assertIn(f"down to a force of 1.308 (of 24) of actuator {name}, the others in "
                          "proportion.", self.text(renamed))

    def test_what_compliance_leaves_of_a_motion_is_no_fall(self):
        # A hair above the least grip these two were called falling at 1e-8 m/s^2, and at 0.1 % less not.
        for seed, least in ((16, 0.02822077078110312), (112, 1.3007331747683242)):
            text = "facets = 8\n" + random_scene(seed)
            for factor in (0.999, 1, 1.001, 1.002, 1.02):
                scaled = re.sub(r"grip_force = (\S+)", lambda m: f"grip_force = {float(m[1]) * least * factor!r}", text)
                file = self.path / "scene.toml"
                file.write_text(scaled)
                self.assertIs(json_of("solve", file)["holds_without_push"], factor >= 1, (seed, factor))

    def test_a_box_that_a_hand_holds_against_a_stop_says_that_friction_is_open(self):
        """Hand and stop may bear any part of the weight; pads' compliance left that a slip of 7e-12 m/s^2."""
        crate = (table("", gravity=[0, 0, -9.81]) + table("[object]", mass=5, box=[0.3, 0.2, 0.2]) +
                 finger("table", "rectangle", on="-z", size=[0.3, 0.2], points=[2, 2], friction=0.4) +
                 finger("stop", "line", on="+x", along="y", center=[0, -0.08], friction=0.2) +
                 pusher("hand", "point", on="-x", center=[0, 0.05], friction=0.5, normal_force=30))
        self.assertEqual(json_of("solve", "-", text=crate)["unique"]["wrench"], False)
        self.assertIn("30 or 31.8 N. The laws leave open how much friction there is", unwrapped(run("solve", "-", text=crate).stdout))

    def test_a_pusher_whose_force_is_given_breaks_by_its_friction(self):
        tube = (table("", gravity=[0, -9.81, 0]) + table("[object]", mass=0.06, cylinder_radius=0.025, cylinder_length=0.3, axis="z") +
                "".join(finger(name, "line", ends=[[0, y, -0.1], [0, y, 0.1]], normal=[0, -y / 0.025, 0], friction=0.4) for name, y in [("table", -0.025)]) +
                pusher("palm", "line", ends=[[0, 0.025, -0.04], [0, 0.025, 0.04]], normal=[0, -1, 0], friction=0.5, normal_force=5,
                       velocity=[0.02, 0, 0]))
        self.assertIn("breaks when palm, which presses with 5 N as given, drags with 0 N", unwrapped(run("break", "-", text=tube).stdout))

    def test_what_a_hundred_points_leave_of_rest_is_no_fall(self):
        plate = table("", gravity=[0, 0, -9.81]) + table("[object]", mass=0.4, cylinder_radius=0.13, cylinder_length=0.008, axis="z")
        for name, on in (("thumb", "+z"), ("index", "-z")):
            plate += finger(name, "disc", on=on, center=[0, 0.12], radius=0.008, points=96, friction=0.6, grip_force=30)
        plate += pusher("rack", "point", center=[0, -0.13, 0], normal=[0, 1, 0], friction=0.3, velocity=[0, 0.01, 0])
        self.assertTrue(json_of("solve", "-", "--seconds", 600, text=plate)["holds_without_push"])

    def test_a_fall_slower_than_the_slowest_push_is_a_fall_and_no_pull(self):
        # 2 mu 2 N carries 1.962 N from mu = 0.4905 on. The object slips as the rod moves, whatever it weighs, so
        # that pushes taken back to none left no fall but a rod that pulls: -0.000274 N, called solved.
        dropped = (SCENES / "dropped.toml").read_text()
        for pressure in ("pad", "rigid", "even"):
            for solver in ("lemke", "hybrid", "gauss-seidel"):
                for friction in (0.4904717, 0.49049, 0.490499, 0.490501, 0.49051):
                    text = re.sub("(?m)^friction = .*$", f"friction = {friction}", dropped)
                    answer = self.answer(f'facets = 8\npressure = "{pressure}"\n' + text, "--solver", solver)
                    told = (pressure, solver, friction, answer["status"])
                    self.assertEqual(answer["status"] == "solved", friction > 0.4905, told)
                    self.assertIs(answer["smallest_grip_at_rest_factor"] <= 1, friction > 0.4905, told)
                    if friction > 0.4905: # along the edge of the pyramid, 22.5 degrees off
                        self.assertAlmostEqual(answer["break_force"], (4 * friction - 1.962) * (1 + 2**0.5), 9)
                        continue
                    self.assertEqual(answer["status"], "does_not_hold", told)
                    self.assertAlmostEqual(answer["rest_acceleration"][1], (4 * friction - 1.962) / 0.2, 7)

    def test_a_grip_far_above_the_load_hides_no_fall(self):
        def point(name, axis, side, **keys):
            center, normal = ([s * side if k == axis else 0 for k in range(3)] for s in (0.02, -1))
            return finger(name, "point", center=center, normal=normal, **keys)

        for grip in (5e4, 1e5, 2e5, 1e6):
            with self.subTest(grip=grip):
                text = (table("", gravity=[0, -9.81, 0]) + table("[object]", mass=0.2, box=[0.04, 0.04, 0.04]) +
                        table("[gripper]", jaws="independent") +
                        "".join(point(f"grip{s}", 2, s, friction=0, grip_force=grip) +
                                point(f"stop{s}", 0, s, friction=0.5) for s in (-1, 1)) +
                        pusher("rod", "point", center=[0, 0.02, 0], normal=[0, -1, 0], friction=0, acceleration=[0, -0.1, 0]))
                self.assertEqual(self.answer(text)["status"], "does_not_hold")

    def test_a_fall_is_no_other_force_that_breaks(self):
        answer = self.answer(LOCKED_TWISTED)
        self.assertAlmostEqual(answer["break_force"], 0.226, 3)
        self.assertEqual(answer["others"], [])

    def test_a_jam_has_every_key_too(self):
        stop = finger("stop", "point", center=[0.05, 0, 0], normal=[-1, 0, 0], friction=0.3)
        answer = self.answer(scene(pinch(), stop))
        self.assertEqual(answer["status"], "ray")
        self.assertIsNone(answer["holds_at_rest"])
        self.assertAlmostEqual(answer["smallest_grip"], 1.962, 6)


main()
