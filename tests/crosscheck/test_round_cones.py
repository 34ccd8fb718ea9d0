"""Siconos' solver of round cones and lcpush's rounds agree on random pushes over a table.

    test_round_cones.py TOOL          needs Debian's python3-siconos

A box stands on three stops and is pushed from its side, without friction. The local problem u = W r + q over second-order
cones is written here from the scene's numbers alone.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import siconos.numerics as siconos

TOOL = sys.argv[1]
MASS, BOX = 0.3, numpy.array([0.1, 0.06, 0.04])
GRAVITY = numpy.array([0, 0, -9.81])


def scene_of(random):
    """(points, normals, tangents, frictions, the pusher's acceleration)"""
    angles = random.uniform(0, 2 * numpy.pi) + numpy.array([0, 2.1, 4.2]) + random.uniform(-0.3, 0.3, 3)
    feet = [[0.03 * numpy.cos(a), 0.02 * numpy.sin(a), -BOX[2] / 2] for a in angles]
    side = [-BOX[0] / 2, random.uniform(-0.02, 0.02), random.uniform(-0.015, 0)]
    points = numpy.array([*feet, side])
    normals = numpy.array([[0, 0, 1.0]] * 3 + [[1.0, 0, 0]])
    tangents = numpy.array([[1.0, 0, 0]] * 3 + [[0, 1.0, 0]])
    push = numpy.array([random.uniform(0.5, 3), random.uniform(-1, 1), 0])
    # Through a pusher that sticks part of the weight may go, or not: there are many answers.
    return points, normals, tangents, numpy.array([*random.uniform(0.1, 0.6, 3), 0]), push


def text_of(points, normals, frictions, push):
    def vector(v):
        return "[" + ", ".join(repr(float(x)) for x in v) + "]"

    text = f'facets = "round"\npressure = "rigid"\ngravity = {vector(GRAVITY)}\n'
    text += f"[object]\nmass = {MASS}\nbox = {vector(BOX)}\n"
    for i, (p, n, mu) in enumerate(zip(points, normals, frictions)):
        text += f'[[{"finger" if i < 3 else "pusher"}]]\nname = "c{i}"\nshape = "point"\n'
        text += f"center = {vector(p)}\nnormal = {vector(n)}\nfriction = {float(mu)!r}\n"
        if i == 3:
            text += f"acceleration = {vector(push)}\n"
    return text


def by_siconos(points, normals, tangents, frictions, push):
    """The object's acceleration, or None."""
    inertia = MASS / 12 * (BOX @ BOX - BOX ** 2)
    inverse = numpy.diag([1 / MASS] * 3 + list(1 / inertia))
    columns, driven = [], []
    for p, n, t in zip(points, normals, tangents):
        for u in (n, t, numpy.cross(n, t)):
            columns.append([*u, *numpy.cross(p, u)])
            driven.append(u @ push if n[0] == 1 else 0)
    H = numpy.array(columns).T
    load = numpy.array([*(MASS * GRAVITY), 0, 0, 0])
    W, q = H.T @ inverse @ H, H.T @ inverse @ load - numpy.array(driven)
    problem = siconos.FrictionContactProblem(3, len(points), W, q, frictions)
    options = siconos.SolverOptions(siconos.SICONOS_FRICTION_3D_NSGS)
    options.dparam[siconos.SICONOS_DPARAM_TOL] = 1e-13
    options.iparam[siconos.SICONOS_IPARAM_MAX_ITER] = 200000
    r, u = numpy.zeros(3 * len(points)), numpy.zeros(3 * len(points))
    if siconos.fc3d_nsgs(problem, r, u, options) not in (0, None) and options.dparam[1] > 1e-10:
        return None
    return inverse @ (H @ r + load)


def by_lcpush(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.toml"
        path.write_text(text)
        done = subprocess.run([TOOL, "solve", path, "--json"], capture_output=True, text=True)
    answer = json.loads(done.stdout)
    return numpy.array(answer["object"]["acceleration"]) if answer["status"] == "solved" else None


compared = turned = 0
reach = numpy.array([1, 1, 1, 0.05, 0.05, 0.05])
for seed in range(100):
    data = scene_of(numpy.random.default_rng(seed))
    points, normals, tangents, frictions, push = data
    theirs, ours = by_siconos(*data), by_lcpush(text_of(points, normals, frictions, push))
    if theirs is None or ours is None:
        continue
    compared += 1
    size = numpy.abs(reach * theirs).max()
    off = numpy.abs(reach * (theirs - ours)).max()
    turned += abs(0.05 * theirs[5]) > 0.05 * size
    assert off <= 1e-6 * size, (seed, off / size, theirs, ours)
assert compared >= 90 and turned >= 50, (compared, turned)
print(f"{compared} pushes agree, {turned} of them turn")
