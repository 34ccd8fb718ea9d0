"""Is an optimiser's answer right? A raw problem's and a scene's, judged by lcpush.

M is symmetric and positive definite: z minimises z'M z / 2 + q'z over z >= 0. Without SciPy, z is
typed in.
"""
import pathlib

import lcpush

M, q = [[2, 1], [1, 2]], [-5, -6]
try:
    import numpy
    import scipy.optimize

    A, b = numpy.array(M), numpy.array(q)
    z = scipy.optimize.minimize(lambda z: z @ A @ z / 2 + b @ z, [1, 1], bounds=[(0, None)] * 2,
                                tol=1e-3).x
except ImportError:
    z = [1.33, 2.33]
verdict = lcpush.check(M, q, z)
print(verdict)
print("right" if verdict else f"off by {verdict.residual:.0e} (scaled) in row {verdict.row}")
print("lcpush finds z =", [round(float(x), 4) for x in lcpush.lcp(M, q).z])

# A scene's problem, in its own unknowns: give M, q to your solver, and its answer to check().
root = pathlib.Path(__file__).resolve().parents[2]
scene = lcpush.read(root / "fixtures/scenes/straight_slide_point.toml")
push = scene.solve()
print(len(push.q), "unknowns:", push.names[0], "..", push.names[-1])

# A simulator's forces and motion, as far as they are known: here with 1 % too much acceleration.
simulated = {"object": {"acceleration": [1.01 * a for a in push.acceleration]},
             "contacts": [{"name": contact.name, "normal_force": contact.normal_force,
                           "friction_force": contact.friction_force}
                          for contact in push.contacts]}
print(lcpush.verify_scene(scene, simulated))
