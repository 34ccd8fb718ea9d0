"""lcpush matrices: the paper's matrices with names, as text and as JSON."""
import json
import math

import tool
from tool import SOURCE, ToolTest, command, main
from scene_tables import finger, pusher, table

run = command("matrices")
SCENES = sorted((SOURCE / "fixtures/scenes").glob("*.toml"))
SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"

# Everything at once: an edge, a soft point, a pulling pusher, an actuator that turns a body.
MIXED = (
    table("[object]", mass=0.5, box=[0.1, 0.04, 0.02]) +
    finger("pad", "rectangle", center=[0.01, 0, 0.01], normal=[0, 0, -1], size=[0.02, 0.01], points=[3, 2],
        friction=0.4) +
    finger("tip", "point", center=[0, 0, -0.01], normal=[0, 0, 1], friction=0.6, torsion_radius=0.003) +
    pusher("wall", "line", ends=[[-0.05, -0.01, 0], [-0.05, 0.01, 0]], points=3, normal=[1, 0, 0], friction=0.3,
        follow="bilateral", acceleration=[0.1, 0, 0]) +
    table("[[actuator]]", name="tendon", bodies=["pad", "tip"], twists=[[0, 0, -1, 0, 2, 0], [0, 0, 1, 0, 0, 0]],
        force=20)
)


def column(matrix, name):
    at = matrix["columns"].index(name)
    return [row[at] for row in matrix["values"]]


def entry(matrix, row, name):
    return column(matrix, name)[matrix["rows"].index(row)]


class Matrices(ToolTest):
    def answer(self, text=None, path=SLIDE):
        if text is not None:
            path = self.file("scene.toml", text)
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
        overview = tool.run("--help")
        self.assertIn("  matrices  ", overview.stdout)
        out = self.path / "m.json"
        self.assertEqual(run(SLIDE, "--json", "-o", out).returncode, 0)
        self.assertEqual(json.loads(out.read_text()), self.answer())
        for words, message in [(("missing.toml",), "missing.toml"), ((), "a scene file is needed"),
                               ((SLIDE, "--format", "yaml"), "text or json")]:
            result = run(*words)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stdout, "")
            self.assertIn(message, result.stderr)


main()
