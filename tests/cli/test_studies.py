"""The studies of docs/studies: every picture comes from its command, and shows its closed form.

Each line of a ```sh block of docs/studies/README.md or motion.md is one `lcpush sweep ... --format svg
-o docs/studies/X.svg`, or one `lcpush move ...` or `lcpush cone ...`.
It is run again, and the picture compared with the stored one number by number: compilers differ in the
last bits. Run with --json instead, the answers are held to closed forms that share nothing with the
solver.
"""
import json
import math
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from tool import SOURCE, TOOL, main

STUDIES = SOURCE / "docs/studies"
PAGE = "".join((STUDIES / name).read_text() for name in ("README.md", "motion.md"))
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
PIXEL = 0.002  # in a picture 640 wide: the last of three decimals, rounded either way


def commands(text):
    """Picture's name -> words of its command, from the page's sh blocks."""
    found = {}
    for block in re.findall(r"```sh\n(.*?)```", text, flags=re.S):
        for line in block.replace("\\\n", " ").strip().split("\n"):
            words = shlex.split(line)
            assert words[0] == "lcpush" and words[1] in ("sweep", "move", "cone") and words[-2] == "-o", line
            found[pathlib.Path(words[-1]).name] = words[1:-2]
    return found


COMMANDS = commands(PAGE)


def run(words):
    return subprocess.run([TOOL, *map(str, words)], cwd=SOURCE, capture_output=True, text=True,
                          timeout=300)


def answers(picture):
    """The JSON behind a picture: a list of curves, or one sweep."""
    words = list(COMMANDS[picture])
    for option in ("--show", "--format"):
        if option in words:
            at = words.index(option)
            del words[at:at + 2]
    result = run([*words, "--json"])
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    data = json.loads(result.stdout)
    return data.get("curves", [data])


def same_text(a, b, tolerance):
    """Equal but for numbers, and those within `tolerance` (absolute, or relative for large ones)."""
    if NUMBER.sub("#", a) != NUMBER.sub("#", b):
        return False
    return all(abs(float(x) - float(y)) <= tolerance * max(1, abs(float(x)) / 1000)
               for x, y in zip(NUMBER.findall(a), NUMBER.findall(b)))


def differences(first, second):
    """Where two SVGs show something else."""
    a, b = list(ElementTree.fromstring(first).iter()), list(ElementTree.fromstring(second).iter())
    if len(a) != len(b):
        return [f"{len(a)} elements instead of {len(b)}"]
    found = []
    for x, y in zip(a, b):
        if x.tag != y.tag or sorted(x.attrib) != sorted(y.attrib):
            found.append(f"<{x.tag}> instead of <{y.tag}>")
            continue
        # Numbers in words have six digits; coordinates three decimals.
        if not same_text(x.text or "", y.text or "", 1e-5):
            found.append(f"{x.text!r} instead of {y.text!r}")
        for key in x.attrib:
            if not same_text(x.attrib[key], y.attrib[key], PIXEL):
                found.append(f"{key} = {x.attrib[key]} instead of {y.attrib[key]}")
    return found


def steps(curve):
    return [p for p in curve["points"] if not p["refined"]]


def at(segment, key, value):
    """A segment's straight line: break_force, or the first component of a vector."""
    share = (value - segment["from"]) / (segment["to"] - segment["from"])
    first, last = (v if key == "break_force" else v[0] for v in segment[key])
    return first + share * (last - first)


