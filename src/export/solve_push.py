#!/usr/bin/env python3
"""Solves the push in this folder the way of Chavan-Dafle and Rodriguez (IROS 2015).

    minimise x' H x / 2 + f' x   subject to   A x <= b,  Aeq x = beq,  lb <= x <= ub

The objective is the sum of all complementarity products. It is never negative where the constraints
hold, and zero exactly at an answer of the contact problem; the program is not convex, so a solver
may also stop at a point where it is not zero. Such a point is not an answer.

    python3 solve_push.py         SLSQP; slow beyond some 400 unknowns
    python3 solve_push.py steps   linear programs along the gradient (Frank and Wolfe); fast

Needs NumPy and SciPy. Writes answer.json beside this file, in SI units. Exit status 0: solved,
1: no start led to an answer.
"""
import json
import pathlib
import sys

try:
    import numpy as np
    import scipy
    from scipy import io, optimize, sparse
except ImportError as missing:
    sys.exit(f"{missing}; solve_push.py needs NumPy and SciPy, such as of `pip install numpy scipy`")

FOLDER = pathlib.Path(__file__).resolve().parent
STARTS, SEED = 12, 1
LP_OPTIONS = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}


def matrix(name):
    return sparse.csr_matrix(io.mmread(str(FOLDER / f"{name}.mtx")))


def vector(name):
    return np.asarray(io.mmread(str(FOLDER / f"{name}.mtx"))).reshape(-1)


names = json.loads((FOLDER / "names.json").read_text(encoding="utf-8"))
H, A, Aeq, answer = map(matrix, ("H", "A", "Aeq", "answer"))
f, b, beq, lb, ub = map(vector, ("f", "b", "beq", "lb", "ub"))
lb = np.where(lb <= -names["no_bound"], -np.inf, lb)
ub = np.where(ub >= names["no_bound"], np.inf, ub)
bounded = np.isfinite(lb)


def objective(x):
    return x @ (H @ x) / 2 + f @ x


def gradient(x):
    return H @ x + f


def violation(x):
    """The largest violation of any constraint, in the scene's units."""
    parts = [A @ x - b, np.abs(Aeq @ x - beq), (lb - x)[bounded]]
    return max([0.0, *(float(part.max()) for part in parts if part.size)])


def tolerance(x):
    """What rounding may leave of the objective; and no more than a millionth of the push."""
    rounding = 1e-12 * (1 + np.abs(x).max() ** 2)
    contacts = np.array([row["symbol"].startswith("r_") for row in names["Aeq"]])
    push = np.abs(beq[contacts]).max() if contacts.any() else 0
    return min(rounding, 1e-6 * push) if push > 0 else rounding


def is_answer(x):
    return objective(x) <= tolerance(x) and violation(x) <= 1e-9


def linear_program(cost):
    return optimize.linprog(cost, A, b, Aeq, beq, np.column_stack([lb, ub]), method="highs",
                            options=LP_OPTIONS)


def feasible_point(start, random):
    """Meets all constraints; none of the products. Another one for each start."""
    cost = np.ones(len(f)) if start == 0 else random.uniform(0.1, 1, len(f))
    return linear_program(np.where(bounded, cost, 0))


def slsqp(x):
    dense_A, dense_Aeq = A.toarray(), Aeq.toarray()
    found = optimize.minimize(
        objective, x, jac=gradient, method="SLSQP", bounds=list(zip(lb, ub)),
        constraints=[{"type": "eq", "fun": lambda x: Aeq @ x - beq, "jac": lambda x: dense_Aeq},
                     {"type": "ineq", "fun": lambda x: b - A @ x, "jac": lambda x: -dense_A}],
        options={"maxiter": 300, "ftol": 1e-14})
    return found.x, found.nit


def steps(x):
    for count in range(300):
        found = linear_program(gradient(x))
        if not found.success:
            break
        direction = found.x - x
        slope = gradient(x) @ direction
        if slope >= -1e-15:
            break
        curvature = direction @ (H @ direction)
        x = x + (min(1.0, -slope / curvature) if curvature > 0 else 1.0) * direction
    return x, count + 1


def write_answer(x, method):
    y = (answer @ x).tolist()
    actuators = len(names["actuators"])
    contacts = []
    for k, name in enumerate(names["contacts"]):
        force, *friction, torsion, ax, ay, az = y[6 + actuators + 8 * k:][:8]
        contacts.append({"name": name, "normal_force": force, "friction_force": friction,
                         "torsion": torsion, "acceleration": [ax, ay, az]})
    data = {"status": "solved" if is_answer(x) else "stagnated",
            "solver": f"{method}, SciPy {scipy.__version__}", "objective": objective(x),
            "violation": violation(x),
            "friction": {"law": "pyramids", "facets": names["facets"]},
            "object": {"acceleration": y[:6]}, "closing": y[6:6 + actuators], "contacts": contacts}
    (FOLDER / "answer.json").write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")


def main():
    if sys.argv[1:] not in ([], ["steps"]):
        sys.exit(__doc__)
    method, solve = ("linear programs", steps) if sys.argv[1:] else ("SLSQP", slsqp)
    (FOLDER / "answer.json").unlink(missing_ok=True)
    random = np.random.default_rng(SEED)
    best = None
    print(f"{names['title'] or FOLDER.name}: {len(f)} unknowns, {method}")
    for start in range(STARTS):
        first = feasible_point(start, random)
        if first.status == 2:
            print("No x meets the linear constraints, whatever the products: no forces and motion "
                  "obey Newton, the grip forces and the prescribed motions at once.")
            return 1
        if not first.success:
            print(f"start {start + 1}: no feasible point found: {first.message}")
            continue
        x, iterations = solve(first.x)
        print(f"start {start + 1}: objective {objective(first.x):.3e} -> {objective(x):.3e}, "
              f"violation {violation(x):.1e}, {iterations} iterations")
        if best is None or (violation(x) > 1e-9, objective(x)) < (violation(best) > 1e-9,
                                                                 objective(best)):
            best = x
        if is_answer(x):
            break
    if best is None:
        return 1
    write_answer(best, method)
    if is_answer(best):
        print(f"Objective {objective(best):.3e}: zero to rounding. answer.json holds an answer.")
        return 0
    print(f"Objective {objective(best):.3e}, violation {violation(best):.1e}; rounding would leave "
          f"{tolerance(best):.1e}. This is NOT a solution: forces and motions in answer.json break "
          "the contact laws.")
    return 1


sys.exit(main())
