"""The tables of docs/studies/replication.md: what is published, and what lcpush finds.

    python3 docs/studies/replicate.py [LCPUSH]           prints them; exit status 1 if a row does not agree
    python3 docs/studies/replicate.py [LCPUSH] --page    also writes them into the page
"""

import json
import math
import pathlib
import random
import subprocess
import sys

LCPUSH = next((word for word in sys.argv[1:] if word != "--page"), "lcpush")
STUDIES, SCENES = "docs/studies/", "fixtures/scenes/"
SIZE = "shape only: the paper prints no dimensions"
ROWS = []


def row(what, published, why, scene):
    """Makes a row of the table: of a function that answers (does it agree?, what lcpush finds)."""
    return lambda function: ROWS.append((what, published, function, why, scene)) or function


def ask(command, scene, *more):
    """The JSON that a command answers; exit status 1, a question without an answer, is an answer too."""
    done = subprocess.run([LCPUSH, command, scene, *more, "--json"], capture_output=True, text=True, check=False)
    assert done.returncode < 2, done.stderr
    return json.loads(done.stdout)


def put(**values):
    """--set for each name__key=value; `every` is *."""
    return [w for name, v in values.items() for w in ("--set", f"{name.replace('__', '.').replace('every', '*')}={v}")]


def near(a, b, relative=1e-6):
    return abs(a - b) <= relative * abs(b)


@row("[CR15] abstract, fig. 5", "line and planar pushers constrain the object", SIZE, "study 1")
def constraining():
    def width(scene):
        sweep = ask("sweep", STUDIES + scene, "--vary", "wall.shift[1]=-0.02:0.02", "--steps", "41")
        [straight] = [zero for zero in sweep["zeros"] if zero["of"] == "twist[5]"]
        return 1e3 * (straight["to"] - straight["from"])
    point, line, plane = (width(name) for name in ("point.toml", "line.toml", "plane.toml"))
    return (point < 1e-6 and near(line, 20, 1e-4) and near(plane, 10, 1e-4),
            f"straight at one height by a point, over {line:.2f} mm by an edge of 20, over {plane:.2f} mm by a plate of 10")


@row("[CR15] abstract, fig. 6", "the force that breaks the grasp's equilibrium, over the grip force", SIZE, "study 2")
def grip_force():
    pieces = ask("sweep", STUDIES + "grip_force.toml", "--vary", "*.grip_force=4:20")["segments"]
    slopes = [(p["break_force"][1] - p["break_force"][0]) / (p["to"] - p["from"]) for p in pieces]
    return (min(slopes) > 0 and near(slopes[-1], 1),
            f"straight lines that rise; from {pieces[-1]['from']:.3f} N on it is {slopes[-1]:.3f} = 2 mu times the grip")


@row("[CR15] figs. 7, 8", "from 10 to 70 mm 3.82 to 0.87 N and 1.73 to 0.51 mm/rad in one run", SIZE, "study 8, round")
def turning_pusher():
    sweep = ask("sweep", SCENES + "rotating_pusher.toml", "--vary", "edge.shift[0]=-0.03:0.03", "--steps", "7")
    points = [point for point in sweep["points"] if not point["refined"]]
    force, slip = zip(*((p["break_force"], 1e3 * math.hypot(*p["break_twist"][:2]) / p["break_twist"][5]) for p in points))
    falls = all(a > b for curve in (force, slip) for a, b in zip(curve, curve[1:]))
    return falls, f"both fall at each step: {force[0]:.2f} to {force[-1]:.2f} N, {slip[0]:.2f} to {slip[-1]:.2f} mm/rad"


@row("[CR15] abstract", "the pusher's motion guides the object's", SIZE, "study 4, round")
def guiding():
    scene = STUDIES + "guided_slide.toml"
    first = ask("cone", scene, "--facets", "round", "--vary", "wall.acceleration[1]=0:0.06")["ranges"][0]
    widest = math.degrees(math.atan2(first["to"], 0.1))
    turned = ask("solve", scene, "--pressure", "rigid", *put(wall__angular_acceleration="[0,0,2]"))["object"]
    return (first["sticks"] and near(widest, math.degrees(math.atan(0.3))) and near(turned["acceleration"][5], 2),
            f"follows up to {widest:.3f} degrees, arctan of the wall's friction; turns as the wall turns")


@row("[CR15] abstract", "straight sliding, pivoting, rolling", "in time; the paper has instants", "[motions](motion.md)")
def primitives():
    def phase(scene, *more):
        [only] = ask("move", SCENES + scene, *more, "--step", "0.002", "--frames", "2")["phases"]
        return only["motion"], 1e3 * only["way"], math.degrees(only["angle"])
    (slides, way, turn), (pivots, _, pivot), (rolls, _, roll) = (
        phase("straight_slide.toml", "--stop-after", "0.03"), phase("rotating_pusher.toml", "--time", "1.26"),
        phase("rolling.toml", "--time", "1.58533"))
    named = (slides, pivots, rolls) == ("slide", "pivot", "roll")
    return (named and near(way, 30) and turn < 1e-6 and near(roll, 360, 1e-3),
            f"slides {way:.1f} mm without a turn; pivots {pivot:.1f} degrees; rolls {roll:.1f} on the spot")


