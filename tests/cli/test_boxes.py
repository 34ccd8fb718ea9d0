"""lcpush lcp and verify --lcp in boxes: --lo, --hi and --findex, from files, typed, and from standard input."""
import json

from tool import ToolTest, main, run, unwrapped

ARRAY = "%%MatrixMarket matrix array real general\n"
CONTACT = ("--M", "2 0; 0 2", "--q", "-5 -3")


def answer(*words, text=""):
    return json.loads(run("lcp", *words, "--json", text=text).stdout)


class Boxes(ToolTest):
    def file(self, name, *numbers):
        path = self.path / name
        path.write_text(f"{ARRAY}{len(numbers)} 1\n" + "\n".join(numbers) + "\n")
        return path

    def test_ends_are_files_or_numbers_or_one_for_all(self):
        typed = answer(*CONTACT, "--lo", "-1 -1", "--hi", "1 1")
        self.assertEqual((typed["status"], typed["z"], typed["at"]), ("solved", [1, 1], ["hi", "hi"]))
        self.assertIsNone(typed["basis"])
        self.assertEqual(answer(*CONTACT, "--lo", "-1", "--hi", "1"), typed)
        files = answer(*CONTACT, "--lo", self.file("lo.mtx", "-1", "-1"), "--hi", self.file("hi.mtx", "1", "1"))
        self.assertEqual(files, typed)
        self.assertEqual(answer(*CONTACT, "--hi", self.file("hi.mtx", "inf", "Infinity"))["z"], [2.5, 1.5])
        self.assertEqual(answer(*CONTACT, "--lo", "-inf", "--hi", "inf")["at"], ["between", "between"])

    def test_a_row_follows_another_ones_force(self):
        for solver in ("lemke", "gauss-seidel", "hybrid"):
            found = answer(*CONTACT, "--hi", "inf 0.5", "--findex", "-1 0", "--solver", solver)
            self.assertEqual((found["status"], found["z"], found["at"]),
                             ("solved", [2.5, 1.25], ["between", "hi"]), solver)
        self.assertIn("between", run("lcp", *CONTACT, "--hi", "inf 0.5", "--findex", "-1 0").stdout)

    def test_verify_judges_in_the_form_given(self):
        path = self.path / "z.json"
        for z, valid in (([2.5, 1.25], True), ([2.5, 1.5], False), ([2.5, -1.25], False)):
            path.write_text(json.dumps({"z": z}))
            result = run("verify", *CONTACT, path, "--hi", "inf 0.5", "--findex", "-1 0", "--json")
            report = json.loads(result.stdout)
            self.assertEqual(report["valid"] if "valid" in report else result.returncode == 0, valid, report)
            self.assertEqual(result.returncode, 0 if valid else 1)
            if valid:
                self.assertEqual((report["verdict"], report["products"] if "products" in report else 0),
                                 ("same solution", 0))

    def test_matrices_come_from_standard_input_and_may_be_empty(self):
        q = self.file("q.mtx", "-5", "-6")
        matrix = ARRAY.replace("general", "symmetric") + "2 2\n2 1\n2\n"
        self.assertEqual(answer("-", q, text=matrix)["w"], [0, 0])
        empty = self.path / "empty.mtx"
        empty.write_text(ARRAY + "0 0\n")
        none = self.path / "none.mtx"
        none.write_text(ARRAY + "0 1\n")
        found = answer(empty, none)
        self.assertEqual((found["status"], found["z"], found["pieces"]), ("solved", [], 0))

    def test_other_programs_infinities_and_brackets_are_read_alike(self):
        wanted = answer(*CONTACT, "--lo", "-inf -inf", "--hi", "inf 1")
        for lo in ("-1e15", "-1e20 -1e30", "[-Inf; -1e300]", "-infinity,-inf", self.file("lo.mtx", "-1e15", "-Inf")):
            for hi in ("1e15 1", "[1e20; 1]", "Inf 1", self.file("hi.mtx", "1e30", "1")):
                for problem in (CONTACT, ("--M", "[2 0; 0 2]", "--q", "[-5; -3]"),
                                ("--M", "[[2, 0], [0, 2]]", "--q", "[-5, -3]")):
                    self.assertEqual(answer(*problem, "--lo", lo, "--hi", hi), wanted, (lo, hi, problem))
        said = run("lcp", *CONTACT, "--hi", "1e20 1e15").stderr
        self.assertEqual(said.count("taken as infinite"), 1, said)
        self.assertNotIn("infinite", run("lcp", *CONTACT, "--hi", "1e14 inf").stderr)
        self.assertIn("is not a number", run("lcp", "--M", "[2 0; 0 2", "--q", "1 1").stderr)

    def test_verify_judges_a_box_in_its_own_units(self):
        path = self.path / "z.json"
        for M, q, good in (("1 1e-11; 1e-11 1", "-1.5 -1e12", "1e12"), ("1 1e-7; 1e-7 1", "-1.5 -1e8", "1e8")):
            for z, valid in (("-5", False), ("1.9", False), ("1.01", False), ("1", True)):
                path.write_text(f'{{"z": [{z}, {good}]}}')
                self.assertEqual(run("verify", "--M", M, "--q", q, "--lo", "1 0", "--hi", "2 inf", path).returncode,
                                 0 if valid else 1, (z, good))

    def test_an_obstacle_of_10000_rows_is_solved_in_time_or_refused_by_name(self):
        m, lines = 100, []
        for i in range(m * m):
            lines += [f"{i + 1} {i + 1} 4"]
            lines += [f"{j + 1} {i + 1} -1" for j in (i + 1, i + m) if j < m * m and (j == i + m or j % m)]
        M = self.path / "membrane.mtx"
        M.write_text(f"%%MatrixMarket matrix coordinate real symmetric\n{m * m} {m * m} {len(lines)}\n" +
                     "\n".join(lines))
        q = self.file("q.mtx", *[str((-1) ** (i // 1250) * 1e-3) for i in range(m * m)])
        found = answer(M, q)
        self.assertEqual((found["status"], found["solver"]), ("solved", "gauss-seidel"))
        self.assertLess(found["residual"], 1e-8)
        refused = unwrapped(run("lcp", M, q, "--solver", "lemke").stderr)
        self.assertIn("pivots store 1.6 GB, and no command takes more than 1", refused)
        self.assertIn("--seconds", run("lcp", "--help").stdout)

    def test_large_pieces_are_announced_and_gauss_seidel_needs_none(self):
        n, lines = 2001, []
        for i in range(1, n + 1):
            lines.append(f"{i} {i} 2.5")
            if i < n:
                lines.append(f"{i + 1} {i} -1")
        M = self.path / "chain.mtx"
        M.write_text(f"%%MatrixMarket matrix coordinate real symmetric\n{n} {n} {len(lines)}\n" + "\n".join(lines))
        q = self.file("q.mtx", *["1"] * n)
        told = unwrapped(run("lcp", M, q, "--solver", "lemke").stderr)
        self.assertIn("lcpush: 2001 unknowns in one piece: pivots store 0.1 GB", told)
        self.assertIn("--solver gauss-seidel stores only what is not zero", told)
        self.assertEqual(run("lcp", M, q, "--solver", "gauss-seidel").stderr, "")


main()
