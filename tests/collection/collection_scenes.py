"""The pushes of fixtures/collection, family by family: seeded, typed with few digits."""
import random
import re


def without_comments(text):
    """A scene file's lines as the collection has them, before it says how many facets."""
    kept = (re.sub(r"\s+#.*$", "", line) for line in text.splitlines() if not line.startswith("#"))
    return re.sub(r"^facets = .*\n", "", "\n".join(kept).strip() + "\n", flags=re.M)


def number(value):
    """Three digits."""
    return float(f"{value:.3g}")


def body(kind, name, shape, normal, friction, **keys):
    lines = [f"\n[[{kind}]]", f'name = "{name}"', f'shape = "{shape}"', f"normal = {list(normal)}",
             f"friction = {friction}"]
    for key, value in keys.items():
        lines.append(f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value}")
    return "\n".join(lines)


def scene(title, bodies, mass=0.2, shape="box = [0.1, 0.03, 0.01]", gravity=(0, -9.81, 0), facets=4,
          planar=False, jaws=None, pressure="rigid"):
    head = [f'title = "{title}"', f"gravity = {list(gravity)}", f"facets = {facets}", f'pressure = "{pressure}"']
    head += ["planar = true"] if planar else []
    head += ["\n[object]", f"mass = {mass}", shape]
    head += ["\n[gripper]", f'jaws = "{jaws}"'] if jaws else []
    return "\n".join(head) + "\n" + "\n".join(bodies) + "\n"


def fingertips(friction, force, shape="point", half=0.005, **keys):
    """Two opposed ones along z."""
    keys = dict(keys)
    return [body("finger", name, shape, [0, 0, -side], friction, center=[0, 0, side * half], grip_force=force, **keys)
            for name, side in (("left", 1), ("right", -1))]


def wall(friction, at=0.0, motion=(0.1, 0, 0), **keys):
    return body("pusher", "wall", "point", [1, 0, 0], friction, center=[-0.05, at, 0], acceleration=list(motion), **keys)


def slide(pick):
    tips = fingertips(number(pick.uniform(0.1, 1)), pick.choice([2, 5, 20]), "ring", radius=0.005, points=pick.choice([2, 3, 4]))
    edge = body("pusher", "wall", "line", [1, 0, 0], number(pick.uniform(0, 0.8)), points=2,
                ends=[[-0.05, -0.015, 0], [-0.05, 0.015, 0]], acceleration=[number(pick.uniform(0.01, 2)), 0, 0])
    angle = pick.choice([(0, -9.81, 0), (0, 0, -9.81), (-9.81, 0, 0), (6, -8, 0), (0, 0, 0)])
    return scene("Straight slide between fingertips", tips + [edge], gravity=angle)


def pivot(pick):
    tips = fingertips(number(pick.uniform(0.2, 1)), pick.choice([5, 20]), "ring", radius=number(pick.uniform(0.002, 0.008)),
                      points=pick.choice([3, 4]))
    edge = body("pusher", "edge", "point", [0, 1, 0], number(pick.uniform(0, 0.6)),
                center=[number(pick.uniform(0.01, 0.05)), -0.015, 0], acceleration=[0, number(pick.uniform(0.05, 1)), 0])
    return scene("Pivoting about the grip", tips + [edge], gravity=pick.choice([(0, 0, 0), (0, -9.81, 0)]))


def roll(pick):
    force, mu, sheet = number(pick.uniform(2, 12)), number(pick.uniform(0.1, 0.5)), number(pick.uniform(0.3, 1))
    bodies = [body("finger", name, "line", [s, 0, 0], mu, ends=[[-s * 0.02, 0, -0.02], [-s * 0.02, 0, 0.02]], points=2,
                   grip_force=force) for name, s in (("left", 1), ("right", -1))]
    bodies.append(body("pusher", "sheet", "line", [0, 1, 0], sheet, ends=[[0, -0.02, -0.02], [0, -0.02, 0.02]], points=2,
                       acceleration=[number(pick.choice([-1, 1]) * pick.uniform(0.05, 1)), 0, 0]))
    return scene("A cylinder on a sheet", bodies, mass=0.5, jaws="parallel",
                 shape='cylinder_radius = 0.02\ncylinder_length = 0.06\naxis = "z"')


