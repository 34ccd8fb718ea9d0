"""lcpush solve: answers near a limit of friction or of wedging, and what a plane leaves open."""
import json
import math
import unittest

from tool import command, main, unwrapped
from scene_tables import finger, pusher, table

run = command("solve")

def floor(x, y):
    return (table("", gravity=[0, 0, -9.81], facets="round") + table("[object]", mass=1, box=[0.2, 0.2, 0.2], force=[x, y, 0]) +
            finger("floor", "rectangle", points=[2, 2], center=[0, 0, -0.1], size=[0.2, 0.2], normal=[0, 0, 1], friction=0.5))


PEG = (
    table("", planar=True) +
    table("[object]", mass=0.1, box=[0.02, 0.06, 0.02]) +
    finger("lip", "point", center=[0.01, -0.025, 0], normal=[-1, 0, 0], friction=0.3) +
    finger("bore", "point", center=[-0.01, -0.03, 0], normal=[1, 0, 0], friction=0.3) +
    pusher("press", "point", center=[0.00833, 0.03, 0], normal=[0, -1, 0], friction=0, acceleration=[0, -0.1, 0])
)

SQUEEZED = (
    table("[object]", mass=1, box=[0.1, 0.05, 0.05]) +
    pusher("below", "ring", center=[0.01, -0.025, 0], radius=0.007, points=4, normal=[0, 1, 0], friction=0,
        acceleration=[0, 2, 0]) +
    pusher("above", "disc", center=[0.025, 0.025, 0], radius=0.007, normal=[0, -1, 0], friction=0,
        acceleration=[0, 0, 0])
)

JAW = (
    table("", planar=True) +
    table("[object]", mass=0.2, box=[0.1, 0.03, 0.01]) +
    finger("left", "point", center=[0, 0, 0.005], normal=[0, 0, -1], friction=0.5, grip_force=20) +
    finger("right", "point", center=[0, 0, -0.005], normal=[0, 0, 1], friction=0.1, grip_force=20) +
    pusher("wall", "line", ends=[[-0.05, -0.015, 0], [-0.05, 0.015, 0]], normal=[1, 0, 0], friction=0.3,
        acceleration=[0.1, 0, 0])
)



def near_points(apart):
    return (table("[object]", mass=1, box=[0.1, 0.05, 0.05]) +
            pusher("rod", "points", points=[[-0.05, 0, 0], [-0.05, apart, 0]], normal=[1, 0, 0], friction=0,
                   acceleration=[1, 0, 0], angular_acceleration=[0, 0, 1], follow="bilateral"))


def light_cube(mass):
    return table("[object]", mass=mass, box=[0.04, 0.04, 0.04]) + "".join(
        finger(name, "rectangle", center=[0, -0.02 * n, 0], size=[0.02, 0.02], normal=[0, n, 0], friction=1, grip_force=20)
        for name, n in (("left", -1), ("right", 1)))

PRESSES = """gravity = [-4.216370485701602, -8.11512681053464, -3.5500756014831967]
[object]
mass = 0.12363338926125472
inertia = [0.0003265018723924516, 0.0002294203749175763, 0.0003428917837854598, 0.00010969159315825751, 3.2257794441104366e-05, 4.097937458381351e-05]
[[finger]]
name = "left"
shape = "disc"
center = [0.04064800503570043, -0.009939430623679494, -0.046393919927358765]
radius = 0.0036529446502985684
normal = [-0.4775197682574479, -0.20218818270547836, 0.855040823409976]
friction = 0.7000601277979507
tangent = [-0.5268479017202907, 0.844690899437812, -0.09449112582601174]
grip_force = 14.999181944261975
[[finger]]
name = "right"
shape = "disc"
center = [-0.013855419439569413, -0.033016901083371235, 0.05119921870239743]
radius = 0.0036529446502985684
normal = [0.4775197682574479, 0.20218818270547836, -0.855040823409976]
friction = 0.7000601277979507
tangent = [-0.5268479017202907, 0.844690899437812, -0.09449112582601174]
grip_force = 14.999181944261975
[[pusher]]
name = "p0"
shape = "rectangle"
center = [0.044422436482890786, -0.07122212635834617, 0.007967244477005357]
size = [0.022649109946864556, 0.07324410576645174]
points = [3, 4]
normal = [-0.5268479017202907, 0.844690899437812, -0.09449112582601174]
friction = 0.4083587577060567
tangent = [0.7031402131696638, 0.49559784420555775, 0.5098790223597393]
acceleration = [0.0008832450364675818, 0.0006395628397029249, 0.0007926365094407624]
normal_force = 29.8739195933654
"""


