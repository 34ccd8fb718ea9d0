"""Judges an answer of a scene by its file and the paper's matrices (`lcpush matrices`) alone."""
import json
import math
import subprocess
import tomllib

TOLERANCE = 1e-7


def lcpush(tool, *words):
    return subprocess.run([tool, *map(str, words)], capture_output=True, text=True, timeout=60).stdout


def dot(x, y):
    return sum(a * b for a, b in zip(x, y, strict=True))


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


class Judge:
    """The laws of one scene, to be asked about answers."""

    def __init__(self, tool, scene):
        self.file = tomllib.loads(scene.read_text())
        self.m = json.loads(lcpush(tool, "matrices", scene, "--json"))
        pushers = self.file.get("pusher", [])
        self.bodies = {b["name"]: b for b in self.file.get("finger", []) + pushers}
        self.generators = {d["body"]: list(zip(*d["values"])) for d in self.m["D"]}
        self.columns = {name: [row[k] for row in self.m["G"]["values"]]
                        for k, name in enumerate(self.m["G"]["columns"])}
        self.jacobian = dict(zip(self.m["J"]["rows"], self.m["J"]["values"]))
        load = [row[0] for row in self.m["w"]["values"]]
        self.mass = self.m["M"]["values"][0][0]
        grips = [b.get("grip_force", 0) for b in self.bodies.values()]
        grips += [a.get("force", 0) for a in self.file.get("actuator", [])]
        self.force = max(*grips, math.hypot(*load[:3]), 0)

    def prescribed(self, name):
        """The prescribed twist of a contact's body, at the object's centre of mass."""
        body = self.bodies[name.split(".")[0]]
        turn = body.get("angular_acceleration", [0, 0, 0])
        center = self.file["object"].get("center_of_mass", [0, 0, 0])
        arm = [x - y for x, y in zip(center, body.get("about", [0, 0, 0]))]
        linear = body.get("acceleration", [0, 0, 0])
        return [x + y for x, y in zip(linear, cross(turn, arm))] + turn

    def motion_and_force(self, contact, a, closing):
        """Of one contact, by its axes n, t, o and, at a soft point, torsion."""
        name, u, f = contact["name"], {}, {"n": contact["normal_force"]}
        for axis in [key.split()[1] for key in self.columns if key.split()[0] == name]:
            column, J = self.columns[f"{name} {axis}"], self.jacobian[f"{name} {axis}"]
            u[axis] = dot(column, a) - dot(J, closing) - dot(column, self.prescribed(name))
            if axis in ("t", "o"):
                f[axis] = dot(column[:3], contact["friction_force"])
            elif axis == "torsion":
                f[axis] = contact["torsion"]
        return u, f

    def targets(self):
        """The forces of the actuators, in their order."""
        pushers = [b["normal_force"] for b in self.file.get("pusher", []) if "normal_force" in b]
        if "actuator" in self.file:
            return [actuator["force"] for actuator in self.file["actuator"]] + pushers
        grips = [b["grip_force"] for b in self.bodies.values() if "grip_force" in b]
        if "jaws" in self.m["J"]["columns"]:  # one drive for both fingers
            grips = [sum(grips)]
        return grips + pushers

    def complaints(self, answer):
        """Laws that the answer breaks, each with its relative violation; empty if it is right."""
        worst = {}

        def keep(law, value):
            if not abs(value) <= worst.get(law, 0):  # a NaN is kept
                worst[law] = abs(value)

        a, closing = answer["object"]["acceleration"], answer["closing"]
        force = max(self.force, max(abs(c["normal_force"]) for c in answer["contacts"]))
        rate = max(force / self.mass, *map(abs, a), *map(abs, closing or [0]))
        length = max(max(map(abs, column[3:])) for column in self.columns.values()) or 1
        total = [row[0] for row in self.m["w"]["values"]]
        load = [0.0] * len(closing)
        for contact in answer["contacts"]:
            name, body = contact["name"], contact["name"].split(".")[0]
            u, f = self.motion_and_force(contact, a, closing)
            for axis in f:
                total = [x + f[axis] * y for x, y in zip(total, self.columns[f"{name} {axis}"])]
                load = [x + f[axis] * y for x, y in zip(load, self.jacobian[f"{name} {axis}"])]
            for axis in ("n", "t", "o"):
                along = dot(self.columns[f"{name} {axis}"][:3], contact["acceleration"])
                keep("acceleration", (along - u[axis]) / rate)
            keep("normal", min(f["n"] / force, u["n"] / rate))
            self.judge_friction(body, u, f, lambda law, value, unit: keep(
                law, value / (force if unit == "N" else force * rate)))
        for k in (0, 1, 5) if self.file.get("planar") else range(6):
            off = dot(self.m["M"]["values"][k], a) - total[k]
            keep("newton", off / (force * (1 if k < 3 else length)))
        for carried, target in zip(load, self.targets(), strict=True):
            keep("grip", (carried - target) / force)
        return {law: value for law, value in worst.items() if not value <= TOLERANCE}

    def judge_friction(self, body, u, f, keep):
        limit = self.bodies[body].get("friction", 0) * f["n"]
        radius = self.bodies[body].get("torsion_radius", 1)
        size = math.hypot(f["t"], f["o"], f.get("torsion", 0) / radius)
        keep("cone", max(0, size - limit), "N")
        # Of all friction that the pyramid allows, the one that takes most power.
        axes, generators = [axis for axis in u if axis != "n"], self.generators[body]
        most = min((dot(d, [u[axis] for axis in axes]) for d in generators), default=0)
        keep("dissipation", sum(f[axis] * u[axis] for axis in axes) - limit * most, "N m/s^2")
        if "torsion" in axes:
            return
        for d, e in zip(generators, generators[1:] + generators[:1]):
            across = [x + y for x, y in zip(d, e)]
            keep("pyramid", max(0, dot(across, [f["t"], f["o"]]) - limit * (1 + dot(d, e))), "N")
