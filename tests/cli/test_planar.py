"""planar = true: friction at a body in the plane acts along the plane alone, forth and back."""
import json
import math
import random
import sys

from tool import SOURCE, ToolTest, json_of, main, run
from scene_tables import finger, pusher, table

sys.path.insert(0, str(SOURCE / "docs/check"))
sys.dont_write_bytecode = True
from lcpush_check import check

LIFT = (
    table("", planar=True, gravity=[0, -9.81, 0]) +
    table("[object]", mass=1, box=[0.1, 0.1, 0.1]) +
    pusher("tray", "point", center=[0, -0.05, 0], normal=[0, 1, 0], friction=0.8, acceleration=[2, 0, 0])
)
PLATE = (
    table("", planar=True) +
    table("[object]", mass=0.8, box=[0.09, 0.09, 0.012]) +
    finger("table", "disc", center=[0.01, 0, -0.006], radius=0.02, normal=[0, 0, 1], friction=0.3, grip_force=8) +
    pusher("rod", "point", center=[-0.045, 0.02, 0], normal=[1, 0, 0], friction=0.2, velocity=[0.02, 0.004, 0])
)


def random_scene(seed):
    """Two or three stops and a pusher around a plate of any size, turned any way; or on its axes."""
    pick = random.Random(seed)
    size, turn = 10 ** pick.uniform(-3, 1), pick.choice([0, math.pi / 2, pick.uniform(0, 7)])

    def vector(angle, length=1):
        return [length * math.cos(angle + turn), length * math.sin(angle + turn), 0]

    text = table("", gravity=vector(pick.uniform(0, 7), 9.81))
    text += table("[object]", mass=pick.uniform(0.1, 5), box=[size, size, size * pick.uniform(0.1, 2)])
    for k, angle in enumerate(pick.sample([0, 1, 2, 3, 4, 5], pick.randint(2, 3))):
        at = angle * math.pi / 3
        text += finger(f"stop{k}", "point", center=vector(at + pick.uniform(-0.2, 0.2), size / 2),
                       normal=vector(at + math.pi), friction=pick.uniform(0, 1))
    at = pick.uniform(0, 7)
    return text + pusher("rod", "point", center=vector(at, size / 2), normal=vector(at + math.pi),
                         friction=pick.uniform(0, 1), acceleration=vector(pick.uniform(0, 7), pick.uniform(0.1, 3)))


class Planar(ToolTest):
    def test_a_moving_support_rubs_along_its_motion_alone(self):
        for facets in ("", "facets = 4\n", "facets = 6\n", 'facets = "round"\n'):
            found = json_of("solve", "-", text=facets + LIFT)
            (contact,) = found["contacts"]
            self.assertAlmostEqual(math.hypot(*found["bodies"][0]["force"]), 9.84257, 5)
            self.assertEqual(contact["friction_force"][1:], [0, 0])
            self.assertFalse(found["unique"]["final_basis"]["wrench_open"])
            self.assertIn("under one set of forces", run("spread", "-", text=facets + LIFT).stdout)

    def test_no_force_leaves_the_plane_and_space_agrees(self):
        solved = 0
        for seed in range(200):
            text = random_scene(seed)
            path = self.file("planar.toml", "planar = true\n" + text)
            found = json_of("solve", path, "--certify", self.path / "proof.json") if seed % 10 == 0 else (
                json_of("solve", path))
            if found["status"] != "solved":
                continue
            solved += 1
            for contact in found["contacts"]:
                self.assertEqual(contact["friction_force"][2], 0, seed)
            answer = self.file("answer.json", json.dumps(found))
            verdict = run("verify", self.file("space.toml", text), answer)
            self.assertEqual(verdict.returncode, 0, (seed, verdict.stdout))
            if seed % 10 == 0:
                check(json.loads((self.path / "proof.json").read_text()), [path.read_bytes()])
        self.assertGreater(solved, 150)

    def test_round_friction_turns_the_cones_of_the_table_alone(self):
        found, finest = (json_of("solve", "-", text=f"facets = {facets}\n" + PLATE) for facets in ('"round"', 256))
        self.assertLessEqual(found["off_round_cone"], 1e-9)
        self.assertLessEqual(found["residual"]["max"], 1e-9)
        rod, fine = found["contacts"][-1], finest["contacts"][-1]
        self.assertAlmostEqual(rod["normal_force"], fine["normal_force"], delta=1e-3 * fine["normal_force"])
        self.assertAlmostEqual(abs(rod["friction_force"][1]), 0.2 * rod["normal_force"], 9)
        for contact in found["contacts"][:-1]:
            slip, force = contact["acceleration"], contact["friction_force"]
            self.assertAlmostEqual(slip[0] * force[1], slip[1] * force[0], 9)
        self.assertEqual(run("verify", self.file("plate.toml", 'facets = "round"\n' + PLATE),
                             self.file("plate.json", json.dumps(found))).returncode, 0)

    def test_without_a_cone_round_friction_and_pyramids_are_the_same_problem(self):
        said = {run("solve", "-", "-v", text=facets + LIFT).stdout
                for facets in ("facets = 4\n", 'facets = "round"\n', "")}
        self.assertEqual(len(said), 1)
        self.assertIn("friction along the plane.", said.pop())

    def test_a_body_does_not_slip_across_the_plane(self):
        sideways = LIFT.replace("[2, 0, 0]", "[2, 0, 0.1]")
        self.is_refused(run("solve", "-", text=sideways), '"tray": moves across the plane')
        smooth = run("solve", "-", text=sideways.replace("friction = 0.8", "friction = 0"))
        self.assertEqual(smooth.returncode, 0)

    def test_every_command_takes_a_plane(self):
        for facets in ("facets = 8\n", 'facets = "round"\n'):
            scene = self.file("plate.toml", facets + PLATE)
            for words in (["break"], ["matrices"], ["pivots"], ["spread"], ["cone"], ["move", "--time", "0.1"],
                          ["report", "-o", self.path / "page.html"], ["play", "-o", self.path / "play.html"],
                          ["export", "-o", self.path / f"out{len(facets)}"]):
                result = run(words[0], scene, *words[1:])
                self.assertEqual(result.returncode, 0, (words, result.stdout, result.stderr))


main()
