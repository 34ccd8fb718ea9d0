"""`lcpush spread` against brute force: every assignment of modes of small random scenes, none left
out, by SciPy's linear programs over laws that this file writes down itself.

    test_enumeration.py TOOL [FIRST LAST]      seeds; needs SciPy

Of the push at hand all ranges must agree to 1e-5, and `--modes` must tell the same combinations of
sticking, slipping and opening points, each with its own range of the push. Of the instant of breaking the forces must be
those of a push of 1e-4 F / m, to 1e-2 of F.
"""
import collections
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import tomllib

import numpy as np
from scipy.optimize import linprog

TOOL = sys.argv[1]
OWN = 1e-6  # m/s^2: what a gap or a slip must reach for a mode to be its own
FIRST, LAST = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else (0, 40)


def random_scene(seed):
    """Two fingers across an object and a pusher, three contact points."""
    pick = random.Random(seed)
    radius, along = pick.uniform(.01, .05), pick.choice([0, pick.uniform(-.01, .01)])
    pushed = pick.choice([0, pick.uniform(-radius, radius)])
    left, right, pusher = (-radius, along, 0), (radius, along, 0), (pushed, -radius, 0)
    normals = [(1., 0., 0.), (-1., 0., 0.), (0., 1., 0.)]
    if pick.random() < .5:  # the other way round
        swap = lambda v: (v[1], v[0], v[2])
        left, right, pusher = map(swap, (left, right, pusher))
        normals = list(map(swap, normals))
    friction, grip = pick.choice([.2, .4, .7, 1.]), pick.uniform(2, 20)
    motion = [pick.choice([0, .1, -.1, pick.uniform(-1, 1)]), pick.choice([0, .1, pick.uniform(-1, 1)]), 0]
    text = f"""gravity = [{pick.uniform(-2, 2)}, {pick.choice([0, -9.81])}, 0]
facets = {6 if pick.random() < .15 else 4}
planar = {"true" if pick.random() < .8 else "false"}
[object]
mass = {pick.uniform(.1, 1)}
box = {[pick.uniform(.02, .1) for _ in range(3)]}
[gripper]
jaws = "{"parallel" if pick.random() < .6 else "independent"}"
"""
    bodies = [("finger", "left", left, friction, f"grip_force = {grip}"),
              ("finger", "right", right, friction, f"grip_force = {grip}"),
              ("pusher", "pusher", pusher, pick.choice([0, .3, .9]), f"acceleration = {motion}")]
    for (kind, name, place, mu, rest), normal in zip(bodies, normals):
        text += f"""[[{kind}]]
name = "{name}"
shape = "point"
center = {list(map(float, place))}
normal = {list(normal)}
friction = {mu}
{rest}
"""
    return text


