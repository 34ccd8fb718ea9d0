"""solve --sensitivity: derivatives by accelerations and grip forces are those of differences of `solve`, and its answers
lie on one line from end to end of a range.

    test_sensitivity.py TOOL ROOT
"""
import random

from tool import SCENES as SHIPPED, ToolTest, json_of, main, run

SCENES = 60
# Of a number, or nine tenths of its range where that is shorter; of what is curved less. What pads settle to, 1.5e-11,
# is worth 1e-6 of a slope over a short range.
STEP, CURVED_STEP = 1e-3, 1e-4
ALLOWED = {"rigid": 1e-6, "pad": 1e-4, "round": 3e-4}


def scene(seed):
    """A grasp that nothing aligns; facets, pressure and hand by turns."""
    pick = random.Random(seed)
    law = list(ALLOWED)[seed % 3]
    facets, pressure = ('"round"', "pad") if law == "round" else ("8", law)
    near = lambda size: round(pick.uniform(-size, size), 5)
    force = round(pick.uniform(5, 30), 2)
    bodies = []
    for name, side in ("left", 1), ("right", -1):
        points = [[near(.008), near(.008), side * .005] for _ in range(pick.randint(1, 4))]
        bodies.append(f'[[finger]]\nname = "{name}"\nshape = "points"\npoints = {points}\nnormal = [0, 0, {-side}]\n'
                      f"friction = {pick.uniform(.2, .9):.3f}\ngrip_force = {force}\n")
    points = [[-.05, near(.015), near(.004)] for _ in range(pick.randint(1, 3))]
    rates = [round(pick.uniform(.5, 2), 4), near(.4), near(.4), near(4), near(4), near(4)]
    hand = pick.choice(["parallel", "independent"])
    return law, (
        f'gravity = [0, -9.81, 0]\nfacets = {facets}\npressure = "{pressure}"\n[object]\nmass = {pick.uniform(.1, .5):.4f}\n'
        f'box = [0.1, 0.03, 0.01]\n[gripper]\njaws = "{hand}"\n' + "".join(bodies) +
        f'[[pusher]]\nname = "wall"\nshape = "points"\npoints = {points}\nnormal = [1, 0, 0]\nfriction = {pick.uniform(.1, .8):.3f}\n'
        f"acceleration = {rates[:3]}\nangular_acceleration = {rates[3:]}\n")


def numbers_of(answer):
    """(push force and its normal part, object's acceleration), or None where there is none or another one as well: a
    neighbour's may be that."""
    if answer["status"] != "solved" or False in answer["unique"].values():
        return None
    wall = next(body for body in answer["bodies"] if body["name"] == "wall")
    return [*wall["force"], wall["normal_force"]], answer["object"]["acceleration"]


def with_number(by, value):
    """Words that give the number another value; a twist about the centre of mass is what the scene has."""
    name = by["number"]
    if ".twist[" in name:
        k = int(name[-2])
        name = f"wall.{'angular_' * (k > 2)}acceleration[{k % 3}]"
    return "--set", f"{name}={value!r}"


def off(told, found):
    """By how much two slopes differ, over the larger one; one that is next to none counts as such."""
    return max(abs(a - b) for a, b in zip(told, found)) / max(*map(abs, told), *map(abs, found), 1e-3)


class Sensitivity(ToolTest):
    def differences(self, path, by):
        """The slopes of force and acceleration over the number's neighbourhood, or None."""
        value, (low, high) = by["value"], by["range"] or (None, None)
        step = max(1, abs(value)) * (STEP if by["range"] else CURVED_STEP)
        below = step if low is None else min(step, .9 * (value - low))
        above = step if high is None else min(step, .9 * (high - value))
        ends = below + above > 1e-2 * step and [numbers_of(json_of("solve", path, *with_number(by, at))) for at in (value - below, value + above)]
        if not ends or None in ends:
            return None
        return [[(b - a) / (above + below) for a, b in zip(*parts)] for parts in zip(*ends)]

    def test_they_are_those_of_differences(self):
        checked = dict.fromkeys(ALLOWED, 0)
        for seed in range(SCENES):
            law, text = scene(seed)
            path = self.file("scene.toml", text)
            answer = json_of("solve", path, "--sensitivity")
            if numbers_of(answer) is None:
                continue
            for by in answer["sensitivity"]:
                slopes = by["reason"] is None and self.differences(path, by)
                if not slopes:
                    continue
                pusher = by["pushers"][0]
                told = [*pusher["force"], pusher["normal_force"]], by["acceleration"]
                for k in range(2):
                    self.assertLess(off(told[k], slopes[k]), ALLOWED[law], (seed, by))
                checked[law] += 1
        self.assertGreater(min(checked.values()), 100, checked)

    def test_beyond_its_range_the_line_bends(self):
        # But for few: where a scene has two answers, `solve` may take the other one earlier.
        ranges = straight = bends = 0
        for seed in range(0, SCENES, 3):  # rigid
            path = self.file("scene.toml", scene(seed)[1])
            for by in json_of("solve", path, "--sensitivity")["sensitivity"]:
                value, end = by["value"], by["range"][1] if by["range"] else None
                if end is None or not 1e-3 < end - value < 10:
                    continue
                at = [numbers_of(json_of("solve", path, *with_number(by, value + share * (end - value))))
                      for share in (0, .5, .999, 1.5)]
                if None in at:
                    continue
                slope = lambda i, j, run: [(b - a) / run for a, b in zip(sum(at[i], []), sum(at[j], []))]
                ranges += 1
                straight += off(slope(0, 1, .5), slope(1, 2, .499)) < 1e-5
                bends += off(slope(0, 1, .5), slope(2, 3, .501)) > 1e-6
        self.assertGreater(straight, .95 * ranges, ranges)
        self.assertGreater(bends, .5 * ranges, ranges)  # a share of forces alone may change, too
        self.assertGreater(ranges, 50)

    def test_the_straight_slide_by_hand(self):
        """F = 2 mu N + m a, and friction turns with a sideways push: mu N / a of both fingers, + m."""
        answer = json_of("solve", SHIPPED / "straight_slide.toml", "--sensitivity")
        by = {one["number"]: one for one in answer["sensitivity"]}
        for number, axis, slope in ("*.grip_force", 0, 1), ("wall.twist[0]", 0, .2), ("wall.twist[1]", 1, 200.2):
            self.assertAlmostEqual(by[number]["pushers"][0]["force"][axis], slope, places=6)
        self.assertIsNone(by["*.grip_force"]["range"])  # curved

    def test_where_there_is_none_the_reason_is_told(self):
        slide = SHIPPED / "straight_slide.toml"
        swept, locked = ("--solver", "gauss-seidel", "--facets", "8"), ("--set", "gripper.jaws=locked")
        for words, reason in (swept, "sweeps"), (locked, "locked"):
            for by in json_of("solve", slide, "--sensitivity", *words)["sensitivity"]:
                self.assertIn(reason, by["reason"])
                self.assertEqual((by["range"], by["acceleration"], by["pushers"]), (None, None, []))
        self.is_refused(run("solve", slide, "--sensitivity"), "--format json")
        self.assertNotIn("sensitivity", json_of("solve", slide))


if __name__ == "__main__":
    main()
