"""Wide discs under `pad`: where an answer is promised there is one, and not after minutes.

    wide_discs.py TOOL ROOT [FIRST LAST [COMMAND [OPTION ...]]]      seeds; solve, or break

Two discs of 40 to 320 points at 8 facets hold a box that a line pushes: upright, along, across, off the
middle, tipping, with and without a turn, by jaws of every kind. docs/theory/numerics.md says what loses them.
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "tests/support"))
from processor_time import processor_time

FIRST, LAST = (int(word) for word in sys.argv[3:5]) if len(sys.argv) > 4 else (0, 60)
ASK = sys.argv[5:] or ["solve"]
PATH = pathlib.Path(tempfile.mkdtemp()) / "scene.toml"


def discs(seed):
    pick = random.Random(seed)
    k = pick.choice([40, 64, 80, 120, 160, 240, 320])
    x, y, radius = pick.uniform(-.01, .01), pick.uniform(-.005, .005), pick.uniform(.003, .008)
    force, mu = pick.uniform(1, 60), pick.uniform(.15, 1.1)
    text = (f"pressure = \"pad\"\nfacets = 8\ngravity = {[round(9.81 * pick.choice([0, -1, 1, .6]), 3) for _ in range(3)]}\n"
            f"[object]\nmass = {pick.uniform(.02, 1):.4g}\nbox = [0.1, 0.03, 0.01]\n"
            f"[gripper]\njaws = \"{pick.choice(['parallel', 'independent'])}\"\n")
    for name, side in (("left", 1), ("right", -1)):
        text += (f"[[finger]]\nname = \"{name}\"\nshape = \"disc\"\npoints = {k}\nradius = {radius:.5g}\n"
                 f"center = [{x:.5g}, {y:.5g}, {side * .005}]\nnormal = [0, 0, {-side}]\nfriction = {mu:.4g}\n"
                 f"grip_force = {force:.5g}\n")
    reach, height = pick.uniform(.002, .014), pick.choice([0, .002, .004, -.004])
    turn = [round(pick.choice([0, 0, pick.uniform(-4, 4)]), 3) for _ in range(3)]
    return k, text + (f"[[pusher]]\nname = \"wall\"\nshape = \"line\"\nends = [[-0.05, {-reach:.5g}, {height}], "
                      f"[-0.05, {reach:.5g}, {height}]]\nnormal = [1, 0, 0]\nfriction = {pick.uniform(0, .8):.4g}\n"
                      f"acceleration = [{pick.uniform(.05, 3):.4g}, {pick.choice([0, pick.uniform(-1, 1)]):.4g}, "
                      f"{pick.choice([0, 0, pick.uniform(-1, 1)]):.4g}]\nangular_acceleration = {turn}\n")


def fault(answer):
    if answer is None:
        return "stopped"
    if answer["status"] == "solved" or ASK[0] == "break" and answer["status"] == "does_not_hold":
        return None
    promised = ASK[0] == "break" or answer["existence"]["covered"]  # every grasp breaks or does not hold
    return f"{answer['status']}, though an answer is promised" if promised else None


def main():
    faults, statuses, slowest = [], {}, (0, None)
    for seed in range(FIRST, LAST):
        points, text = discs(seed)
        PATH.write_text(text)
        before = processor_time()
        done = subprocess.run([TOOL, ASK[0], PATH, "--json", *ASK[1:]], capture_output=True, text=True)
        slowest = max(slowest, (processor_time() - before, seed))
        answer = json.loads(done.stdout) if done.stdout else None
        status = answer["status"] if answer else "stopped"
        statuses[status] = statuses.get(status, 0) + 1
        if fault(answer):
            faults.append(f"seed {seed}, {points} points: {fault(answer)}")
    print(f"{LAST - FIRST} scenes: {statuses}; slowest {slowest[0]:.1f} s (seed {slowest[1]})", *faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
