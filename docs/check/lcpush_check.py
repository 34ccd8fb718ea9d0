"""Accepts or refuses a certificate of lcpush in whole numbers, by the laws in certificates.md.

    python3 lcpush_check.py CERTIFICATE.json SCENE.toml        or  CERTIFICATE.json M.mtx q.mtx
"""
import hashlib, json, math, pathlib, sys, tomllib
from fractions import Fraction as F

CUT, UNIT, PI, ZERO = 10**15, 10**40, 31415926535897932384626433832795028841971, [F(0)] * 3
SAYS = {
    "answer": "These numbers solve every law of the problem without any error.",
    "squeeze": "These forces balance inside the friction cones, load no actuator, and the push tightens them.",
    "cannot_hold": "No forces inside the friction cones balance the load: this motion gains more than they take.",
    "no_answer": "These weights add the rows up to a contradiction: no z >= 0 makes every w >= 0."}

def require(truth, why):
    if not truth: raise ValueError(why)
def dot(a, b): return sum((x * y for x, y in zip(a, b) if x and y), F(0))
def add(a, b, k=1): return [x + k * y for x, y in zip(a, b)]
def cross(a, b): return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]

def unit(v):  # v / |v|; if that is irrational, every coordinate cut off after 15 decimals
    square = F(dot(v, v))
    root = F(math.isqrt(square.numerator), math.isqrt(square.denominator))
    if root * root == square: return [x / root for x in v]
    parts = [F(x * x) / square for x in v]
    roots = [F(math.isqrt(p.numerator * CUT * CUT // p.denominator), CUT) for p in parts]
    return [-r if x < 0 else r for x, r in zip(v, roots)]

def circle(turn):  # (cos, sin) of 2 pi turn: a fraction on the unit circle
    turn %= 1
    if turn > F(1, 2): return (lambda c, s: (c, -s))(*circle(1 - turn))
    if turn > F(1, 4): return (lambda c, s: (-c, s))(*circle(F(1, 2) - turn))
    if turn > F(1, 8): return circle(F(1, 4) - turn)[::-1]
    angle, sums, term, k = PI * turn.numerator // turn.denominator, [0, 0], UNIT, 0
    while term:  # Taylor's series of the half angle
        sums[k % 2] += term if k % 4 < 2 else -term
        term, k = term * angle // UNIT // (k + 1), k + 1
    t = F(sums[1] * UNIT // sums[0], UNIT).limit_denominator(2000000)
    return (1 - t*t) / (1 + t*t), 2*t / (1 + t*t)

def steps(k): return [F(2*i - k + 1, max(k - 1, 1)) for i in range(k)]
def shares(k):  # of a line's points: total, mean distance and second moment
    if k < 4: return [[F(1)], [F(1, 2)] * 2, [F(1, 4), F(1, 2), F(1, 4)]][k - 1]
    m, inner = (k - 1) // 2, F(k - 4, (k - 3) * (k - 2)) if k % 2 else F(k - 1, k * (k - 2))
    near = (F(m, 2) - (m*m - 2) * inner) / 2 if k % 2 else inner
    end = (1 - 2*near - (k - 4) * inner) / 2
    return [end, near] + [inner] * (k - 4) + [near, end]

def patch(body, t, o):  # points and their weights
    shape, k, c = body["shape"], body.get("points"), body.get("center")
    if shape == "point": return [c], [F(1)]
    if shape == "points": return k, [F(w) / sum(body.get("weights", [1] * len(k)))
                                     for w in body.get("weights", [1] * len(k))]
    if shape == "line":
        (a, b), k = body["ends"], k or 4
        return [add([x / F(2) for x in add(a, b)], add(b, a, -1), x / 2) for x in steps(k)], shares(k)
    if shape == "rectangle":
        (i, j), (a, b) = k or (4, 4), body["size"]
        return ([add(add(c, t, a * x / 2), o, b * y / 2) for y in steps(j) for x in steps(i)],
                [v * w for v in shares(j) for w in shares(i)])
    k, r = k or (12 if shape == "disc" else 8), body["radius"]
    rings = 0 if k == 1 else 1 if k < 6 or shape == "ring" else 2
    while rings > 1 and 4 * (rings + 2)**2 <= k: rings += 2
    points, weights = ([], []) if rings else ([c], [F(1)])
    begin = lambda i: i*k // rings if rings < 3 else i*(i+1)*k // (rings*(rings+1))
    for i in range(rings):
        count, simpson = begin(i + 1) - begin(i), 1 if i + 1 == rings else 4 if i % 2 == 0 else 2
        radius = r * (F(i + 1, rings) if rings > 1 or shape == "ring" else F(2, 3))
        turns = (circle(F(2*j + rings - 1 - i, 2*count)) for j in range(count))
        points += [add(add(c, t, radius * x), o, radius * y) for x, y in turns]
        weights += [(F(2*(i+1)*simpson, 3*rings**2) if rings > 1 else F(1)) / count] * count
    return points, weights

def scene_problem(text, law, g):  # w = L x + q0 + push q1: L, q0, q1, the free rows, the cones
    scene = tomllib.loads(text, parse_float=F)
    same = (scene.get("pressure") == "even") == (law == "even") and scene.get("facets", 8) == g
    require(same and law in ("even", "literal"), "another law")
    obj, fingers, pushers = scene["object"], scene.get("finger", []), scene.get("pusher", [])
    m, com, named, r = F(obj["mass"]), obj.get("center_of_mass", ZERO), {}, obj.get("cylinder_radius")
    I = list(obj.get("inertia", [])) + ZERO
    if "box" in obj: I = [m * (dot(obj["box"], obj["box"]) - e*e) / 12 for e in obj["box"]] + ZERO
    if r: I = [m * (6*r*r if obj.get("axis", "z") == a else 3*r*r + obj["cylinder_length"]**2) / 12
               for a in "xyz"] + ZERO
    load = add(obj.get("force", ZERO), scene.get("gravity", ZERO), m) + add(obj.get("moment", ZERO), cross(
        add(obj.get("at", com), com, -1), obj.get("force", ZERO)))
    def twist(v, w, about): return add(v, cross(w, add(com, about, -1))) + list(w)
    tau, drives = [], []  # every actuator's (force, inertia); (body, None or point, actuator, twist)
    def drive(body, key): tau.append((F(body[key]), F(0))), drives.append(
        (body, None, len(tau) - 1, body["frame"][0] + ZERO))
    for body in fingers + pushers:
        n, v, axis, named[body["name"]] = unit(body["normal"]), body["normal"], 0, body
        for i in (1, 2): axis = i if abs(n[i]) < abs(n[axis]) - F(1, 10**9) else axis
        along = body.get("tangent", [i == axis for i in range(3)])
        t = unit(add([dot(v, v) * x for x in along], v, -dot(v, along)))
        body["frame"], body["patch"] = (n, t, cross(n, t)), patch(body, t, cross(n, t))
        body["moves"] = twist(*(body.get(k, ZERO) if body in pushers else ZERO for k in
                                ("acceleration", "angular_acceleration", "about")))
    grips, jaws = [b for b in fingers if "grip_force" in b], scene.get("gripper", {}).get("jaws")
    if not jaws and law != "even" and len(grips) == 2:
        between = add(grips[0]["frame"][0], grips[1]["frame"][0])
        is_jaw = dot(between, between) <= F(1, 10**18) and grips[0]["grip_force"] == grips[1]["grip_force"]
        jaws = "parallel" if is_jaw else None
    for body in grips if jaws != "locked" else []: drive(body, "grip_force")
    if jaws == "parallel":  # one actuator with both forces
        tau, drives = [(2 * tau[0][0], F(0))], [(b, None, 0, J) for b, _, _, J in drives]
    for a in scene.get("actuator", []):
        if "force" in a: tau.append((F(a["force"]), F(a.get("inertia", 0))))
        for name, v in zip(a["bodies"], a["twists"]):
            body, column = named[name], twist(v[:3], v[3:], ZERO)
            if "force" in a: drives.append((body, None, len(tau) - 1, column))
            else: body["moves"] = add(body["moves"], column, a["acceleration"])
    for body in pushers: drive(body, "normal_force") if "normal_force" in body else None
    if law == "even":  # every point of a driven body holds its own share
        even = [(body, k, J, [w * x for x in tau[a]]) for body in fingers + pushers for k, w in
                enumerate(body["patch"][1]) for b, _, a, J in drives if b is body]
        tau, drives = [e[3] for e in even], [(e[0], e[1], i, e[2]) for i, e in enumerate(even)]
    axes, rows, cones, q1, c30 = (0, 1, 5) if scene.get("planar") else range(6), [], {}, [], circle(F(1, 12))[0]
    for body in fingers + pushers:
        (n, t, o), mu, r = body["frame"], F(body["friction"]), body.get("torsion_radius", 0)
        for k, position in enumerate(body["patch"][0]):
            p, first, signs = add(position, com, -1), len(rows), (1, -1)
            forces = [[s * x for x in n + cross(p, n)] for s in signs[:1 + (body.get("follow") == "bilateral")]]
            normals = range(first, first + len(forces))
            for c, s in [(1, 0), (c30, F(1, 2)), (c30, -F(1, 2)), (F(1, 2), c30), (F(1, 2), -c30)][:5 if r else 1]:
                for d in ([c * (x * u + y * v) for u, v in zip(t, o)] for x, y in map(circle, (F(j, g) for j in range(g)))):
                    forces.append(d + add(cross(p, d), n, s * r))
            forces += [ZERO + [s * r * x for x in n] for s in signs if r]
            for f in forces if mu else forces[:len(normals)]:
                rows.append((f, [(a, dot(f, J)) for b, at, a, J in drives if b is body and at in (None, k)]))
                q1.append(-dot(f, body["moves"]))
            if mu: cones[len(rows)] = mu, normals, range(normals.stop, len(rows))
            if mu: rows.append(None), q1.append(F(0))
    pairs, twists = len(rows), len(rows) + len(tau)  # then come the actuators, then the acceleration
    L, q0 = [{} for _ in range(twists + len(axes))], [F(0)] * (twists + len(axes))
    M = [[m * (i == j) for j in range(6)] for i in range(3)] + [
        ZERO + [I[k] for k in ks] for ks in ((0, 3, 4), (3, 1, 5), (4, 5, 2))]
    for i, a in enumerate(axes): L[twists+i], q0[twists+i] = {twists+j: M[a][b] for j, b in enumerate(axes)}, -load[a]
    for a, (force, inertia) in enumerate(tau): L[pairs + a][pairs + a], q0[pairs + a] = inertia, -force
    for i, (f, powers) in ((i, row) for i, row in enumerate(rows) if row):
        for j, value in [(twists + k, f[a]) for k, a in enumerate(axes)] + [(pairs + a, -v) for a, v in powers]:
            L[i][j], L[j][i] = L[i].get(j, 0) + value, L[j].get(i, 0) - value
    for slip, (mu, normals, frictions) in cones.items():
        L[slip] = {**{i: mu for i in normals}, **{j: F(-1) for j in frictions}}
        for j in frictions: L[j][slip] = F(1)
    return L, q0, q1 + [F(0)] * (len(L) - pairs), range(pairs, len(L)), cones

def matrix(text):  # Matrix Market
    lines = [line.split() for line in text.splitlines() if line.strip()]
    size, *cells = [line for line in lines if line[0][0] != "%"]
    rows = [{} for _ in range(int(size[0]))]
    for k, line in enumerate(cells):
        i, j = (int(x) - 1 for x in line[:2]) if lines[0][2] == "coordinate" else (k % len(rows), k // len(rows))
        rows[i][j] = F(line[-1])
    return rows

def check(c, texts):
    require([hashlib.sha256(t).hexdigest() for t in texts] == c["sha256"], "another file")
    require(c["certificate"] == 1 and c["statement"] == SAYS[c["proof"]], "another statement")
    texts, x, push = [t.decode("utf-8-sig") for t in texts], [F(v) for v in c["x"]], F(c["push"])
    if c["law"] == "raw":
        L, q0, free, cones = matrix(texts[0]), matrix(texts[1]), [i - 1 for i in c["free"]], {}
        q0, q1 = [row.get(0, F(0)) for row in q0], [F(0)] * len(q0)
    else: L, q0, q1, free, cones = scene_problem(texts[0], c["law"], c["facets"])
    n, free = len(L), set(free)
    if c["proof"] in ("cannot_hold", "no_answer"):  # Farkas: y adds the rows up to a contradiction
        require(len(x) == (n if c["law"] == "raw" else len(free)) and push == 0 and not c["basis"], "another length")
        y = [F(0)] * (n - len(x)) + x
        require(all(v >= 0 for i, v in enumerate(y) if i not in free) and dot(y, q0) < 0, "no contradiction")
        gain = [sum((L[i].get(j, 0) * y[i] for i in range(n) if y[i]), F(0)) for j in range(n)]
        for mu, normals, frictions in cones.values():
            require(all(gain[i] + mu * gain[j] <= 0 for i in normals for j in frictions), "a force takes more")
        inside = {k for slip, (_, a, b) in cones.items() for k in (slip, *a, *b)} | (free if cones else set())
        return require(all(gain[j] == 0 or gain[j] < 0 and j not in free for j in set(range(n)) - inside), "more")
    require([i + 1 for i in range(n) if i not in free and x[i]] == c["basis"] and len(x) == n, "another basis")
    w = [sum((v * x[j] for j, v in row.items() if x[j]), F(0)) for row in L]
    if c["proof"] == "squeeze":
        require(push == 1 and all(v >= 0 for v in x) and not any(x[i] for i in (*cones, *free)), "not forces")
        return require(not any(w[i] for i in free) and all(w[i] >= 0 for i in cones) and dot(x, q1) < 0, "no squeeze")
    w = [v + a + push * b for v, a, b in zip(w, q0, q1)]
    for i in range(n): require(w[i] == 0 if i in free else min(x[i], w[i]) == 0, f"row {i + 1} fails")

if __name__ == "__main__":
    try:
        certificate, *texts = [pathlib.Path(path).read_bytes() for path in sys.argv[1:]]
        check(json.loads(certificate), texts)
    except Exception as error:
        sys.exit(f"Refused: {error}.")
    print("Accepted: " + SAYS[json.loads(certificate)["proof"]])
