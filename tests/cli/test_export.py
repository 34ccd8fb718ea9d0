"""lcpush export: every file is there, fits the others and says what its numbers are."""
import json
import pathlib
import subprocess
import sys

from tool import SOURCE, ToolTest, main, run, unwrapped

SCENES = sorted((SOURCE / "fixtures/scenes").glob("*.toml"))
SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"
SOFT = SOURCE / "fixtures/scenes/soft_fingers.toml"
FCLIB = {"W", "V", "R", "mu", "q", "s"}


def read(path):
    """A Matrix Market file: rows, columns and {(row, column): value}, both from 1."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("%")]
    is_array = " array " in path.read_text().splitlines()[0]
    rows, columns, *_ = map(int, lines[0].split())
    if is_array:
        values = {(k % rows + 1, k // rows + 1): float(line) for k, line in enumerate(lines[1:])}
        assert len(values) == rows * columns
    else:
        entries = [line.split() for line in lines[1:]]
        values = {(int(i), int(j)): float(value) for i, j, value in entries}
        assert len(values) == len(entries)
    return rows, columns, values


class Export(ToolTest):
    def setUp(self):
        super().setUp()
        self.out = pathlib.Path(self.path, "new", "out")

    def export(self, scene, out=None):
        result = run("export", scene, "-o", out or self.out)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_every_fixture_has_files_that_fit_each_other(self):
        self.assertTrue(SCENES)
        for path in SCENES:
            with self.subTest(path=path.name):
                out = self.out / path.stem
                self.export(path, out)
                names = json.loads((out / "names.json").read_text())
                n, lcp = len(names["unknowns"]), names["lcp_unknowns"]
                c, rest = names["complementary"], len(names["Aeq"])
                self.assertEqual((len(names["A"]), c + rest), (c, n))
                shapes = {"M": (lcp, lcp), "q": (lcp, 1), "H": (n, n), "f": (n, 1), "A": (c, n),
                          "b": (c, 1), "Aeq": (rest, n), "beq": (rest, 1), "lb": (n, 1),
                          "ub": (n, 1), "answer": (len(names["answer"]), n)}
                for name, shape in shapes.items():
                    self.assertEqual(read(out / f"{name}.mtx")[:2], shape, name)
                free = (out / "free.txt").read_text().strip()
                free = [int(k) for k in free.split(",")] if free else []
                self.assertEqual(free, list(range(c + 1, lcp + 1)))
                self.assertEqual(len(free), len(names["actuators"]))
                done = run("lcp", out / "M.mtx", out / "q.mtx", "--free", out / "free.txt", "--json")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                lines = (out / "names.txt").read_text().splitlines()
                self.assertEqual([line.split("\t")[1] for line in lines],
                                 [unknown["name"] for unknown in names["unknowns"][:lcp]])

    def test_every_number_has_a_name_a_unit_and_a_scale(self):
        self.export(SLIDE)
        names = json.loads((self.out / "names.json").read_text())
        for table in ("unknowns", "A", "Aeq", "answer"):
            self.assertEqual([q["index"] for q in names[table]],
                             list(range(1, len(names[table]) + 1)))
            for quantity in names[table]:
                self.assertEqual(list(quantity), ["index", "name", "symbol", "contact", "law",
                                                  "unit", "scale"])
                self.assertTrue(quantity["name"] and quantity["symbol"])
                self.assertIn(quantity["unit"], ("N", "m/s^2", "N m", "rad/s^2"))
                self.assertGreater(quantity["scale"], 0)
                self.assertIn(quantity["contact"], [None, *names["contacts"]])
        by_name = {q["name"]: q for q in names["unknowns"]}
        self.assertEqual(len(by_name), len(names["unknowns"]))
        self.assertEqual(by_name["normal of wall.1"]["scale"], 40)  # the jaw's 2 F
        self.assertEqual(by_name["slip of wall.1"]["unit"], "m/s^2")
        self.assertEqual(by_name["slip of wall.1"]["scale"], 200)  # 40 N / 0.2 kg
        self.assertEqual(by_name["acceleration of wall.1 along n = +x"]["symbol"], "r_n")
        laws = {row["law"] for row in names["A"] + names["Aeq"]}
        self.assertEqual(laws, {"[T.1]", "[T.2]", "[T.3]", "[T.4]", "[T.5]", "[T.6]", "[P.10]"})
        answer = [q["name"] for q in names["answer"]]
        self.assertEqual(answer[:7], ["object.acceleration"] * 6 + ["closing"])
        self.assertEqual(answer[7:15], ["normal_force"] + ["friction_force"] * 3 + ["torsion"] +
                         ["acceleration"] * 3)

    def test_an_actuator_that_turns_a_body_has_other_units(self):
        self.export(SOURCE / "fixtures/scenes/three_finger_hand.toml")
        names = json.loads((self.out / "names.json").read_text())
        units = {q["name"]: q["unit"] for q in names["unknowns"] if q["symbol"] == "s"}
        self.assertIn("1/s^2", units.values())
        balances = [q["unit"] for q in names["Aeq"] if q["law"] == "[T.5]"]
        self.assertIn("J", balances)

    def test_the_complementarity_problem_solves_again(self):
        printed = self.export(SLIDE)
        again = next(line for line in printed.splitlines() if line.startswith("Solve it again: "))
        result = run(*again.split(": ", 1)[1].split()[1:], "--json")
        self.assertEqual(json.loads(result.stdout)["status"], "solved")

    def test_the_scripts_are_python_and_say_what_a_positive_objective_means(self):
        printed = self.export(SLIDE)
        self.assertIn("solve_push.py", printed)
        self.assertIn("lcpush verify", printed)
        sentences = [line for line in printed.splitlines() if "lcpush " not in line and "solve_push" not in line]
        self.assertLessEqual(max(map(len, sentences)), 80)
        self.assertIn(" length 0.0522015 m,", " ".join(printed.split()))
        (self.out / "numpy.py").write_text("raise ImportError('No module named numpy')")
        bare = subprocess.run([sys.executable, self.out / "solve_push.py"], capture_output=True, text=True)
        (self.out / "numpy.py").unlink()
        self.assertEqual((bare.returncode, bare.stderr.count("\n")), (1, 1), bare.stderr)
        self.assertIn("needs NumPy and SciPy", bare.stderr)
        compile((self.out / "solve_push.py").read_text(), "solve_push.py", "exec")
        for script in ("solve_push.py", "solve_push.m"):
            text = (self.out / script).read_text()
            self.assertIn("NOT a solution", text)
            self.assertLessEqual(max(map(len, text.splitlines())), 110)

    def test_what_fclib_cannot_say_is_left_out_and_not_left_over(self):
        self.export(SLIDE)
        self.assertEqual({path.stem for path in (self.out / "fclib").iterdir()}, FCLIB)
        rows, columns, W = read(self.out / "fclib/W.mtx")
        self.assertEqual(rows, columns)
        self.assertEqual(W, {(j, i): value for (i, j), value in W.items()})
        kept = self.out / "fclib" / "mine.txt"
        kept.write_text("a note")
        printed = self.export(SOFT)
        self.assertIn('No fclib/: "left" resists twisting', printed)
        self.assertEqual(list((self.out / "fclib").iterdir()), [kept])

    def test_numbers_keep_their_bits_at_any_scale(self):
        text = SLIDE.read_text().replace("grip_force = 20", "grip_force = 2.0000000000000004e-7")
        scene = pathlib.Path(self.path, "small.toml")
        scene.write_text(text.replace("gravity = [0, -9.81, 0]", "gravity = [0, 0, 0]")
                         .replace("acceleration = [0.1, 0, 0]", "acceleration = [1e-9, 0, 0]"))
        self.export(scene)
        names = json.loads((self.out / "names.json").read_text())
        self.assertEqual(names["unknowns"][0]["scale"], 4.000000000000001e-7)
        self.assertIn("force 4.000000000000001e-07 N", (self.out / "M.mtx").read_text())

    def test_bad_input_is_refused(self):
        for words, message in [
                (("export", SLIDE), "say where to: -o DIRECTORY"),
                (("export", "missing.toml", "-o", self.out), "missing.toml"),
                (("export", SLIDE, "-o", SLIDE), "--output is ")]:
            result = run(*words)
            self.assertEqual((result.returncode, result.stdout), (2, ""), words)
            self.assertIn(message, unwrapped(result.stderr))
        self.assertFalse(self.out.exists())


main()
