"""Accepts or refuses a certificate of lcpush in whole numbers, by the laws in certificates.md:
    python3 lcpush_check.py CERTIFICATE.json SCENE.toml        or  CERTIFICATE.json M.mtx q.mtx"""
import hashlib, json, math, pathlib, re, sys, tomllib
from fractions import Fraction as F
CUT, UNIT, PI, ZERO = 10**15, 10**40, 31415926535897932384626433832795028841971, [F(0)] * 3
SAYS = {"answer": "These numbers solve every law of the problem without any error.",
        "squeeze": "These forces balance inside the friction cones, load no actuator, and the push tightens them.",
        "cannot_hold": "No forces inside the friction cones balance the load: this motion gains more than they take.",
        "no_answer": "These weights add the rows up to a contradiction: no z >= 0 makes every w >= 0."}
UNITS = {name: F(10)**power for power, names in {
    3: "kN", 0: "kg,m,N,N m,s,rad,m/s,rad/s,m/s^2,rad/s^2,kg m^2", -2: "cm,cm/s,cm/s^2", -3: "g,mm,mN,N mm,ms,mm/s,mm/s^2",
    -6: "um"}.items() for name in names.split(",")} | {name: F(PI, 180 * UNIT) for name in ("deg", "deg/s", "deg/s^2")}
SYMBOLS = str.maketrans({"²": "^2", "°": "deg", "µ": "u", "μ": "u", "·": " ", "*": " "})  # in typed units
def require(truth, why):
    if not truth: raise ValueError(why)
