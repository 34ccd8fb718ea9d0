"""Names for the same: order and solver do not change a motion that is not reported as open.

    test_same_push.py TOOL ROOT [FIRST LAST]      seeds

Of random grasps the fingers, the points of every patch and the pusher's come in another order; and
every solver is asked, the path of a sweep among them. Where `unique` does not say that the motion is open, it is the same, to 1e-5 of
what the push moves.
"""
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

TOOL = sys.argv[1]
FIRST, LAST = (int(word) for word in sys.argv[3:5]) if len(sys.argv) > 4 else (0, 60)
PATH = pathlib.Path(tempfile.mkdtemp()) / "scene.toml"


def grasp(seed):
    """(head, fingers, pusher): a body is (lines, points)."""
    pick = random.Random(seed)
    is_plain = seed % 3 == 0  # normal forces are known, and the motion proved unique
    jaws = "independent" if is_plain else pick.choice(["parallel", "independent", "locked"])
    force = round(pick.uniform(1, 30), 2)
    down = pick.choice([[0, -9.81, 0], [0, 0, -9.81], [-5, 2, 8]])
    head = (f"gravity = {down}\nfacets = {pick.choice([4, 8, 12])}\n[object]\nmass = {round(pick.uniform(.05, 1), 3)}\n"
            f"box = [0.1, 0.03, 0.01]\n[gripper]\njaws = \"{jaws}\"\n")
    place = lambda: round(pick.uniform(-.008, .008), 5)
    bodies = []
    for name, side in (("left", 1), ("right", -1)):
        points = [[place(), place(), side * .005] for _ in range(1 if is_plain else pick.randint(1, 6))]
        bodies.append((f"[[finger]]\nname = \"{name}\"\nnormal = [0, 0, {-side}]\ngrip_force = {force}\n"
                       f"friction = {round(pick.uniform(.1, 1.1), 3)}\n", points))
    points = [[-.05, round(pick.uniform(-.015, .015), 5), place()] for _ in range(pick.randint(1, 3))]
    angle = pick.uniform(-.7, .7)
    pusher = (f"[[pusher]]\nname = \"wall\"\nnormal = [1, 0, 0]\nfriction = {0 if is_plain else round(pick.uniform(0, .8), 3)}\n"
              f"acceleration = [{round(math.cos(angle), 6)}, {round(math.sin(angle), 6)}, 0]\n", points)
    return head, bodies, pusher


def written(head, fingers, pusher):
    return head + "".join(f"{lines}shape = \"points\"\npoints = {points}\n" for lines, points in [*fingers, pusher])


def reordered(pick, bodies):
    bodies = [(lines, pick.sample(points, len(points))) for lines, points in bodies]
    return pick.sample(bodies, len(bodies))


def solved(text, *words):
    PATH.write_text(text)
    result = subprocess.run([TOOL, "solve", PATH, "--json", *words], capture_output=True, text=True)
    answer = json.loads(result.stdout)
    if answer["status"] != "solved":
        return answer["status"], answer["existence"], None
    twist = answer["object"]["acceleration"]
    return "solved", [*twist[:3], *(.05 * x for x in twist[3:])], answer["unique"]


def swept(text, mass):
    """The same at the end of a sweep, each step from its neighbour's answer."""
    PATH.write_text(text)
    result = subprocess.run([TOOL, "sweep", PATH, "--vary", f"object.mass={mass / 2}:{mass}", "--steps", "3", "--json"],
                            capture_output=True, text=True)
    last = json.loads(result.stdout)["points"][-1]
    if last["status"] != "solved":
        return last["status"], None, None
    return "solved", [*last["twist"][:3], *(.05 * x for x in last["twist"][3:])], {"motion": True}


def main():
    faults, compared, solvers = [], 0, 0
    for seed in range(FIRST, LAST):
        pick, (head, fingers, pusher) = random.Random(f"order {seed}"), grasp(seed)
        status, motion, unique = solved(written(head, fingers, pusher))
        if status != "solved":
            if motion["covered"]:
                faults.append(f"seed {seed}: {status}")
            continue
        if unique["motion"] is False:
            continue
        near = 1e-5 * max(1, math.hypot(*motion))
        other = solved(written(head, reordered(pick, fingers), reordered(pick, [pusher])[0]))
        asked = [("another order", other)]
        if unique["motion"] is True:
            asked += [(name, solved(written(head, fingers, pusher), "--solver", name)) for name in ("gauss-seidel", "hybrid")]
            asked.append(("path", swept(written(head, fingers, pusher), float(re.search(r"mass = (\S+)", head)[1]))))
        for what, (said, moved, still) in asked:
            if said != "solved":
                if what != "gauss-seidel":  # which may stagnate, and says so
                    faults.append(f"seed {seed}: {what}: {said}")
                continue
            compared, solvers = compared + 1, solvers + (what != "another order")
            off = math.dist(moved, motion)
            if off > near and still["motion"] is not False:
                faults.append(f"seed {seed}: {what} moves it otherwise by {off:.1e}, unique: {unique['motion']}")
    print(f"{LAST - FIRST} grasps, {compared} comparisons, {solvers} of them of solvers", *faults, sep="\n")
    return 1 if faults or compared < (LAST - FIRST) / 3 else 0


if __name__ == "__main__":
    sys.exit(main())