def tip(pick):
    tips = fingertips(number(pick.uniform(0.3, 0.9)), pick.choice([3, 10]), "rectangle",
                      size=[number(pick.uniform(0.004, 0.01)), 0.006], points=[2, 2])
    high = body("pusher", "rod", "point", [0, 0, 1], 0.3, center=[number(pick.uniform(0.002, 0.04)), 0, -0.005],
                acceleration=[0, 0, number(pick.uniform(0.1, 2))])
    return scene("Tipping over a fingertip's edge", tips + [high])


def stop(pick, squeezed):
    tips = fingertips(number(pick.uniform(0.2, 0.8)), pick.choice([1, 5]), "ring", radius=0.004, points=2)
    mu = number(pick.uniform(0.1, 0.9))
    along = number(pick.uniform(0.2, 2)) if not squeezed else number(pick.uniform(0, 0.02))
    against = body("finger", "stop", "line", [-1, 0, 0], mu, ends=[[0.05, -0.01, 0], [0.05, 0.01, 0]], points=2)
    motion = [0.1, along, 0] if squeezed else [number(-pick.uniform(0.01, 1)), along, 0]
    return scene("Against a stop", tips + [against, wall(mu, motion=motion)])


def soft(pick):
    tips = fingertips(number(pick.uniform(0.2, 1)), pick.choice([5, 20]), torsion_radius=number(pick.uniform(0.001, 0.006)))
    return scene("Soft fingertips", tips + [wall(number(pick.uniform(0, 0.6)), number(pick.uniform(-0.01, 0.01)))])


def driven(pick):
    tips = fingertips(number(pick.uniform(0.2, 0.8)), 10, "ring", radius=0.005, points=2)
    keys = {"follow": "bilateral"} if pick.random() < 0.5 else {"normal_force": number(pick.uniform(1, 30))}
    motion = [0.2, number(pick.uniform(-0.5, 0.5)), 0] if "follow" in keys else [0, number(pick.uniform(-0.5, 0.5)), 0]
    return scene("A pusher that holds on, or presses", tips + [wall(number(pick.uniform(0.1, 0.6)), 0, motion, **keys)])


def scaled(pick):
    size, mass, force = 10.0 ** pick.randint(-4, 1), 10.0 ** pick.randint(-6, 4), 10.0 ** pick.randint(-3, 5)
    bodies = [body("finger", name, "ring", [0, 0, -s], 0.5, center=[0, 0, number(s * size / 20)], radius=number(size / 30),
                   points=2, grip_force=force) for name, s in (("left", 1), ("right", -1))]
    bodies.append(body("pusher", "wall", "point", [1, 0, 0], 0.3, center=[-number(size / 2), number(size / 25), 0],
                       acceleration=[10.0 ** pick.randint(-4, 3), 0, 0]))
    return scene("Grams and tonnes", bodies, mass=mass, shape=f"box = [{number(size)}, {number(size / 3)}, {number(size / 10)}]")


def margin(pick):
    """A wedge that jams where mu_table mu_thumb-like slopes reach one: a hair on either side of it."""
    beside = pick.choice([1e-2, 1e-4, 1e-6, 1e-9]) * pick.choice([-1, 1])
    slope = pick.choice([0.5, 0.75, 1.25])
    bodies = [body("finger", "table", "point", [0, 1, 0], repr(slope * (1 + beside)), center=[0, 0, 0]),
              body("pusher", "thumb", "point", [1, -slope ** -1, 0], 0, center=[0, 0, 0], acceleration=[1, 0, 0])]
    return scene(f"A wedge at {beside:g} of its limit", bodies, mass=1, planar=True, gravity=(0, -10, 0),
                 shape='cylinder_radius = 0.05\ncylinder_length = 0.016\naxis = "y"')


def bistable(pick):
    if pick.random() < 0.5:
        force = number(pick.uniform(8.2, 8.55))
        bodies = [body("finger", name, "point", [s, 0, 0], 0.3, center=[-s * 0.02, 0, 0], grip_force=force)
                  for name, s in (("left", 1), ("right", -1))]
        bodies.append(body("pusher", "sheet", "point", [0, 1, 0], 0.8, center=[0, -0.02, 0], acceleration=[0.1, 0, 0]))
        return scene("Rolling or held: two answers", bodies, mass=0.5, jaws="parallel", planar=True,
                     shape='cylinder_radius = 0.02\ncylinder_length = 0.06\naxis = "z"')
    mu = number(pick.uniform(0.1, 1))
    bodies = [body("finger", name, "point", [s, 0, 0], mu, center=[-s * 0.02, 0, 0]) for name, s in (("left", 1), ("right", -1))]
    return scene("A vise of two stops: held, or falling", bodies, shape="box = [0.04, 0.04, 0.04]", mass=number(pick.uniform(0.1, 2)),
                 planar=pick.random() < 0.5)


