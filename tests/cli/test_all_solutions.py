"""lcpush lcp --all: every solution, against all subsets of equations in fractions (it shares no code with the tool).

    test_all_solutions.py TOOL ROOT [COUNT]
"""
import itertools
import random
import sys
from fractions import Fraction
from xml.etree import ElementTree

from tool import command, json_of, main, ToolTest

COUNT = int(sys.argv[3]) if len(sys.argv) > 3 else 60
lcp = command("lcp")


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def kernel(rows, n):
    """A basis of {x : rows x = 0}."""
    rows, pivots = [list(map(Fraction, row)) for row in rows], []
    for j in range(n):
        top = len(pivots)
        k = next((k for k in range(top, len(rows)) if rows[k][j] != 0), None)
        if k is None:
            continue
        rows[top], rows[k] = rows[k], rows[top]
        rows[top] = [x / rows[top][j] for x in rows[top]]
        for i, row in enumerate(rows):
            if i != top and row[j] != 0:
                rows[i] = [x - row[j] * y for x, y in zip(row, rows[top])]
        pivots.append(j)
    basis = [[Fraction(k == j) for k in range(n)] for j in range(n) if j not in pivots]
    for x, j in zip(basis, (j for j in range(n) if j not in pivots)):
        for row, pivot in zip(rows, pivots):
            x[pivot] = -row[j]
    return basis


def pieces(M, q, free):
    """The largest convex sets of solutions, each by its vertices (1, z) and rays (0, z); None if there are lines."""
    n = len(q)
    w = [[q[i], *M[i]] for i in range(n)]
    signed = [row for i in range(n) if not free[i] for row in (w[i], [int(j == i + 1) for j in range(n + 1)])]
    signed.append([1] + n * [0])
    always = [w[i] for i in range(n) if free[i]]
    if kernel(always + signed, n + 1):
        return None
    found = set()
    for tight in itertools.combinations(signed, len(kernel(always, n + 1)) - 1):
        line = kernel(always + list(tight), n + 1)
        if len(line) != 1:
            continue
        for x in (line[0], [-a for a in line[0]]):
            if min(dot(row, x) for row in signed) >= 0 and all(dot(w[i], x) * x[i + 1] == 0 for i in range(n)):
                found.add(tuple(a / (x[0] or max(map(abs, x))) for a in x))
    sets = set()
    for sides in itertools.product(*[(0,) if f else (0, 1) for f in free]):
        some = frozenset(x for x in found if all((x[i + 1] if s else dot(w[i], x)) == 0 for i, s in enumerate(sides)))
        if any(x[0] for x in some):
            sets.add(some)
    return {some for some in sets if not any(some < other for other in sets)}


def joined(sets):
    """Those that share a vertex, directly or by others, in one."""
    groups = []
    for some in sets:
        near = [group for group in groups if any(x[0] and x in other for other in group for x in some)]
        groups = [group for group in groups if group not in near] + [frozenset([some]).union(*near)]
    return set(groups)


def text(numbers):
    return " ".join(map(str, numbers))


def rows(M):
    return "; ".join(map(text, M))


def ask(*words):
    return json_of("lcp", "--all", *words, "--exact")


def told(answer):
    """As joined(pieces())."""
    numbers = lambda one: map(Fraction, one if isinstance(one, list) else one.get("z") or one["row"] + one["column"])
    sets = {frozenset([frozenset([(1, *numbers(one))])]) for one in answer.get("solutions", answer.get("equilibria"))}
    for part in answer["components"]:
        sets.add(frozenset(frozenset([(1, *numbers(part["vertices"][k])) for k in cell["vertices"]]
                                     + [(0, *numbers(part["rays"][k])) for k in cell["rays"]]) for cell in part["cells"]))
    return sets