# The public code's numbers: 0.5 kg, 50 N, friction 0.8, torsion radius 6 mm, a wall of 60 mm that is 30 mm below.
LIMIT, WEIGHT, RADIUS, HALF, MU = 0.8 * 50, 0.5 * 9.81, 0.006, 0.03, 0.8


def edges(moment=lambda fx, fy: 0, s=0.0):
    """(N, mm a radian along x and along the push) of the grip at the cone's edges, moments about the axis into the page:
    [1 s; -s 1] f = k w + (0, weight) and moment(f) + m = k turn, on the ellipsoid |f|^2 + (m / r)^2 = LIMIT^2."""
    for x in (-HALF, HALF):
        for side in (-MU, MU):
            wx, wy = side / math.hypot(1, MU), 1 / math.hypot(1, MU)
            parts = []  # times k, and without k
            for a, b, m in ((wx, wy, -HALF * wx - x * wy), (0, WEIGHT, 0)):
                fx, fy = (a - s * b) / (1 + s * s), (s * a + b) / (1 + s * s)
                parts.append((fx, fy, (m - moment(fx, fy)) / RADIUS))
            aa, ab, bb = (sum(map(lambda p, q: p * q, parts[i], parts[j])) for i, j in ((0, 0), (0, 1), (1, 1)))
            k = (-ab + math.sqrt(ab * ab - aa * (bb - LIMIT**2))) / aa
            vx, vy, turn = (k * p + q for p, q in zip(*parts))
            yield k, 1e3 * RADIUS * vx / turn, 1e3 * RADIUS * vy / turn


def edges_found(x=0.0, y=0.0):
    """The same by lcpush, of a plate that is gripped at (x, y), in m."""
    for edge in ask("cone", STUDIES + "cone.toml", *put(left__center=[x, y], right__center=[x, y]))["edges"]:
        vx, vy, turn = (edge["twist"][k] for k in (0, 1, 5))  # of the middle; the grip is beside it
        yield math.hypot(*edge["wrench"][:3]), -1e3 * (vx / turn - y), -1e3 * (vy / turn + x)


def same(found, closed):
    """Each edge found is one of the closed form, and each of those is found."""
    return all(any(all(map(near, a, b)) for b in others)
               for ones, others in ((found, closed), (closed, found)) for a in ones)


@row("[CHR18] equations", "with the [public code]'s numbers 29.000, 5.5169 N; (4.80, 7.30), (-0.53, 1.43) mm/rad",
     "nothing", "[cone.toml](cone.toml)")
def cone_edges():
    found = list(edges_found())
    weak, strong = sorted(edge for edge in found if edge[2] > 0)
    told = "{:.3f}, {:.4f} N; ({:.2f}, {:.2f}), ({:.2f}, {:.2f}) mm/rad"
    return same(found, list(edges())), told.format(strong[0], weak[0], *strong[1:], *weak[1:])


@row("[CHR18] fig. 4", "with grip enough, what sticks without weight sticks with it", "nothing", "cone.toml, 30 degrees off")
def least_grip():
    slide = math.radians(30)
    needed = WEIGHT / (2 * (MU * math.cos(slide) - math.sin(slide)))
    weak = ask("cone", STUDIES + "cone.toml", "--twist", f"{math.sin(slide)} {math.cos(slide)} 0", *put(every__grip_force=8))
    return (not weak["sticks"] and near(weak["smallest_grip"], needed),
            f"slips at 8 N a finger, sticks from {weak['smallest_grip']:.3f} N on")


@row("[CHR18] fig. 8", "2,000 measured pushes verify which stick and which slip", "here by `break`, which knows no cone",
     "cone.toml; 2,000 by `ctest -R cone_pushes`")
def pushes(count=100):
    draw, agree, judged = random.Random(2018), 0, 0
    while judged < count:
        v = draw.uniform(-0.01, 0.01), draw.uniform(0.002, 0.01), draw.uniform(-0.3, 0.3)
        cone = ask("cone", STUDIES + "cone.toml", "--twist", "{} {} {}".format(*v))
        if abs(cone["margin"]) < 0.01 or cone["leaves"]:
            continue
        turned = put(wall__velocity=[*v[:2], 0], wall__angular_velocity=[0, 0, v[2]])
        u = ask("break", STUDIES + "cone.toml", *turned)["twist"]
        off = math.hypot(u[0] * v[1] - u[1] * v[0], HALF * (u[5] * v[1] - u[1] * v[2])) / (abs(v[1]) * math.hypot(*u))
        judged, agree = judged + 1, agree + ((off < 1e-5) is cone["sticks"])
    return agree == count, f"{agree} of {count} stick or slip as the cone says"


@row("[CHR18] VII", "pushed across its weight an object slides down; rubber on the pushers makes them stick",
     "no number at hand", "soft_square.toml, 10 N a finger")
