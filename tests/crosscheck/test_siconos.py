"""Siconos' LCP solvers on every fixture; `lcpush verify --lcp` judges what they return.

    test_siconos.py TOOL SOURCE          needs Debian's python3-siconos and SciPy
    test_siconos.py TOOL SOURCE --keep   writes each solver's wrong answers to fixtures/external

A closing s is free in the exported problem; here it is bounded below, s = s' - S, as Siconos wants
s' >= 0. Whatever a solver claims, no answer that the mathematics of this file (a natural residual of
its own) calls right may be refused, and none that it calls wrong may pass.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import scipy.io
import siconos.numerics as siconos

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
KEEP = "--keep" in sys.argv
BOUND = 100.0  # S, in the scaled units of the export
SOLVERS = {"lemke": siconos.SICONOS_LCP_LEMKE, "pivot": siconos.SICONOS_LCP_PIVOT,
           "newton_min": siconos.SICONOS_LCP_NEWTONMIN,
           "newton_fb": siconos.SICONOS_LCP_NEWTON_FB_FBLSA, "rpgs": siconos.SICONOS_LCP_RPGS}
VALID = ("same solution", "another valid solution")


def read_problem(folder):
    M = scipy.io.mmread(folder / "M.mtx")
    M = numpy.asarray(M.todense() if hasattr(M, "todense") else M, dtype=float)
    q = numpy.asarray(scipy.io.mmread(folder / "q.mtx"), dtype=float).ravel()
    text = (folder / "free.txt").read_text().strip()
    free = [int(word) - 1 for word in text.split(",")] if text else []
    return M, q, free


def solve(M, q, free, solver):
    """z as the solver leaves it, and whether it says that it has solved."""
    shift = numpy.zeros(len(q))
    shift[free] = BOUND
    shifted = q - M @ shift
    z, w = numpy.zeros(len(q)), numpy.zeros(len(q))
    options = siconos.SolverOptions(solver)
    info = siconos.linearComplementarity_driver(siconos.LCP(M, shifted), z, w, options)
    return z - shift, info == 0


def residual(M, q, free, z):
    """The largest |min(z, w)|, or |w| of a free row, over the largest number around."""
    w = M @ z + q
    rows = numpy.minimum(z, w)
    rows[free] = w[free]
    return numpy.abs(rows).max() / max(1.0, numpy.abs(z).max())


def verify(folder, free, z):
    path = folder / "z.json"
    path.write_text(json.dumps({"z": z.tolist()}))
    command = [TOOL, "verify", "--lcp", folder / "M.mtx", folder / "q.mtx", path, "--json"]
    if free:
        command += ["--free", ",".join(str(i + 1) for i in free)]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert result.returncode in (0, 1), result.stderr
    report = json.loads(result.stdout)
    assert report["valid"] == (result.returncode == 0) == (report["verdict"] in VALID), report
    return report


def main():
    faults, table = [], {name: [0, 0, 0] for name in SOLVERS}
    with tempfile.TemporaryDirectory() as temporary:
        for scene in sorted((SOURCE / "fixtures/scenes").glob("*.toml")):
            folder = pathlib.Path(temporary, scene.stem)
            subprocess.run([TOOL, "export", scene, "-o", folder], check=True, capture_output=True)
            M, q, free = read_problem(folder)
            for name, solver in SOLVERS.items():
                z, claims = solve(M, q, free, solver)
                if not numpy.isfinite(z).all():
                    table[name][2] += 1
                    continue
                wrong = residual(M, q, free, z)
                report = verify(folder, free, z)
                if wrong < 1e-9 and not report["valid"]:
                    faults.append(f"{scene.stem}, {name}: right to {wrong:.0e} and refused: {report}")
                if wrong > 1e-3 and report["valid"]:
                    faults.append(f"{scene.stem}, {name}: wrong by {wrong:.0e} and passed: {report}")
                table[name][0 if report["valid"] else 1 if claims else 2] += 1
                if claims and not report["valid"]:
                    print(f"{scene.stem}: {name} says solved, but {report['verdict']}, "
                          f"residual {report['residual']:.1e}")
                if KEEP and claims and not report["valid"]:
                    keep = SOURCE / "fixtures/external" / f"siconos_{name}_{scene.stem}.json"
                    keep.write_text(json.dumps({"z": z.tolist()}, indent=1) + "\n")
    print("solver       right  wrong but called solved  gave up")
    for name, (right, wrong, gave_up) in table.items():
        print(f"{name:12} {right:5}  {wrong:23}  {gave_up:7}")
    if table["lemke"][0] == 0:
        faults.append("Siconos' Lemke has solved nothing: is this the right problem?")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
