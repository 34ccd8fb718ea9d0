"""A normal that is a rounding error off its axis turns no pyramid: one answer for everyone.

    test_rounded_normals.py TOOL ROOT [FIRST LAST]      seeds

Of random scenes and of the shipped ones every zero of every normal becomes 1e-17 or so. What moves and
what pushes stays, to 1e-5 (as `unique` is meant), but where the answer says that it is one of several.
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
FIRST, LAST = (int(word) for word in sys.argv[3:5]) if len(sys.argv) > 4 else (0, 150)
PATH = pathlib.Path(tempfile.mkdtemp()) / "scene.toml"
sys.path.insert(0, str(ROOT / "tests/support"))
from random_scenes import random_scene


def solved(text):
    PATH.write_text(text)
    answer = json.loads(subprocess.run([TOOL, "solve", PATH, "--json"], capture_output=True, text=True).stdout)
    if answer["status"] != "solved":
        return answer["status"], None, None, None
    pushes = [sum(x * x for x in body["force"]) ** .5 for body in answer["bodies"] if body["role"] == "pusher"]
    return "solved", answer["object"]["acceleration"], pushes, answer["unique"]


def rounded(pick, text):
    def off(match):
        numbers = [x.strip() for x in match[1].split(",")]
        return "normal = [" + ", ".join(repr(pick.choice([1, -1]) * pick.uniform(.1, 1) * 1e-16)
                                        if float(x) == 0 else x for x in numbers) + "]"
    return re.sub(r"(?m)^normal = \[(.*?)\]", off, text)


def apart(a, b):
    return max((abs(x - y) for x, y in zip(a, b)), default=0) / max([1e-3, *map(abs, a), *map(abs, b)])


def main():
    faults, compared, turned = [], 0, 0
    scenes = [(f"seed {seed}", random_scene(seed)) for seed in range(FIRST, LAST)]
    scenes += [(path.stem, path.read_text()) for path in sorted((ROOT / "fixtures/scenes").glob("*.toml"))]
    for name, text in scenes:
        pick = random.Random(name)
        status, motion, pushes, unique = solved(text)
        said, moved, pushed, also = solved(rounded(pick, text))
        if status != said:
            faults.append(f"{name}: {status}, and {said} with rounded normals")
            continue
        if status != "solved":
            continue
        turned += rounded(pick, text) != text
        if unique["motion"] is not False and also["motion"] is not False:
            compared += 1
            if apart(motion, moved) > 1e-5:
                faults.append(f"{name}: the motion differs by {apart(motion, moved):.1e}")
        if unique["wrench"] is not False and also["wrench"] is not False and apart(pushes, pushed) > 1e-5:
            faults.append(f"{name}: the push differs by {apart(pushes, pushed):.1e}")
    print(f"{len(scenes)} scenes, {compared} motions compared, {turned} with rounded normals", *faults, sep="\n")
    return 1 if faults or compared < len(scenes) / 3 else 0


if __name__ == "__main__":
    sys.exit(main())