def degenerate(pick):
    """Ties everywhere: no weight, no grip, equal points twice."""
    mu = pick.choice([0, 0.5, 1])
    tips = [body("finger", name, "points", [0, 0, -s], mu, points=[[0, 0, s * 0.005]] * pick.choice([1, 2]) + [[0.004, 0, s * 0.005]],
                 grip_force=pick.choice([1, 4])) for name, s in (("left", 1), ("right", -1))]
    return scene("Ties", tips + [wall(mu, 0, pick.choice([[1, 0, 0], [0, 0, 0], [0, 1, 0], [-1, 0, 0]]))], mass=1,
                 gravity=pick.choice([(0, 0, 0), (0, -10, 0)]))


def stack(pick):
    """A block on the ground between walls, pushed or pressed: friction everywhere, no gripper."""
    mu = lambda: number(pick.uniform(0.05, 1.2))
    ground = [body("finger", f"foot{k}", "point", [0, 1, 0], mu(), center=[x, -0.02, z])
              for k, (x, z) in enumerate([(-0.04, -0.01), (0.04, -0.01), (0, 0.01)][:pick.choice([2, 3])])]
    if pick.random() < 0.5:
        ground.append(body("finger", "press", "point", [0, -1, 0], mu(), center=[number(pick.uniform(-0.03, 0.03)), 0.02, 0],
                           grip_force=number(pick.uniform(1, 50))))
    push = body("pusher", "ram", "point", [1, 0, 0], mu(), center=[-0.05, number(pick.uniform(-0.015, 0.015)), 0],
                acceleration=[number(pick.uniform(0.1, 3)), 0, 0])
    return scene("A block on the ground", ground + [push], shape="box = [0.1, 0.04, 0.04]", mass=number(pick.uniform(0.1, 5)))


def frictionless(pick):
    """Small enough for all cones to be tried."""
    bodies = [body("finger", f"f{k}", "point", n, 0, center=[-0.02 * n[0], -0.02 * n[1], 0],
                   **({"grip_force": pick.randint(1, 9)} if pick.random() < 0.6 else {}))
              for k, n in enumerate(pick.sample([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0.6, 0.8, 0], [-0.8, 0.6, 0]], 3))]
    bodies.append(body("pusher", "thumb", "point", [1, 0, 0], 0, center=[-0.02, 0, 0], acceleration=[1, 0, 0]))
    return scene("Without friction", bodies, mass=1, planar=True, shape="box = [0.04, 0.04, 0.04]", gravity=(0, -10, 0))


def smallest(pick):
    """One frictional point and a thumb: all cones are tried."""
    slope = pick.choice([-1, -0.5, 0, 0.5, 1])
    bodies = [body("finger", "table", "point", [0, 1, 0], number(pick.uniform(0.05, 2)), center=[0, 0, 0]),
              body("pusher", "thumb", "point", [1, slope, 0], 0, center=[0, 0, 0], acceleration=[1, number(pick.uniform(-1, 1)), 0])]
    return scene("A coin on a table", bodies, mass=number(pick.uniform(0.1, 3)), planar=True, gravity=(0, -10, 0),
                 shape='cylinder_radius = 0.05\ncylinder_length = 0.016\naxis = "y"')


FAMILIES = {
    "slide": (slide, 12, ["push"]), "pivot": (pivot, 12, ["push"]), "roll": (roll, 10, ["push"]), "tip": (tip, 10, ["push"]),
    "jam": (lambda pick: stop(pick, True), 14, ["jam"]), "stop": (lambda pick: stop(pick, False), 8, ["push"]),
    "soft": (soft, 8, ["push"]), "driven": (driven, 8, ["push"]), "scaled": (scaled, 16, ["badly scaled"]),
    "margin": (margin, 14, ["near-unsolvable"]), "bistable": (bistable, 10, ["bistable"]),
    "degenerate": (degenerate, 12, ["degenerate"]), "stack": (stack, 16, ["frictional stack"]),
    "frictionless": (frictionless, 10, ["push"]), "coin": (smallest, 12, ["push"])}


def scenes(family):
    """(name, text, tags) without end."""
    make, _, tags = FAMILIES[family]
    k = 0
    while True:
        yield f"{family}_{k:02}", make(random.Random(f"{family}:{k}")), tags
        k += 1