def some_problem(seed):
    pick = random.Random(seed)
    n = pick.choice((1, 2, 2, 3, 3, 3, 4))
    values = pick.choice(((-1, 0, 1), (0, 0, 1, -1, 2), range(-3, 4), (Fraction(1, 2), Fraction(-2, 3), 1, 0, -1)))
    M = [[Fraction(pick.choice(values)) for _ in range(n)] for _ in range(n)]
    q = [Fraction(pick.choice(values)) for _ in range(n)]
    if n > 1 and seed % 2:  # singular
        M[-1] = [sum(c) for c in zip(*M[:-1])] if seed % 4 == 1 else list(M[0])
    if seed % 3 == 0:  # with a solution
        z = [pick.choice((0, 0, 1, 2)) for _ in range(n)]
        q = [-dot(row, z) + (pick.choice((0, 1)) if x == 0 else 0) for row, x in zip(M, z)]
    return M, q, [pick.random() < 0.3 for _ in range(n)] if seed % 5 == 0 else [False] * n


class AllSolutions(ToolTest):
    def compare(self, expected, answer, *about):
        self.assertIs(answer["complete"], True)
        self.assertEqual(told(answer), joined(expected), about)

    def test_random_problems(self):
        for seed in range(COUNT):
            M, q, free = some_problem(seed)
            expected = pieces(M, q, free)
            names = ["--free", ",".join(str(i + 1) for i, f in enumerate(free) if f)] if any(free) else []
            answer = ask("--M", rows(M), "--q", text(q), *names)
            if expected is not None:
                self.compare(expected, answer, M, q, free)

    def test_random_games_are_mixed_problems(self):
        for seed in range(COUNT // 6):
            pick = random.Random(seed)
            m, n = pick.choice(((1, 2), (2, 2), (2, 2), (2, 3), (3, 2)))
            A, B = ([[pick.randint(-2, 2) for _ in range(n)] for _ in range(m)] for _ in range(2))
            # w = u - A y for x, v - B'x for y; u and v are free, the sums 1.
            M = [[0] * m + [-a for a in row] + [1, 0] for row in A]
            M += [[-B[i][j] for i in range(m)] + [0] * n + [0, 1] for j in range(n)]
            M += [[1] * m + [0] * (n + 2), [0] * m + [1] * n + [0, 0]]
            q, free = [0] * (m + n) + [-1, -1], [False] * (m + n) + [True, True]
            expected = pieces(M, q, free)
            self.compare(expected, ask("--M", rows(M), "--q", text(q), "--free", f"{m + n + 1},{m + n + 2}"), A, B)
            answer = ask("--game", rows(A), rows(B))
            self.compare({frozenset(x[:-2] for x in some) for some in expected}, answer, A, B)
            for one in answer["equilibria"]:
                x, y = list(map(Fraction, one["row"])), list(map(Fraction, one["column"]))
                pays = [dot(x, [dot(row, y) for row in matrix]) for matrix in (A, B)]
                self.assertEqual(list(map(Fraction, one["payoffs"])), pays)

    def test_as_many_cones_hold_q_as_there_are_solutions_drawn(self):
        for M, q, count in (("1 2; 2 1", "-2 -2", 3), ("2 1; 1 2", "-5 -6", 1), ("1 2; 2 1", "3 1", 1), ("-1 0; 0 -1", "1 2", 4),
                            ("1 2; 3 1", "-2 -5", 3), ("1 3; 2 1", "-2 -5", 1)):
            svg = ElementTree.fromstring(lcp("--all", "--M", M, "--q", q, "--format", "svg").stdout)
            at = [tuple(float(e.get(k)) for k in ("cx", "cy")) for e in svg.iter() if e.get("class") == "dot"]
            cones = [[tuple(map(float, c.split(","))) for c in e.get("points").split()] for e in svg.iter()
                     if (e.get("class") or "").split(" ")[0] == "sector"]
            side = lambda a, b, p: (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            within = [{side(a, b, at[0]) > 0 for a, b in zip(cone, cone[1:] + cone[:1])} for cone in cones]
            self.assertEqual(sum(len(sides) == 1 for sides in within), count, M)
            self.assertEqual(len(at), 1 + count)
            if M == "1 2; 2 1" and count == 3:  # (0, 2), (2, 0) and (2/3, 2/3) on axes of one scale
                (left, _), (x, y), (_, low) = sorted(at[1:])
                self.assertAlmostEqual((x - left) / (low - y), 1, 2)
        for words in (("--M", "1", "--q", "-1"), ("--game", "1", "1")):
            self.assertEqual(lcp("--all", *words, "--format", "svg").returncode, 2)
        space = lcp("--all", "--M", rows([[1] * 3] * 3), "--q", "-1 -1 -1", "--format", "svg").stdout
        self.assertEqual((space.count('class="dot"'), space.count("sector zz solution")), (3, 1))

    def test_games_of_the_textbooks(self):
        for A, B, isolated, parts in [
                ("3 0; 5 1", "3 5; 0 1", [((0, 1), (0, 1))], 0),  # the prisoners' dilemma
                ("1 -1; -1 1", "-1 1; 1 -1", [(("1/2", "1/2"), ("1/2", "1/2"))], 0),
                ("0 -1 1; 1 0 -1; -1 1 0", "0 1 -1; -1 0 1; 1 -1 0", [(("1/3",) * 3, ("1/3",) * 3)], 0),
                ("2 0; 0 1", "1 0; 0 2", [((1, 0), (1, 0)), ((0, 1), (0, 1)), (("2/3", "1/3"), ("1/3", "2/3"))], 0),
                ("7", "[[1e300]]", [((1,), (1,))], 0), ("0.1 1/10", "1 1", [], 1)]:
            answer = ask("--game", A, B)
            told = {(tuple(map(Fraction, one["row"])), tuple(map(Fraction, one["column"]))) for one in answer["equilibria"]}
            self.assertEqual(told, {tuple(tuple(map(Fraction, x)) for x in one) for one in isolated}, A)
            self.assertEqual((len(answer["components"]), answer["complete"]), (parts, True), A)
        # Nashpy's issue 222: p from 0 to 2/7. Its issue 82, of costs: eight extreme equilibria.
        segment = ask("--game", "-3 3; -3 5", "2 7; 4 2")
        self.assertEqual(sorted(one["row"][0] for one in segment["components"][0]["vertices"]), ["0", "2/7"])
        costs = [[[0, 0, 6, 0, 0], [0, 0, 3, 2, 1], [4, 3, 0, 0, 1]], [[3, 0, 2, 1, 0], [0, 2, 0, 0, 4], [4, 0, 2, 4, 4]]]
        answer = ask("--game", *(rows([[-x for x in row] for row in matrix]) for matrix in costs))
        self.assertEqual(len(answer["equilibria"]) + sum(len(part["vertices"]) for part in answer["components"]), 8)

    def test_many_equilibria(self):
        for n in (3, 6, 10):
            one = rows([[int(i == j) for j in range(n)] for i in range(n)])
            self.assertEqual(len(ask("--game", one, one)["equilibria"]), 2 ** n - 1)
        # B. von Stengel, New maximal numbers of equilibria in bimatrix games, 1999
        A = [[9504, -660, 19976, -20526, 1776, -8976], [-111771, 31680, -130944, 168124, -8514, 52764],
             [397584, -113850, 451176, -586476, 29216, -178761], [171204, -45936, 208626, -263076, 14124, -84436],
             [1303104, -453420, 1227336, -1718376, 72336, -461736], [737154, -227040, 774576, -1039236, 48081, -300036]]
        order = [4, 5, 2, 3, 0, 1]
        B = [[A[i][j] for i in order] for j in order]
        self.assertEqual(len(ask("--game", rows(A), rows(B))["equilibria"]), 75)

    def test_problems_of_the_textbooks(self):
        unit = [[int(i == j) for j in range(20)] for i in range(20)]
        murty = [[1 if i == j else 2 * (i < j) for j in range(20)] for i in range(20)]
        for M, q, isolated, parts in [
                (murty, [-1] * 20, 1, 0), (unit, [0] * 20, 1, 0), ([[0] * 20] * 20, [0] * 20, 0, 1),
                ([[0]], [-1], 0, 0), ([[0]], [1], 1, 0), ([[-1]], [1], 2, 0), ([[1, 1], [1, 1]], [-1, -1], 0, 1),
                ([[1, 2, 0], [0, 1, 2], [2, 0, 1]], [-1] * 3, 1, 0),  # Kostreva's, in which pivots by least index cycle
                ([["1e-300"]], ["-1e300"], 1, 0)]:
            answer = ask("--M", rows(M), "--q", text(q))
            self.assertEqual((len(answer["solutions"]), len(answer["components"]), answer["complete"]),
                             (isolated, parts, True), (M, q))
        orthant = ask("--M", rows([[0] * 20] * 20), "--q", text([0] * 20))["components"][0]
        self.assertEqual((orthant["vertices"], sorted(orthant["rays"])), ([["0"] * 20], sorted([str(x) for x in row] for row in unit)))
        lines = ask("--M", "0 0; 0 0", "--q", "0 0", "--free", "1,2")["components"][0]
        self.assertEqual(sorted(lines["rays"]), [["-1", "0"], ["0", "-1"], ["0", "1"], ["1", "0"]])

    def test_what_is_left_out_is_said(self):
        minus = rows([[-int(i == j) for j in range(20)] for i in range(20)])
        answer = json_of("lcp", "--all", "--M", minus, "--q", text([1] * 20), "--most", 500)
        self.assertEqual((len(answer["solutions"]), answer["complete"], answer["most"]), (500, False, 500))
        result = lcp("--all", "--M", minus, "--q", text([1] * 20), "--most", 500)
        self.assertRegex(result.stdout, "^At least 500 solutions; there may be more: the search ended at --most 500")
        self.assertEqual((result.returncode, len(result.stdout.splitlines()) <= 20), (1, True))
        self.assertRegex(lcp("--all", "--M", "0", "--q", "-1").stdout, "^There is no solution.\n\nProved in fractions")
        pick = random.Random(0)
        S = [[pick.randint(-1, 1) for _ in range(5)] for _ in range(20)]  # one face of 131 vertices
        answer = ask("--M", rows([[dot(a, b) for b in S] for a in S]), "--q", text([-sum(a) for a in S]), "--most", 5)
        self.assertEqual((answer["cases"], answer["complete"], answer["most"]), (1, False, 5))
        dense = rows([[(i * j * j + 7 * i + 3 * j) % 23 - 11 for j in range(60)] for i in range(60)])
        stopped = json_of("lcp", "--all", "--M", dense, "--q", text([-1] * 60), "--seconds", 0.2)
        self.assertEqual((stopped["complete"], stopped["stopped"]), (False, "time"))

    def test_bad_questions_are_refused(self):
        for words, pattern in [(("--all", "--game", "1 2", "1; 2"), "1 x 2 and 2 x 1"), (("--game", "1", "1"), "goes with --all"),
                               (("--all", "--game", "1"), "two matrices"), (("--all", "--game", "1 inf", "1 1"), "finite"),
                               (("--all", "--game", "1", "1", "--q", "1"), "leave --q out"), (("--all",), "--M .* --q"),
                               (("--all", "--M", "1", "--q", "1", "--hi", "1"), "takes no boxes"),
                               (("--all", "--M", "1", "--q", "1", "--solver", "hybrid"), "about one solution"),
                               (("--all", "--M", rows([[0] * 65] * 65), "--q", text([0] * 65)), "at most 64 unknowns")]:
            self.is_refused(lcp(*words), pattern)
        empty = [self.file(f"{n}.mtx", f"%%MatrixMarket matrix array real general\n0 {n}\n") for n in (0, 1)]
        self.assertEqual(ask(*empty)["solutions"], [{"z": [], "w": []}])


if __name__ == "__main__":
    main()