class Laws:
    """Columns: the object's acceleration, the jaws', then per point lambda, beta_j, xi."""

    def __init__(self, text, push):
        scene = tomllib.loads(text)
        body = scene["object"]
        self.mass, size = body["mass"], np.array(body["box"])
        inertia = self.mass / 12 * (size @ size - size ** 2)
        mass = np.diag([self.mass] * 3 + list(inertia))
        self.moving = [0, 1, 5] if scene["planar"] else list(range(6))
        parallel = scene["gripper"]["jaws"] == "parallel"
        fingers, pushers = scene["finger"], scene["pusher"]
        self.grip = fingers[0]["grip_force"]
        jaws = [2 * self.grip] if parallel else [self.grip] * 2
        self.points = []
        for k, entry in enumerate(fingers + pushers):
            motion = push * np.array(entry.get("acceleration", [0, 0, 0]))
            self.points.append((np.array(entry["center"]), np.array(entry["normal"]),
                                self.directions(entry["normal"], scene["facets"])
                                if entry["friction"] > 0 else [], entry["friction"],
                                None if k >= 2 else 0 if parallel else k, motion))
        first, self.at = len(self.moving) + len(jaws), []
        self.free, self.columns = first, first
        for point in self.points:
            self.at.append(self.columns)
            self.columns += 2 + len(point[2])
        load = np.concatenate([self.mass * np.array(scene["gravity"]), np.zeros(3)])
        self.rows, self.right = [], []
        for column, k in enumerate(self.moving):
            row = np.zeros(self.columns)
            row[column] = mass[k, k]
            for at, (p, n, generators, *_) in zip(self.at, self.points):
                for j, d in enumerate([n] + generators):
                    row[at + j] -= np.concatenate([d, np.cross(p, d)])[k]
            self.rows.append(row)
            self.right.append(load[k])
        for jaw, force in enumerate(jaws):
            row = np.zeros(self.columns)
            for at, point in zip(self.at, self.points):
                row[at] = point[4] == jaw
            self.rows.append(row)
            self.right.append(force)

    @staticmethod
    def directions(normal, g):
        axis = np.eye(3)[int(np.argmin(np.abs(normal)))]
        t = axis - np.array(normal) * (axis @ normal)
        t /= np.linalg.norm(t)
        o = np.cross(normal, t)
        return [math.cos(2 * math.pi * j / g) * t + math.sin(2 * math.pi * j / g) * o for j in range(g)]

    def rate(self, i, direction):
        """Row and right-hand side: rate = row x - right."""
        p, n, _, _, jaw, motion = self.points[i]
        row = np.zeros(self.columns)
        row[:len(self.moving)] = np.concatenate([direction, np.cross(p, direction)])[self.moving]
        if jaw is not None:
            row[len(self.moving) + jaw] = -direction @ n
        return row, motion @ direction

    def modes(self, i):
        """(name, equations, lower bounds of rows, unknowns that are 0, rows that are 0 in another mode
        only) of each mode."""
        _, n, generators, mu, _, _ = self.points[i]
        at, g = self.at[i], len(generators)
        gap, slip = self.rate(i, n), at + 1 + g
        yield "open", [], [gap], list(range(at, slip + 1)), [gap]
        if not g:
            yield "touch", [gap], [], [slip], []
            return
        cone = np.zeros(self.columns)
        cone[at], cone[at + 1:slip] = mu, -1
        rates = [self.rate(i, d) for d in generators]
        yield "stick", [gap] + rates, [(cone, 0)], [slip], []
        rates = [(row.copy(), right) for row, right in rates]
        for row, _ in rates:
            row[slip] = 1
        slips = np.zeros(self.columns)
        slips[slip] = 1
        for active in [{j} for j in range(g)] + [{j, (j + 1) % g} for j in range(g)]:
            others = [rates[j] for j in range(g) if j not in active]
            yield ("slip", [gap, (cone, 0)] + [rates[j] for j in active], others,
                   [at + 1 + j for j in range(g) if j not in active], others + [(slips, 0)])

    def quantities(self):
        for k in list(range(len(self.moving))) + self.at:
            c = np.zeros(self.columns)
            c[k] = 1
            yield c

    def faces(self):
        """The modes' names, their strict rows and their linear program, of every one with answers."""
        for modes in itertools.product(*(list(self.modes(i)) for i in range(len(self.points)))):
            equal = list(zip(self.rows, self.right)) + [row for mode in modes for row in mode[1]]
            above = [row for mode in modes for row in mode[2]]
            limits = [(None, None)] * self.free + [(0, None)] * (self.columns - self.free)
            for mode in modes:
                for k in mode[3]:
                    limits[k] = (0, 0)
            at_most = dict(A_ub=-np.array([r for r, _ in above]), b_ub=[-b for _, b in above]) if above else {}
            program = dict(A_eq=np.array([r for r, _ in equal]), b_eq=[b for _, b in equal], bounds=limits,
                           method="highs", options=dict(primal_feasibility_tolerance=1e-10), **at_most)
            if linprog(np.zeros(self.columns), **program).status != 2:
                yield [mode[0] for mode in modes], [row for mode in modes for row in mode[4]], program

    def widen(self, program, bounds):
        for c, bound in zip(self.quantities(), bounds):
            for sign, end, best in ((1, 0, min), (-1, 1, max)):
                result = linprog(sign * c, **program)
                value = -sign * math.inf if result.status == 3 else sign * result.fun
                bound[end] = best(bound[end], value)

    def ranges(self):
        """Of every quantity over all answers; and the push's over those of each combination of modes."""
        bounds, combinations = [[math.inf, -math.inf] for _ in self.quantities()], {}
        for names, strict, program in self.faces():
            own = [[math.inf, -math.inf] for _ in bounds]
            self.widen(program, own)
            bounds = [[min(a, c), max(b, d)] for (a, b), (c, d) in zip(bounds, own)]
            ends = (linprog(-row, **program) for row, _ in strict)
            if all(end.status == 3 or -end.fun - right > OWN for end, (_, right) in zip(ends, strict)):
                push = combinations.setdefault(tuple(names), [math.inf, -math.inf])
                push[:] = min(push[0], own[-1][0]), max(push[1], own[-1][1])
        return bounds, combinations


