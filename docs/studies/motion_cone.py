"""The edges of a motion cone, and how it changes with gravity and the grip.

    python3 docs/studies/motion_cone.py [LCPUSH]
"""

import json
import math
import subprocess
import sys

LCPUSH = sys.argv[1] if len(sys.argv) > 1 else "lcpush"
SCENE = open("docs/studies/cone.toml", encoding="utf-8").read()
L = 0.006  # m: turns count at the radius of the fingertips


def cone(*changes):
    text = SCENE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return json.loads(subprocess.run([LCPUSH, "cone", "-", "--json"], input=text, check=True,
                                     capture_output=True, text=True).stdout)


def directions(answer):
    for side in answer["sides"]:
        for vx, vy, _, _, _, wz in side["twists"]:
            size = math.hypot(vx, vy, L * wz)
            yield vx / size, vy / size, L * wz / size


def sideways(answer):
    """The widest angle to the push's normal of a motion with no more turn than 5 % of it."""
    slides = [math.atan2(abs(x), y) for x, y, w in directions(answer) if abs(w) < 0.05]
    return math.degrees(max(slides)) if slides else 0


def main():
    print("Edges: N of push, mm a radian")
    for edge in cone()["edges"]:
        vx, vy, wz = (edge["twist"][k] for k in (0, 1, 5))
        print(f"{math.hypot(*edge['wrench'][:3]):8.3f} N  ({1e3 * vx / wz:6.2f}, {1e3 * vy / wz:6.2f})")
    print("\nWidest slide from the normal, without turning, in degrees")
    print("grip N   weight along the push   none   against it")
    for grip in (8, 12, 25, 50, 100):
        row = [sideways(cone(("grip_force = 25", f"grip_force = {grip}"),
                             ("[0, 9.81, 0]", f"[0, {g}, 0]"))) for g in (9.81, 0, -9.81)]
        print(f"{grip:6}   {row[0]:21.2f}   {row[1]:4.2f}   {row[2]:10.2f}")


main()
