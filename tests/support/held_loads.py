"""What a grasp can hold, from nothing but Newton and Coulomb: a cone program over contact forces, met from inside by
rays of the friction cones, on a simplex method of this file. With scipy also from outside, by planes.

Shares no code with lcpush. Lengths in m, forces in N."""
import math
import random

from motion_frames import cross, dot


def unit(v):
    return [x / math.sqrt(dot(v, v)) for x in v]


class Contact:
    """A point at p with the normal n into the object; axes of its friction as [force; moment]."""

    def __init__(self, p, n, friction, torsion=0.0, planar=False):
        self.p, self.n, self.friction = p, unit(n), friction
        a = unit(cross(self.n, min(([1, 0, 0], [0, 1, 0], [0, 0, 1]), key=lambda e: abs(dot(e, self.n)))))
        if planar:
            a = [-self.n[1], self.n[0], 0]
        self.axes = [self.wrench(a)] + ([] if planar else [self.wrench(cross(self.n, a))])
        if torsion and not planar:
            self.axes.append([0, 0, 0] + [torsion * x for x in self.n])
        self.normal = self.wrench(self.n)

    def wrench(self, force):
        return list(force) + cross(self.p, force)


class Grasp:
    """`grips`: (row of coefficients of the normal forces, force)."""

    def __init__(self, contacts, grips, load, length, planar=False):
        self.contacts, self.grips, self.load = contacts, grips, load
        self.rows = [0, 1, 5] if planar else range(6)
        self.scale = [1, 1, 1, 1 / length, 1 / length, 1 / length]
        zero = [self.column(i, [0.0] * len(c.axes)) for i, c in enumerate(contacts)]
        self.parts = [(zero[i], [[x - y for x, y in zip(self.column(i, [float(k == j) for k in range(len(c.axes))]), zero[i])]
                                 for j in range(len(c.axes))]) for i, c in enumerate(contacts)]
        self.cap = 1000 * (sum(abs(force) for _, force in grips) + math.sqrt(dot(load[:3], load[:3])) + 1)

    def part(self, wrench):
        return [wrench[k] * self.scale[k] for k in self.rows]

    def column(self, i, u):
        c = self.contacts[i]
        wrench = [c.normal[k] + c.friction * sum(x * axis[k] for x, axis in zip(u, c.axes)) for k in range(6)]
        return self.part(wrench) + [row[i] for row, _ in self.grips] + [1.0]

    def demand(self, factor):
        return [-x for x in self.part(self.load)] + [factor * force for _, force in self.grips] + [self.cap]

    def solve(self, column, demand):
        """The largest x >= 0 with forces + column x = demand; None: there is none; inf: only the cap ends it."""
        rays = [(i, [s * (k == j) for k in range(len(c.axes))]) for i, c in enumerate(self.contacts)
                for j in range(len(c.axes)) for s in (1, -1)]
        m = len(demand)
        slack = [0.0] * (m - 1) + [1.0]
        program = Simplex([column, slack] + [self.column(i, u) for i, u in rays], demand)
        for costs in ("rest", "x"):
            for _ in range(60):
                y = program.maximise(costs == "x")
                added, lacks = False, 0.0
                for i, (normal, axes) in enumerate(self.parts):
                    power = [dot(axis, y) for axis in axes]
                    size = math.sqrt(dot(power, power))
                    lacks = max(lacks, size - dot(normal, y))
                    if dot(normal, y) - size < -1e-10:
                        added = program.add(self.column(i, [-x / size for x in power])) or added
                if not added or (costs == "rest" and program.rest() > 1e-6 + lacks * (demand[-1] + 1e3)):
                    break
            if costs == "rest" and program.rest() > 1e-9 * (1 + max(map(abs, demand[:-1]))):
                return None
        return math.inf if y[-1] > 1e-7 else program.value(0)

    def least_grip(self):
        column = [0.0] * len(self.rows) + [-force for _, force in self.grips] + [0.0]
        least = self.solve([-x for x in column], self.demand(1e3))  # from a thousand times the grip downwards
        return None if least is None else 1e3 - least


