"""lcpush design: the choice with the widest margin, against closed forms, random designs and replays. [T.21]

    test_design.py TOOL ROOT [--all]      with --all 50 scenes of 2,000 random designs and 1,000 replays"""
import itertools
import json
import math
import random
import sys
import xml.etree.ElementTree as ElementTree

from tool import SCENES, SOURCE, ToolTest, json_of, main, run

from scene_tables import table
from test_tolerance import ALL, Push, slide

DEEP = "--all" in sys.argv
NARROW, TIPS = SOURCE / "docs/guide/narrow_wall.toml", SOURCE / "docs/guide/fingertips.toml"
RANGES = {"wall.shift[0]": (-0.01, 0.01), "wall.shift[1]": (-0.01, 0.01), "wall.friction": (0.1, 0.8), "*.grip_force": (5, 60),
          "left.friction": (0.1, 0.9)}


def design(scene, *choices, words=()):
    return json_of("design", scene, *(word for one in choices for word in ("--choose", one)), *words)


def closed_form(mu_wall, mu, force, mass):
    target, low, high = 2 * mu_wall * mu * force / (mass * 9.81), 0, 1
    for _ in range(60):
        e = (low + high) / 2
        low, high = (e, high) if (1 + e) < target * (1 - e) ** 3 else (low, e)
    return low


def fence(width=0.1, depth=0.03, friction=0.0, c=0.02):
    """A plate that two soft points ride on, whose ellipsoid of friction has the length c, and an edge along its lower face."""
    fingers = "".join(table("[[finger]]", name=name, center=[0, 0, z], normal=[0, 0, -1 if z > 0 else 1], friction=0.5, grip_force=20,
                            shape="point", torsion_radius=c, points_on="object") for name, z in (("left", 0.005), ("right", -0.005)))
    return table("", planar=True) + table("[object]", mass=0.2, box=[width, depth, 0.01]) + fingers + table(
        "[[pusher]]", name="fence", shape="line", on="-y", along="x", friction=friction, velocity=[0, 1e-4, 0])


