"""lcpush move: text, JSON, CSV, a picture and a page; frames that obey the laws as printed."""
import csv
import io
import json
import math
import pathlib
import random
import re
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import tool
from tool import SCENES, command, main, unwrapped

from motion_frames import faults
from random_scenes import random_scene
from scene_tables import finger, pusher, table

run = command("move")
PIVOT, SLIDE = SCENES / "pivot.toml", SCENES / "straight_slide.toml"
MODES = {"stick", "slide", "separate", "beside", "behind", "no_line", "away"}


def answer(*words, **more):
    result = run(*words, "--json", **more)
    return json.loads(result.stdout), result.returncode


class Move(unittest.TestCase):
    def test_says_first_where_it_goes(self):
        result = run(SLIDE)
        self.assertEqual(result.returncode, 0)
        self.assertIn("The box slides 50 mm along +x in 1 s.", result.stdout)
        self.assertLess(max(map(len, result.stdout.splitlines())), 81)
        self.assertIn("pivots", run(PIVOT).stdout.split("\n\n")[1])
        self.assertIn("rolls 143 degrees", run(SCENES / "rolling.toml").stdout)

    def test_what_slides_up_and_down_again_loses_to_friction_on_both_ways(self):
        up, down = 9.81 * (0.5 + 0.2 * 0.75 ** 0.5), 9.81 * (0.5 - 0.2 * 0.75 ** 0.5)
        for across in (0, 1e-5): # so that it nearly stops, and does
            ramp = (table("", gravity=[4.905, -9.81 * 0.75 ** 0.5, 0]) +
                    table("[object]", mass=1, box=[0.2, 0.02, 0.2], velocity=[-1, 0, across]) +
                    finger("slope", "rectangle", on="-y", along="x", size=[0.2, 0.2], friction=0.2, points_on="object"))
            for frames in (3, 21):
                end, error = answer("-", "--time", 1, "--frames", frames, text=ramp)[0]["frames"][-1]["position"][0], 2e-6
                self.assertAlmostEqual(end, down * (1 - 1 / up) ** 2 / 2 - 1 / (2 * up), delta=error + 5e-6 * (across > 0))

    def test_what_spins_to_and_fro_in_the_grip_does_so_both_ways(self):
        for shape in (dict(shape="ring", radius=0.02), dict(shape="point", torsion_radius=0.02)):
            pads = table("", gravity=[0, 0, 0]) + table("[object]", mass=0.5, inertia=[0.001] * 3, moment=[0, 0, 0.08],
                                                        angular_velocity=[0, 0, -20.0])
            for name, side in (("l", 1), ("r", -1)):
                pads += table("[[finger]]", name=name, center=[0, 0, side * 0.01], normal=[0, 0, -side], friction=0.5, grip_force=2.0, **shape)
            for frames in (3, 21):
                r = answer("-", "--time", 0.4, "--frames", frames, text=pads)[0]["frames"][-1]["rotation"]
                self.assertAlmostEqual(math.atan2(r[3], r[0]), -5 / 3 + 20 * (0.4 - 1 / 6) ** 2, delta=1e-5, msg=shape)

    def test_a_book_that_rocks_is_told_to_go_to_and_fro(self):
        book = (table("", gravity=[0, 0, -9.81]) + table("[object]", mass=1, box=[0.04, 0.15, 0.24]) +
                finger("shelf", "rectangle", on="-z", size=[0.04, 0.15], points_on="object", friction=0.4) +
                pusher("finger", "point", on="-x", center=[0, 0.1], friction=0.3, velocity=[0.02, 0, 0], until=1))
        self.assertIn("turns to and fro, by ", unwrapped(run("-", "--time", 3, "--seconds", 600, text=book).stdout))

    def test_a_push_that_only_gets_going_is_not_the_one_that_a_motion_takes(self):
        first = lambda name: re.search(r"^  0 .*?(\S+)$", run(SCENES / name).stdout, flags=re.M)[1]
        self.assertEqual([first("lever.toml"), first("straight_slide.toml")], ["-", "20.12"])

    def test_flat_pads_on_a_round_side_are_told_to_be_lines(self):
        for place, words in ((dict(center=[0.033, 0, 0.02], size=[0.02, 0.025]), 'give shape = "line"'),
                             (dict(center=[0.06, 0, 0.02], size=[0.02, 0.025]), "[[face]]s")):
            bottle = (table("[object]", mass=0.5, cylinder_radius=0.033, cylinder_length=0.2, axis="z") +
                      finger("pad", "rectangle", normal=[-1, 0, 0], friction=0.6, grip_force=25, **place))
            self.assertIn(words, unwrapped(run("-", text=bottle).stderr))

    def test_frames_obey_the_laws_as_they_are_printed(self):
        texts = {name: (SCENES / f"{name}.toml").read_text()
                 for name in ("straight_slide", "rolling", "soft_fingers", "three_finger_hand", "tipping")}
        # In some of them points leave their faces.
        texts |= {f"random {seed}": random_scene(seed) for seed in (1, 2, 10, 16, 72, 143, 157)}
        for name, text in texts.items():
            step = 0.001 if "random" in name else 0.005
            result = run("-", "--step", step, "--time", 100 * step, "--frames", 101, "--json", text=text)
            motion = json.loads(result.stdout)
            self.assertGreater(len(motion["frames"]), 30, name)
            self.assertEqual(faults(text, motion), [], name)

    def test_the_check_of_frames_sees_what_is_planted(self):
        text = PIVOT.read_text()
        printed, code = answer(PIVOT, "--time", 0.5, "--step", 0.005, "--frames", 101)
        self.assertEqual((code, printed["status"], printed["end"]), (0, "solved", "time"))
        self.assertEqual((len(printed["frames"]), faults(text, printed)), (101, []))
        for plant, fault in (
                (lambda f: f["twist"].__setitem__(0, f["twist"][0] + 1e-3), "Newton"),
                (lambda f: f["twist"].__setitem__(5, f["twist"][5] + 1e-2), "Euler"),
                (lambda f: f["position"].__setitem__(1, f["position"][1] + 1e-6), "the way"),
                (lambda f: f["rotation"].__setitem__(1, f["rotation"][1] + 1e-6), "the turn"),
                (lambda f: f["contacts"][0].__setitem__("friction_force", [9, 9, 0]), "cone"),
                (lambda f: f["contacts"][-1].__setitem__(
                    "friction_force", [-x for x in f["contacts"][-1]["friction_force"]]), "dissipate"),
                (lambda f: f["contacts"][-1].__setitem__("gap", -1e-6), "inside"),
                (lambda f: f["contacts"][-1].__setitem__("gap", 1e-4), "through a gap"),
                (lambda f: f["contacts"][-1].__setitem__("velocity", [0, 1, 0]), "what leaves it"),
                (lambda f: f["bodies"][0]["force"].__setitem__(2, f["bodies"][0]["force"][2] - 1), "closes")):
            spoilt = json.loads(json.dumps(printed))
            plant(spoilt["frames"][40])
            self.assertTrue(any(fault in words for words in faults(text, spoilt)), fault)

    def test_a_point_that_ends_beside_its_face_has_no_gap(self):
        result = run("-", "--step", 0.001, "--time", 0.1, "--frames", 101, "--json", text=random_scene(72))
        frames = json.loads(result.stdout)["frames"]
        left = [contact for frame, after in zip(frames, frames[1:])
                for contact, then in zip(frame["contacts"], after["contacts"])
                if contact["mode"] != "beside" and then["mode"] == "beside"]
        self.assertGreater(len(left), 0)
        self.assertEqual({contact["gap"] for contact in left}, {None})

    def test_json_has_its_keys(self):
        printed, _ = answer(SLIDE, "--frames", 6)
        for key in ("status", "end", "time", "steps", "step", "frames", "events", "phases",
                    "penetration", "residual", "error", "tolerance", "warnings"):
            self.assertIn(key, printed)
        for frame, time in zip(printed["frames"], (0, 0.2, 0.4, 0.6, 0.8, 1)):
            self.assertAlmostEqual(frame["time"], time, delta=1e-12)
        first = printed["frames"][0]
        self.assertEqual(first["position"], [0, 0, 0])
        self.assertEqual(first["rotation"], [1, 0, 0, 0, 1, 0, 0, 0, 1])
        for frame in printed["frames"]:
            for contact in frame["contacts"]:
                self.assertIn(contact["mode"], MODES)
        self.assertLessEqual(printed["residual"]["max"], 1e-9)
        self.assertLessEqual(printed["penetration"], 1e-9)
        self.assertLessEqual(printed["error"], printed["tolerance"])

    def test_csv_says_what_json_says(self):
        rows = list(csv.DictReader(io.StringIO(run(PIVOT, "--frames", 5, "--format", "csv").stdout)))
        frames = answer(PIVOT, "--frames", 5)[0]["frames"]
        self.assertEqual(len(rows), 5)
        for row, frame in zip(rows, frames):
            self.assertEqual([float(row[k]) for k in ("time", "x", "y", "z")],
                             [frame["time"], *frame["position"]])
            self.assertEqual([float(row[f"edge.f{k}"]) for k in "xyz"],
                             frame["bodies"][2]["force"])
            self.assertEqual(row["left.1.mode"], frame["contacts"][0]["mode"])
            self.assertEqual(float(row["r21"]), frame["rotation"][3])

    def test_the_picture_is_an_image_with_words(self):
        svg = ElementTree.fromstring(run(PIVOT, "--format", "svg").stdout)
        text = "".join(svg.itertext())
        self.assertIn("pivots", text)
        self.assertEqual(svg.get("role"), "img")
        ghosts = [e for e in svg.iter() if e.get("class") == "ghost"]
        self.assertEqual(len(ghosts), 6)

    def test_the_page_plays_by_itself(self):
        result = run(PIVOT, "--format", "html", "--frames", 21)
        page = result.stdout
        root = ElementTree.fromstring(page.split("<script>")[0].replace("<!DOCTYPE html>", "") +
                                      "</body></html>")
        moments = [e for e in root.iter() if (e.get("class") or "").split()[:1] == ["moment"]]
        self.assertEqual(len(moments), 21)
        self.assertEqual(sum("shown" in e.get("class") for e in moments), 1)
        data = json.loads(next(e for e in root.iter() if e.get("id") == "frames").text)
        self.assertEqual(len(data), 21)
        self.assertEqual(len(data[0]["cells"]), 3 * 3)
        for part in ("https://", "src=\"/", "<link rel=\"stylesheet"):
            self.assertNotIn(part, page.replace("http://www.w3.org/2000/svg", ""))
        for needed in ("prefers-color-scheme: dark", "aria-label=\"Time\"", "width=device-width",
                       "default-src 'none'", "aria-valuetext"):
            self.assertIn(needed, page)

    def test_names_stay_names_on_the_page(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "odd.toml")
            path.write_text(SLIDE.read_text().replace('"wall"', '"</script><b>&"'))
            page = run(path, "--format", "html", "--frames", 3).stdout
            self.assertEqual(page.count("</script>"), 2)
            self.assertNotIn("<b>&", page)

    def test_wide_pads_go_on_where_rounding_tilts_them(self):
        # Two pads and an edge each hold the block's turn about y: a gap that differs by 1e-14 m along
        # the edge may not say which of its points presses.
        for mass, center, friction, pads in ((120, -10, 0.4, 0.8), (161.6, 2.875, 0.3, 0.52),
                                             (133.7, -14.738, 0.75, 0.757), (386.9, -9.214, 0.61, 0.62)):
            text = table("", gravity=[0, -9.81, 0])
            text += table("[object]", mass=f"{mass} g", box=["80 mm", "40 mm", "20 mm"])
            for face in ("+z", "-z"):
                text += finger(f"at {face}", "rectangle", on=face, size=["20 mm", "10 mm"], friction=pads,
                               grip_force="20 N")
            text += pusher("edge", "line", on="-x", along="z", center=[f"{center} mm", 0], friction=friction,
                           acceleration=[0.1, 0, 0])
            motion = json.loads(run("-", "--time", 0.2, "--json", text=text).stdout)
            self.assertEqual((motion["end"], motion["by_pyramids"]), ("time", 0), text)
            self.assertLess(motion["steps"], 300)

    def test_ends_where_it_is_told_to(self):
        printed, code = answer(SLIDE, "--stop-after", 0.0123)
        self.assertEqual((printed["end"], code), ("distance", 0))
        self.assertAlmostEqual(printed["frames"][-1]["position"][0], 0.0123, delta=1e-9)
        printed, code = answer(SLIDE, "--time", 2)
        self.assertEqual((printed["end"], printed["status"], code), ("lost", "does_not_hold", 1))
        self.assertIn(printed["end_body"], ("left", "right"))
        self.assertGreater(len(printed["frames"]), 40)
        self.assertIn("loses hold of it", unwrapped(run(SLIDE, "--time", 2).stdout))

    def test_a_box_pushed_against_a_stop_jams_and_is_not_called_a_failure(self):
        """A stop that yields to the push is none."""
        def end(motion, **stop):
            hand = "[gripper]\njaws = \"independent\"\n" if stop else ""
            text = ("planar = true\ngravity = [0, -9.81, 0]\n" + hand + "[object]\nmass = 0.5\nbox = [0.08, 0.04, 0.04]\n" +
                    finger("floor", "line", friction=0.3, on="-y", along="x", points_on="object") +
                    finger("stop", "point", friction=0.3, on="+x", **stop) +
                    pusher("hand", "point", friction=0.3, on="-x") + motion + "\n")
            printed = json.loads(run("-", "--json", "--time", 0.1, text=text).stdout)
            return printed["end"], printed["status"]
        for motion in ("velocity = [0.01, 0, 0]", "acceleration = [0.1, 0, 0]"):
            self.assertEqual(end(motion), ("failed", "ray"))
            self.assertEqual(end(motion, grip_force=1), ("time", "solved"))

    def test_what_a_step_undoes_is_no_event(self):
        text = "facets = 8\n" + (SCENES / "dropped.toml").read_text()
        printed = json.loads(run("-", "--json", text=text).stdout)
        self.assertEqual([(e["contact"], e["to"]) for e in printed["events"]], [("rod.1", "separate")])

    def test_what_stands_on_a_tray_goes_with_it_and_nothing_happens(self):
        """Twelve points that stick share their forces in many ways: what ties between them let pass is no slip."""
        glass = table("[object]", mass=0.3, cylinder_radius=0.03, cylinder_length=0.14)
        tray = {"shape": "disc", "on": "-z", "radius": 0.03, "friction": 0.5}
        for acceleration, pressure in (([3, 0, 0], "pad"), ([-1.1, 1.7, 0.8], "pad"), ([0, 2.9, 0], "rigid")):
            text = f'gravity = [0, 0, -9.81]\npressure = "{pressure}"\n' + glass + pusher("tray", acceleration=acceleration, **tray)
            for words in (("--step", 0.002), ()):
                with self.subTest(acceleration=acceleration, pressure=pressure, words=words):
                    printed = json.loads(run("-", "--json", "--time", 0.4, "--seconds", 600, *words, text=text).stdout)
                    self.assertEqual((printed["events"], printed["end"]), ([], "time"))
                    self.assertLess(printed["steps"], 300)
                    for is_at, a in zip(printed["frames"][-1]["position"], acceleration):
                        self.assertAlmostEqual(is_at, 0.08 * a, delta=1e-6)

    def test_ended_early_it_has_what_there_is(self):
        result = run(SCENES / "three_finger_hand.toml", "--seconds", "0.02", "--json")
        motion = json.loads(result.stdout)
        self.assertEqual((result.returncode, motion["end"]), (1, "stopped"))
        self.assertEqual(motion["stopped"], "time")
        self.assertGreater(len(motion["frames"]), 1)
        self.assertLess(motion["frames"][-1]["time"], 0.7)
        self.assertIn("stopped after 0.02 s of processor time; what there was", result.stderr)
        motion, status = answer(SCENES / "rolling_hard_grip.toml")
        self.assertEqual((motion["end"], status), ("time", 0))
        self.assertNotRegex(run(SCENES / "rolling_hard_grip.toml").stdout, "[0-9]e-[0-9]+  ")

    def test_the_moving_picture_shows_one_moment_at_a_time(self):
        text = run(PIVOT, "--time", "0.3", "--format", "animation").stdout
        moments = [e for e in ElementTree.fromstring(text).iter() if e.get("class", "").startswith("moment")]
        delays = [float(re.search(r"delay: (-[0-9.]+)s", e.get("style"))[1]) for e in moments]
        whole = float(re.search(r"animation: moment ([0-9.]+)s infinite step-end", text)[1])
        shares = {name: float(share) / 100 * whole
                  for name, share in re.findall(r"@keyframes (\w+) .*?([0-9.]+)%, 100% { visibility: hidden", text)}
        self.assertEqual(len(moments), 41)
        self.assertEqual([e.get("class") for e in moments[-2:]], ["moment", "moment last"])
        self.assertAlmostEqual(delays[0], -whole)  # all have begun, each ends as the next one begins
        for one, two in zip(delays, delays[1:]):
            self.assertAlmostEqual(two - one, shares["moment"], 3)
        self.assertAlmostEqual(delays[-1] + shares["last"], 0, 3)
        outlines = {next(p for p in e.iter() if p.get("class") == "object").get("points") for e in moments}
        self.assertGreater(len(outlines), 35)
        self.assertIn("prefers-reduced-motion: reduce", text)

    def test_wrong_usage_says_what_to_type(self):
        for words, message in (
                (("--time", "-1"), "--time is a number between 0 and 1e+06, in seconds, such as 2.5, not"),
                (("--step", "0"), "--step is a number between 0 and 1e+06, in seconds, such as 0.001, not"),
                (("--stop-after", "far"), "in metres, such as 0.03, not \"far\""),
                (("--time", "10", "--step", "1e-7"), "makes more than the 1000000"),
                (("--step", "0.1", "--tolerance", "1e-4"), "give one of the two"),
                (("--frames", "1"), "--frames"), (("--format", "png"), "--format")):
            result = run(SLIDE, *words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(message, unwrapped(result.stderr))
            self.assertEqual(result.stdout, "")
        result = run(SCENES / "coin_from_above.toml")
        self.assertEqual(result.returncode, 2)
        self.assertRegex(unwrapped(result.stderr), r"coin_from_above.toml:\d+: finger \"table\": ")

    def test_strokes_of_one_file(self):
        text = SLIDE.read_text().replace("acceleration = [0.1, 0, 0]",
                                         "velocity = [0.01, 0, 0]\nuntil = 1")
        self.assertIn("velocity", text)
        text += ("\n[[pusher]]\nname = \"back\"\nshape = \"line\"\nends = [[0.07, -0.015, 0], "
                 "[0.07, 0.015, 0]]\nnormal = [-1, 0, 0]\nfriction = 0.3\n"
                 "velocity = [-0.01, 0, 0]\nfrom = 1\nuntil = 3\n")
        printed = json.loads(run("-", "--json", text=text).stdout)
        self.assertEqual((printed["end"], printed["time"]), ("time", 3))
        # It starts at 70 mm, meets the end face at 60 mm after 1 s, and takes it back 10 mm.
        self.assertAlmostEqual(printed["frames"][-1]["position"][0], 0, delta=1e-6)
        self.assertEqual([phase["motion"] for phase in printed["phases"]],
                         ["slide", "rest", "slide"])
        solved = tool.run("solve", "-", "--json", text=text)
        self.assertNotIn("back", solved.stdout)
        # Who is not there has no gap.
        first = printed["frames"][1]["contacts"]
        self.assertEqual({c["gap"] for c in first if c["mode"] == "away"}, {None})


class Blows(tool.ToolTest):
    def test_a_blow_with_friction_does_not_depend_on_the_steps(self):
        """A corner of a body that spins strikes a table once. The end is another program's: its own equations, steps of
        1e-6 s up to the blow, all of that at once with friction against the slip after it, and steps again."""
        scene = self.file("drop.toml", """gravity = [0.0, -9.81, 0.0]
[object]
mass = 0.3382721392173412
inertia = [0.0006012845660353452, 0.0005303484088672795, 0.0007662692372249866, 0.0, 0.0, 0.0]
velocity = [1.00200496373752, 0.041822381942961034, 0.18359151478321784]
angular_velocity = [19.496798054380942, 10.915857179304005, -5.139536263594949]
[[finger]]
name = "t"
shape = "point"
center = [0.012214684762945863, -0.047025282220560446, -0.01640446161200154]
normal = [0.0, 1.0, 0.0]
friction = 0.38143709268242126
points_on = "object"
""")
        for tolerance in (1.8e-4, 1e-5, 1e-6):
            end = self.end(scene, "--time", 0.15033252690780333, "--tolerance", tolerance)
            self.assertLess(math.dist(end, (0.1459256516, -0.0918882043, 0.0264984885)), tolerance / 10)
        rng = random.Random(4)
        for k in range(6):
            corner = [rng.uniform(-0.03, 0.03), -0.04, rng.uniform(-0.03, 0.03)]
            spun = self.file("spun.toml", f"""gravity = [0, -9.81, 0]
[object]
mass = 0.3
inertia = [6e-4, 5e-4, 7e-4, 0, 0, 0]
velocity = [{rng.uniform(-1, 1)}, {rng.uniform(-1, 0)}, {rng.uniform(-1, 1)}]
angular_velocity = {[rng.uniform(-15, 15) for _ in range(3)]}
[[finger]]
name = "t"
shape = "point"
center = {corner}
normal = [0, 1, 0]
friction = {rng.uniform(0.2, 0.8)}
points_on = "object"
""")
            coarse, fine = (self.end(spun, "--time", 0.1, "--tolerance", t) for t in (1e-5, 1e-7))
            self.assertLess(math.dist(coarse, fine), 1e-5, k)

    def end(self, scene, *words):
        return answer(scene, "--frames", 2, *words)[0]["frames"][-1]["position"]


main()
