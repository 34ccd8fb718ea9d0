"""Ranges in scenes, and what holds for every value of them: cone, hold and plan with --tolerance.

    test_tolerance.py TOOL ROOT [--all]      with --all 200 boxes of 10,000 samples instead of 20 of 300"""
import itertools
import json
import math
import operator
import random
import re
import sys

from tool import SCENES, SOURCE, ToolTest, json_of, main, run, unwrapped

UNCERTAIN = SOURCE / "docs/guide/uncertain_slide.toml"
SQUARE, SLIDE = SOURCE / "docs/guide/square.toml", SCENES / "straight_slide.toml"
DEEP = "--all" in sys.argv
BOXES, SAMPLES = (200, 10000) if DEEP else (20, 300)
SLIDE_TEXT = SLIDE.read_text().replace("gravity = [0,", "planar = true\ngravity = [0,").replace(
    'on = "-x"\nalong = "y"', "normal = [1, 0, 0]\nends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]")
ALL = ("--tolerance", "*.friction", "--tolerance", "*.grip_force", "--tolerance", "object.mass")


class Push:
    """A planar push by its own mechanics: numbers by path, places fixed."""

    def __init__(self, rng):
        u = rng.uniform
        self.facets = rng.choice([None, None, None, 8])
        self.fingers = {name: [[round(u(-0.01, 0.01), 4) for _ in range(2)] for _ in range(rng.choice([2, 3, 5]))]
                        for name in ("left", "right")}
        angle = u(0, 6)
        self.n = rng.choice([(1, 0), (0, -1), (0.6, 0.8), (-0.8, 0.6), (math.cos(angle), math.sin(angle))])
        width, h, middle = u(0.005, 0.04), -0.05, round(u(-0.01, 0.01), 4)
        self.places = [(h * self.n[0] - s * self.n[1], h * self.n[1] + s * self.n[0])
                       for s in (round(middle - width / 2, 4), round(middle + width / 2, 4))]
        self.middle = {"object.mass": round(u(0.1, 0.5), 3), "gravity[1]": rng.choice([0, -9.81, -3]),
                       "object.force[0]": round(u(-2, 2), 2), "wall.friction": round(u(0.2, 0.9), 2)}
        grip = round(u(10, 30), 1)
        for name in self.fingers:
            self.middle.update({f"{name}.friction": round(u(0.2, 0.8), 2), f"{name}.grip_force": grip})
        self.twist = [round(self.n[0] + u(-0.4, 0.4), 3), round(self.n[1] + u(-0.4, 0.4), 3), round(u(-15, 15), 2)]
        self.slips = {name: [sum(part) / len(points) for part in zip(*(self.slip_wrench(*p) for p in points))]
                      for name, points in self.fingers.items()}

    def text(self):
        m, text = self.middle, "planar = true\n" + (f"facets = {self.facets}\n" if self.facets else "")
        text += (f"gravity = [0, {m['gravity[1]']}, 0]\n[object]\nmass = {m['object.mass']}\nbox = [0.1, 0.1, 0.01]\n"
                 f"force = [{m['object.force[0]']}, 0, 0]\n")
        for name, z in (("left", 0.005), ("right", -0.005)):
            points = [[*p, z] for p in self.fingers[name]]
            text += (f'[[finger]]\nname = "{name}"\nshape = "points"\npoints = {points}\nnormal = [0, 0, {-1 if z > 0 else 1}]\n'
                     f"friction = {m[name + '.friction']}\ngrip_force = {m[name + '.grip_force']}\n")
        ends = [[x, y, 0] for x, y in self.places]
        return text + (f'[[pusher]]\nname = "wall"\nshape = "line"\nends = {ends}\npoints = 2\nnormal = [{self.n[0]}, {self.n[1]}, 0]\n'
                       f"friction = {m['wall.friction']}\nvelocity = [{self.n[0]}, {self.n[1]}, 0]\n")

    def slip_wrench(self, x, y):
        """Of a point at (x, y) under friction of one newton."""
        vx, vy = self.twist[0] - self.twist[2] * y, self.twist[1] + self.twist[2] * x
        angles = [2 * math.pi * k / self.facets for k in range(self.facets)] if self.facets else [math.atan2(vy, vx)]
        fx, fy = max(((math.cos(a), math.sin(a)) for a in angles), key=lambda d: d[0] * vx + d[1] * vy)
        return fx, fy, x * fy - y * fx

    def sticks(self, at):
        """Is what the pusher has to exert a sum of its points' extreme forces? By every three of them. None: on the verge."""
        wx, wy, wz = -at["object.force[0]"], -at["object.mass"] * at["gravity[1]"], 0
        for name, (fx, fy, turn) in self.slips.items():
            limit = at[f"{name}.friction"] * at[f"{name}.grip_force"]
            wx, wy, wz = wx + limit * fx, wy + limit * fy, wz + limit * turn
        (nx, ny), mu, rays = self.n, at["wall.friction"], []
        for (x, y), side in itertools.product(self.places, (mu, -mu)):
            fx, fy = nx - side * ny, ny + side * nx
            rays.append((fx, fy, x * fy - y * fx))
        across = {(i, j): (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
                  for (i, a), (j, b) in itertools.combinations(enumerate(rays), 2)}
        along = {pair: wx * x + wy * y + wz * z for pair, (x, y, z) in across.items()}
        best = -math.inf
        for i, j, k in itertools.combinations(range(4), 3):
            volume = sum(map(operator.mul, rays[i], across[j, k]))
            if abs(volume) > 1e-12:
                best = max(best, min(along[j, k] / volume, -along[i, k] / volume, along[i, j] / volume))
        return None if abs(best) < 1e-9 else best > 0


def slide(mu_wall, mu, force, mass):
    return SLIDE_TEXT.replace("friction = 0.5", f"friction = {mu}").replace("= 0.3\n", f"= {mu_wall}\n").replace(
        "grip_force = 20", f"grip_force = {force}").replace("mass = 0.2 ", f"mass = {mass} ").replace(
            "-0.015", "-0.15").replace("0.015, 0]]", "0.15, 0]]").replace("[0.1, 0.03,", "[0.1, 0.3,")


class Tolerance(ToolTest):
    def test_own_mechanics_finds_no_counterexample(self):
        seen = {}
        for k in range(BOXES):
            rng = random.Random(k)
            push = Push(rng)
            scene = self.file("push.toml", push.text())
            words, box = [], {}
            for path, value in push.middle.items():
                off = 0 if path == "gravity[1]" else round(rng.choice([0, 0.02, 0.1, 0.3]) * abs(value), 6)
                box[path] = box["left.grip_force"] if path == "right.grip_force" else (value - off, value + off)
                words += ["--tolerance", "{}={!r}:{!r}".format(path, *box[path])]
            answer = run("cone", scene, "--twist", " ".join(map(str, push.twist)), "--json", *words)
            self.assertIn(answer.returncode, (0, 1), answer.stderr + push.text())
            answer = json.loads(answer.stdout)
            verdict = answer["verdict"]
            seen[verdict] = seen.get(verdict, 0) + 1
            for _ in range(SAMPLES if verdict in ("always", "never") else 0):
                at = {p: rng.choice([low, high, rng.uniform(low, high)]) for p, (low, high) in box.items()}
                at["right.grip_force"] = at["left.grip_force"]
                self.assertNotEqual(push.sticks(at), verdict == "never", (k, verdict, at))
            if verdict == "may_slip" and "does not hold" not in answer["reason"]:
                self.assertIs(push.sticks({**push.middle, **answer["corner"]}), False, k)
                corner = self.file("corner.toml", answer["corner_scene"])
                self.assertIs(json_of("cone", corner, "--twist", " ".join(map(str, push.twist)))["sticks"], False, k)
            if verdict == "always" and answer["margin"]:  # and a little beyond the margin some corner slips
                far = [1 - 1.001 * answer["margin"], 1 + 1.001 * answer["margin"]]
                at = [{p: v * s if box[p][0] < box[p][1] else v for (p, v), s in zip(push.middle.items(), c)} for c in itertools.product(far, repeat=len(box))]
                same = [a for a in at if a["left.grip_force"] == a["right.grip_force"]]
                held = answer["margin"] < 0.999 and answer["holding_grip_factor"] == 0
                self.assertTrue(not held or any(push.sticks(a) is False for a in same), k)
        self.assertGreaterEqual(len(seen), 3, seen)
        self.assertEqual(seen.get("not_known", 0), 0, seen)

    def test_straight_slides_have_the_closed_form(self):
        rng = random.Random(7)
        for _ in range(20):
            mu_wall, mu = round(rng.uniform(0.3, 0.9), 3), round(rng.uniform(0.3, 0.9), 3)
            force, mass = round(rng.uniform(15, 40), 2), round(rng.uniform(0.1, 0.3), 3)
            answer = json_of("cone", self.file("slide.toml", slide(mu_wall, mu, force, mass)), *ALL)
            self.assertEqual(answer["verdict"], "always")
            target, low, high = 2 * mu_wall * mu * force / (mass * 9.81), 0, 1
            for _ in range(60):
                e = (low + high) / 2
                low, high = (e, high) if (1 + e) < target * (1 - e) ** 3 else (low, e)
            self.assertAlmostEqual(answer["margin"], low, delta=1e-6)

    def test_both_jaws_have_one_force(self):
        scene = self.file("slide.toml", SLIDE_TEXT)
        for given in (["*.grip_force=8:30"], ["left.grip_force=8:30", "right.grip_force=8:30"]):
            answer = json_of("cone", scene, *(word for one in given for word in ("--tolerance", one)))
            self.assertEqual((answer["verdict"], answer["box"]["right.grip_force"]), ("always", [8, 30]))
            self.assertLess(json_of("cone", scene, "--tolerance", "*.grip_force=6:30")["corner"]["left.grip_force"], 6.54)

    def test_a_narrow_wall_at_its_own_place(self):
        text = SLIDE_TEXT.replace("-0.015", "-0.0069").replace("0.015, 0]]", "-0.0029, 0]]")
        self.assertAlmostEqual(json_of("cone", self.file("w.toml", text), *ALL)["margin"], 0.111, delta=5e-4)

    def test_ranges_are_read_and_the_middle_is_solved(self):
        ranges = SLIDE_TEXT.replace("friction = 0.3", "friction = [0.2, 0.4]").replace(
            "mass = 0.2 ", 'mass = ["0.18 kg", "220 g"] ').replace("points = 2", "points = 2\nshift = [0, [-1e-3, 1e-3], 0]")
        scene, middle = self.file("ranges.toml", ranges), self.file("middle.toml", SLIDE_TEXT)
        solved = run("solve", scene)
        self.assertEqual(solved.stdout, run("solve", middle).stdout)
        for asked in ("solve", "pivots", "play", "export"):
            said = unwrapped(run(asked, scene, "-o", self.path / asked).stderr)
            self.assertIn("the middle of the ranges is taken, object mass = 0.2 (0.18 to 0.22)", said, asked)
        self.assertEqual(run("solve", scene, "--strict").returncode, 0)
        self.assertEqual([w["code"] for w in json_of("break", scene)["warnings"]], ["middle"])
        self.assertIn("numbers are ranges", run("solve", scene, "--certify", self.path / "c.json").stderr)
        answer = json_of("cone", scene)
        self.assertEqual(answer["box"], {"object.mass": [0.18, 0.22], "wall.friction": [0.2, 0.4], "wall.shift[1]": [-1e-3, 1e-3]})
        self.assertEqual((answer["verdict"], answer["warnings"]), ("always", []))
        wide = json_of("cone", scene, "--tolerance", "wall.friction=0.05:0.4")
        self.assertEqual((wide["verdict"], wide["corner"]["wall.friction"]), ("may_slip", 0.05))
        self.assertEqual(wide["corner_scene"], run("cone", scene, "--tolerance", "wall.friction=0.05:0.4", "--format", "toml").stdout)
        moved = json_of("solve", self.file("m.toml", SLIDE_TEXT.replace("points = 2", "points = 2\nshift = [0, 0.001, 0]")))
        typed = json_of("solve", self.file("t.toml", SLIDE_TEXT.replace("-0.015", "-0.014").replace("0.015, 0]]", "0.016, 0]]")))
        self.assertEqual(moved["bodies"], typed["bodies"])

    def test_whatever_takes_the_middle_says_so(self):
        scene, taken = self.file("slide.toml", SLIDE_TEXT), 'taken, finger "left" friction = 0.7 (0.5 to 0.9)'
        solve = ("solve", scene, "--tolerance", "*.friction=0.5:0.9")
        self.assertEqual(unwrapped(run(*solve).stderr).count(taken), 1)
        self.assertEqual([w["code"] for w in json_of(*solve)["warnings"]], ["middle"])
        for words in (["solve", "--box"], ["break"], ["move", "--time", "0.01"], ["report"], ["spread"],
                      ["sweep", "--vary", "wall.friction=0.2:0.4", "--steps", "2"]):
            said = unwrapped(run(words[0], UNCERTAIN, *words[1:], "-o", self.path / "answer").stderr)
            self.assertEqual(said.count("the middle of the ranges is taken"), 1, words)

    def test_contact_modes_of_solve(self):
        scene = self.file("slide.toml", SLIDE_TEXT)
        free = self.file("held.toml", SLIDE_TEXT.split("[[pusher]]")[0])
        pressed = self.file("pressed.toml", re.sub("acceleration = .*", "acceleration = [0, 0.1, 0]\nnormal_force = 30", SLIDE_TEXT))
        for path, words, verdict, said in (
                (scene, ["--tolerance", "*.friction=10%"], "always", "Pushed slowly, the pusher sticks for every value in the ranges; it"),
                (scene, ["--tolerance", "wall.friction=0.01:0.4"], "may_slip", "may slip: at wall.friction = 0.01 the box slips over wall"),
                (scene, ["--tolerance", "wall.friction=0.01:0.02"], "never", "sticks for no value in the ranges: the box slips over wall"),
                (scene, ["--tolerance", "left.points[0][0]=0:0.01"], "not_known", "Not known for every value in the ranges: whether it"),
                (SLIDE, ["--tolerance", "*.friction=10%"], "not_known", "proved alone of one pusher that sticks in a plane"),
                (SCENES / "two_pushers.toml", ["--tolerance", "*.friction=10%"], "not_known", "proved alone of one pusher"),
                (pressed, ["--tolerance", "object.mass=5%"], "not_known", "the pusher's force is given"),
                (free, ["--tolerance", "object.mass=0.1:0.4"], "always", "The grasp holds for every object.mass from 0.1 to 0.4: worst at 0.4, with 5.1 times"),
                (free, ["--tolerance", "object.mass=0.1:9"], "may_slip", "The grasp may give way: at object.mass = 9 the grasp does not hold"),
                (UNCERTAIN, ["--box"], "always", "it would still if all of these numbers were 25.66 % off")):
            answer, text = json_of("solve", path, *words), run("solve", path, *words)
            cone = json_of("cone", path, *[w for w in words if w != "--box"]) if path in (scene, UNCERTAIN) else answer
            self.assertEqual((answer["verdict"], text.returncode), (verdict, verdict != "always"), words)
            self.assertEqual([answer[k] for k in ("margin", "corner", "box")], [cone[k] for k in ("margin", "corner", "box")])
            self.assertEqual(answer["status"], "solved")
            self.assertIn(said, " ".join(text.stdout.split()))
        self.assertIn("it has none", " ".join(run("solve", scene, "--box").stderr.split()))

    def test_the_corner_at_which_a_load_falls_says_how_much_grip_it_takes(self):
        """m g / (2 mu) of 9 kg and a friction of 0.4."""
        free = self.file("held.toml", SLIDE_TEXT.split("[[pusher]]")[0])
        said = unwrapped(run("hold", free, "--tolerance", "object.mass=0.1:9", "--tolerance", "*.friction=0.4:0.5").stdout)
        self.assertIn("At that corner: Not held: it takes 5.52 times the grip, 111 N per finger; with less the load slides", said)
        self.assertNotIn("At that corner", run("hold", free, "--tolerance", "object.mass=0.1:0.4").stdout)

    def test_what_is_refused(self):
        for old, new, said in (
                ("friction = 0.3", "friction = [0.5, 0.3]", 'pusher "wall": friction = [0.5, 0.3] is a range that goes backwards'),
                ("friction = 0.3", "friction = [-0.1, 0.3]", "friction must be >= 0, got -0.1"),
                ("mass = 0.2 ", "mass = [0, 0.2] ", "mass must be > 0, got 0"),
                ("mass = 0.2 ", 'mass = ["1 mm", "2 mm"] ', "a length"),
                ("friction = 0.3", "friction = [0.1, 0.2, 0.3]", "friction must be a number, got a list")):
            self.assertIn(said, unwrapped(run("solve", self.file("bad.toml", SLIDE_TEXT.replace(old, new))).stderr))
        scene = self.file("slide.toml", SLIDE_TEXT)
        for given, said in (("wall.fricton=10%", 'did you mean "wall.friction"'), ("wall.friction=-3%", "not negative"),
                            ("wall.friction=0.5:0.3", "backwards"), ("object.mass=0.2:0.2", "one value is no range"), ("wall.friction=200%", "friction must be >= 0, got -0.3"),
                            ("facets=10%", "counts something"), ("wall.turn=10%", "is a turn"), ("wall.friction=x%", "is not a number"),
                            ("wall.friction=0.3", "write PATH=10%"), ("left.grip_force=10%", "share one grip_force")):
            refused = run("cone", scene, "--tolerance", given)
            self.assertEqual(refused.returncode, 2, given)
            self.assertIn(said, unwrapped(refused.stderr))
        for given, box in (("1/3:1/2", [1 / 3, 1 / 2]), ("0:4/3", [0, 4 / 3])):  # fractions are numbers
            self.assertEqual(json_of("cone", scene, "--tolerance", f"wall.friction={given}")["box"]["wall.friction"], box)
        self.assertIn("no corner of the box", run("cone", scene, "--tolerance", "*.friction=1%", "--format", "toml").stderr)
        self.assertIn("would take it", run("break", scene, "--tolerance", "*.friction=1%").stderr)

    def test_a_range_of_one_value_is_a_number(self):
        """Of those that vary: with the mass fixed the margin is that of the forces alone."""
        answers = [json_of("cone", self.file("one.toml", SLIDE_TEXT.replace("mass = 0.2 ", f"mass = {mass} ")), "--tolerance", "*.friction=2%", *words)
                   for mass, words in (("0.2", ()), ("[0.2, 0.2]", ()), ("[0.1, 0.3]", ("--tolerance", "object.mass=0.2:0.2")))]
        for answer in answers:
            self.assertEqual((answer["margin"], answer["box"]), (answers[0]["margin"], answers[0]["box"]))

    def test_a_pusher_that_presses_nowhere_turns_nothing(self):
        away = run("cone", self.file("slide.toml", SLIDE_TEXT), "--tolerance", "wall.friction=5%", "--twist", "-0.01 0 0")
        self.assertIn("the pusher presses nowhere, and leaves the box", unwrapped(away.stdout))

    def test_the_verge_no_load_and_what_does_not_matter(self):
        verge = self.file("verge.toml", slide(0.25, 0.5, 20, 0.5).replace("-9.81", "-10"))  # mu_p 2 mu F = m g
        on_it = json_of("cone", verge, "--tolerance", "*.friction")
        self.assertEqual((on_it["verdict"], on_it["margin"]), ("always", 0))
        for given, verdict in (("0.25:0.3", "always"), ("0.2499999999999999999999:0.3", "may_slip"), ("0.1:0.2499999999999999999999", "never")):
            self.assertEqual(json_of("cone", verge, "--tolerance", f"wall.friction={given}")["verdict"], verdict)
        free = self.file("free.toml", SLIDE_TEXT.replace("-9.81", "0"))
        for given in ("object.box[0]=10%", "wall.acceleration[0]=10%"):
            answer = json_of("cone", free, "--tolerance", given, "--twist", "1 0 0")
            self.assertEqual((answer["verdict"], answer["margin"]), ("always", None), given)
        self.assertGreater(json_of("cone", free, "--tolerance", "object.mass=50%")["margin"], 0.99)
        for given in ("left.points[0][0]=0:0.01", "left.normal[2]=-1.1:-0.9", "object.center_of_mass[0]=0:0.001"):
            self.assertEqual(json_of("cone", verge, "--tolerance", given)["verdict"], "not_known", given)
        point = SCENES / "straight_slide_point.toml"
        text = point.read_text().replace("gravity = [", "planar = true\ngravity = [")
        self.assertIn("one place", json_of("cone", self.file("p.toml", text), "--tolerance", "*.friction=1%")["reason"])
        wide = self.file("wide.toml", SLIDE_TEXT.replace("-0.015", "-0.025"))  # cut to the bar
        self.assertEqual(json_of("cone", wide, "--tolerance", "*.friction=1%")["verdict"], "always")
        self.assertIn("beyond the object", json_of("cone", wide, "--tolerance", "wall.shift[1]=0:0.001")["reason"])
        back = json_of("cone", free, "--tolerance", "*.friction=1%", "--twist", "-1 0 0")
        self.assertIn(back["verdict"], ("never", "not_known"))

    def test_more_friction_of_a_finger_can_make_it_slip(self):
        text = SLIDE_TEXT.replace("[0.005, 0, 0.005], [0, 0.005, 0.005], [-0.005, 0, 0.005], [0, -0.005, 0.005]",
                                  "[0.005, 0.02, 0.005], [0, 0.02, 0.005]").replace("-9.81", "0")
        answer = json_of("cone", self.file("off.toml", text), "--tolerance", "left.friction=0.5:2")
        self.assertEqual((answer["verdict"], answer["corner"]), ("may_slip", {"left.friction": 2}))

    def test_a_box_is_of_a_plane_only_where_the_scene_says_so(self):
        # Ranges may leave the mirror image that the middle is: only `planar = true` drops what is across.
        spatial = SQUARE.read_text().replace("planar = true", "")
        for words in (("--tolerance", "*.friction=10%"), ("--tolerance", "gravity[2]=-500:500")):
            for name, *rest in (("cone", "--pusher", "east"), ("plan", "--to", "-0.04 0.02 0.1")):
                said = unwrapped(run(name, self.file("s.toml", spatial), *rest, *words).stderr)
                self.assertIn("planar = true", said)
                self.assertNotIn("taken as", said)
        pyramids = self.file("p.toml", spatial.replace("[object]", "facets = 4\n[object]", 1))
        self.assertIn("planar = true", run("cone", pyramids, "--pusher", "east").stderr)
        left_out = run("cone", SQUARE, "--pusher", "east", "--tolerance", "south.friction=0.1:0.9")
        self.assertIn("a pusher that is left out", unwrapped(left_out.stderr))

    def test_a_report_has_the_verdict_and_its_margin(self):
        page = unwrapped(run("report", UNCERTAIN).stdout)
        self.assertIn("the pusher sticks for every value in the ranges; it would still if all of these numbers were 25.66 % off.", page)
        self.assertNotIn("in the ranges", run("report", SLIDE).stdout)

    def test_hold(self):
        held = json_of("hold", SLIDE, "--tolerance", "*.friction", "--tolerance", "object.mass", "--tolerance", "*.grip_force")
        least = held["least_grip"]["statics_factor"]  # (1 - e)^2 / (1 + e) of friction, grip and mass
        e = held["margin"]
        self.assertEqual(held["verdict"], "always")
        self.assertAlmostEqual((1 + e) / (1 - e) ** 2 * least, 1, delta=1e-6)
        heavy = json_of("hold", SLIDE, "--tolerance", "object.mass=1:5")
        self.assertEqual((heavy["verdict"], heavy["corner"]), ("may_slip", {"object.mass": 5}))
        corner = json_of("hold", self.file("corner.toml", heavy["corner_scene"]))
        self.assertIs(corner["held"], False)
        slippery = json_of("hold", self.file("s.toml", SLIDE_TEXT.replace("mass = 0.2 ", "mass = 20 ")), "--tolerance", "*.friction=5%")
        self.assertEqual((slippery["verdict"], slippery["margin"]), ("never", 0))
        self.assertEqual(json_of("hold", SLIDE, "--tolerance", "object.mass=5:9", "--tolerance", "*.grip_force=10:20")["verdict"], "never")
        locked = self.file("l.toml", SLIDE_TEXT.replace("[object]", '[gripper]\njaws = "locked"\n[object]'))
        self.assertEqual(json_of("hold", locked, "--tolerance", "*.friction=1%")["verdict"], "not_known")

    def test_a_box_is_judged_beside_a_sound_scene(self):
        heavy = ("--tolerance", "object.mass=0.1:9")  # whose middle no material has
        self.assertEqual(run("hold", SLIDE, *heavy).stderr, "")
        self.assertIn("heavier than any material", run("solve", SLIDE, *heavy).stderr)

    def test_hold_names_the_worst_and_where_it_lets_go(self):
        scene = self.file("slide.toml", SLIDE_TEXT)
        least = 0.2 * 9.81 / (2 * 20)  # of the friction of two fingers with 20 N
        for given, words, at in (("*.friction=0.4:0.9", "holds for every friction from 0.4 to 0.9: worst at 0.4, ", 0.4),
                                 ("*.friction", "The grasp holds ", 0.5)):
            said = unwrapped(run("hold", scene, "--tolerance", given).stdout)
            self.assertIn(f"{words}with {at / least:.3g} times the grip it needs ({least * 20 / at:.3g} of 20 N per finger); "
                          f"it would still down to a friction of {least:.3g}.", said)
            self.assertNotIn("number", said)  # no table of the same numbers

    def test_how_an_actuator_moves_its_bodies_is_not_known_to_be_convex(self):
        finger = '[[finger]]\nname = "{0}"\nshape = "point"\non = "{1}z"\nfriction = 0.5\n'
        text = "gravity = [0, -9.81, 0]\n[object]\nmass = 0.2\nbox = [0.08, 0.04, 0.02]\n" + finger.format("l", "+") + (
            finger.format("r", "-")) + '[[actuator]]\nname = "jaw"\nbodies = ["l", "r"]\nforce = 10\n' + (
            "twists = [[0, 0, -1, 0, 0, 0], [0, 0, 1, 0, 0, 0]]\n")
        scene = self.file("actuator.toml", text)
        for word, verdict in (("jaw.force=9:11", "always"), ("jaw.twists[1][2]=0.5:9", "may_slip"),
                              ("jaw.twists[1][2]=0.9:1.1", "not_known")):
            self.assertEqual(json_of("hold", scene, "--tolerance", word)["verdict"], verdict, word)
        self.assertIs(json_of("hold", scene, "--set", "jaw.twists[1][2]=9")["held"], False)

    def test_plans(self):
        words = ("plan", SQUARE, "--to", "-0.04 0.02 0.1", "--tolerance", "*.friction=10%", "--tolerance", "object.mass=20%")
        plan = json_of(*words)
        self.assertEqual((plan["found"], plan["verdict"]), (True, "always"))
        self.assertGreater(plan["margin"], 0.1)
        for push in plan["pushes"]:
            self.assertEqual(push["kind"], "stick")
            x, y, turn = push["twist"][0], push["twist"][1], push["twist"][5]
            scene = self.file("push.toml", SQUARE.read_text())
            begin = json_of("cone", scene, "--pusher", push["pusher"], "--twist", f"{x} {y} {turn}", "--tolerance", "*.friction=10%")
            self.assertEqual(begin["verdict"], "always")
        self.assertIn("friction, grip, mass and load alone", unwrapped(run(*words, "--tolerance", "east.shift[1]=0:1e-3").stderr))
        rng = random.Random(3)
        for _ in range(200 if DEEP else 3):  # replays at values of the box end where the plan does
            text = plan["scene"].replace("friction = 0.9\n", f"friction = {rng.uniform(0.81, 0.99)}\n")
            motion = json_of("move", self.file("replay.toml", text))
            self.assertEqual(motion["end"], "time")
            place = motion["frames"][-1]["position"]
            self.assertAlmostEqual(place[0], -0.04, delta=1e-3)
            self.assertAlmostEqual(place[1], 0.02, delta=1e-3)


if __name__ == "__main__":
    main()
