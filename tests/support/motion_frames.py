"""Do the printed frames of a motion obey the laws of a step [T.13]? From scene file and frames alone.

faults(text, answer) says a sentence for each that does not: text is the scene, answer the object of
`lcpush move --json` with a frame for every step. Where a body turns, its normal is not known
here: only its forces' sums are looked at.
"""
import math
import tomllib


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def norm(v):
    return math.sqrt(dot(v, v))


def add(a, b, factor=1.0):
    return [x + factor * y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turned(R, v):
    return [dot(row, v) for row in R]


def rows(flat):
    return [flat[0:3], flat[3:6], flat[6:9]]


def product(A, B):
    return [[dot(row, column) for column in zip(*B)] for row in A]


def rotation_by(w):
    angle = norm(w)
    if angle == 0:
        return [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
    u, c, s = [x / angle for x in w], math.cos(angle), math.sin(angle)
    K = [[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]]
    KK = product(K, K)
    return [[(i == j) + s * K[i][j] + (1 - c) * KK[i][j] for j in range(3)] for i in range(3)]


def inertia(thing):
    m = thing["mass"]
    if "box" in thing:
        x, y, z = thing["box"]
        d = [m / 12 * (y * y + z * z), m / 12 * (x * x + z * z), m / 12 * (x * x + y * y)]
    elif "cylinder_radius" in thing:
        r, length, axis = thing["cylinder_radius"], thing["cylinder_length"], "xyz".index(thing.get("axis", "z"))
        d = [m * r * r / 2 if k == axis else m * (3 * r * r + length * length) / 12 for k in range(3)]
    else:
        d = list(thing["inertia"]) + [0, 0, 0]
        return [[d[0], d[3], d[4]], [d[3], d[1], d[5]], [d[4], d[5], d[2]]]
    return [[d[0], 0, 0], [0, d[1], 0], [0, 0, d[2]]]


class Laws:
    """Of one scene."""

    def __init__(self, text):
        scene = tomllib.loads(text)
        self.thing, self.gravity = scene["object"], scene.get("gravity", [0, 0, 0])
        self.planar = scene.get("planar", False)
        self.facets = scene.get("facets", 8)
        self.bodies = {body["name"]: body for kind in ("finger", "pusher") for body in scene.get(kind, [])}
        for body in self.bodies.values():
            if "on" in body:
                sign = -1 if body["on"][0] == "+" else 1
                body["normal"] = [sign * (axis == body["on"][1]) for axis in "xyz"]
            body["n"] = [x / norm(body["normal"]) for x in body["normal"]]
        self.jaws, self.actuators = scene.get("gripper", {}).get("jaws"), scene.get("actuator", [])
        self.fingers = [b for b in scene.get("finger", []) if "grip_force" in b]
        com = self.thing.get("center_of_mass", [0, 0, 0])
        force = self.thing.get("force", [0, 0, 0])
        self.force = add(force, self.gravity, self.thing["mass"])
        self.moment = add(self.thing.get("moment", [0, 0, 0]), cross(add(self.thing.get("at", com), com, -1), force))
        self.inertia = inertia(self.thing)
        self.size = 2 * math.sqrt(sum(self.inertia[k][k] for k in range(3)) / self.thing["mass"])
        self.turning = {name for actuator in self.actuators
                        for name, twist in zip(actuator["bodies"], actuator["twists"]) if norm(twist[3:]) > 0}

    def check(self, answer):
        """A sentence for each fault."""
        self.found, before = [], None
        for frame in answer["frames"]:
            h = frame["step"]
            if before is not None and abs(frame["time"] - before["time"] - h) > 1e-9 * h:
                before = None  # a step is missing between them
            if before is not None:
                self.step(before, frame, h)
            before = frame
        return self.found

    def say(self, words, frame):
        self.found.append(f"{words} at {frame['time']:.6g} s")

    def step(self, before, frame, h):
        self.largest = max([c["normal_force"] for c in frame["contacts"]] +
                           [norm(b["force"]) for b in frame["bodies"]] + [norm(self.force), 1e-6])
        self.fastest = max([norm(c["velocity"]) for c in frame["contacts"]] + [norm(frame["twist"][:3]), 1e-3])
        # How far a step along tangents may miss a face that turns.
        turn = h * norm(frame["twist"][3:])
        self.missed = 2 * turn * (turn * self.size + h * self.fastest) + 1e-9
        self.balance(before, frame, h)
        self.way(before, frame, h)
        R = rows(before["rotation"])
        for contact in frame["contacts"]:
            body = self.bodies[contact["name"].rsplit(".", 1)[0]]
            turns = body.get("angular_velocity") or body.get("angular_acceleration") or body["name"] in self.turning
            if contact["mode"] in ("stick", "slide", "separate") and not turns:
                stays = self.on_side(body) or body.get("points_on") == "object"
                self.contact(contact, body, body["n"] if stays else turned(R, body["n"]), frame, h)
        self.closing(frame)

    def balance(self, before, frame, h):
        m, change = self.thing["mass"], add(frame["twist"], before["twist"], -1)
        forces = [b["force"] for b in frame["bodies"]]
        left, sum_ = [m * x / h for x in change[:3]], self.force
        for f in forces:
            sum_ = add(sum_, f)
        axes = (0, 1) if self.planar else (0, 1, 2)
        if max(abs(left[k] - sum_[k]) for k in axes) > 1e-8 * self.largest:
            self.say(f"Newton fails by {norm(add(left, sum_, -1)):.2g} N", frame)
        R, w = rows(before["rotation"]), before["twist"][3:]
        I = product(product(R, self.inertia), [list(column) for column in zip(*R)])
        left = [x / h for x in turned(I, change[3:])]
        sum_ = add(self.moment, cross(w, turned(I, w)), -1)
        for b in frame["bodies"]:
            sum_ = add(sum_, b["moment"])
        axes = (2,) if self.planar else (0, 1, 2)
        if max(abs(left[k] - sum_[k]) for k in axes) > 1e-7 * self.largest * self.size:
            self.say(f"Euler fails by {norm(add(left, sum_, -1)):.2g} N m", frame)

    def way(self, before, frame, h):
        v, w = frame["twist"][:3], frame["twist"][3:]
        if norm(add(add(before["position"], v, h), frame["position"], -1)) > 1e-12:
            self.say("the way is not the velocity's", frame)
        R = product(rotation_by([h * x for x in w]), rows(before["rotation"]))
        if max(abs(x - y) for a, b in zip(R, rows(frame["rotation"])) for x, y in zip(a, b)) > 1e-12:
            self.say("the turn is not the velocity's", frame)

    def on_side(self, body):
        if "cylinder_radius" not in self.thing or body.get("points_on") == "object":
            return False
        return abs(body["n"]["xyz".index(self.thing.get("axis", "z"))]) < 0.5

    def contact(self, contact, body, n, frame, h):
        name, N, f, v = (contact[k] for k in ("name", "normal_force", "friction_force", "velocity"))
        limit, gap, presses = body["friction"] * N, contact["gap"], N > 1e-6 * self.largest
        if N < 0 or norm(f) > limit + 1e-8 * self.largest or abs(dot(f, n)) > 1e-8 * self.largest:
            self.say(f"{name} leaves its cone", frame)
        if gap is not None and gap < -1e-9:
            self.say(f"{name} is {-gap:.2g} m inside its face", frame)
        along = add(v, n, -dot(v, n))
        if "torsion_radius" not in body:
            corner = 1 if self.facets == "round" else math.cos(math.pi / self.facets)
            if dot(f, along) + limit * corner * norm(along) > 1e-6 * self.largest * self.fastest:
                self.say(f"{name} does not dissipate along its slip", frame)
        if presses and gap is not None and gap > self.missed:
            self.say(f"{name} presses through a gap of {gap:.2g} m", frame)
        if presses and dot(v, n) > 1e-6 * self.fastest + self.missed / h:
            self.say(f"{name} presses what leaves it", frame)

    def closing(self, frame):
        force = {b["name"]: b["force"] for b in frame["bodies"]}
        pressed = [(dot(force[f["name"]], f["n"]), f["grip_force"], f["name"]) for f in self.fingers]
        opposed = len(pressed) == 2 and pressed[0][1] == pressed[1][1] and \
            norm(add(self.fingers[0]["n"], self.fingers[1]["n"])) < 1e-9
        if self.actuators or self.jaws == "locked":
            return
        if self.jaws == "parallel" or (self.jaws is None and opposed):
            pressed = [(sum(p[0] for p in pressed), sum(p[1] for p in pressed), "the jaw")]
        for got, grip, name in pressed:
            if abs(got - grip) > 1e-7 * self.largest:
                self.say(f"{name} closes with {got:.9g} N, not {grip} N,", frame)


def faults(text, answer):
    return Laws(text).check(answer)
