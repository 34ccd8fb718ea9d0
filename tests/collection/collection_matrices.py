"""The raw problems of fixtures/collection, family by family: M and q of numbers with few digits."""
import random


def integers(pick, rows, columns, most=5):
    return [[pick.randint(-most, most) for _ in range(columns)] for _ in range(rows)]


def times(A, B):
    return [[sum(a * b for a, b in zip(row, column)) for column in zip(*B)] for row in A]


def transposed(A):
    return [list(row) for row in zip(*A)]


def murty(pick, n):
    return [[1 if i == j else 2 * (j > i) for j in range(n)] for i in range(n)], [-1] * n


def fathi(pick, n):
    return [[1 + 4 * min(i, j) if i == j else 2 + 4 * min(i, j) for j in range(n)] for i in range(n)], [-1] * n


def definite(pick, n):
    A = integers(pick, n, n)
    M = times(A, transposed(A))
    for i in range(n):
        M[i][i] += 1
    return M, [pick.randint(-20, 20) for _ in range(n)]


def semidefinite(pick, n):
    """Of half its rank, solvable: w = M z + q for a pair z, w."""
    A = integers(pick, n, n // 2)
    M = times(A, transposed(A))
    z = [pick.randint(1, 4) if i % 2 else 0 for i in range(n)]
    w = [0 if i % 2 else pick.choice([0, 0, 3]) for i in range(n)]
    return M, [v - sum(m * x for m, x in zip(row, z)) for row, v in zip(M, w)]


def program(pick, n):
    """Of a linear program, feasible on both sides: skew."""
    k = n // 2
    A = integers(pick, k, n - k)
    M = [[0] * (n - k) + [-a for a in column] for column in transposed(A)] + [row + [0] * k for row in A]
    z = [pick.choice([0, 1, 3]) for _ in range(n)]
    return M, [-sum(m * x for m, x in zip(row, z)) + (0 if v else pick.randint(0, 3)) for row, v in zip(M, z)]


def game(pick, n):
    """A bimatrix game with positive costs: z1, z2 in proportion to the mixed strategies."""
    k = n // 2
    A, B = ([[pick.randint(1, 9) for _ in range(n - k)] for _ in range(k)] for _ in range(2))
    M = [[0] * k + row for row in A] + [row + [0] * (n - k) for row in transposed(B)]
    return M, [-1] * n


def scaled(pick, n):
    M, q = definite(pick, n)
    units = [10.0 ** pick.randint(-6, 6) for _ in range(n)]
    rows = [10.0 ** pick.randint(-6, 6) for _ in range(n)]
    return ([[float(f"{r * m * u:.15g}") for m, u in zip(row, units)] for row, r in zip(M, rows)],
            [float(f"{r * v:.15g}") for v, r in zip(q, rows)])


def infeasible(pick, n):
    """A row of nothing positive, under a negative q."""
    M, q = definite(pick, n)
    M[0], q[0] = [0] + [-abs(m) for m in M[0][1:]], -pick.randint(1, 5)
    return M, q


def redundant(pick, n):
    """Rows of zeros, and rows and columns twice."""
    M, q = definite(pick, n - 2)
    M = [row + [row[-1], 0] for row in M]
    return M + [M[-1][:], [0] * n], q + [q[-1], pick.randint(0, 1)]


def pile(pick, n):
    """Weights in a heap without friction: M = G' G of who rests on whom."""
    G = [[(pick.choice([1, 1, 0]) if j == i else -pick.choice([0, 1]) if j > i else 0) for j in range(n)] for i in range(n)]
    M = times(transposed(G), G)
    return M, [-v for v in (sum(m for m in row) + pick.choice([0, 0, -1]) for row in M)]


FAMILIES = {"murty": (murty, range(3, 13), ["textbook"]), "fathi": (fathi, range(3, 13), ["textbook"]),
            "definite": (definite, (4, 6, 8, 12, 16, 24), ["random"]),
            "semidefinite": (semidefinite, (4, 6, 8, 12, 16, 24), ["degenerate"]),
            "program": (program, (4, 6, 8, 10, 16, 24), ["skew"]), "game": (game, (4, 6, 8, 8, 10, 12, 16, 20), ["game"]),
            "badly_scaled": (scaled, (3, 4, 6, 8, 12, 16, 20, 24), ["badly scaled"]),
            "infeasible": (infeasible, (3, 4, 6, 8, 12, 16, 20, 24), ["unsolvable"]),
            "redundant": (redundant, (4, 6, 8, 12, 16), ["degenerate"]), "pile": (pile, (4, 6, 8, 10, 16, 24), ["stack"])}
SOURCES = {"murty": "Murty 1978: 2^n pivots", "fathi": "Fathi 1979: 2^n pivots"}


def problems(family):
    """(name, M, q, tags)."""
    make, sizes, tags = FAMILIES[family]
    for k, n in enumerate(sizes):
        M, q = make(random.Random(f"{family}:{k}"), n)
        yield f"{family}_{n}" + ("" if list(sizes).count(n) == 1 else f"_{k}"), M, q, tags
