"""Plans for twenty goals: what the walls' friction and the weight do to them.

    python3 docs/studies/plans.py [LCPUSH]
"""

import json
import random
import statistics
import subprocess
import sys

LCPUSH = sys.argv[1] if len(sys.argv) > 1 else "lcpush"
HEAD, *PUSHERS = open("docs/guide/square.toml", encoding="utf-8").read().split("\n[[pusher]]")


def scene(grip, friction, gravity):
    head = f"gravity = [0, {-gravity}, 0]\n" + HEAD
    for face in ("+z", "-z"):
        head = head.replace(f'on = "{face}"', f'on = "{face}"\ncenter = [{-grip[0]}, {-grip[1]}]')
    return "\n[[pusher]]".join([head] + [p.replace("0.9", str(friction)) for p in PUSHERS])


def goals(count):
    draw = random.Random(2020)
    for _ in range(count):
        start = draw.uniform(0, 0.03), draw.uniform(-0.005, 0.005)
        end = draw.uniform(-0.045, -0.025), draw.uniform(-0.04, 0.02)
        yield start, (end[0] - start[0], end[1] - start[1], draw.uniform(-0.2, 0.2))


def plans(friction, gravity):
    for start, to in goals(20):
        text = scene(start, friction, gravity)
        yield json.loads(subprocess.run(
            [LCPUSH, "plan", "-", "--to", "{} {} {}".format(*to), "--json"], input=text,
            capture_output=True, text=True, check=False).stdout)


def main():
    print("friction  weight N  held  solved  pushes a plan  takes grip N  way mm  replay mm")
    for friction, g in ((0.9, 0), (0.9, 9.81), (0.9, 39.24), (0.6, 0), (0.6, 9.81)):
        answers = list(plans(friction, g))
        held = [p for p in answers if p["holds_start"] and p["holds_goal"]]
        found = [p for p in held if p["found"]]
        pushes = [push for p in found for push in p["pushes"]]
        print(f"{friction:8}{0.5 * g:10.2f}{len(held):6}{len(found):8}{len(pushes) / len(found):15.2f}"
              f"{max(push['grip'] for push in pushes):14.2f}"
              f"{1e3 * statistics.mean(p['cost'] for p in found):8.1f}"
              f"{1e3 * max(p['replay']['position_error'] for p in found):11.3f}", flush=True)


main()
