"""The scripts of `lcpush export`, run: SciPy and GNU Octave solve every fixture the paper's way.

    test_export_scripts.py TOOL SOURCE PYTHON_WITH_SCIPY OCTAVE

The judge of their answers shares nothing with the exported program.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from judge import Judge, lcpush  # noqa: E402

TOOL, SOURCE, PYTHON, OCTAVE = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
INFEASIBLE = {"jam"}  # its linear constraints alone have no solution
STUCK = {("planar_pusher", "Octave")}  # its linear programs end off their constraints, and it says so


def runs(folder):
    yield "SLSQP", [PYTHON, folder / "solve_push.py"]
    yield "SciPy's linear programs", [PYTHON, folder / "solve_push.py", "steps"]
    yield "Octave", [OCTAVE, "--quiet", "--no-gui", "--path", folder, "--eval", "solve_push"]


def run(command):
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, env=environment,
                          timeout=600)


def check_a_solver_that_gives_up(temporary):
    """One step from one start is not enough: the script must say so, and the judge too."""
    scene = SOURCE / "fixtures/scenes/straight_slide_point.toml"
    lcpush(TOOL, "export", scene, "-o", temporary)
    script = pathlib.Path(temporary, "solve_push.py")
    text = script.read_text()
    lazy = text.replace("STARTS, SEED = 12, 1", "STARTS, SEED = 1, 1").replace('"maxiter": 300',
                                                                              '"maxiter": 1')
    assert lazy.count('"maxiter": 1}') + lazy.count('"maxiter": 1,') == 1 and "= 1, 1" in lazy
    script.write_text(lazy)
    result = run([PYTHON, script])
    answer = json.loads(pathlib.Path(temporary, "answer.json").read_text())
    assert result.returncode == 1 and "This is NOT a solution" in result.stdout, result
    assert answer["status"] == "stagnated" and answer["objective"] > 1e-6, answer
    assert Judge(TOOL, scene).complaints(answer)


def main():
    failures, tampered = [], 0
    with tempfile.TemporaryDirectory() as temporary:
        check_a_solver_that_gives_up(temporary)
    with tempfile.TemporaryDirectory() as temporary:
        for scene in sorted((SOURCE / "fixtures/scenes").glob("*.toml")):
            folder = pathlib.Path(temporary, scene.stem)
            lcpush(TOOL, "export", scene, "-o", folder)
            judge = Judge(TOOL, scene)
            for solver, command in runs(folder):
                result = run(command)
                starts = result.stdout.count("\nstart ")
                path = folder / "answer.json"
                if scene.stem in INFEASIBLE:
                    right = (result.returncode == 1 and "No x meets" in result.stdout and
                             not path.exists())
                    print(f"{scene.stem}, {solver}: {'no feasible point' if right else 'FAILED'}")
                elif (scene.stem, solver) in STUCK:
                    answer = json.loads(path.read_text())
                    right = (result.returncode == 1 and "NOT a solution" in result.stdout and
                             answer["status"] == "stagnated" and judge.complaints(answer) and
                             run([TOOL, "verify", scene, path]).returncode == 1)
                    tampered += 1 if right else 0
                    path.unlink()
                    print(f"{scene.stem}, {solver}: {'no answer, and says so' if right else 'FAILED'}")
                else:
                    right = result.returncode == 0 and path.exists()
                    complaints = {"script": result.stdout[-300:] + result.stderr[-300:]}
                    if right:
                        answer = json.loads(path.read_text())
                        complaints = judge.complaints(answer)
                        verdict = run([TOOL, "verify", scene, path])
                        if verdict.returncode != 0:
                            complaints["lcpush verify"] = verdict.stdout
                        right = not complaints and answer["status"] == "solved"
                        # The judge can say no.
                        answer["contacts"][-1]["normal_force"] += 1e-3 * judge.force
                        tampered += 1 if judge.complaints(answer) else 0
                        path.unlink()
                    print(f"{scene.stem}, {solver}: {'ok' if right else complaints} "
                          f"after {starts} start(s)")
                if not right:
                    failures.append((scene.stem, solver))
                tampered += 1 if scene.stem in INFEASIBLE else 0
            count = len(list(runs(folder)))
    scenes = len(list((SOURCE / "fixtures/scenes").glob("*.toml")))
    if failures or tampered != count * scenes:
        sys.exit(f"failed: {failures}; tampered answers found: {tampered} of {count * scenes}")


main()