class Pictures(unittest.TestCase):
    def test_every_picture_has_a_command_and_is_on_the_page(self):
        stored = {path.name for path in STUDIES.glob("*.svg")}
        self.assertEqual(stored, set(COMMANDS))
        for name in stored:
            self.assertIn(f"]({name})", PAGE)

    def test_every_picture_is_what_its_command_draws_now(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, words in COMMANDS.items():
                with self.subTest(name):
                    drawn = pathlib.Path(folder) / name
                    result = run([*words, "-o", drawn])
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertEqual(differences(drawn.read_text(),
                                                 (STUDIES / name).read_text()), [])

    def test_the_comparison_sees_a_point_that_moved(self):
        text = (STUDIES / sorted(COMMANDS)[0]).read_text()
        points = re.search(r'points="[\d.]+,([\d.]+)', text)
        moved = text[:points.start(1)] + f"{float(points[1]) + 0.01:.3f}" + text[points.end(1):]
        self.assertEqual(differences(text, text), [])
        self.assertEqual(len(differences(moved, text)), 1)
        self.assertEqual(len(differences(text.replace("</title>", ".</title>", 1), text)), 1)


MU, GRIP, MASS, SIGMA, GRAVITY = 0.5, 20, 0.2, 0.1, 9.81  # of the bars


class StraightSlide(unittest.TestCase):
    def test_pushers(self):
        """The resultant acts at y = -l m g / N, which has to lie on the pusher."""
        height = -0.05 * MASS * GRAVITY / (2 * MU * GRIP + MASS * SIGMA)
        halves = {"point pusher": 0, "line pusher, 20 mm": 0.01, "planar pusher, 10 mm": 0.005}
        curves = answers("pushers.svg")
        self.assertEqual({c["label"] for c in curves}, set(halves))
        for curve in curves:
            half = halves[curve["label"]]
            straight = [z for z in curve["zeros"] if z["of"] == "twist[5]"]
            self.assertEqual(len(straight), 1, straight)
            self.assertIs(straight[0]["jumps"], False)
            # A zero between points is found to rounding, a range's ends to 1e-6 of the range.
            tolerance = 1e-9 if half == 0 else 1e-7
            self.assertAlmostEqual(straight[0]["from"], height - half, delta=tolerance)
            self.assertAlmostEqual(straight[0]["to"], height + half, delta=tolerance)

    def test_grip_force(self):
        """Slopes, intercepts and breakpoints, to 1e-9."""
        wall, weight, inertia = 0.25, MASS * GRAVITY, MASS * SIGMA
        [sweep] = answers("grip_force.svg")
        self.assertEqual([s["kind"] for s in sweep["segments"]], ["exact"] * 4)
        ends = [4, ((1 - wall) * (weight - inertia) / wall + weight - 2 * inertia) / (2 * MU),
                (weight / wall - inertia) / (2 * MU), weight / wall / (2 * MU), 20]
        for segment, first, last in zip(sweep["segments"], ends, ends[1:]):
            self.assertAlmostEqual(segment["from"], first, delta=1e-9)
            self.assertAlmostEqual(segment["to"], last, delta=1e-9)
            for share in (0, 0.37, 1):
                grip = segment["from"] + share * (segment["to"] - segment["from"])
                friction = 2 * MU * grip
                breaking = friction if first >= ends[3] else (friction - weight) / (1 - wall)
                push = (friction + inertia if first >= ends[1]
                        else (friction - weight + 2 * inertia) / (1 - wall))
                self.assertAlmostEqual(at(segment, "break_force", grip), breaking, delta=1e-9)
                self.assertAlmostEqual(at(segment, "force", grip), push, delta=1e-9)
        slope = (sweep["segments"][-1]["break_force"][1] - sweep["segments"][-1]["break_force"][0])
        self.assertAlmostEqual(slope / (ends[4] - ends[3]), 2 * MU, delta=1e-9)

    def test_pyramid(self):
        """Turned by t, the nearest of g generators is off the slip by t modulo 360/g."""
        for curve in answers("pyramid.svg"):
            step = 360 / curve["each_value"]
            for point in steps(curve):
                off = abs(point["value"] - step * round(point["value"] / step))
                self.assertAlmostEqual(point["break_force"],
                                       2 * MU * GRIP * math.cos(math.radians(off)), delta=1e-8)


def scene_points(**changes):
    """Where the fingers of offset_push.toml touch."""
    text = (STUDIES / "offset_push.toml").read_text()
    for key, value in changes.items():
        text, count = re.subn(rf"(?m)^{key} = .*$", f"{key} = {value:g}", text)
        assert count > 0, key
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.toml"
        path.write_text(text)
        solved = json.loads(run(["solve", path, "--json"]).stdout)
    # Under "even" a point's normal force is its weight's share of the grip.
    return [(*c["position"][:2], c["normal_force"]) for c in solved["contacts"] if c["body"] != "rod"]


def dissipation(points, facets, lever, spin):
    """Power against friction when the object's point at x = `lever` moves at 1 along y and the object
    turns at `spin`: what the push must be, at least. facets None: round cones."""
    total = 0
    for x, y, normal in points:
        vx, vy = -spin * y, 1 + spin * (x - lever)
        speed = math.hypot(vx, vy)
        if facets and speed > 0:
            step = 2 * math.pi / facets
            angle = math.atan2(vy, vx)
            speed *= math.cos(angle - step * round(angle / step))
        total += MU * normal * speed
    return total


def least(function, low, high):
    """The least value of a convex function, by golden section."""
    ratio = (math.sqrt(5) - 1) / 2
    a, b = high - ratio * (high - low), low + ratio * (high - low)
    fa, fb = function(a), function(b)
    for _ in range(90):
        if fa < fb:
            high, b, fb = b, a, fa
            a = high - ratio * (high - low)
            fa = function(a)
        else:
            low, a, fa = a, b, fb
            b = low + ratio * (high - low)
            fb = function(b)
    return min(fa, fb)


def disc_push(radius, lever):
    """The same for a disc of even pressure and round cones."""
    rings, rays = 24, 48
    points = [(radius * math.sqrt((i + 0.5) / rings) * math.cos(2 * math.pi * (j + 0.5) / rays),
               radius * math.sqrt((i + 0.5) / rings) * math.sin(2 * math.pi * (j + 0.5) / rays),
               2 * GRIP / (rings * rays))
              for i in range(rings) for j in range(rays)]
    return least(lambda spin: dissipation(points, None, lever, spin), 0, 1000)


class OffsetPush(unittest.TestCase):
    """Balance of torques: force times lever arm is the patches' friction torque. Of all motions the
    object takes the one that dissipates least."""

    def check_curve(self, curve, points, facets, slack=1e-9):
        for point in steps(curve):
            # The rod pushes at x > 0, so the object turns with spin > 0.
            lever = point["value"]
            push = least(lambda spin: dissipation(points, facets, lever, spin), -10, 2000)
            self.assertAlmostEqual(point["break_force"], push, delta=slack * push)
            spin = point["break_twist"][5]
            self.assertAlmostEqual(dissipation(points, facets, lever, spin), push,
                                   delta=1e-7 * push)
            # The rod's point moves at 1: what is not rotation is slip.
            self.assertAlmostEqual(point["break_twist"][1] + spin * lever, 1, delta=1e-7)

    def test_facets(self):
        points = scene_points()
        for curve in answers("facets.svg"):
            self.check_curve(curve, points, int(curve["each_value"]))

    def test_round(self):
        [curve] = answers("round.svg")
        self.check_curve(curve, scene_points(), None, 1e-8)  # from finite pushes

    def test_scripts_print_what_the_page_says(self):
        for name in ("facet_error.py", "motion_cone.py", "plans.py"):
            printed = subprocess.run([sys.executable, STUDIES / name, TOOL], cwd=SOURCE, check=True,
                                     text=True, capture_output=True).stdout
            self.assertIn(f"```text\n{printed}```", PAGE)

    def test_patch_size(self):
        for curve in answers("patch_size.svg"):
            self.check_curve(curve, scene_points(radius=curve["each_value"]), 16)

    def test_discretisation(self):
        """The page's table: how far k points and g facets miss the round cone and the whole disc."""
        table = dict(re.findall(r"(?m)^\| ([kg] = \d+) \| ([\d.]+) % \|", PAGE))
        levers = [0.002 * i for i in range(1, 21)]
        disc = {round(x, 6): disc_push(0.005, x) for x in levers}

        def worst(curve):
            return max(abs(p["break_force"] / disc[round(p["value"], 6)] - 1)
                       for p in steps(curve) if round(p["value"], 6) in disc)

        seen = 0
        for picture, letter in (("points.svg", "k"), ("facets.svg", "g")):
            for curve in answers(picture):
                name = f"{letter} = {curve['each_value']:g}"
                self.assertAlmostEqual(100 * worst(curve), float(table[name]), delta=0.051, msg=name)
                seen += 1
        self.assertEqual(seen, len(table))
        for curve in answers("points.svg"):
            self.check_curve(curve, scene_points(points=curve["each_value"]), 16)


class Rolling(unittest.TestCase):
    WEIGHT, FINGER, RADIUS = 0.5 * 9.81, 0.3, 0.02
    INERTIA = 0.5 * 0.5 * 0.1  # I sigma / R^2

    def turning_ends(self, sheet):
        return sheet * self.WEIGHT / (1 - sheet * self.FINGER)  # T*, at 2 mu_f F

    def test_threshold(self):
        for curve in answers("rolling.svg"):
            sheet = curve["each_value"]
            last = self.turning_ends(sheet) / (2 * self.FINGER)
            rolls_to = last - self.INERTIA / (2 * self.FINGER)
            for value in (rolls_to, last):
                nearest = min((s["to"] for s in curve["segments"]), key=lambda v: abs(v - value))
                self.assertAlmostEqual(nearest, value, delta=1e-6)
            for segment in curve["segments"]:
                middle = (segment["from"] + segment["to"]) / 2
                expected = min(5, max(0, 5 * (last - middle) / (last - rolls_to)))
                spin = sum(t[5] for t in segment["twist"]) / 2
                self.assertAlmostEqual(spin, expected, delta=1e-6)
                # A held cylinder does not break loose: no force there.
                breaks = middle < last
                self.assertIs(segment["breaks"], breaks)
                self.assertEqual([force is None for force in segment["break_force"]],
                                 [not breaks] * 2)
            moving = [b for b in curve["bistable"] if b["motion"]]
            if sheet * (1 + self.FINGER) < 1:
                self.assertEqual(moving, [])
            else:
                [band] = moving
                self.assertGreaterEqual(band["from"], self.WEIGHT / (2 * self.FINGER))
                self.assertAlmostEqual(band["to"], last, delta=1e-6)
                # There and back: rolling on the one way, held on the other.
                for segment in curve["segments_back"]:
                    if band["from"] < segment["to"] < band["to"]:
                        self.assertAlmostEqual(segment["twist"][1][5], 0, delta=1e-6)

    def test_map(self):
        [sweep] = answers("rolling_map.svg")
        hatched = 0
        for point in sweep["points"]:
            sheet, grip, spin = point["second_value"], point["value"], point["twist"][5]
            ends, load = self.turning_ends(sheet), 2 * self.FINGER * grip
            turning = 5 if load <= ends - self.INERTIA else 0 if load >= ends else None
            if turning is not None:
                self.assertAlmostEqual(spin, turning, delta=1e-6)
            self.assertEqual(spin > 1e-6, load < ends)
            if point["bistable"]:
                hatched += 1
                self.assertGreater(sheet * (1 + self.FINGER), 1)
                self.assertTrue(self.WEIGHT <= load <= ends, (grip, sheet))
        self.assertGreater(hatched, 10)


main()
