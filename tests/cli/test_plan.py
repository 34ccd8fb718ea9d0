"""lcpush plan: plans whose replay ends where they say, refusals, words."""
import json
import math
import random
import re
import unittest

from tool import SOURCE, main, run, unwrapped
from scene_tables import finger, pusher, table, without

SQUARE = SOURCE / "docs/guide/square.toml"


def square(grip=(0.0, 0.0), head=""):
    text = SQUARE.read_text()
    for face in ("+z", "-z"):
        text = text.replace(f'on = "{face}"', f'on = "{face}"\ncenter = [{grip[0]}, {grip[1]}]')
    return head + text


def with_walls(text, half):
    """Their ends as numbers, so that they may be wider than the square."""
    for on, normal, ends in (('on = "+x"\nalong = "y"', "[-1, 0, 0]", "[[0.05, -{0}, 0], [0.05, {0}, 0]]"),
                             ('on = "-y"\nalong = "x"', "[0, 1, 0]", "[[-{0}, -0.05, 0], [{0}, -0.05, 0]]"),
                             ('on = "+y"\nalong = "x"', "[0, -1, 0]", "[[-{0}, 0.05, 0], [{0}, 0.05, 0]]")):
        old = f'{on}\nlength = "80 mm"'
        assert old in text
        text = text.replace(old, f"normal = {normal}\nends = {ends.format(half)}")
    return text


def goal(dx, dy, angle):
    return f"{dx} {dy} {angle}"