class Funnel(ToolTest):
    def funnel(self, text, box, *words, status=0):
        result = run("design", self.file("f.toml", text), "--from-box", box, "--json", "--seconds", 600, *words)
        self.assertEqual(result.returncode, status, result.stderr)
        return json.loads(result.stdout)

    def test_an_edge_without_friction_aligns_as_the_integral_over_the_turn_says(self):
        for width, depth, c, angle in ((0.1, 0.03, 0.02, 0.349), (0.06, 0.05, 0.01, 0.2), (0.06, 0.05, 0.01, 0.33), (0.08, 0.04, 0.015, 0.36)):
            answer = self.funnel(fence(width, depth, c=c), f"0 0 {angle}")
            rho, e = math.hypot(width, depth) / 2, math.atan2(depth, width)
            # A corner at rho and the angle e + s goes (c^2 + q^2) / q ds, q = rho cos(e + s) its arm.
            steps = 20000
            way = sum((c * c + q * q) / q for q in (rho * math.cos(e + angle * (k + 0.5) / steps) for k in range(steps))) * angle / steps
            for push in (answer["pushes"][0], answer["pushes"][-1]):
                self.assertLess(abs(push["way"] / way - 1), 0.001)
            self.assertAlmostEqual(answer["along"][1], 0, 9)

    def test_what_slips_off_its_place_once_it_is_flush(self):
        """A wall of little friction lets the weight slip, as `move` has it; a heavy box turns off a rough one."""
        block = (SOURCE / "docs/check/block.toml").read_text()
        slippery = block.replace("friction = 0.3\nvelocity", "friction = 0.1\nvelocity")
        answer = self.funnel(slippery, "0.001 0.001 0")
        moved = json_of("move", "-", "--time", 1, text=slippery)["frames"][-1]["position"]
        self.assertTrue(answer["stays"])
        self.assertAlmostEqual(answer["drift"], moved[1] / moved[0], delta=0.002)
        self.assertLess(answer["drift"], -0.1)
        heavy = block.replace("120 g", "500 g").replace("2.9 N", "4.5 N").replace("friction = 0.3\nvelocity", "friction = 0.9\nvelocity")
        off = self.funnel(heavy, "0.001 0.001 0", status=1)
        self.assertEqual((off["stays"], off["flush"], off["capture_known"]), (False, False, False))
        self.assertEqual(self.funnel(block, "0.001 0.001 0")["drift"], 0)

    def test_it_turns_to_the_edge_while_the_corner_is_before_the_middle_of_friction(self):
        for width, depth, friction in ((0.1, 0.03, 0), (0.04, 0.08, 0.5)):
            low, high = self.funnel(fence(width, depth, friction), "0 0 0.1")["capture"]
            self.assertAlmostEqual(high, math.atan(width / depth), delta=4e-3)
            self.assertAlmostEqual(low, -high, delta=1e-6)
        self.assertFalse(self.funnel(fence(0.04, 0.08), "0 0 0.5", status=1)["flush"])

    def test_the_same_motion_as_move_says_and_a_mirror_image(self):
        answer = self.funnel(fence(friction=0.4), "0.001 0.002 0.2")
        low, high = answer["along"]
        self.assertAlmostEqual(low, -high, delta=1e-6)
        self.assertGreater(high, 0.002)
        self.assertAlmostEqual(answer["way"], answer["stop"] - min(push["contact"] for push in answer["pushes"]), 12)
        told = " ".join(run("design", self.file("f.toml", fence()), "--from-box", "0 2 mm 5 deg", "--goal", "10 mm 0 0").stdout.split())
        self.assertIn("The edge stops".lower(), told.lower())
        self.assertIn("from -73.", told)

    def test_a_step_without_an_answer_is_no_verdict(self):
        text = fence().replace("velocity = [0, 0.0001, 0]", "velocity = [0, 1e-12, 0]")  # beside forces of 20 N
        answer = self.funnel(text, "0 0 0.3", status=1)
        self.assertFalse(answer["capture_known"])
        self.assertIn("numerical_breakdown", [push["status"] for push in answer["pushes"]])
        told = " ".join(run("design", self.file("f.toml", text), "--from-box", "0 0 0.3").stdout.split())
        self.assertIn("It is not known whether the box ends flush with fence", told)
        sure = self.funnel(fence(), "0 0 1.4", status=1)
        self.assertEqual(({push["status"] for push in sure["pushes"]}, sure["capture_known"]), ({"solved"}, True))

    def test_what_is_no_edge_is_refused(self):
        for change, other in (("planar = true", ""), ("velocity = [0, 0.0001, 0]", "velocity = [0.0001, 0.0001, 0]"),
                              ("velocity = [0, 0.0001, 0]", "acceleration = [0, 0.1, 0]"),
                              ('shape = "line"', 'shape = "point"')):
            self.assertIn(change, fence())
            result = run("design", self.file("f.toml", fence().replace(change, other)), "--from-box", "0 0 0.1")
            self.assertEqual(result.returncode, 2, change)
            self.assertIn("fence", result.stderr)
        for words in (("--from-box", "0 0 0"), ("--from-box", "0 0 -1"), ("--goal", "0 0 0", "--choose", "fence.friction=0:1"),
                      ("--from-box", "0 0 0.1", "--goal", "0 0 0.1")):
            self.assertEqual(run("design", self.file("f.toml", fence()), *words).returncode, 2, words)