def dot(a, b): return sum((x * y for x, y in zip(a, b) if x and y), F(0))
def add(a, b, k=1): return [x + k * y for x, y in zip(a, b)]
def cross(a, b): return [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]]
def twist(v, w, arm): return add(v, cross(w, arm)) + list(w)
def steps(k): return [F(2*i - k + 1, max(k - 1, 1)) for i in range(k)]
def unit(v):  # v / |v|; if that is irrational, every coordinate cut off after 15 decimals
    square = F(dot(v, v))
    root = F(math.isqrt(square.numerator), math.isqrt(square.denominator))
    if root * root == square: return [x / root for x in v]
    parts = [F(x * x) / square for x in v]
    return [(-1 if x < 0 else 1) * F(math.isqrt(p.numerator * CUT**2 // p.denominator), CUT) for x, p in zip(v, parts)]
def circle(turn):  # (cos, sin) of 2 pi turn: a fraction on the unit circle
    turn %= 1
    if turn > F(1, 2): return (lambda c, s: (c, -s))(*circle(1 - turn))
    if turn > F(1, 4): return (lambda c, s: (-c, s))(*circle(F(1, 2) - turn))
    if turn > F(1, 8): return circle(F(1, 4) - turn)[::-1]
    angle, sums, term, k = PI * turn.numerator // turn.denominator, [0, 0], UNIT, 0
    while term:  # Taylor's series of the half angle
        sums[k % 2] += term if k % 4 < 2 else -term
        term, k = term * angle // UNIT // (k + 1), k + 1
    t = F(sums[1] * UNIT // sums[0], UNIT).limit_denominator(10**9)
    return (1 - t*t) / (1 + t*t), 2*t / (1 + t*t)
def patch(body, t, o):  # its points
    shape, k, c = body["shape"], body.get("points"), body.get("center")
    if shape in ("point", "points") or k == 1: return k if shape == "points" else [c]
    if shape == "line":
        a, b = body["ends"]
        return [add([x / F(2) for x in add(a, b)], add(b, a, -1), x / 2) for x in steps(k or 4)]
    if shape == "rectangle":
        (i, j), (a, b) = k or (4, 4), body["size"]
        return [add(add(c, t, a * x / 2), o, b * y / 2) for y in steps(j) for x in steps(i)]
    k, points = k or (12 if shape == "disc" else 8), []
    rings = 1 if k < 6 or shape == "ring" else 2
    while rings > 1 and 4 * (rings + 2)**2 <= k: rings += 2
    begin = lambda i: i*k // rings if rings < 3 else i*(i+1)*k // (rings*(rings+1))
    for i, count in ((i, begin(i + 1) - begin(i)) for i in range(rings)):
        r = body["radius"] * (F(i + 1, rings) if rings > 1 or shape == "ring" else F(2, 3))
        points += [add(add(c, t, r * x), o, r * y)
                   for x, y in (circle(F(2*j + rings - 1 - i, 2*count)) for j in range(count))]
    return points
def si(value):  # "120 g" is 3/25
    if isinstance(value, dict): return {k: v if k in ("name", "title", "bodies") else si(v) for k, v in value.items()}
    if isinstance(value, str) and re.fullmatch(r"\s*\d[^x]*(x\s*\d[^x]*)+", value):  # "80 x 40 x 20 mm"
        value = [v if re.search("[a-df-z]", v) else v + re.search(r"\s*[a-z]*$", value)[0] for v in value.split("x")]
    if isinstance(value, list): return [si(v) for v in value]
    parts = isinstance(value, str) and re.fullmatch(r"\s*\+?(-?\d[\d.]*(?:[eE][+-]?\d+)?)\s*(\D.*?)\s*", value)
    unit = parts and parts[2].translate(SYMBOLS).replace("s2", "s^2").replace("Nm", "N m")
    return F(parts[1]) * UNITS[unit] if unit in UNITS else value
def put_on_face(body, obj, com):  # on = "+z", center = [x, y] in that face, along = "y"
    axis, sign = "xyz".index(body["on"][1]), F(body["on"][0] + "1")
    offset = list(body.get("center", (0, 0)))
    offset.insert(axis, sign * (obj["box"][axis] if "box" in obj else
                                obj["cylinder_length"] if "cylinder_length" in obj else 2*obj["sphere_radius"]) / 2)
    if body["shape"] == "line":  # clipped to the face
        j, ends = "xyz".index(body["along"]), [list(offset), list(offset)]
        half, reach = (obj["box"][j] / 2 if "box" in obj else obj["cylinder_radius"]), body.get("length", 0) / F(2)
        ends[0][j], ends[1][j] = (max(offset[j] - reach, -half), min(offset[j] + reach, half)) if reach else (-half, half)
        body["ends"] = [add(com, end) for end in ends]
    elif "along" in body: body["tangent"] = [i == "xyz".index(body["along"]) for i in range(3)]
    body.update(center=add(com, offset), normal=[-sign * (i == axis) for i in range(3)])

def turned(rotation):  # v -> v turned back by [axis.., angle]
    axis, near = [F(x) for x in rotation[:3]], lambda x: F(x).limit_denominator(10**9)
    half, size, w = math.tan(float(rotation[3]) / 2), math.sqrt(float(dot(axis, axis))), F(1)
    if abs(half) <= 1: axis = [near(half / size) * x for x in axis]
    else: w = near(size / half)
    return lambda v: add(v, add(cross(axis, cross(axis, v)), cross(axis, v), -w), 2 / (w*w + dot(axis, axis)))

def in_object_frame(scene, obj):
    if "tilt" in obj: obj["rotation"] = [F(a == obj["tilt"][-1]) for a in "xyz"] + [si(obj["tilt"].split(" about ")[0])]
    back = turned(obj["rotation"])
    for table, keys in [(scene, ("gravity",)), (obj, ("force", "moment"))] + [
            (b, ("center", "ends", "points", "normal", "tangent", "shift", "about", "velocity", "angular_velocity", "acceleration",
                 "angular_acceleration")) for b in scene.get("finger", []) + scene.get("pusher", []) if b.get("frame") == "scene"]:
        for key in keys:
            if isinstance(table.get(key), list) and not (key == "points" and not isinstance(table[key][0], list)):
                table[key] = [back(v) for v in table[key]] if isinstance(table[key][0], list) else back(table[key])

def scene_problem(text, g):  # w = L x + q0 + push q1: L, q0, q1, the free rows, the cones
    scene = si(tomllib.loads(text, parse_float=F))
    require(scene.get("pressure") != "even", "another law")
    obj, fingers, pushers = scene["object"], scene.get("finger", []), [b for b in scene.get("pusher", []) if not b.get("from")]
    if "tilt" in obj or "rotation" in obj: in_object_frame(scene, obj)
    m, com, box, r = F(obj["mass"]), obj.get("center_of_mass", ZERO), obj.get("box"), obj.get("cylinder_radius")
    I = (list(obj.get("inertia", [])) or (box and [m * (dot(box, box) - e*e) / 12 for e in box]) or
         (not r and 3 * [2 * m * obj["sphere_radius"]**2 / 5]) or
         [m * (6*r*r if obj.get("axis", "z") == a else 3*r*r + obj["cylinder_length"]**2) / 12 for a in "xyz"]) + ZERO
    load = add(obj.get("force", ZERO), scene.get("gravity", ZERO), m) + add(
        obj.get("moment", ZERO), cross(add(obj.get("at", com), com, -1), obj.get("force", ZERO)))
    tau, drives, named = [], [], {}  # every actuator's (force, inertia); (body, actuator, twist)
    def drive(body, force): tau.append((F(force), F(0))), drives.append((body, len(tau) - 1, body["n"] + ZERO))
    for body in fingers + pushers:
        if "on" in body: put_on_face(body, obj, com)
        for key in ("angular_velocity", "angular_acceleration"):  # in a plane, about z
            if isinstance(body.get(key), F): body[key] = [F(0), F(0), body[key]]
        n, v, axis, named[body["name"]] = unit(body["normal"]), body["normal"], 0, body
        for i in (1, 2): axis = i if abs(n[i]) < abs(n[axis]) - F(1, 10**9) else axis
        along = body.get("tangent", [i == axis for i in range(3)])
        t = unit(add([dot(v, v) * x for x in along], v, -dot(v, along)))
        body.update(n=n, t=t, o=cross(n, t), moves=twist(*(body.get(k + "velocity", body.get(k + "acceleration", ZERO))
            if body in pushers else ZERO for k in ("", "angular_")), add(com, body.get("about", ZERO), -1)))
    grips, jaws = [b for b in fingers if "grip_force" in b], scene.get("gripper", {}).get("jaws")
    if not jaws and len(grips) == 2 and grips[0]["grip_force"] == grips[1]["grip_force"] and max(
            map(abs, add(grips[0]["n"], grips[1]["n"]))) < F(1, 10**9): jaws = "parallel"
    for body in grips if jaws != "locked" else []: drive(body, body["grip_force"])
    if jaws == "parallel": tau, drives = [(2 * tau[0][0], F(0))], [(b, 0, J) for b, _, J in drives]
    for a in scene.get("actuator", []):
        if "force" in a: tau.append((F(a["force"]), F(a.get("inertia", 0))))
        for body, v in zip(map(named.get, a["bodies"]), a["twists"]):
            if "force" in a: drives.append((body, len(tau) - 1, twist(v[:3], v[3:], com)))
            else: body["moves"] = add(body["moves"], twist(v[:3], v[3:], com), a["acceleration"])
    for body in pushers: drive(body, body["normal_force"]) if "normal_force" in body else None
    c30, half, axes = circle(F(1, 12))[0], F(1, 2), (0, 1, 5) if scene.get("planar") else range(6)
    rows, cones, q1 = [], {}, []  # of the pairs: a force's wrench and its powers, or None for a slip
    for body in fingers + pushers:
        n, t, o, mu, r = *(body[k] for k in "nto"), F(body["friction"]), body.get("torsion_radius", 0)
        positions, sides = [add(p, body.get("shift", ZERO)) for p in patch(body, t, o)], g
        if scene.get("planar") and abs(n[2]) <= F(1, 10**9):  # friction forth and back along the plane
            t, r, sides = [n[1], -n[0], F(0)], 0, 2
        elif mu: require(scene.get("facets", 8) == g, "another law")
        for position in positions:
            p, normals = add(position, com, -1), range(len(rows), len(rows) + 1 + (body.get("follow") == "bilateral"))
            forces = [[s * x for x in n + cross(p, n)] for s in (1, -1)[:len(normals)]]
            for c, s in [(1, 0)] + ([(c30, half), (c30, -half), (half, c30), (half, -c30)] if r else []):
                for d in ([c * (x * u + y * v) for u, v in zip(t, o)] for x, y in (circle(F(j, sides)) for j in range(sides))):
                    forces.append(d + add(cross(p, d), n, s * r))
            forces += [ZERO + [s * r * x for x in n] for s in (1, -1) if r]
            for f in forces if mu else forces[:len(normals)]:
                rows.append((f, [(a, dot(f, J)) for b, a, J in drives if b is body])); q1.append(-dot(f, body["moves"]))
            if mu: cones[len(rows)] = mu, normals, range(normals.stop, len(rows)); rows.append(None); q1.append(F(0))
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
        L[slip] = {i: mu for i in normals}
        for j in frictions: L[slip][j], L[j][slip] = F(-1), F(1)
    return L, q0, q1 + [F(0)] * (len(L) - pairs), range(pairs, len(L)), cones
def matrix(text):  # Matrix Market, real general
    lines = [line.split() for line in text.splitlines() if line.strip()]
    require(lines[0][3:] in (["real", "general"], ["integer", "general"]), "another kind of matrix")
    size, *cells = [line for line in lines if line[0][0] != "%"]
    n, rows = int(size[0]), [{} for _ in range(int(size[0]))]
    if lines[0][2] == "array": cells = [(k % n + 1, k // n + 1, v) for k, v in enumerate(sum(cells, []))]
    for i, j, v in cells: rows[int(i) - 1][int(j) - 1] = F(v)
    return rows

def check(c, texts):
    prints = [hashlib.sha256(t).hexdigest() for t in (*texts, ",".join(c["x"]).encode())]
    require(prints == c["sha256"] and c["certificate"] == 1, "another file, or x is damaged")
    require(c["statement"] == SAYS[c["proof"]], "another statement")
    (text, *rest), x, push = [t.decode("utf-8-sig") for t in texts], [F(v) for v in c["x"]], F(c["push"])
    require(c["law"] == ("raw" if rest else "literal"), "another law")
    L, q0, q1, free, cones = scene_problem(text, c["facets"]) if not rest else (
        matrix(text), [row.get(0, F(0)) for row in matrix(*rest)], [F(0)] * len(x), [i - 1 for i in c["free"]], {})
    n, free = len(L), set(free)
    if c["proof"] in ("cannot_hold", "no_answer"):  # Farkas: y adds the rows up to a contradiction
        require(len(x) == (n if rest else len(free)) and push == 0 and not c["basis"], "another length")
        y = [F(0)] * (n - len(x)) + x
        require(all(v >= 0 for i, v in enumerate(y) if i not in free) and dot(y, q0) < 0, "no contradiction")
        gain = [sum((L[i].get(j, 0) * y[i] for i in range(n) if y[i]), F(0)) for j in range(n)]
        rays = [gain[i] + mu * gain[j] for mu, normals, frictions in cones.values() for i in normals for j in frictions]
        inside = {k for slip, (_, a, b) in cones.items() for k in (slip, *a, *b)} | (set() if rest else free)
        rays += [abs(gain[j]) if j in free else gain[j] for j in range(n) if j not in inside]
        return require(max(rays) <= 0, "a force takes more")
    require([i + 1 for i in range(n) if i not in free and x[i]] == c["basis"] and len(x) == n, "another basis")
    require(push == 1 if rest else push > 0, "another push")
    w = [sum((v * x[j] for j, v in row.items() if x[j]), F(0)) for row in L]
    if c["proof"] == "squeeze":
        require(push == 1 and all(v >= 0 for v in x) and not any(x[i] for i in (*cones, *free)), "not forces")
        return require(not any(w[i] for i in free) and all(w[i] >= 0 for i in cones) and dot(x, q1) < 0, "no squeeze")
    for i, v in enumerate(w):
        v += q0[i] + push * q1[i]
        require(v == 0 if i in free else min(x[i], v) == 0, f"row {i + 1} fails")
if __name__ == "__main__":
    try: certificate, scene, *more = [pathlib.Path(path).read_bytes() for path in sys.argv[1:]]
    except (OSError, ValueError): sys.exit(print("usage: lcpush_check.py CERTIFICATE SCENE.toml, both readable", file=sys.stderr) or 2)
    try: check(c := json.loads(certificate), [scene, *more])
    except Exception as error: sys.exit(f"Refused: {error}.")
    print("Accepted: " + SAYS[c["proof"]] + f" Push: {c['push']} times the scene's." * (c["law"] == "literal"))
