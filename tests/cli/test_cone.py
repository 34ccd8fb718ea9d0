"""lcpush cone: edges, verdicts and refusals on the command line."""
import json
import re
import math
import unittest
import xml.etree.ElementTree as ElementTree

from tool import SOURCE, command, json_of, main, unwrapped
from scene_tables import finger, pusher, table, without

run = command("cone")
SQUARE = SOURCE / "docs/guide/square.toml"


def square(*changes):
    text = SQUARE.read_text()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return text


class Cone(unittest.TestCase):
    def answer(self, *words, text):
        result = run("-", *words, "--json", text=text)
        self.assertEqual(re.sub("lcpush: .* alone pushes; .* left out.\n", "", result.stderr), "")
        return json.loads(result.stdout)

    def test_json_has_every_promised_key(self):
        answer = self.answer("--pusher", "east", "--facets", "8", text=square())
        self.assertEqual(set(answer), {
            "status", "pusher", "exact", "single_place", "length", "edges", "sides",
            "holding_grip_factor", "twist", "sticks", "leaves", "margin", "nearest_side",
            "smallest_grip", "smallest_grip_factor", "largest_grip_factor", "warnings"})
        self.assertEqual(answer["status"], "solved")
        self.assertTrue(answer["sticks"] and answer["exact"])
        self.assertEqual(len(answer["edges"]), 4)
        for edge in answer["edges"]:
            vx, vy, _, _, _, wz = edge["twist"]
            ends = [math.hypot(vx - wz * y, vy + wz * x) for x, y in ((.05, -.04), (.05, .04))]
            self.assertAlmostEqual(max(ends), 1, 12)
            n, t = -edge["wrench"][0], edge["wrench"][1]
            self.assertAlmostEqual(abs(t) / n, 0.9, 12)
            self.assertLess(edge["slips"][1] * t, 0)  # friction against the slip
        for side in answer["sides"]:
            self.assertEqual(side["slips"] is None, side["turns_about"] is not None)
            self.assertEqual(side["twists"][0], answer["edges"][side["from"]]["twist"])
            self.assertEqual(side["twists"][-1], answer["edges"][side["to"]]["twist"])

    def test_a_grip_that_is_too_hard_slips_the_pusher_and_that_is_said(self):
        """A short edge that turns a plate: from some grip on one of its ends carries it alone."""
        pad = {"shape": "rectangle", "center": [0.019, 0.001], "size": [0.0167, 0.0209], "friction": 0.76}
        plate = lambda force: (
            table("", gravity=[0, -9.81, 0], planar=True) + table("[object]", mass=0.46, box=[0.149, 0.049, 0.044]) +
            table("[[finger]]", name="l", on="+z", grip_force=force, **pad) + table("[[finger]]", name="r", on="-z", grip_force=force, **pad) +
            table("[[pusher]]", name="w", on="-x", shape="line", along="y", length=0.0113, points=2, friction=0.62,
                  velocity=[0.01, 0.0026, 0], angular_velocity=[0, 0, -0.222], about=[0, 0, 0]))
        answer = self.answer(text=plate(58))
        least, most = answer["smallest_grip_factor"] * 58, answer["largest_grip_factor"] * 58
        self.assertTrue(0 < least < most < 58 and not answer["sticks"])
        for force, sticks in ((0.98 * least, False), (1.02 * least, True), (0.98 * most, True), (1.02 * most, False)):
            self.assertEqual(self.answer(text=plate(force))["sticks"], sticks, force)
        self.assertIn(f"sticks from {least:.3g} N per finger to {most:.3g} N per finger", run("-", text=plate(58)).stdout)

    def test_a_pusher_that_comes_later_is_named_as_that(self):
        later = without(square(), "south", "north") + pusher("pin", "point", on="-y", friction=0.3, velocity=[0, 0.01, 0]) + 'from = "1 s"\n'
        for words in (("cone", "-", "--pusher", "pin"), ("break", "-", "--pusher", "pin"), ("sweep", "-", "--vary", "pin.friction=0:1"),
                      ("solve", "-", "--tolerance", "pin.friction=10%"), ("design", "-", "--choose", "pin.center[2]=-0.01:0.01")):
            refused = command(words[0])(*words[1:], text=later)
            self.assertEqual(refused.returncode, 2, words)
            self.assertIn("pin is not there at the start, which this is about", unwrapped(refused.stderr))

    def test_the_mirrored_square_has_the_mirrored_cone(self):
        twist = lambda s: f"-0.01 {s * 0.004} {s * 0.05}"
        one = self.answer("--pusher", "east", "--twist", twist(1), text=square())
        two = self.answer("--pusher", "east", "--twist", twist(-1), text=square())
        self.assertAlmostEqual(one["margin"], two["margin"], 9)

    def test_a_twist_is_judged_by_its_direction(self):
        margins = [self.answer("--pusher", "east", "--twist", f"{-k} {0.2 * k} {3 * k}",
                               text=square())["margin"] for k in (1e-6, 1, 1e3)]
        self.assertAlmostEqual(margins[0], margins[1], 9)
        self.assertAlmostEqual(margins[2], margins[1], 9)

    def test_solve_slips_where_the_cone_says_so(self):
        for vy, wz in ((0.3, 0), (0.3, 6), (1.5, 0), (0, 25), (-0.8, -3)):
            text = square(("velocity = [-0.01, 0, 0]       # m/s",
                           f"acceleration = [-1e-4, {vy * 1e-4}, 0]\n"
                           f"angular_acceleration = [0, 0, {wz * 1e-4}]"))
            text = without(text, "south", "north")  # cone leaves the others out
            cone = self.answer(text=text)
            solved = json_of("solve", "-", text=text)
            slips = any(c["mode"] != "stick" for c in solved["contacts"]
                        if c["name"].startswith("east"))
            self.assertEqual(cone["sticks"], not slips, (vy, wz))

    def test_text_fits_and_says_what_is_beyond(self):
        result = run(SQUARE, "--pusher", "east", "-v")
        self.assertEqual(result.returncode, 0)
        self.assertIn("The push of east sticks, and so does", result.stdout)
        self.assertIn("the box slips over east along +y", result.stdout)
        self.assertTrue(all(len(line) <= 80 for line in result.stdout.splitlines()))
        away = run(SQUARE, "--pusher", "east", "--twist", "1 0 0")
        self.assertIn("presses nowhere in this motion", away.stdout)

    def test_the_picture_is_an_image_with_words(self):
        root = ElementTree.fromstring(run(SQUARE, "--pusher", "east", "--format", "svg").stdout)
        self.assertIn("The push of east sticks", root.find("{*}desc").text)

    def test_a_load_that_the_grip_does_not_hold_has_no_cone(self):
        text = "gravity = [0, -9.81, 0]\n" + square(("grip_force = 50", "grip_force = 2"))
        result = run("-", "--pusher", "east", text=text)
        self.assertEqual(result.returncode, 1)
        self.assertIn("does not hold the box", result.stdout)
        self.assertEqual(self.answer("--pusher", "east", text=text)["status"], "does_not_hold")

    def test_a_scene_that_is_its_own_image_across_z_is_taken_as_planar(self):
        given, found = (run("-", "--pusher", "east", "--json", text=square(*changes))
                        for changes in ((), (("planar = true\n", "\n"),)))
        self.assertEqual((found.returncode, found.stdout), (0, given.stdout))
        self.assertIn("its own image across z", unwrapped(found.stderr))
        self.assertNotIn("image", given.stderr)

    def test_what_has_no_cone_is_refused_with_its_line(self):
        refused = [
            ((("planar = true\n", "gravity = [0, 0, -9.81]\n"),), "say planar = true"),
            ((("planar = true", 'planar = true\npressure = "rigid"'),), "pad"),
            ((('on = "-z"', 'on = "+y"'),), "lies in the plane"),
            ((('shape = "disc"', 'shape = "point"'), ("radius = 0.01\n", "")), "resist no turning"),
            ((("grip_force = 50", ""),), "no finger presses on the object across the plane"),
            ((("friction = 0.9\nvelocity = [-0.01", "friction = 0\nvelocity = [-0.01"),),
             "without friction"),
            ((("friction = 0.9\nvelocity = [-0.01", "friction = 0.9\nnormal_force = 5\nvelocity = [0"),),
             "its force is given, not its motion"),
        ]
        for changes, words in refused:
            result = run("-", "--pusher", "east", text=square(*changes))
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(words, unwrapped(result.stderr))
            self.assertRegex(result.stderr, r"<stdin>:\d+:|standard input:\d+:|:\d+: ")
            self.assertEqual(result.stdout, "")

    def test_the_margin_of_a_phone_pushed_onto_a_table_under_its_weight(self):
        """At an angle a the grip resists with G = 2 mu F along the motion: it sticks to mu' (G cos a + W) = G sin a. With a
        weak grip a side of the cone turns by nearly half a turn."""
        disc = '[[finger]]\nname = "{0}"\nshape = "disc"\non = "{1}z"\nradius = 0.008\nfriction = 0.6\ngrip_force = {2}\n'
        weight = 0.19 * 9.81
        for force in (2, 3, 6, 15, 20, 100):
            phone = ('gravity = [0, -9.81, 0]\nplanar = true\n[object]\nmass = 0.19\nbox = "150 x 72 x 8 mm"\n'
                     + disc.format("a", "+", force) + disc.format("b", "-", force)
                     + '[[pusher]]\nname = "table"\nshape = "line"\non = "-y"\nalong = "x"\nfriction = 0.3\nvelocity = [0, 0.02, 0]\n')
            grip = 2 * 0.6 * force
            most = math.atan(0.3) + math.asin(0.3 * weight / grip / math.hypot(1, 0.3))
            verdict = json.loads(run("-", "--json", text=phone).stdout)
            self.assertAlmostEqual(verdict["margin"], most, 6)
            for part, sticks in ((0.99, True), (1.01, False)):
                twist = f"{math.sin(part * most)} {math.cos(part * most)} 0"
                verdict = json.loads(run("-", "--twist", twist, "--json", text=phone).stdout)
                self.assertEqual(verdict["sticks"], sticks)
                self.assertAlmostEqual(abs(verdict["margin"]), 0.01 * most, 6)

    def test_a_cut_ends_where_the_cone_does(self):
        text = without(square(("velocity = [-0.01, 0, 0]       # m/s", "velocity = [-0.01, 0, 0.0]"),
                              ("planar = true", 'planar = true\npressure = "even"')),
                       "south", "north")
        vary = ("--facets", "8", "--vary", "east.velocity[1]=-0.03:0.03")
        cut = self.answer(*vary, text=text)
        self.assertTrue(cut["exact"])
        self.assertEqual([r["sticks"] for r in cut["ranges"]], [False, True, False])
        low, high = cut["ranges"][1]["from"], cut["ranges"][1]["to"]
        self.assertAlmostEqual(low, -high, 9)
        for vy, sticks in ((high * (1 - 1e-8), True), (high * (1 + 1e-8), False)):
            verdict = self.answer("--twist", f"-0.01 {vy:.17g} 0", "--facets", "8", text=text)
            self.assertEqual(verdict["sticks"], sticks)

    def test_a_number_that_has_no_segments_is_cut_by_bisection(self):
        slide = SOURCE / "fixtures/scenes/straight_slide.toml"
        cut = json.loads(run(slide, "--facets", "8", "--vary", "wall.turn=-60:60", "--json").stdout)
        self.assertFalse(cut["exact"])
        self.assertEqual([r["sticks"] for r in cut["ranges"]], [False, True, False])
        self.assertAlmostEqual(cut["ranges"][1]["from"], -22.5, 2)  # half a facet's angle
        self.assertAlmostEqual(cut["ranges"][1]["to"], 22.5, 2)
        self.assertEqual(cut["ranges"][0]["changing"], ["wall.1", "wall.2"])
        text = square(("planar = true", 'planar = true\nfacets = "round"'))
        low = self.answer("--vary", "east.velocity[1]=-0.03:0.03", "--pusher", "east", text=text)
        self.assertEqual([r["sticks"] for r in low["ranges"]], [False, True, False])
        self.assertLess(abs(low["ranges"][1]["to"] - 0.9 * 0.01), 2e-3)

    def test_a_pusher_that_leaves_does_not_slip(self):
        slide = SOURCE / "fixtures/scenes/straight_slide.toml"
        vary = ("--vary", "wall.acceleration[0]=-0.1:0.1")
        ranges = json.loads(run(slide, *vary, "--json").stdout)["ranges"]
        self.assertEqual([(r["breaks"], r["sticks"]) for r in ranges], [(False, False), (True, True)])
        self.assertIn("object stays", run(slide, *vary).stdout)

    def test_a_cut_leaves_other_pushers_out(self):
        vary = ("--vary", "east.velocity[1]=-0.03:0.03", "--pusher", "east", "--pressure", "even")
        all_three = self.answer(*vary, text=square())
        alone = self.answer(*vary, text=without(square(), "south", "north"))
        self.assertEqual(all_three["ranges"], alone["ranges"])
        self.assertTrue(any(r["sticks"] for r in alone["ranges"]))

    def test_the_ends_of_a_cut_have_the_push_as_break_finds_it(self):
        slide = SOURCE / "fixtures/scenes/straight_slide.toml"
        vary = "wall.acceleration[1]=-0.3:0.3"
        cut = json.loads(run(slide, "--vary", vary, "--pressure", "rigid", "--json").stdout)
        wrench = cut["ranges"][1]["at_to"]["wrench"]
        at = cut["ranges"][1]["to"] * (1 - 1e-6)
        text = slide.read_text().replace("acceleration = [0.1, 0, 0]",
                                         f"acceleration = [0.1, {at:.17g}, 0]")
        self.assertIn(f"{at:.17g}", text)
        there = json_of("break", "-", text='pressure = "rigid"\n' + text)
        for mine, theirs in zip(wrench, there["force"] + there["moment"]):
            self.assertAlmostEqual(mine, theirs, 3)
        picture = run(slide, "--vary", vary, "--pressure", "rigid", "--format", "svg").stdout
        ElementTree.fromstring(picture)
        self.assertIn("wall sticks", picture)

    def test_the_least_grip_in_space_is_a_cut_along_the_grip(self):
        slide = SOURCE / "fixtures/scenes/straight_slide.toml"
        cut = json.loads(run(slide, "--vary", "*.grip_force=2:30", "--pressure", "rigid",
                             "--facets", "8", "--json").stdout)
        self.assertTrue(cut["exact"])
        self.assertEqual([r["sticks"] for r in cut["ranges"]], [False, True])
        self.assertAlmostEqual(cut["ranges"][1]["from"], 6.54, 9)  # half the weight over 2 mu

    def test_the_size_of_a_twist_does_not_matter_up_to_the_largest_numbers(self):
        margins = [self.answer("--pusher", "east", "--twist", f"-{k} {k} 0", text=square())["margin"]
                   for k in ("1", "1e300", "1e-300")]
        self.assertLess(margins[0], 0)
        self.assertAlmostEqual(margins[0], margins[1], 12)
        self.assertAlmostEqual(margins[0], margins[2], 12)

    def test_scenes_in_space_are_cut(self):
        result = run(SOURCE / "fixtures/scenes/straight_slide.toml", "--vary",
                     "wall.acceleration[1]=-0.3:0.3")
        self.assertEqual(result.returncode, 0)
        self.assertIn("wall sticks for wall.acceleration[1] of -0.0406 to 0.02 m/s^2", result.stdout)
        both = run(SQUARE, "--pusher", "east", "--vary", "east.velocity[1]=0:1", "--twist", "1 0 0")
        self.assertEqual(both.returncode, 2)

    def test_a_sliver_between_two_samples_is_no_interval(self):
        pad = '[[finger]]\nname = "{0}"\nshape = "rectangle"\nsize = "12 x 8 mm"\non = "{1}z"\nfriction = 0.7\ngrip_force = 25\n'
        bar = 'gravity = [0, -9.81, 0]\n[object]\nmass = 0.063\nbox = "120 x 22 x 14 mm"\n' + pad.format("a", "+") + pad.format("b", "-") + (
            '[[pusher]]\nname = "edge"\nshape = "line"\non = "-x"\nalong = "z"\ncenter = [4e-3, 0]\nfriction = 0.3\nvelocity = [0.01, 0, 0]\n')
        vary = ("--vary", "edge.velocity[1]=-10:10 mm/s")
        slivers = [r for r in json.loads(run("-", *vary, "--json", text=bar).stdout)["ranges"] if r["to"] - r["from"] < 2e-5]
        told = run("-", *vary, text=bar).stdout
        self.assertEqual(told.count("noise"), len(slivers))
        self.assertIn("edge sticks for edge.velocity[1] of -0.01 to 0.01 m/s.", told)

    def test_what_pads_leave_of_a_slip_is_none(self):
        """A point that pushes with half the friction it has sticks all along, whatever the rounds leave of a motion."""
        pads = {"shape": "disc", "radius": 0.008766369254305406, "points": 6, "friction": 0.5489217078360649, "grip_force": 21.795447824321013}
        text = (table("", gravity=[0, -9.81, 0]) + table("[object]", mass=1, box=[0.1, 0.05010378401210819, 0.06607844116497395]) +
                finger("a", on="+z", **pads) + finger("b", on="-z", **pads) +
                pusher("w", "point", center=[-0.05, 0.016994527147349284, 0], normal=[1, 0, 0], friction=0.6793166147014473,
                       acceleration=[0.5, 0, 0]))
        found = self.answer("--vary", "w.acceleration[1]=-0.6:0.6", text=text)
        self.assertEqual([(one["from"], one["to"], one["sticks"]) for one in found["ranges"]], [(-0.6, 0.6, True)])

    def test_what_a_scene_in_space_is_told_to_cut_cuts_it(self):
        for text, key in ((square(), "velocity"), (square().replace("velocity", "acceleration"), "acceleration")):
            said = " ".join(run("-", "--pusher", "east", text=text.replace("planar = true", "gravity = [0, 0, 1]")).stderr.split())
            given = re.search(r'--vary, such as "(east\.%s\[1\]=.*?)"' % key, said)
            self.assertTrue(given, said)
            cut = run("-", "--pusher", "east", "--pressure", "even", "--vary", given[1], text=text)
            self.assertIn(f"east sticks for east.{key}[1] of", cut.stdout)

    def test_mistyped_twists_are_refused(self):
        for twist in ("1 2", "1 2 x", "0 0 0", "", "1 2 3 4", "nan 0 0"):
            result = run(SQUARE, "--pusher", "east", "--twist", twist)
            self.assertEqual(result.returncode, 2, twist)
            self.assertIn("--twist", result.stderr)


main()