class Design(ToolTest):
    def test_straight_slides_have_the_closed_form(self):
        rng = random.Random(2)
        for k in range(5):
            mu, most, force, mass = (round(rng.uniform(*ends), 3) for ends in ((0.3, 0.9), (0.3, 0.9), (20, 40), (0.1, 0.3)))
            scene = self.file("s.toml", slide(0.2, mu, 18, mass))
            answer = design(scene, f"wall.friction=0.1:{most}", f"*.grip_force=5:{force}", "wall.shift[1]=-0.01:0.01")
            self.assertEqual(answer["choice"], {"wall.friction": most, "*.grip_force": force, "wall.shift[1]": 0})
            self.assertAlmostEqual(answer["margin"], closed_form(most, mu, force, mass), delta=1e-6)
            self.assertEqual(answer["binds"], "the box slips over wall along -y")
            alone = [closed_form(most, mu, 18, mass), closed_form(0.2, mu, force, mass), closed_form(0.2, mu, 18, mass)]
            for one, margin in zip(answer["alone"], alone):
                self.assertAlmostEqual(one["margin"], margin, delta=1e-6)
        wide = design(SCENES / "straight_slide.toml", "wall.friction=0.1:0.3")  # taken as planar
        self.assertAlmostEqual(wide["margin"], 0.2566, delta=5e-5)
        self.assertIn("planar = true", wide["scene"])

    def test_the_robust_place_of_a_narrow_wall_is_not_the_nominal_one(self):
        for path, ends, best in (("wall.center[1]", (-0.012, 0.012), -0.00534), ("wall.shift[1]", (-0.005, 0.003), -0.00044)):
            answer = design(NARROW, "{}={}:{}".format(path, *ends))
            self.assertAlmostEqual(answer["choice"][path], best, delta=1e-5)
            self.assertAlmostEqual(answer["margin"], 0.1306, delta=5e-5)
            chosen = json_of("cone", self.file("c.toml", answer["scene"]), *ALL)
            self.assertAlmostEqual(chosen["margin"], answer["margin"], delta=1e-7)
        self.assertAlmostEqual(json_of("cone", NARROW, *ALL)["margin"], 0.1112, delta=5e-5)
        both = design(NARROW, "wall.ends[0][1]=-0.012:0", "wall.ends[1][1]=-0.006:0.006")
        self.assertAlmostEqual(both["margin"], 0.2566, delta=5e-5)  # wide enough: friction alone
        width = design(NARROW, "wall.center[1]=-0.01:0.01", "wall.width=0.002:0.004")
        self.assertEqual(width["choice"]["wall.width"], 0.004)
        self.assertAlmostEqual(width["margin"], 0.1306, delta=5e-5)

    def test_random_designs_are_no_better(self):
        found = 0
        for seed in range(50 if DEEP else 8):
            rng = random.Random(seed)
            push = Push(rng)
            scene, twist = self.file("push.toml", push.text()), " ".join(map(str, push.twist))
            chosen = rng.sample(sorted(RANGES), rng.choice([1, 2, 3]))
            answer = design(scene, *("{}={}:{}".format(path, *RANGES[path]) for path in chosen), words=("--push", twist))
            margin = answer["margin"]
            found += margin > 0
            sure = (1 - margin * (1 + 1e-6) - 1e-7, 1 + margin * (1 + 1e-6) + 1e-7)
            for _ in range(2000 if DEEP else 100):
                values = {path: rng.uniform(*RANGES[path]) for path in chosen}
                at, places = dict(push.middle), push.places
                at.update({k: v for k, v in values.items() if k in at})
                at["left.grip_force"] = values.get("*.grip_force", at["left.grip_force"])
                by = [values.get(f"wall.shift[{axis}]", 0) for axis in (0, 1)]
                push.places = [(x + by[0], y + by[1]) for x, y in places]
                varied = [k for k in at if "gravity" not in k and "force[" not in k and k != "right.grip_force"]
                slips = False
                for factors in itertools.product(sure, repeat=len(varied)):
                    corner = {**at, **{k: at[k] * f for k, f in zip(varied, factors)}}
                    corner["right.grip_force"] = corner["left.grip_force"]
                    slips = slips or push.sticks(corner) is not True
                    if slips:
                        break
                push.places = places
                if slips:
                    continue
                sets = [word for path, value in values.items() for word in ("--set", f"{path}={value}")]
                other = json_of("cone", scene, "--twist", twist, *ALL, *sets)["margin"]  # the grip has to hold it, too
                self.assertLessEqual(other or 0, margin * (1 + 1e-6) + 1e-7, (seed, values))
        self.assertGreater(found, 3)

    def test_replays_in_the_box_do_not_slip(self):
        for scene, choices in ((NARROW, ("wall.center[1]=-0.012:0.012",)), (TIPS, ("*.radius=0.002:0.015",)),
                               (NARROW, ("wall.width=0.003:0.006", "*.grip_force=10:30"))):
            answer = design(scene, *choices)
            chosen = self.file("chosen.toml", answer["scene"])
            rng, e = random.Random(5), 0.999 * answer["margin"]
            at = {}
            for parameter in ("object.mass", "wall.friction", "left.friction", "right.friction", "left.grip_force"):
                body, key = parameter.split(".")
                table = answer["scene"].split("[object]" if body == "object" else f'name = "{body}"')[1]
                at[parameter] = float(table.split(f"{key} = ")[1].split()[0])
            for k in range(334 if DEEP else 5):
                values = {p: v * rng.choice([1 - e, 1 + e, rng.uniform(1 - e, 1 + e)]) for p, v in at.items()}
                values["*.grip_force"] = values.pop("left.grip_force")
                sets = [word for p, v in values.items() for word in ("--set", f"{p}={v}")]
                solved = json_of("solve", chosen, *sets)
                self.assertEqual(solved["status"], "solved")
                modes = {c["mode"] for c in solved["contacts"] if c["body"] == "wall"}
                self.assertLessEqual(modes, {"stick"}, (scene, values))
                if k > 0:
                    continue
                motion = json_of("move", chosen, "--time", "0.5", *sets)
                place = motion["frames"][-1]["position"]
                self.assertEqual(motion["end"], "time")
                self.assertAlmostEqual(place[0], 0.005, delta=3e-5)
                self.assertAlmostEqual(place[1], 0, delta=1e-4)

    def test_choices_in_which_nothing_is_linear(self):
        for path, low, high in (("*.radius", 0.002, 0.015), ("left.radius", 0.002, 0.015), ("wall.turn", -10, 10)):
            answer = design(TIPS, f"{path}={low}:{high}")
            for k in range(9):
                other = json_of("cone", TIPS, "--set", f"{path}={low + k * (high - low) / 8}", *ALL)["margin"]
                self.assertLessEqual(other or 0, answer["margin"] + 1e-6, (path, k))
        self.assertGreater(answer["margin"], 0.37)

    def test_what_is_said(self):
        words = ("design", NARROW, "--choose", "wall.center[1]=-0.012:0.012", "--choose", "*.grip_force=10:40")
        answer = json_of(*words)
        self.assertEqual(list(answer), ["choice", "margin", "binds", "alone", "warnings", "scene"])
        self.assertEqual([list(one) for one in answer["alone"]], 2 * [["path", "value", "margin"]])
        text = run(*words)
        self.assertEqual(text.returncode, 0)
        self.assertIn("\nWith wall.center[1] = ", text.stdout)
        self.assertLessEqual(len(text.stdout.splitlines()), 20)
        self.assertLessEqual(max(map(len, text.stdout.splitlines())), 80)
        self.assertEqual(run(*words, "--format", "toml").stdout, answer["scene"])
        self.assertEqual(ElementTree.fromstring(run(*words, "--format", "svg").stdout).tag, "{http://www.w3.org/2000/svg}svg")
        asked = run(*words, "--tolerance", "*.friction=60%")
        self.assertEqual(asked.returncode, 1)
        self.assertIn("less than was asked", " ".join(asked.stdout.split()))
        self.assertEqual(run(*words, "--tolerance", "*.friction=2%").returncode, 0)
        turned = json_of("design", TIPS, "--push", "0.01 0.002 -0.1", "--choose", "wall.friction=0.3:0.5")
        replay = json_of("cone", self.file("t.toml", turned["scene"]), "--twist", "0.01 0.002 -0.1", *ALL)
        own = json_of("cone", self.file("t.toml", turned["scene"]), *ALL)
        self.assertEqual((own["margin"], own["sticks"]), (replay["margin"], replay["sticks"]))
        nothing = run("design", NARROW, "--choose", "wall.center[1]=0.002:0.01")
        self.assertEqual(nothing.returncode, 1)
        self.assertIn("Nothing sticks in these ranges; the nearest is wall.center[1] = 0.002, where the box turns about wall.1",
                      " ".join(nothing.stdout.split()))

    def test_a_margin_of_all_that_is_not_known(self):
        """Near 100 per cent masses and frictions are none, which no scene has."""
        for choice, tolerance in (("*.radius=0.002:0.015", "object.mass=0.1:0.3"), ("wall.friction=0.1:0.9", "object.mass=50%")):
            found = json_of("design", TIPS, "--choose", choice, "--tolerance", tolerance)
            self.assertGreater(found["margin"], 0.999)

    def test_a_choice_of_many_is_no_worse_than_one_of_them_alone(self):
        for words in (("*.shift[0]=-0.02:0.02", "wall.angular_velocity[2]=-0.3:0.3"), ("wall.turn=-20:20", "wall.velocity[1]=-0.004:0.004")):
            found = json_of("design", NARROW, *(part for word in words for part in ("--choose", word)))
            self.assertGreaterEqual(found["margin"], max(one["margin"] for one in found["alone"]) * (1 - 1e-6), words)
        self.assertGreater(json_of("design", NARROW, "--choose", "*.shift[0]=-0.02:0.02", "--choose",
                                   "wall.angular_velocity[2]=-0.3:0.3")["margin"], 0.16)

    def test_a_wall_within_the_object_is_told(self):
        words = ("design", NARROW, "--choose", "wall.center[0]=-0.03:-0.01")
        self.assertEqual([warning["code"] for warning in json_of(*words)["warnings"]], ["outside_object"])
        self.assertIn("as chosen, pusher", run(*words).stderr)

    def test_a_choice_that_leaves_the_plane_of_symmetry_is_refused(self):
        """One pad alone moves aside: then the grip turns the bar about y, which no motion in the plane shows."""
        pad = {"shape": "rectangle", "size": [0.02, 0.012], "center": [0.025, 0], "friction": 0.4, "grip_force": 40}
        bar = self.file("bar.toml", table("", gravity=[0, -9.81, 0]) + table("[object]", mass=0.45, box=[0.12, 0.03, 0.016]) +
                        table("[[finger]]", name="left", on="+z", **pad) + table("[[finger]]", name="right", on="-z", **pad) +
                        table("[[pusher]]", name="wall", shape="line", on="-x", along="y", length=0.03, friction=0.3, velocity=[0.005, 0, 0]))
        refused = run("design", bar, "--choose", "left.center[0]=-0.04:0.04")
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertIn("with -0.04 the scene is no longer its own image across z", " ".join(refused.stderr.split()))
        self.assertIn("No grip force holds the box", run("hold", bar, "--set", "left.center[0]=-0.04").stdout)
        self.assertEqual(run("design", bar, "--choose", "left.friction=0.2:0.6").returncode, 0)

    def test_mistakes(self):
        for choice, said in (("wall.width=-0.02:0.01", "a width is larger than 0"), ("wall.fricton=0.1:0.5", 'did you mean "wall.friction"'), ("wall.friction=0.5:0.1", "the smaller number comes first"),
                             ("wall.friction=0.3:0.3", "nothing to choose"), ("wall.friction=0.3", "write PATH=FROM:TO"),
                             ("wall.friction=a:b", '"a" is not a number'), ("wall.friction=-1:0.5", "friction must be >= 0"),
                             ("wall.points=2:5", "no place, size or strength"), ("left.grip_force=10:30", "both jaws share one grip_force")):
            refused = run("design", NARROW, "--choose", choice)
            self.assertEqual((refused.returncode, refused.stdout), (2, ""), choice)
            self.assertIn(said, " ".join(refused.stderr.split()))
        self.assertIn("says what may be chosen", run("design", NARROW).stderr)
        self.assertIn("wall is as wide as its face", run("design", TIPS, "--choose", "wall.width=0.004:0.03").stderr)
        twice = run("design", NARROW, "--choose", "wall.center[1]=0:1", "--choose", "wall.ends[0][1]=0:1")
        self.assertIn("chosen twice", twice.stderr)
        point = run("design", SCENES / "straight_slide_point.toml", "--choose", "wall.friction=0.1:0.5")
        self.assertIn("no design is known: the pusher presses at one place", " ".join(point.stderr.split()))


if __name__ == "__main__":
    main()