class Simplex:
    """max x_0 or the least rest, over columns z + artificial ones = b; a dense inverse."""

    def __init__(self, columns, b):
        self.columns, self.b, self.m = [list(c) for c in columns], b, len(b)
        self.art = [[(1.0 if x >= 0 else -1.0) * (i == k) for i in range(self.m)] for k, x in enumerate(b)]
        self.basis = [-1 - k for k in range(self.m)]

    def at(self, j):
        return self.columns[j] if j >= 0 else self.art[-1 - j]

    def add(self, column):
        if any(max(abs(x - y) for x, y in zip(column, known)) < 1e-9 for known in self.columns[2:]):
            return False
        self.columns.append(column)
        return True

    def solve_rows(self, rhs, transposed=False):
        m = self.m
        a = [[self.at(self.basis[i])[k] if transposed else self.at(self.basis[k])[i] for k in range(m)] + [rhs[i]]
             for i in range(m)]
        for c in range(m):
            best = max(range(c, m), key=lambda r: abs(a[r][c]))
            a[c], a[best] = a[best], a[c]
            for r in range(m):
                if r != c and a[r][c]:
                    f = a[r][c] / a[c][c]
                    a[r] = [x - f * y for x, y in zip(a[r], a[c])]
        return [a[i][m] / a[i][i] for i in range(m)]

    def rest(self):
        return sum(x for j, x in zip(self.basis, self.solve_rows(self.b)) if j < 0)

    def value(self, j):
        return self.solve_rows(self.b)[self.basis.index(j)] if j in self.basis else 0.0

    def maximise(self, of_x):
        """Multipliers y with y column >= 0, of x_0 >= 1 in the second program."""
        for step in range(300):
            cost = [(-1.0 if j == 0 else 0.0) if of_x else (1.0 if j < 0 else 0.0) for j in self.basis]
            if of_x:
                cost = [1e4 if j < 0 else c for j, c in zip(self.basis, cost)]
            y = self.solve_rows(cost, True)
            reduced = [-dot(column, y) for column in self.columns]
            reduced[0] -= of_x
            basic = set(self.basis)
            better = [(r if step < 150 else j, j) for j, r in enumerate(reduced) if r < -1e-11 and j not in basic]
            if not better:
                break
            enter = min(better)[1]
            way, now = self.solve_rows(self.columns[enter]), self.solve_rows(self.b)
            ratios = [(max(x, 0) / w, -w, i) for i, (x, w) in enumerate(zip(now, way)) if w > 1e-10]
            if not ratios:
                break
            self.basis[min(ratios)[2]] = enter
        return [-x for x in y]


