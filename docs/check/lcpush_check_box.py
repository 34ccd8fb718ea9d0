"""Accepts or refuses the certificate of a box: a push in the plane sticks for every value of some numbers of a scene.
    python3 lcpush_check_box.py CERTIFICATE.json SCENE.toml
By the laws in certificates.md, at every corner of the box, in fractions, and intervals around what is irrational."""
import copy, hashlib, itertools, json, math, pathlib, re, sys, tomllib
from fractions import Fraction as F
from lcpush_check import ZERO, add, cross, dot, in_object_frame, patch, put_on_face, require, si, unit

SAYS = ("For every value in this box the pusher's force lies within its friction cone and between its outer points: the "
        "object moves as the pusher does.")
KEYS = ("friction", "grip_force", "mass", "gravity", "force", "moment")  # each condition is affine in each of them
ROOT, TIE, ROUNDED, CUT = 10**40, F(1, 10**30), F(1, 10**12), F(1, 10**15)


class Interval:
    """It holds a number; one point where that is a fraction."""

    def __init__(self, low, high=None):
        self.low, self.high = F(low), F(low if high is None else high)

    def __add__(self, other): return Interval(self.low + other.low, self.high + other.high)
    def __sub__(self, other): return Interval(self.low - other.high, self.high - other.low)

    def __mul__(self, other):
        ends = [x * y for x in (self.low, self.high) for y in (other.low, other.high)]
        return Interval(min(ends), max(ends))

    def over(self, other):  # which is positive
        return self * Interval(1 / other.high, 1 / other.low)


def about(x, off): return Interval(x - off, x + off)