def rubber():
    ranges = ask("cone", STUDIES + "soft_square.toml", "--pusher", "east", *put(every__grip_force=10),
                 "--vary", "east.friction=0.2:0.9")["ranges"]
    down = ranges[0]["at_from"]["twist"][1]
    return (down < -0.01 and ranges[-1]["sticks"] and near(ranges[-1]["from"], WEIGHT / (2 * 0.9 * 10), 1e-4),
            f"friction 0.2: down {-100 * down:.1f} mm on 100; from {ranges[-1]['from']:.4f} = m g / (2 mu F) on it sticks")


def plan(scene, grip, end, turn, *side):
    """A plan that takes the grip from one place on the object to another, as the object turns."""
    c, s = math.cos(turn), math.sin(turn)
    to = f"{grip[0] - c * end[0] + s * end[1]} {grip[1] - s * end[0] - c * end[1]} {turn}"
    left, right = ([*grip, *side], [*grip, *(-z for z in side)])
    return ask("plan", STUDIES + scene, *put(left__center=left, right__center=right), "--to", to)


def goals():
    draw = random.Random(2018)
    for _ in range(50):
        start = draw.uniform(0, 0.03), draw.uniform(-0.005, 0.005), draw.uniform(-0.2, 0.2)
        end = draw.uniform(-0.045, -0.025), draw.uniform(-0.04, 0.02), draw.uniform(-0.2, 0.2)
        yield start[:2], end[:2], end[2] - start[2]


def told(found, plans):
    each, worst = sum(len(p["pushes"]) for p in plans) / 50, 1e3 * max(p["replay"]["position_error"] for p in plans)
    return found == 50, f"{found} of 50 found, {each:.2f} pushes each; replays end within {worst:.2f} mm"


@row("[public code]", "50 plans between places drawn from given ranges", "not its places: it draws them anew each time",
     "[soft_square.toml](soft_square.toml)")
def square_set():  # at the places opposite: the walls are those of study 11
    plans = [plan("soft_square.toml", [-v for v in start], [-v for v in end], turn) for start, end, turn in goals()]
    return told(sum(p["found"] for p in plans), plans)


def stays_on_the_t(grip, leg):
    """Is the grip on the T along a plan's pushes? Arcs are near enough to their chords."""
    def on(px, py, a):
        x, y = (math.cos(a + b) * (grip[0] - px) + math.sin(a + b) * (grip[1] - py) for b in (0, math.pi / 2))
        return -0.0356 <= x <= -0.0056 and abs(y) <= 0.05 or -0.0056 <= x <= 0.0644 and abs(y) <= 0.015
    return all(on(*(p + k / 50 * (q - p) for p, q in zip(push["from"], push["to"])))
               for push in leg["pushes"] for k in range(51))


@row("[CHR18] VII", "a T-shaped object is regrasped", "not its poses: those 50, from the stem by way of the bar's middle",
     "[t_shape.toml](t_shape.toml)")
def t_set(shift=0.0144):  # m, of the T's frame from its centre of mass
    found, plans = 0, []
    for start, end, turn in goals():
        places = [(x + shift, y) for x, y in (start, (-0.035, 0), end)]
        legs = [plan("t_shape.toml", a, b, angle, 0.005) for a, b, angle in zip(places, places[1:], (turn, 0))]
        found += all(leg["found"] and stays_on_the_t(grip, leg) for leg, grip in zip(legs, places))
        plans += legs
    return told(found, plans)


def faults():
    """(fault, where, with it, without it, lcpush) of the public code's two."""
    x, y = 0.012, -0.007  # m
    yield "cosine", "in its middle", edges(s=math.cos(0)), edges(), edges_found()
    yield ("dot product", "at (12, -7) mm, 14 mm off", edges(lambda fx, fy: x * fx + y * fy),
           edges(lambda fx, fy: y * fx - x * fy), edges_found(x, y))


def main():
    said = {True: "yes", False: "**no**"}
    table = [("source", "published", "here", "agrees", "what differs", "made with")]
    for what, published, function, why, scene in ROWS:
        agrees, ours = function()
        table.append((what, published, ours, said[agrees], why, scene))
    warning = [("fault", "the plate is gripped", "with it, N", "without it, N", "`lcpush cone`, N", "agrees")]
    for fault, where, *forms in faults():
        wrong, right, found = map(list, forms)
        found = [min(found, key=lambda edge: math.dist(edge, other)) for other in right]
        forces = (", ".join(f"{edge[0]:.3f}" for edge in form) for form in (wrong, right, found))
        warning.append((fault, where, *forces, said[same(found, right)]))
    page = pathlib.Path(STUDIES + "replication.md")
    for name, (head, *lines) in (("table", table), ("faults", warning)):
        made = "".join("| " + " | ".join(line) + " |\n" for line in (head, ["---"] * len(head), *lines))
        print(made)
        if "--page" in sys.argv:
            begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
            before, rest = page.read_text(encoding="utf-8").split(begin)
            page.write_text(before + begin + made + end + rest.split(end)[1], encoding="utf-8")
    return int(any("**no**" in line for line in table + warning))


if __name__ == "__main__":
    sys.exit(main())
