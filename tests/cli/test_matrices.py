"""lcpush matrices: the paper's matrices with names, as text and as JSON."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENES = sorted((SOURCE / "fixtures/scenes").glob("*.toml"))
SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"

# Everything at once: an edge, a soft point, a pulling pusher, an actuator that turns a body.
MIXED = """
[object]
mass = 0.5
box = [0.1, 0.04, 0.02]
[[finger]]
name = "pad"
shape = "rectangle"
center = [0.01, 0, 0.01]
normal = [0, 0, -1]
size = [0.02, 0.01]
points = [3, 2]
friction = 0.4
[[finger]]
name = "tip"
shape = "point"
center = [0, 0, -0.01]
normal = [0, 0, 1]
friction = 0.6
torsion_radius = 0.003
[[pusher]]
name = "wall"
shape = "line"
ends = [[-0.05, -0.01, 0], [-0.05, 0.01, 0]]
points = 3
normal = [1, 0, 0]
friction = 0.3
follow = "bilateral"
acceleration = [0.1, 0, 0]
[[actuator]]
name = "tendon"
bodies = ["pad", "tip"]
twists = [[0, 0, -1, 0, 2, 0], [0, 0, 1, 0, 0, 0]]
force = 20
"""


# A finger that a wrist turns as prescribed, and a pusher that the same wrist carries along.
WRIST = """
[object]
mass = 0.5
box = [0.1, 0.04, 0.02]
center_of_mass = [0.003, -0.002, 0.001]
[[finger]]
name = "pad"
shape = "line"
ends = [[0.01, 0.02, -0.005], [0.01, 0.02, 0.005]]
normal = [0, -1, 0]
friction = 0.4
[[pusher]]
name = "wall"
shape = "line"
ends = [[-0.05, -0.01, 0], [-0.05, 0.01, 0]]
normal = [1, 0, 0]
friction = 0.3
acceleration = [0.1, 0, 0.02]
angular_acceleration = [0, 0.3, 0.5]
about = [0, 0.01, 0]
[[actuator]]
name = "wrist"
bodies = ["pad", "wall"]
twists = [[0, 0.1, 0, 0, 0, 1], [0.01, 0, 0, 0, 0, 0.2]]
acceleration = 0.5
"""


def run(*words):
    return subprocess.run([TOOL, "matrices", *map(str, words)], capture_output=True, text=True,
                          timeout=60)


def column(matrix, name):
    at = matrix["columns"].index(name)
    return [row[at] for row in matrix["values"]]


def entry(matrix, row, name):
    return column(matrix, name)[matrix["rows"].index(row)]


class Matrices(unittest.TestCase):
    def answer(self, text=None, path=SLIDE):
        with tempfile.TemporaryDirectory() as folder:
            if text is not None:
                path = pathlib.Path(folder, "scene.toml")
                path.write_text(text)
            result = run(path, "--json")
        self.assertEqual(result.returncode, 0, result)
        return json.loads(result.stdout)

    def near(self, left, right):
        self.assertEqual(len(left), len(right))
        for x, y in zip(left, right):
            self.assertAlmostEqual(x, y, 12)

    def test_every_fixture_has_matrices_of_matching_shapes(self):
        self.assertTrue(SCENES)
        for path in SCENES:
            with self.subTest(path=path.name):
                m = self.answer(path=path)
                self.assertEqual(list(m), ["warnings", "M", "w", "G", "G_bar", "J", "J_prescribed",
                                           "s_prescribed", "v", "J_pusher", "D", "rigidity"])
                for key in ("M", "w", "G", "G_bar", "J"):
                    self.assertEqual(list(m[key]), ["rows", "columns", "values"])
                    self.assertEqual(len(m[key]["values"]), len(m[key]["rows"]))
                    for row in m[key]["values"]:
                        self.assertEqual(len(row), len(m[key]["columns"]))
                for key in ("M", "w", "G", "G_bar"):
                    self.assertEqual(m[key]["rows"], ["fx", "fy", "fz", "mx", "my", "mz"])
                self.assertEqual(m["J"]["rows"], m["G"]["columns"])
                for patch in m["rigidity"]:
                    k, r = len(patch["points"]), len(patch["references"])
                    self.assertEqual(patch["count"], 0 if k == 1 else 3 * k - (r - 1) - 4)
                    self.assertEqual(patch["rank"], patch["count"])
                    self.assertIs(patch["holds"], True)
                    # W(t) is affine in the point, so it follows the references as r does.
                    for point, weights in zip(patch["points"], patch["weights"]):
                        self.assertAlmostEqual(sum(weights), 1, 12)
                        follows = [0.0] * 6
                        for alpha, reference in zip(weights, patch["references"], strict=True):
                            for i, x in enumerate(column(m["G"], f"{reference} t")):
                                follows[i] += alpha * x
                        self.near(column(m["G"], f"{point} t"), follows)

    def test_contact_accelerations_follow_from_what_is_printed(self):
        """[P.10]: r = G' a - J s - v, with v from what is prescribed, for every answer of solve."""
        self.assertEqual([path.stem for path in SCENES if not self.check_answer(path)], ["jam"])
        with tempfile.TemporaryDirectory() as folder:
            for text in (MIXED, WRIST):
                path = pathlib.Path(folder, "scene.toml")
                path.write_text(text)
                self.assertTrue(self.check_answer(path))

    def check_answer(self, path):
        solved = json.loads(subprocess.run([TOOL, "solve", path, "--json"], timeout=60,
                                           capture_output=True, text=True).stdout)
        with self.subTest(path.name):
            if solved["status"] == "solved":
                self.check_accelerations(self.answer(path=path), solved)
        return solved["status"] == "solved"

    def check_accelerations(self, m, solved):
        names, a = m["G"]["columns"], solved["object"]["acceleration"]
        v = dict(zip(names, column(m["v"], "v")))
        prescribed = dict.fromkeys(names, 0.0)
        for actuator, (s,) in zip(m["s_prescribed"]["rows"], m["s_prescribed"]["values"]):
            for name, x in zip(names, column(m["J_prescribed"], actuator)):
                prescribed[name] += x * s
        for pusher in m["J_pusher"]:
            A = column(pusher["twist"], "A")
            for name, row in zip(pusher["rows"], pusher["values"]):
                prescribed[name] += sum(x * y for x, y in zip(row, A))
        self.near([v[name] for name in names], [prescribed[name] for name in names])
        # solve prints what closes each body along its normal, which its points share on average.
        s = {}
        for body in solved["bodies"]:
            points = [c["name"] for c in solved["contacts"] if c["body"] == body["name"]]
            normals = [f"{point} n" for point in points]
            for actuator in m["J"]["columns"] if body["closing_acceleration"] is not None else ():
                closing = sum(entry(m["J"], n, actuator) for n in normals) / len(normals)
                if closing:
                    s[actuator] = body["closing_acceleration"] / closing
        self.assertEqual(set(s), set(m["J"]["columns"]))
        J = {n: sum(x * s[k] for x, k in zip(row, m["J"]["columns"]))
             for n, row in zip(m["J"]["rows"], m["J"]["values"])}
        moving = max(map(abs, [*a, *v.values(), *J.values()]))
        for contact in solved["contacts"]:
            for component in ("n", "t", "o", "torsion"):
                name = f"{contact['name']} {component}"
                if name not in names:
                    continue
                W = column(m["G"], name)
                r = sum(x * y for x, y in zip(W, a)) - J[name] - v[name]
                printed = (contact["spin"] if component == "torsion"
                           else sum(x * y for x, y in zip(W, contact["acceleration"])))
                self.assertAlmostEqual(r, printed, delta=1e-9 * moving, msg=name)

    def test_the_slide_by_hand(self):
        m = self.answer()
        self.assertAlmostEqual(m["M"]["values"][0][0], 0.2)
        self.assertAlmostEqual(m["M"]["values"][5][5], 0.2 / 12 * (0.1**2 + 0.03**2))
        self.near([row[0] for row in m["w"]["values"]], [0, 0.2 * -9.81, 0, 0, 0, 0])
        wall = column(m["G"], "wall.1 n")
        self.near(wall[:3], [1, 0, 0])
        self.assertAlmostEqual(abs(wall[5]), 0.015)
        self.assertEqual(wall, column(m["G_bar"], "wall.1 n"))
        left = [name for name in m["J"]["rows"] if name.startswith("left.")]
        for name in left:
            self.assertEqual(entry(m["J"], name, "jaws"), 1 if name.endswith(" n") else 0)

    def test_soft_pulling_and_driven_bodies_have_their_rows_and_columns(self):
        m = self.answer(MIXED)
        self.assertEqual([c for c in m["G"]["columns"] if c.startswith("tip")],
                         ["tip.1 n", "tip.1 t", "tip.1 o", "tip.1 torsion"])
        self.near(column(m["G"], "tip.1 torsion"), [0, 0, 0, 0, 0, 1])
        self.assertEqual(column(m["G_bar"], "wall.1 n"), column(m["G"], "wall.1 n"))
        self.near(column(m["G_bar"], "wall.1 -n"), [-x for x in column(m["G_bar"], "wall.1 n")])
        self.assertEqual(m["J"]["columns"], ["tendon"])
        self.assertEqual(entry(m["J"], "tip.1 n", "tendon"), 1)
        self.assertEqual(entry(m["J"], "tip.1 torsion", "tendon"), 0)
        # pad turns about y by 2: a point at x moves along z by -2 x, against its normal -z.
        corner = next(c for c in m["G"]["columns"] if c.startswith("pad") and c.endswith(" n"))
        x = column(m["G"], corner)[4]  # my of a force along -z at x is x
        self.assertAlmostEqual(entry(m["J"], corner, "tendon"), 1 + 2 * x, 12)
        by_body = {d["body"]: d for d in m["D"]}
        self.assertEqual(by_body["pad"]["rows"], ["t", "o"])
        self.assertEqual(by_body["tip"]["rows"], ["t", "o", "torsion"])
        for d in by_body.values():
            for t, o, *torsion in zip(*d["values"]):
                self.assertAlmostEqual(math.hypot(t, o, *(x / 0.003 for x in torsion)), 1, 12)
        patches = {p["body"]: p for p in m["rigidity"]}
        self.assertEqual([(patches[b]["count"], len(patches[b]["references"]))
                          for b in ("pad", "tip", "wall")], [(12, 3), (0, 1), (4, 2)])
        self.assertEqual(sorted(patches["wall"]["references"]), ["wall.1", "wall.3"])
        self.near(patches["wall"]["weights"][1], [0.5, 0.5])

    def test_g_bar_is_g_times_the_generators(self):
        m = self.answer(MIXED)
        for d in m["D"]:
            for j, name in enumerate(d["columns"]):
                wrench = [0.0] * 6
                for k, component in enumerate(d["rows"]):
                    for i, x in enumerate(column(m["G"], f"{d['body']}.1 {component}")):
                        wrench[i] += x * d["values"][k][j]
                self.near(column(m["G_bar"], f"{d['body']}.1 {name}"), wrench)

    def test_text_is_readable_and_says_the_same(self):
        for path in SCENES:
            lines = run(path).stdout.splitlines()
            self.assertLessEqual(max(map(len, lines)), 80, path.name)
        lines = run(SLIDE).stdout.splitlines()
        row = next(line.split() for line in lines if line.startswith("  wall.1 n "))
        self.near([float(x) for x in row[2:]], column(self.answer()["G"], "wall.1 n"))
        text = "\n".join(lines)
        for words in ("Inertia M", "Load w", "Grasp matrix G", "G-bar", "Hand Jacobian J",
                      "Friction generators D", "Patch rigidity", "rank found"):
            self.assertIn(words, text)
        self.assertNotIn("NOT as it should be", text)

    def test_many_actuators_stay_within_the_line(self):
        fingers = "".join(
            f'[[finger]]\nname = "a_long_finger_name_{i}"\nshape = "point"\n'
            f"center = [{i / 100}, 0, 0.005]\nnormal = [0, 0, -1]\nfriction = 0.5\ngrip_force = 1\n"
            for i in range(9))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "many.toml")
            path.write_text("[object]\nmass = 1\nbox = [0.1, 0.1, 0.1]\n" + fingers)
            lines = run(path).stdout.splitlines()
        self.assertLessEqual(max(map(len, lines)), 80)
        self.assertEqual(sum(line.startswith("  a_long_finger_name_8.1 n ") for line in lines), 8)

    def test_a_patch_too_large_for_ranks_says_so(self):
        patch = ('[[finger]]\nname = "pad"\nshape = "disc"\ncenter = [0, 0, 0.005]\n'
                 'normal = [0, 0, -1]\nradius = 0.004\npoints = 257\nfriction = 0.5\n')
        text = "facets = 4\n[object]\nmass = 1\nbox = [0.1, 0.1, 0.01]\n" + patch
        (pad,) = self.answer(text)["rigidity"]
        self.assertEqual(pad["count"], 3 * 257 - 6)
        self.assertIsNone(pad["rank"])
        self.assertIsNone(pad["holds"])

    def test_help_output_and_usage(self):
        help_text = run("--help").stdout
        self.assertIn("Example:\n  lcpush matrices ", help_text)
        overview = subprocess.run([TOOL, "--help"], capture_output=True, text=True, timeout=60)
        self.assertIn("  matrices  ", overview.stdout)
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "m.json")
            self.assertEqual(run(SLIDE, "--json", "-o", out).returncode, 0)
            self.assertEqual(json.loads(out.read_text()), self.answer())
        for words, message in [(("missing.toml",), "missing.toml"), ((), "a scene file is needed"),
                               ((SLIDE, "--format", "yaml"), "text or json")]:
            result = run(*words)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stdout, "")
            self.assertIn(message, result.stderr)


unittest.main(argv=[sys.argv[0]], verbosity=1)