def scipy_limit(grasp, column, demand):
    """The same from outside: friction in polygons' planes, more where it leaves the cone."""
    import numpy as np
    from scipy.optimize import linprog
    sizes = [1 + len(c.axes) for c in grasp.contacts]
    starts = [1 + sum(sizes[:i]) for i in range(len(sizes))]
    n, A = 1 + sum(sizes), []
    A = np.zeros((len(demand) - 1, n))
    A[:, 0] = column[:-1]
    for i, c in enumerate(grasp.contacts):
        zero = np.array(grasp.column(i, [0.0] * len(c.axes))[:-1])
        A[:, starts[i]] = zero
        for k in range(len(c.axes)):
            one = np.array(grasp.column(i, [float(j == k) for j in range(len(c.axes))])[:-1])
            A[:, starts[i] + 1 + k] = (one - zero) / c.friction
    cuts, limits = [], []

    def cut(i, direction):
        row = np.zeros(n)
        row[starts[i]] = -grasp.contacts[i].friction
        row[starts[i] + 1:starts[i] + sizes[i]] = direction
        cuts.append(row)
        limits.append(0.0)
    row = np.zeros(n)
    row[starts] = 1
    cuts.append(row)
    limits.append(demand[-1])
    for i, c in enumerate(grasp.contacts):
        for k in range(len(c.axes)):
            for s in (1, -1):
                cut(i, [s * float(j == k) for j in range(len(c.axes))])
    free = {starts[i] + 1 + k for i in range(len(sizes)) for k in range(sizes[i] - 1)}
    bounds = [(None, None) if j in free else (0, None) for j in range(n)]
    cost = np.zeros(n)
    cost[0] = -1
    for _ in range(60):
        r = linprog(cost, A_ub=np.array(cuts), b_ub=limits, A_eq=A, b_eq=demand[:-1], bounds=bounds,
                    method="highs", options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
        if r.status == 3:
            return math.inf
        if r.status != 0:
            return None
        worst = 0.0
        for i, c in enumerate(grasp.contacts):
            u = r.x[starts[i] + 1:starts[i] + sizes[i]]
            size = float(np.linalg.norm(u))
            over = size - c.friction * r.x[starts[i]]
            if over > 1e-11 * (1 + size):
                cut(i, u / size)
                worst = max(worst, over / (1 + size))
        if worst < 1e-10:
            break
    return math.inf if cuts[0] @ r.x > 0.999 * limits[0] else float(r.x[0])


def random_grasp(seed):
    """(text of a scene, its Grasp): a jaw, fingers on their own, or with stops; soft points, off centre, or planar."""
    pick = random.Random(seed)
    planar = seed % 5 == 4
    kind = ("jaw", "own", "stops", "actuator")[seed % 4]
    mass, size = pick.uniform(0.05, 2), pick.uniform(0.01, 0.1)
    flat = lambda v: [v[0], v[1], 0.0 if planar else v[2]]
    gravity = flat([pick.uniform(-10, 10) for _ in range(3)])
    direction = lambda: unit(flat([pick.gauss(0, 1) for _ in range(3)]))
    number = lambda: float(f"{pick.uniform(-1, 1):.3f}")
    where = lambda: flat([number() * size for _ in range(3)])
    contacts, grips, text = [], [], ""
    offset = where()
    n = direction()
    count = {"jaw": 2, "own": pick.choice((3, 4, 5)), "stops": 4, "actuator": 3}[kind]
    for i in range(count):
        if kind == "jaw" or (kind == "stops" and i < 2):
            normal = n if i == 0 else [-x for x in n]
            p = [o - size * x for o, x in zip(offset, normal)]
        elif kind == "actuator":  # a thumb against two
            normal = n if i == 0 else unit([-x + 0.3 * y for x, y in zip(n, direction())])
            p = [-size * x + 0.3 * y for x, y in zip(normal, where())]
        else:
            normal = direction()
            p = [-size * x + 0.2 * y for x, y in zip(normal, where())]
        mu = pick.uniform(0.2, 1.2)
        torsion = pick.uniform(0.1, 0.5) * size if pick.random() < 0.4 and not planar else 0.0
        force = pick.uniform(5, 50)
        contacts.append(Contact(p, normal, mu, torsion, planar))
        text += (f'[[finger]]\nname = "f{i}"\nshape = "point"\ncenter = {p}\nnormal = {contacts[-1].n}\nfriction = {mu!r}\n'
                 + (f"torsion_radius = {torsion!r}\n" if torsion else ""))
        if kind == "own" or (kind == "stops" and i < 2):
            grips.append(([float(j == i) for j in range(count)], force))
            text += f"grip_force = {force!r}\n"
        elif kind == "jaw":
            text += f"grip_force = {50 * mass!r}\n"
    hand = ""
    if kind == "jaw":
        grips = [([1.0, 1.0], 100 * mass)]
        hand = '[gripper]\njaws = "parallel"\n'
    elif kind in ("own", "stops"):
        hand = '[gripper]\njaws = "independent"\n'
    else:
        force = pick.uniform(20, 100)
        grips = [([1.0] * count, force)]
        twists = [list(c.n) + cross(c.p, c.n) * 0 + [0.0] * 3 for c in contacts]
        hand = (f'[[actuator]]\nname = "hand"\nbodies = {[f"f{i}" for i in range(count)]}\ntwists = {twists}\n'
                f"force = {force!r}\n").replace("'", '"')
        grips = [([dot(twists[i][:3], c.n) for i, c in enumerate(contacts)], force)]
    pressure = 'pressure = "rigid"\n'
    text = (f"gravity = {gravity}\n{pressure}" + ("planar = true\n" if planar else "")
            + f"[object]\nmass = {mass!r}\nbox = {[4 * size] * 3}\n" + text + hand)
    load = [mass * g for g in gravity] + [0.0] * 3
    return text, Grasp(contacts, grips, load, size, planar), mass
