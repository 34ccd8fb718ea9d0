"""How often the paper's program ends in a false minimum: random grasps, three ways to search.

    random_grasps.py TOOL PYTHON_WITH_SCIPY OCTAVE COUNT

Not a test of the optimisers, which may fail; but of the scripts, which must know: exit status 1 if one
calls an answer what the judge refuses, or the other way round.
"""
import collections
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from judge import Judge, lcpush  # noqa: E402

TOOL, PYTHON, OCTAVE, COUNT = sys.argv[1], sys.argv[2], sys.argv[3], int(sys.argv[4])
LARGEST_FOR_SLSQP = 160  # unknowns; beyond, it takes minutes


def grasp(seed):
    """Two fingers of 1 to 5 points, a wall with two, any weight; as a scene file."""
    draw = random.Random(seed)
    uniform = draw.uniform
    points = draw.choice([1, 1, 2, 4, 5])
    text = f"facets = {draw.choice([4, 8, 8, 16])}\n"
    text += f"gravity = {[round(uniform(-7, 7), 3) for _ in range(3)]}\n"
    text += f"[object]\nmass = {round(uniform(0.05, 1), 3)}\nbox = [0.1, 0.04, 0.01]\n"
    force = round(uniform(5, 30), 2)
    for name, z, direction in (("left", 0.005, -1), ("right", -0.005, 1)):
        patch = [[round(uniform(-0.01, 0.01), 4), round(uniform(-0.01, 0.01), 4), z]
                 for _ in range(points)]
        text += (f'[[finger]]\nname = "{name}"\nshape = "points"\npoints = {patch}\n'
                 f"normal = [0, 0, {direction}]\nfriction = {round(uniform(0.1, 1.2), 3)}\n"
                 f"grip_force = {force}\n")
    half = round(uniform(0.001, 0.019), 4)
    motion = [round(uniform(0.01, 2), 3), round(uniform(-1, 1), 3), 0]
    return text + (f'[[pusher]]\nname = "wall"\nshape = "line"\n'
                   f"ends = [[-0.05, {-half}, 0], [-0.05, {half}, 0]]\nnormal = [1, 0, 0]\n"
                   f"friction = {round(uniform(0.1, 1.2), 3)}\nacceleration = {motion}\n")


def searches(folder, unknowns):
    if unknowns <= LARGEST_FOR_SLSQP:
        yield "SLSQP", [PYTHON, folder / "solve_push.py"]
    yield "SciPy's linear programs", [PYTHON, folder / "solve_push.py", "steps"]
    yield "Octave", [OCTAVE, "--quiet", "--no-gui", "--path", folder, "--eval", "solve_push"]


def main():
    tally, wrong = collections.defaultdict(collections.Counter), []
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    with tempfile.TemporaryDirectory() as temporary:
        for seed in range(1, COUNT + 1):
            scene, folder = pathlib.Path(temporary, "scene.toml"), pathlib.Path(temporary, "out")
            scene.write_text(grasp(seed))
            status = json.loads(lcpush(TOOL, "solve", scene, "--json"))["status"]
            tally["lcpush"][status] += 1
            lcpush(TOOL, "export", scene, "-o", folder)
            judge = Judge(TOOL, scene)
            names = json.loads((folder / "names.json").read_text())
            for search, command in searches(folder, len(names["unknowns"])):
                result = subprocess.run(list(map(str, command)), capture_output=True, text=True,
                                        env=environment, timeout=600)
                starts = result.stdout.count("\nstart ")
                answer = json.loads((folder / "answer.json").read_text())
                solved = result.returncode == 0
                if solved != (not judge.complaints(answer)):
                    wrong.append((seed, search, solved, judge.complaints(answer)))
                count = tally[search]
                count["grasps"] += 1
                count["answers at the first start"] += solved and starts == 1
                count["answers within twelve"] += solved
    for search, count in tally.items():
        print(f"{search}: " + ", ".join(f"{n} {what}" for what, n in count.items()))
    if wrong:
        sys.exit(f"script and judge differ: {wrong}")


main()