def spread(text, *words):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.toml"
        file.write_text(text)
        result = subprocess.run([TOOL, "spread", file, "--json", *words], capture_output=True, text=True)
    return json.loads(result.stdout or '{"status": "refused"}')


def is_near(ends, bound, slack):
    ends = [sign * math.inf if x is None else x for x, sign in zip(ends, (-1, 1))]
    return all(a == b or abs(a - b) <= slack for a, b in zip(ends, bound))


def compare_modes(text, combinations, slack):
    """What is wrong with the combinations of modes."""
    told = spread(text, "--modes")
    pushes = {tuple(entry["modes"].values()): entry["push_force"]["pusher"] for entry in told["combinations"]}
    seen["with several combinations of modes"] += len(pushes) > 1
    if not told["complete"]:
        return "modes not complete"
    if pushes.keys() != combinations.keys():
        return f"modes {sorted(pushes)}, brute force {sorted(combinations)}"
    if not all(is_near(pushes[names], combinations[names], slack) for names in pushes):
        return f"pushes {pushes}, brute force {combinations}"
    return ""


def compare(seed):
    """What is wrong."""
    text = random_scene(seed)
    laws, answer = Laws(text, 1), spread(text)
    (bounds, combinations), moving = laws.ranges(), len(laws.moving)
    exists = bounds[0][0] <= bounds[0][1]
    if not answer["complete"]:
        return "not complete"
    if (answer["status"] == "solved") != exists:
        return f"{answer['status']}, but {bounds}"
    if not exists:
        return ""
    forces = [contact["normal_force"] for contact in answer["contacts"]]
    twists = [answer["twist"][k] for k in laws.moving]
    if not all(is_near(a, b, 2e-3) for a, b in zip(twists, bounds)):
        return f"twist {twists}, brute force {bounds[:moving]}"
    if not all(is_near(a, b, 1e-5 * laws.grip) for a, b in zip(forces, bounds[moving:])):
        return f"forces {forces}, brute force {bounds[moving:]}"
    if fault := compare_modes(text, combinations, 1e-5 * laws.grip):
        return fault
    fastest = np.linalg.norm(laws.points[-1][-1])
    if not fastest:
        return ""
    breaking = spread(text, "--break")
    if breaking["status"] != "solved" or breaking["falls"] or not breaking["complete"]:
        return ""
    small = 1e-4 * laws.grip / laws.mass / fastest
    bounds, _ = Laws(text, small).ranges()
    if max(abs(x) for bound in bounds[:2] for x in bound) > 10 * small * fastest:
        return ""  # the object may fall as well: no answer to a push alone
    seen["broken too"] += 1
    forces = [contact["normal_force"] for contact in breaking["contacts"]]
    if not all(is_near(a, b, 1e-2 * laws.grip) for a, b in zip(forces, bounds[moving:])):
        return f"breaking {forces}, brute force {bounds[moving:]}"
    return ""


wrong, seen = 0, collections.Counter()
for seed in range(FIRST, LAST):
    if fault := compare(seed):
        wrong += 1
        print(f"seed {seed}: {fault}\n{random_scene(seed)}")
print(f"{LAST - FIRST} scenes, {dict(seen)}: {wrong} differ")
sys.exit(1 if wrong or LAST - FIRST >= 40 and (seen["broken too"] < 10 or min(seen.values()) < 3) else 0)