def root(x):
    def low(a):
        return F(math.isqrt(max(a, F(0)).numerator * ROOT**2 // max(a, F(0)).denominator), ROOT)
    ends = low(x.low), low(x.high)
    return Interval(ends[0], ends[1] + (ends[1]**2 != x.high) * F(1, ROOT))


def line_weights(k):
    if k <= 3: return [[F(1)], [F(1, 2)] * 2, [F(1, 4), F(1, 2), F(1, 4)]][k - 1]
    if k % 2 == 0: return [F(1, 2 * k) if i in (0, k - 1) else F(k - 1, k * (k - 2)) for i in range(k)]
    m = (k - 1) // 2
    inner = F(2 * m - 3, 2 * (m - 1) * (2 * m - 1))
    beside = (F(m, 2) - (m * m - 2) * inner) / 2
    end = (1 - 2 * beside - (2 * m - 3) * inner) / 2
    return [end if i in (0, k - 1) else beside if i in (1, k - 2) else inner for i in range(k)]


def disc_weights(k):
    if k < 6: return [F(1, k)] * k
    rings, weights = 2, []
    while 4 * (rings + 2)**2 <= k: rings += 2
    begin = [i * k // rings if rings < 3 else i * (i + 1) * k // (rings * (rings + 1)) for i in range(rings + 1)]
    for i in range(rings):
        simpson = 1 if i + 1 == rings else 2 if i % 2 else 4
        count = begin[i + 1] - begin[i]
        weights += [F(2 * (i + 1) * simpson, 3 * rings * rings * count)] * count
    return weights


def weights(body, k):  # of its points, by shape
    if body["shape"] == "line": return line_weights(k)
    if body["shape"] == "disc": return disc_weights(k)
    if body["shape"] == "rectangle":
        i, j = body.get("points", (4, 4))
        return [a * b for b in line_weights(j) for a in line_weights(i)]
    given = [F(w) for w in body.get("weights", [1] * k)]
    return [w / sum(given) for w in given]


def put(scene, path, value):
    """Sets a number, as "left.friction" or "gravity[1]" names it."""
    owner, key, places = re.fullmatch(r"(?:(.+)\.)?(\w+)((?:\[\d+\])*)", path).groups()
    require(key in KEYS, f"{path} may not be affine")
    bodies = {b["name"]: b for b in scene.get("finger", []) + scene.get("pusher", [])}
    table = scene if owner is None else scene["object"] if owner == "object" else bodies[owner]
    for place in [int(p) for p in re.findall(r"\d+", places)]:
        table, key = table[key], place
    require(table[key] is not None, "no such number")
    table[key] = value


def plane(scene, name):
    """The bodies and the load, in the plane and about the centre of mass."""
    obj, fingers = scene["object"], scene.get("finger", [])
    pusher, = [b for b in scene["pusher"] if b["name"] == name]
    require(scene.get("planar") is True and scene.get("facets", "round") == "round", "another law")
    require(not scene.get("actuator"), "another hand")
    if "tilt" in obj or "rotation" in obj: in_object_frame(scene, obj)
    com = obj.get("center_of_mass", ZERO)
    force, arm = obj.get("force", ZERO), add(obj.get("at", com), com, -1)
    load = add(force, scene.get("gravity", ZERO), F(obj["mass"]))[:2] + [add(obj.get("moment", ZERO), cross(arm, force))[2]]
    for body in fingers + [pusher]:
        if "on" in body: put_on_face(body, obj, com)
        n = unit(body["normal"])
        axis = 0
        for i in (1, 2): axis = i if abs(n[i]) < abs(n[axis]) - F(1, 10**9) else axis
        v, along = body["normal"], body.get("tangent", [i == axis for i in range(3)])
        t = unit(add([dot(v, v) * x for x in along], v, -dot(v, along)))
        body["n"] = n
        body["at"] = [add(add(p, body.get("shift", ZERO)), com, -1) for p in patch(body, t, cross(n, t))]
    return load, fingers, pusher


def resists(body, twist):
    """Force and torque against the motion of a finger that presses with 1 and has friction 1."""
    require(not body["n"][0] and not body["n"][1], "a finger does not press along z")
    total, (vx, vy, turn) = [Interval(0)] * 3, map(Interval, twist)
    radius = Interval(body.get("torsion_radius", 0))
    for p, weight in zip(body["at"], map(Interval, weights(body, len(body["at"])))):
        off = ROUNDED * sum(map(abs, p)) if body["shape"] in ("disc", "ring") else 0
        x, y = about(p[0], off), about(p[1], off)
        u = vx - turn * y, vy + turn * x, radius * turn
        square = [a if a.low >= 0 or a.high <= 0 else Interval(min(a.low, -a.high), max(-a.low, a.high)) for a in u]
        speed = root(square[0] * square[0] + square[1] * square[1] + square[2] * square[2])
        r = [a.over(speed) for a in u] if speed.low > 0 else [Interval(-1, 1)] * 3
        part = r[0], r[1], x * r[1] - y * r[0] + radius * r[2]
        total = [a + weight * b for a, b in zip(total, part)]
    return total


def conditions(load, fingers, pusher, fixed):
    """mu f_n - f_t, mu f_n + f_t, M - s_first f_n, s_last f_n - M: none is negative where it sticks."""
    w = [Interval(-x) for x in load]
    for body, resistance in zip(fingers, fixed):
        limit = Interval(F(body["friction"]) * F(body.get("grip_force", 0)))
        w = [a + limit * r for a, r in zip(w, resistance)]
    off = 0 if dot(pusher["n"], pusher["n"]) == 1 else CUT
    nx, ny, mu = about(pusher["n"][0], off), about(pusher["n"][1], off), Interval(F(pusher["friction"]))
    pressed, dragged = w[0] * nx + w[1] * ny, w[1] * nx - w[0] * ny

    def beyond(p):
        x, y = Interval(p[0]), Interval(p[1])
        return (x * nx + y * ny) * dragged - w[2] - (y * nx - x * ny) * pressed
    along = sorted(pusher["at"], key=lambda p: p[1] * pusher["n"][0] - p[0] * pusher["n"][1])
    return mu * pressed - dragged, mu * pressed + dragged, beyond(along[0]), Interval(0) - beyond(along[-1])


def check(c, text):
    claim = [c["pusher"], *c["twist"]] + [x for side in c["box"] for x in (*side["paths"], side["low"], side["high"])] + [
        x for one in c["conditions"] for x in (*one["corner"], one["least"])]
    prints = [hashlib.sha256(part).hexdigest() for part in (text, ",".join(claim).encode())]
    require(prints == c["sha256"] and c["certificate"] == 1 and c["proof"] == "box", "another file, or it is damaged")
    require(c["statement"] == SAYS and len(c["conditions"]) == 4, "another statement")
    scene, twist = tomllib.loads(text.decode("utf-8-sig"), parse_float=F), [F(x) for x in c["twist"]]
    sides = [(side["paths"], F(side["low"]), F(side["high"])) for side in c["box"]]
    paths = [path for side in sides for path in side[0]]
    require(len(set(paths)) == len(paths) and all(low <= high for _, low, high in sides) and any(twist), "no box")
    least, fixed = [None] * 4, None
    for ends in itertools.product((1, 2), repeat=len(sides)):  # of the first number the lower end changes first
        corner = [side[end] for side, end in zip(sides, reversed(ends))]
        there = copy.deepcopy(scene)
        for (names, _, _), value in zip(sides, corner):
            for path in names: put(there, path, value)
        load, fingers, pusher = plane(si(there), c["pusher"])
        if fixed is None:
            fixed = [resists(body, twist) for body in fingers]
            (vx, vy, turn), (nx, ny, _) = twist, pusher["n"]
            require(any((vx - turn * y) * nx + (vy + turn * x) * ny > 2 * CUT for x, y, _ in pusher["at"]), "it does not press")
        require(F(pusher["friction"]) >= 0 and all(F(b["friction"]) >= 0 and F(b.get("grip_force", 0)) >= 0 for b in fingers),
                "a negative friction or grip")
        for k, value in enumerate(conditions(load, fingers, pusher, fixed)):
            require(value.low >= 0, f"condition {k + 1} fails at {[str(x) for x in corner]}")
            if least[k] is None or value.low < least[k][0] - TIE: least[k] = value.low, corner
    for one, (value, corner) in zip(c["conditions"], least):
        require([F(x) for x in one["corner"]] == corner and 0 <= F(one["least"]) <= value, "another corner is worse")


if __name__ == "__main__":
    try: certificate, text = [pathlib.Path(path).read_bytes() for path in sys.argv[1:]]
    except (OSError, ValueError): sys.exit(print("usage: lcpush_check_box.py CERTIFICATE SCENE.toml, both readable", file=sys.stderr) or 2)
    try: check(json.loads(certificate), text)
    except Exception as error: sys.exit(f"Refused: {error}.")
    print("Accepted: " + SAYS)
