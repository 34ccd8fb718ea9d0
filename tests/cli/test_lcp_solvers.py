"""lcpush lcp --solver: sweeps, pivots and both give the same answers, and say how they came there."""
import csv
import io
import json
import random
import re

from tool import SOURCE, ToolTest, command, main, unwrapped

run = command("lcp")
TEXTBOOK = SOURCE / "fixtures/textbook"
SOLVERS = ("lemke", "gauss-seidel", "hybrid")
BOUND = 1e-9


def inline(M, q):
    rows = "; ".join(" ".join(map(repr, row)) for row in M)
    return "--M", rows, "--q", " ".join(map(repr, q))


def solve(problem, solver, *options):
    return json.loads(run(*problem, "--solver", solver, "--json", *options).stdout)


def dominant(seed, n):
    """Rows that their positive diagonal outweighs: one solution, and sweeps converge to it."""
    source = random.Random(seed)
    M = [[source.uniform(-1, 1) for _ in range(n)] for _ in range(n)]
    for i, row in enumerate(M):
        row[i] = 0.2 + 1.1 * sum(abs(x) for j, x in enumerate(row) if j != i)
    return M, [source.uniform(-2, 2) for _ in range(n)]


def violation(M, q, z, free=()):
    """Of w = M z + q >= 0, z >= 0, z w = 0; w = 0 in the 1-based rows of `free`."""
    worst = 0
    for i, row in enumerate(M):
        w = q[i] + sum(a * b for a, b in zip(row, z))
        worst = max(worst, abs(w if i + 1 in free else min(w, z[i])))
    return worst


class Undecided(ToolTest):
    def test_pairs_below_the_rounding_of_others_are_settled(self):
        # Without undecided pairs (src/raw/search_further.cpp) both end in a ray.
        for name, free in (("undecided_pairs", range(16, 26)), ("undecided_pairs_longer", range(21, 31))):
            problem = [SOURCE / f"fixtures/raw/{name}.{k}.mtx" for k in "Mq"]
            answer = solve(problem, "lemke", "--free", ",".join(map(str, free)))
            self.assertEqual(answer["status"], "solved", name)


class Singular(ToolTest):
    def test_answers_in_which_q_is_lost_are_none(self):
        """Rank 1 and free rows: with unknowns of 1e19 every row's terms cancel to less than rounding of themselves."""
        rng = random.Random(2)
        for k in range(60):
            n = rng.randint(2, 4)
            v = [rng.gauss(0, 1) for _ in range(n)]
            M, q = [[a * b for b in v] for a in v], [rng.gauss(0, 1) for _ in range(n)]
            lo = ["0"] * n
            lo[rng.randrange(n)] = "-inf"
            answer = json.loads(run(*inline(M, q), "--lo=" + " ".join(lo), "--json").stdout)
            if answer["status"] != "solved":
                continue
            for i in range(n):
                w = sum(M[i][j] * answer["z"][j] for j in range(n)) + q[i]
                if answer["z"][i] != 0:
                    self.assertLess(abs(w), 1e-2, (k, M, q, answer))
                else:
                    self.assertGreater(w, -1e-2, (k, M, q, answer))

    def test_equalities_that_contradict_each_other_have_no_solution(self):
        for words in (("--M", "0", "--q", "1", "--lo", "-inf", "--hi", "inf"),
                      ("--M", "4 -4; -4 4", "--q", "-1 5", "--lo", "-inf", "--hi", "inf")):
            result = run(*words)
            self.assertEqual((result.returncode, result.stderr), (1, ""))
            self.assertRegex(unwrapped(result.stdout), "^There is no solution: equality [12] cannot hold")
            answer = json.loads(run(*words, "--json").stdout)
            self.assertIn(answer["inconsistent_row"], (1, 2))
            self.assertTrue(answer["has_no_solution"])

    def test_what_rounded_cones_do_not_show_is_no_proof(self):
        told = unwrapped(run("--M", "1 -3; -0.3333333333333 1", "--q", "-1 -1").stdout)  # z = (4e13, 1.3e13)
        self.assertNotIn("there is no solution", told)


