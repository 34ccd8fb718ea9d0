"""Round friction from the command line: facets = "round".

    test_round.py TOOL SOURCE
"""
import json
import math
import pathlib
import tempfile
import unittest

from tool import SOURCE, json_of, main, run, unwrapped

from scene_tables import finger, pusher, table

FOLDER = tempfile.TemporaryDirectory()


def scene(name, facets='"round"'):
    lines = (SOURCE / f"fixtures/scenes/{name}.toml").read_text().splitlines()
    kept = [line for line in lines if not line.startswith("facets")]
    path = pathlib.Path(FOLDER.name) / f"{name}.toml"
    path.write_text("\n".join([f"facets = {facets}", *kept]) + "\n")
    return path


def verdict(path, data):
    file = pathlib.Path(FOLDER.name) / "answer.json"
    file.write_text(json.dumps(data))
    return run("verify", path, file)


class Round(unittest.TestCase):
    def test_friction_is_opposite_to_every_slip(self):
        for name in ("pivot", "tipping", "screw_driving", "soft_fingers", "rotating_pusher"):
            found = json_of("solve", scene(name))
            self.assertEqual(found["status"], "solved", name)
            self.assertLessEqual(found["residual"]["max"], 1e-9)
            self.assertLessEqual(found["off_round_cone"], 1e-9)

    def test_pressure_is_affine_over_what_touches_however_the_scene_is_turned(self):
        """A box that is dragged over four points leaves one: the others bear what statics asks, 0.832, 4.839 and 2.338 N.

        On the way the pads press otherwise: what they have left of that is no pressure of their law."""
        def rotated(R, v):
            return [sum(R[i][k] * v[k] for k in range(3)) for i in range(3)]
        a, b = 0.7, 0.4
        turned = [[math.cos(a), -math.sin(a) * math.cos(b), math.sin(a) * math.sin(b)],
                  [math.sin(a), math.cos(a) * math.cos(b), -math.cos(a) * math.sin(b)], [0, math.sin(b), math.cos(b)]]
        inertia = (0.00032208171308801013, 0.0003536082543404321, 0.0004684734587475781)
        for R in ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], turned):
            I = [[sum(R[i][k] * inertia[k] * R[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
            x, y, z = 0.05, 0.046741144481877855, 0.03218823610271804
            legs = [rotated(R, p) for p in ([-x, -y, -z], [-x, -y, z], [x, -y, -z], [x, -y, z])]
            path = pathlib.Path(FOLDER.name) / "dragged.toml"
            path.write_text(
                table("", gravity=rotated(R, [0, -9.81, 0])) +
                table("[object]", mass=0.3, inertia=[I[0][0], I[1][1], I[2][2], I[0][1], I[0][2], I[1][2]]) +
                finger("t", "points", points=legs, normal=rotated(R, [0, 1, 0]), friction=0.45045261520196966) +
                pusher("p", "point", center=rotated(R, [-0.006304691294385479, y, -0.010875536532143829]),
                       normal=rotated(R, [0, -1, 0]), friction=0.9545825319761843, normal_force=5.066751826013125,
                       acceleration=rotated(R, [1.4377350334351762, 0, -0.6546414383644319])))
            found = json_of("solve", path)
            for contact, force in zip(found["contacts"], (0.832, 0, 4.839, 2.338)):
                self.assertAlmostEqual(contact["normal_force"], force, delta=2e-3)

    def test_a_pyramid_is_told_what_it_costs(self):
        path = scene("pivot", "8")
        self.assertGreater(json_of("solve", path)["off_round_cone"], 1e-3)
        self.assertIn("8 facets cost up to", run("solve", path, "-v").stdout)

    def test_verify_judges_by_the_round_cone(self):
        of_pyramids = json_of("solve", scene("pivot", "8"))
        path = scene("pivot")
        mine = json_of("solve", path)
        self.assertIn("Same solution.", verdict(path, mine).stdout)
        self.assertEqual(verdict(path, of_pyramids).returncode, 1)
        turned = json.loads(json.dumps(mine))
        force = turned["contacts"][0]["friction_force"]
        c, s = math.cos(0.01), math.sin(0.01)
        turned["contacts"][0]["friction_force"] = [c * force[0] - s * force[1],
                                                   s * force[0] + c * force[1], force[2]]
        self.assertEqual(verdict(path, turned).returncode, 1)
        long = json.loads(json.dumps(mine))
        long["contacts"][0]["friction_force"] = [1.01 * x for x in force]
        self.assertEqual(verdict(path, long).returncode, 1)

    def test_verify_fills_in_the_forces_of_a_motion(self):
        path = scene("pivot")
        motion = {"object": json_of("solve", path)["object"]}
        self.assertEqual(verdict(path, motion).returncode, 0, verdict(path, motion).stdout)

    def test_a_line_between_forces_is_no_line_and_sweeps_say_so(self):
        path = scene("pivot")
        swept = json.loads(run("sweep", path, "--vary", "*.grip_force=10:20", "--steps", "5",
                               "--json").stdout)
        self.assertFalse([s for s in swept.get("segments", []) if s["kind"] == "exact"])
        self.assertEqual({p["status"] for p in swept["points"]}, {"solved"})

    def test_what_speaks_of_pyramids_says_so(self):
        path = scene("pivot")
        self.assertIn("pyramids of 8 facets", unwrapped(run("spread", path).stdout))
        proved = run("solve", path, "--json", "--certify", pathlib.Path(FOLDER.name) / "c.json")
        self.assertIn("Pyramids of 8 facets stand for round friction here.", proved.stderr)
        self.assertEqual(json.loads(proved.stdout)["friction"]["law"], "pyramids")
        self.assertEqual(json.loads((pathlib.Path(FOLDER.name) / "c.json").read_text())["facets"], 8)

    def test_friction_is_round_unless_the_scene_or_an_option_says_facets(self):
        silent = pathlib.Path(FOLDER.name) / "silent.toml"
        silent.write_text(scene("pivot").read_text().replace('facets = "round"\n', ""))
        of = lambda path, *words: json.loads(run("solve", path, "--json", *words).stdout)
        self.assertEqual(of(silent)["object"], of(scene("pivot"))["object"])
        self.assertEqual(of(silent)["friction"]["law"], "round")
        self.assertEqual(of(silent, "--facets", "8")["object"], of(scene("pivot", "8"))["object"])
        self.assertEqual(of(scene("pivot", "8"), "--facets", "round")["object"], of(silent)["object"])
        # Somebody else's pyramids are judged as what they say they are, where the scene says nothing.
        other = of(silent, "--facets", "8")
        self.assertEqual(verdict(silent, other).returncode, 0)
        self.assertEqual(verdict(scene("pivot"), other).returncode, 1)
        del other["friction"]
        self.assertEqual(verdict(silent, other).returncode, 1)

    def test_every_command_takes_it(self):
        path = scene("pivot")
        page = pathlib.Path(FOLDER.name) / "page.html"
        for words in (["break", path], ["report", path, "-o", page], ["matrices", path],
                      ["pivots", path], ["move", path, "--time", "0.1"],
                      ["solve", path, "--solver", "gauss-seidel"],
                      ["solve", path, "--solver", "hybrid"]):
            done = run(*words)
            self.assertEqual(done.returncode, 0, (words, done.stdout, done.stderr))

    def test_a_word_that_is_no_number_of_facets_is_refused_with_its_line(self):
        done = run("solve", scene("pivot", '"rund"'))
        self.assertEqual(done.returncode, 2)
        self.assertIn('pivot.toml:1: facets must be a whole number from 4 to 256, or "round"',
                      unwrapped(done.stderr))


main()