def solved(scene):
    return json.loads(run("-", "--seconds", 600, "--json", text=scene).stdout)


class NearLimits(unittest.TestCase):
    def test_round_friction_settles_within_a_hundredth_of_its_limit_in_every_direction(self):
        limit = 0.5 * 9.81
        for part in (0.99, 0.999, 0.9999, 1.0001, 1.001, 1.01):
            for degrees in (3, 22.5, 71, 130, 204.3, 311):
                with self.subTest(part=part, degrees=degrees):
                    x, y = (part * limit * f(math.radians(degrees)) for f in (math.cos, math.sin))
                    answer = solved(floor(x, y))
                    self.assertEqual(answer["status"], "solved")
                    a = math.hypot(*answer["object"]["acceleration"][:2])
                    self.assertAlmostEqual(a, max(0, part - 1) * limit, delta=1e-6)

    def test_a_peg_just_inside_the_wedging_limit_needs_its_large_force(self):
        for weight in ("", "gravity = [0, -1e-7, 0]\n", "gravity = [0, -9.81, 0]\n"):
            with self.subTest(weight=weight):
                answer = solved(weight + PEG)
                self.assertEqual(answer["status"], "solved")
                if "9.81" not in weight:
                    self.assertAlmostEqual(answer["contacts"][-1]["normal_force"], 25, delta=0.01)

    def test_pads_bear_what_the_rigid_laws_ask_for_near_a_jam(self):
        self.assertEqual(solved(SQUEEZED)["status"], "solved")

    def test_a_slow_pusher_that_presses_hard_is_told_from_rounding_by_what_it_moves(self):
        """Of a pusher with a normal_force the acceleration is next to nothing beside that of the object."""
        self.assertEqual(solved(PRESSES)["status"], "solved")

    def test_fingers_across_a_plane_share_a_parallel_jaws_force(self):
        answer = solved(JAW)
        self.assertEqual([round(c["normal_force"], 6) for c in answer["contacts"][:2]], [20, 20])

    def test_a_load_across_the_plane_is_not_dropped_in_silence(self):
        result = run("-", text="gravity = [0, 0, -9.81]\n" + JAW)
        self.assertIn("planar leaves out 1.96 N along z", unwrapped(result.stderr))
        table = ('gravity = [0, 0, -10]\nplanar = true\n[object]\nmass = 0.7\nbox = [0.2, 0.14, 0.03]\n[[finger]]\nname = "table"\n'
                 'shape = "rectangle"\non = "-z"\nsize = [0.2, 0.14]\nfriction = 0.35\n{}[[pusher]]\nname = "palm"\nshape = "line"\n'
                 'on = "-x"\nalong = "y"\nfriction = 0.5\nvelocity = [0.05, 0, 0]\n')
        told = unwrapped(run("-", text=table.format("")).stderr)
        self.assertIn('give the finger "table" grip_force = 7', told)
        self.assertIn("grip_force = 7, its weight", unwrapped(command("cone")("-", text=table.format("")).stderr))
        self.assertEqual(run("-", text=table.format("grip_force = 7\n")).stderr, "")

    def test_what_rounding_hides_is_not_known_and_neither_a_jam_nor_a_motion(self):
        for apart in (1e-5, 1e-6, 1e-8):
            with self.subTest(apart=apart):
                answer = solved(near_points(apart))
                self.assertEqual(answer["status"], "solved" if apart == 1e-5 else "numerical_breakdown")
        for mass in (1e-6, 1e-9, 1e-10, 1e-12, 1e-15):
            for weight in ("gravity = [0, 0, -9.81]\n", ""):
                with self.subTest(mass=mass, weight=weight):
                    answer = solved(weight + light_cube(mass))
                    if answer["status"] == "solved":
                        self.assertEqual({c["mode"] for c in answer["contacts"]}, {"stick"})
                        self.assertLess(max(map(abs, answer["object"]["acceleration"])), 1e-3)
                    else:
                        self.assertIn("cannot be told from rounding", answer["reason"])
                        self.assertLess(mass, 1e-8)


if __name__ == "__main__":
    main()