class LcpSolvers(ToolTest):
    def test_free_rows_anywhere_keep_their_places(self):
        for seed in range(10):
            M, q = dominant(seed, 5)
            for free in ((1,), (2, 4), (1, 2, 3, 4, 5)):
                option = "--free", ",".join(map(str, free))
                for solver in SOLVERS:
                    with self.subTest(seed=seed, free=free, solver=solver):
                        answer = solve(inline(M, q), solver, *option)
                        self.assertEqual(answer["status"], "solved")
                        self.assertLessEqual(violation(M, q, answer["z"], free), 1e-7)
                        for i in free:
                            self.assertEqual(answer["basis"][i - 1], f"z{i}")

    def test_effort_is_counted_by_kind(self):
        problem = inline([[2, 1], [1, 2]], [-5, -6])
        lemke, sweeps, both = (solve(problem, solver) for solver in SOLVERS)
        self.assertEqual(lemke["sweeps"], 0)
        self.assertGreater(lemke["pivots"], 0)
        self.assertGreater(sweeps["sweeps"], 0)
        self.assertEqual((sweeps["pivots"], sweeps["covers"]), (0, 0))
        self.assertGreater(both["sweeps"], 0)
        self.assertLess(both["pivots"], lemke["pivots"])
        self.assertEqual(both["residual"], 0)
        self.assertRegex(run(*problem, "--solver", "gauss-seidel").stdout, r"^Solved in \d+ sweeps;")
        self.assertRegex(run(*problem, "--solver", "hybrid").stdout,
                         r"^Solved in \d+ sweeps and \d+ pivots;")

    def test_pgs_is_another_name_for_gauss_seidel(self):
        problem = inline([[2, 1], [1, 2]], [-5, -6])
        self.assertEqual(run(*problem, "--solver", "pgs", "--json").stdout,
                         run(*problem, "--solver", "gauss-seidel", "--json").stdout)

    def test_hybrid_solves_what_lemke_solves_and_fails_like_it(self):
        for M in sorted(TEXTBOOK.glob("*.M.mtx")):
            with self.subTest(problem=M.name):
                files = M, M.with_name(M.name.replace(".M.", ".q."))
                lemke, hybrid = solve(files, "lemke"), solve(files, "hybrid")
                self.assertEqual(hybrid["status"], lemke["status"])
                self.assertEqual(hybrid["solver"], "hybrid")
                if hybrid["status"] == "solved":
                    self.assertLessEqual(hybrid["residual"], BOUND)
                else:
                    self.assertEqual(hybrid["ray"], lemke["ray"])

    def test_a_ray_says_whether_it_proves_that_there_is_no_solution(self):
        rounded = [[1, -3], [-0.3333333333333, 1]]  # z = (4e13, 1.3e13)
        for M, q, proved in (([[-1]], [-1], True), ([[0, 1], [-1, 0]], [-1, -1], True), (rounded, [-1, -1], False)):
            problem = inline(M, q)
            answer = solve(problem, "lemke")
            self.assertEqual(answer["has_no_solution"], proved, M)
            self.assertEqual("There is no solution" in run(*problem).stdout, proved, M)

    def test_hybrid_leaves_redundant_equalities_to_pivots(self):
        problem = (*inline([[2, 1, 0], [1, 1, 1], [1, 1, 1]], [-5, -1, -1]), "--free", "2,3")
        lemke, hybrid = solve(problem, "lemke"), solve(problem, "hybrid")
        self.assertEqual(lemke["status"], hybrid["status"])
        self.assertEqual(hybrid["status"], "solved")

    def test_a_diagonal_that_is_not_positive_is_refused_by_row_number_and_file(self):
        message = r"--solver gauss-seidel needs a positive diagonal, but row 3 has 0; use lemke or hybrid"
        M, q = [[1, 0, 0], [0, 1, 0], [0, 0, 0]], [1, 1, 1]
        self.is_refused(run(*inline(M, q), "--solver", "gauss-seidel"), "^lcpush lcp: " + message)
        self.is_refused(run(*inline(M, q), "--solver", "pgs", "--free", "1"), message)
        M[2][2] = -0.5
        self.is_refused(run(*inline(M, q), "--solver", "pgs"), "row 3 has -0.5")
        file = TEXTBOOK / "murty_2_11.M.mtx"
        self.is_refused(run(file, TEXTBOOK / "murty_2_11.q.mtx", "--solver", "pgs"),
                     "^" + re.escape(str(file)) + ": --solver gauss-seidel .* row 1 has -1.5")
        self.assertEqual(solve(inline(M, q), "hybrid")["sweeps"], 0)
        history = json.loads(run(*inline(M, q), "--solver", "hybrid", "--history", "--json").stdout)
        self.assertEqual((history["status"], history["history"]), ("solved", []))

    def test_limits_and_stagnation_exit_with_1_and_say_why(self):
        M, q = dominant(3, 6)
        result = run(*inline(M, q), "--solver", "pgs", "--sweeps", "2", "--json")
        answer = json.loads(result.stdout)
        self.assertEqual(result.returncode, 1)
        self.assertEqual((answer["status"], answer["sweeps"], answer["z"]), ("sweep_limit", 2, None))
        self.assertRegex(answer["reason"], r"limit of sweeps.*residual is \d.*--sweeps")
        result = run(*inline([[1, 2, 0], [0, 1, 2], [2, 0, 1]], [-1, -1, -1]), "--solver", "pgs")
        self.assertEqual(result.returncode, 1)
        self.assertRegex(unwrapped(result.stdout),
                         r"^Not solved \(stagnated\): .*use hybrid or lemke")

    def test_history_is_the_same_in_every_format(self):
        M, q = dominant(4, 6)
        problem = (*inline(M, q), "--solver", "pgs", "--history")
        answer = solve(inline(M, q), "pgs")
        history = json.loads(run(*problem, "--format", "json").stdout)
        self.assertEqual(set(history), {"solver", "status", "history"})
        self.assertEqual((history["solver"], history["status"]), ("gauss-seidel", "solved"))
        rows = history["history"]
        self.assertEqual(rows[0]["sweep"], 0)
        self.assertEqual(rows[-1], {"sweep": answer["sweeps"], "residual": answer["residual"]})
        self.assertGreater(rows[0]["residual"], BOUND)
        self.assertTrue(all(x["sweep"] < y["sweep"] for x, y in zip(rows, rows[1:])))
        self.assertTrue(all(row["residual"] > 9.4e-10 for row in rows[:-1]))
        table = list(csv.DictReader(io.StringIO(run(*problem, "--format", "csv").stdout)))
        self.assertEqual([{"sweep": int(row["sweep"]), "residual": float(row["residual"])}
                          for row in table], rows)
        text = run(*problem).stdout
        self.assertRegex(text, r"^Solver gauss-seidel, solved\.\n\n  sweep +residual\n")
        numbers = [line.split() for line in text.splitlines()[3:]]
        self.assertEqual([int(sweep) for sweep, _ in numbers], [row["sweep"] for row in rows])
        for (_, residual), row in zip(numbers, rows):
            self.assertAlmostEqual(float(residual), row["residual"], delta=1e-4 * row["residual"])

    def test_usage_errors_say_what_to_type(self):
        problem = inline([[2, 1], [1, 2]], [-5, -6])
        self.is_refused(run(*problem, "--format", "csv"), "--format is text or json")
        self.is_refused(run(*problem, "--solver", "pgs", "--history", "--format", "xml"),
                     "text, json or csv")
        for option in (("--history",), ("--sweeps", "9"), ("--relaxation", "1")):
            self.is_refused(run(*problem, *option), option[0] + " is about sweeps.*--solver gauss-seidel")
        for sweeps in ("0", "-3", "1.5", "many", "", "99999999999999999999"):
            self.is_refused(run(*problem, "--solver", "pgs", "--sweeps", sweeps), "--sweeps is a whole")
        for factor in ("0", "2", "-1", "nan", "one", ""):
            self.is_refused(run(*problem, "--solver", "pgs", "--relaxation", factor),
                         "--relaxation is a number between 0 and 2")
        self.is_refused(run(*problem, "--solver", "gaus-seidel"), 'did you mean "gauss-seidel"')


main()