class Plan(unittest.TestCase):
    def replayed(self, text, *steps):
        """Where `lcpush move` takes the object in this scene: x, y, angle."""
        frames = json.loads(run("move", "-", *steps, "--json", text=text).stdout)["frames"]
        R = frames[-1]["rotation"]
        return (*frames[-1]["position"][:2], math.atan2(R[3], R[0]))

    def test_random_goals_are_reached_within_a_millimetre_and_a_degree(self):
        draw = random.Random(2018)
        reached = 0
        for head in ("", "gravity = [0, -9.81, 0]\n", 'facets = "round"\n'):
            for _ in range(6):
                sx, sy = draw.uniform(0, .03), draw.uniform(-.005, .005)
                gx, gy = draw.uniform(-.045, -.025), draw.uniform(-.04, .02)
                to = (gx - sx, gy - sy, draw.uniform(-.2, .2))
                text = square((-sx, -sy), head)
                plan = json.loads(run("plan", "-", "--to", goal(*to), "--json", text=text).stdout)
                if not plan["found"]:
                    continue
                reached += 1
                x, y, angle = self.replayed(plan["scene"])  # in steps of its own
                self.assertLess(math.hypot(x - to[0], y - to[1]), 1e-3)
                self.assertLess(abs(angle - to[2]), math.radians(1))
                self.check_pushes(plan, to)
        self.assertGreaterEqual(reached, 17)

    def check_pushes(self, plan, to):
        pushes = plan["pushes"]
        self.assertEqual(pushes[0]["from"], [0, 0, 0])
        for one, two in zip(pushes, pushes[1:]):
            self.assertEqual(one["to"], two["from"])
            self.assertAlmostEqual(one["begin"] + one["time"], two["begin"], 9)
        for value, wanted in zip(pushes[-1]["to"], to):
            self.assertAlmostEqual(value, wanted, 12)
        for push in pushes:
            self.assertEqual(push["kind"], "stick")
            self.assertLess(push["friction"], 0.9)
            self.assertLess(push["reach"], 0.04)
            self.assertLess(push["grip"], 50)

    def test_pushes_stick_in_the_replay(self):
        text = run("plan", SQUARE, "--to", "-0.04 0.02 0.1", "--format", "toml").stdout
        motion = json.loads(run("move", "-", "--step", "0.02", "--frames", "400", "--json",
                                 text=text).stdout)
        slipping = touching = 0
        for frame in motion["frames"][1:]:
            modes = [c["mode"] for c in frame["contacts"] if c["name"].split(".")[0] not in
                     ("left", "right")]
            touching += "stick" in modes
            slipping += "slide" in modes
        self.assertGreater(touching, 0.97 * len(motion["frames"]))
        self.assertLess(slipping, 10)  # where a pusher comes

    def test_needs_are_where_sticking_ends(self):
        plan = json.loads(run("plan", SQUARE, "--to", "-0.03 0 0", "--json").stdout)
        self.assertEqual([push["pusher"] for push in plan["pushes"]], ["east"])
        needs = plan["pushes"][0]
        self.assertLess(needs["friction"], 1e-8)  # straight through the middle
        self.assertLess(needs["reach"], 1e-6)
        turn = json.loads(run("plan", SQUARE, "--to", "-0.03 0 0.2", "--json").stdout)["pushes"][0]
        self.assertGreater(turn["friction"] + turn["reach"], 1e-3)

    def test_a_margin_is_not_wider_than_what_a_push_needs(self):
        plate = (table("", gravity=[0, 0, 0], planar=True) + table("[object]", mass=0.1, box=[0.06, 0.06, 0.01]) +
                 "".join(finger(name, "disc", on=on, radius=0.006, friction=0.5, grip_force=10) for name, on in (("l", "+z"), ("r", "-z"))) +
                 pusher("west", "line", on="-x", along="y", friction=0.8, velocity=[0.01, 0, 0]))
        words = ("--to", "0.01 0.005 0.35", "--tolerance", "west.friction=10%", "--json")
        plan = json.loads(run("plan", "-", *words, text=plate).stdout)
        least = max(push["friction"] for push in plan["pushes"])
        self.assertGreater(least, 0.2)
        self.assertTrue(0.3 < plan["margin"] <= 1 - least / 0.8, plan["margin"])

    def test_walls_as_wide_as_the_object_or_wider_push_along_its_face(self):
        for half in ("0.05", "0.06"):
            text = with_walls(square(), half)
            for to in ((-0.035, -0.025, 0.1), (-0.04, 0.01, -0.15), (-0.04, 0.02, 0.1)):
                plan = json.loads(run("plan", "-", "--to", goal(*to), "--json", text=text).stdout)
                self.assertTrue(plan["found"], (half, to))
                x, y, angle = self.replayed(plan["scene"])
                self.assertLess(math.hypot(x - to[0], y - to[1]), 1e-3)
                self.assertLess(abs(angle - to[2]), math.radians(1))
                self.assertTrue(all(push["reach"] < 0.05 for push in plan["pushes"]))
        beside = run("plan", "-", "--to", "-0.01 0 0", text=with_walls(square(), "0.04").replace(
            "[[0.05, -0.04, 0], [0.05, 0.04, 0]]", "[[0.05, 0.06, 0], [0.05, 0.09, 0]]"))
        self.assertEqual(beside.returncode, 2)

    def test_the_replay_is_the_one_that_move_makes(self):
        for head in ("", "facets = 16\n", 'facets = "round"\n'):
            plan = json.loads(run("plan", "-", "--to", "-0.05 -0.03 -0.1", "--json",
                                   text=square(head=head)).stdout)
            self.assertTrue(plan["found"])
            step = plan["replay"]["step"]
            words = ("--step", f"{step:.17g}") if step else ()
            motion = json.loads(run("move", "-", *words, "--json", text=plan["scene"]).stdout)
            self.assertEqual((motion["end"], motion["steps"]), ("time", plan["replay"]["steps"]))
            self.assertEqual(motion["frames"][-1]["position"][:2], plan["nearest"][:2])

    def test_less_friction_than_a_push_takes_makes_it_slip(self):
        to = (-0.04, 0.02, 0.1)
        plan = json.loads(run("plan", SQUARE, "--to", goal(*to), "--json").stdout)
        need = max(push["friction"] for push in plan["pushes"])
        self.assertGreater(need, 0.3)
        for share, sticks in ((1.005, True), (0.98, False)):
            fingers, pushers = plan["scene"].split("[[pusher]]", 1)
            pushers = re.sub(r"friction = .*", f"friction = {share * need}", pushers)
            motion = json.loads(run("move", "-", "--frames", "400", "--json",
                                     text=fingers + "[[pusher]]" + pushers).stdout)
            slips = any(contact["mode"] == "slide" for frame in motion["frames"][1:]
                        for contact in frame["contacts"]
                        if contact["name"].split(".")[0] not in ("left", "right"))
            self.assertEqual(slips, not sticks, share)

    def test_a_pusher_in_the_plane_needs_the_same_friction_whatever_its_tangent(self):
        needs = []
        for tangent in ("[0, 1, 0]", "[0, 0, 1]"):  # a pyramid's corners: in the plane; 18 degrees beside it
            text = square(head="facets = 10\n").replace("normal = [-1, 0, 0]\n",
                                                       f"normal = [-1, 0, 0]\ntangent = {tangent}\n")
            pushes = json.loads(run("plan", "-", "--to", "-0.02 0.008 0", "--json",
                                     text=without(text, "south", "north")).stdout)["pushes"]
            self.assertEqual(len(pushes), 1)
            needs.append(pushes[0]["friction"])
        self.assertGreater(needs[0], 0.1)
        self.assertAlmostEqual(needs[1], needs[0], 9)

    def test_a_grip_that_does_not_hold_the_object_has_no_plan(self):
        text = square(head="gravity = [0, -9.81, 0]\n").replace("grip_force = 50", "grip_force = 2")
        result = run("plan", "-", "--to", "-0.01 0 0", text=text)
        self.assertEqual(result.returncode, 1)
        self.assertIn("does not hold the box before it is pushed", unwrapped(result.stdout))
        answer = json.loads(run("plan", "-", "--to", "-0.01 0 0", "--json", text=text).stdout)
        self.assertEqual((answer["holds_start"], answer["found"], answer["tried"]), (False, False, 0))

    def test_goals_beside_the_grip_or_in_other_units_are_told_at_once(self):
        result = run("plan", SQUARE, "--to", "-40 20 0.1")
        self.assertEqual(result.returncode, 1)
        words = unwrapped(result.stdout)
        self.assertIn("No plan leads to (-40000, 20000) mm", words)
        self.assertIn("--to is in m and rad", words)
        answer = json.loads(run("plan", SQUARE, "--to", "-0.3 0 0", "--json").stdout)
        self.assertEqual((answer["holds_goal"], answer["tried"]), (False, 0))
        for turn in ("30", "10", "-7"):
            degrees = run("plan", SQUARE, "--to", f"-0.01 0 {turn}")
            self.assertEqual(degrees.returncode, 2)
            self.assertIn("not in degrees", unwrapped(degrees.stderr))

    def test_what_cannot_be_reached_says_how_near_it_came(self):
        text = without(square(), "south", "north")
        result = run("plan", "-", "--to", "0.02 0 0", "--seconds", "1", text=text)
        self.assertEqual(result.returncode, 1)
        self.assertIn("No plan was found that takes the box to (20, 0) mm and 0 degrees",
                      unwrapped(result.stdout))
        self.assertIn("the nearest that pushes reach is (0, 0) mm", unwrapped(result.stdout))
        answer = json.loads(run("plan", "-", "--to", "0.02 0 0", "--seconds", "1", "--json",
                                 text=text).stdout)
        self.assertEqual((answer["found"], answer["pushes"], answer["scene"]), (False, [], None))

    def test_goals_that_take_a_slipping_push_are_reached(self):
        scene = "planar = true\n" + (SOURCE / "fixtures/scenes/pivot.toml").read_text()
        for time in ("0.6", "0.8", "1"):
            to = self.replayed(scene, "--time", time)  # the scene's own push leads there
            plan = json.loads(run("plan", "-", "--to", goal(*to), "--json", text=scene).stdout)
            self.assertTrue(plan["found"], (time, plan["nearest"], to))
            self.assertIn("slip", [push["kind"] for push in plan["pushes"]])

    def test_a_turn_in_place_has_no_direction(self):
        for to in ("0 0 0.1", "0 0 -0.2"):
            text = run("plan", SQUARE, "--to", to).stdout
            self.assertIn(" turns it by ", unwrapped(text))
            self.assertNotIn("nan", text)

    def test_where_it_is_already_needs_no_push(self):
        result = run("plan", SQUARE, "--to", "0 0.0005 0.01")
        self.assertEqual(result.returncode, 0)
        self.assertIn("No push is needed: the box is as near to (0, 0.5) mm", unwrapped(result.stdout))
        answer = json.loads(run("plan", SQUARE, "--to", "0 0 0", "--json").stdout)
        self.assertEqual((answer["found"], answer["pushes"], answer["scene"]), (True, [], None))

    def test_turns_of_more_than_a_corner_meet_the_next_face(self):
        for to in ("0 0 2", "-0.01 0.02 -2.5", "0 0 6.2831853"):
            result = run("plan", SQUARE, "--to", to, "--json")
            self.assertEqual(result.returncode, 0, to)
            replay = json.loads(result.stdout)["replay"]
            self.assertLess(replay["position_error"], 2.5e-4)
            self.assertLess(replay["angle_error"], 1e-6)

    def test_formats(self):
        page = run("plan", SQUARE, "--to", "-0.04 0.02 0.1", "--format", "html").stdout
        self.assertIn("<!doctype html>", page.lower())
        text = run("plan", SQUARE, "--to", "-0.04 0.02 0.1", "-v").stdout
        self.assertTrue(all(len(line) <= 80 for line in text.splitlines()), text)
        again = run("plan", SQUARE, "--to", "-0.04 0.02 0.1", "-v").stdout
        self.assertEqual(text, again)

    def test_a_scene_that_is_its_own_image_across_z_is_taken_as_planar(self):
        given, found = (json.loads(run("plan", "-", "--to", "-0.01 0 0", "--json", text=text).stdout)
                        for text in (square(), square().replace("planar = true\n", "\n")))
        self.assertEqual(given["pushes"], found["pushes"])

    def test_bad_input_is_refused(self):
        for words, said in ((("--to", "1 2"), "x y angle"), (("--to", "a b c"), "--to"), ((), "--to"),
                            (("--to", "0 0 inf"), "--to")):
            result = run("plan", SQUARE, *words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(said, result.stderr)
        apart = run("plan", "-", "--to", "-0.01 0 0",
                     text=with_walls(square(), "0.04").replace("[[0.05, -0.04, 0], [0.05", "[[0.055, -0.04, 0], [0.055"))
        self.assertEqual(apart.returncode, 2)
        self.assertIn("east.1 stands 5 mm off the object", unwrapped(apart.stderr))
        spatial = run("plan", "-", "--to", "-0.01 0 0",
                      text=square().replace("planar = true\n", "gravity = [0, 0, -9.81]\n"))
        self.assertEqual(spatial.returncode, 2)
        self.assertIn("a plan moves the object in the plane", unwrapped(spatial.stderr))
        alone = run("plan", "-", "--to", "0 0.01 0", text=without(square(), "east", "south", "north"))
        self.assertEqual(alone.returncode, 2)
        self.assertIn("add a [[pusher]]", unwrapped(alone.stderr))


main()
