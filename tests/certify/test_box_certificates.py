"""Certificates of boxes (`lcpush cone --certify`): the checker of the docs accepts those of `always`, and refuses each
change of one field, also one that carries the right fingerprints where it says more than is true.

    test_box_certificates.py TOOL REPO_ROOT"""
import copy
import hashlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "docs/check"))
import lcpush_check_box as checker  # noqa: E402

FOLDER = pathlib.Path(tempfile.mkdtemp())
UNCERTAIN = ROOT / "docs/guide/uncertain_slide.toml"
faults = []


def certified(scene, *words):
    """(certificate or None, verdict)"""
    path = FOLDER / "certificate.json"
    path.unlink(missing_ok=True)
    said = subprocess.run([TOOL, "cone", scene, *words, "--json", "--certify", path], capture_output=True, text=True)
    return (json.loads(path.read_text()) if path.exists() else None), json.loads(said.stdout)["verdict"], said.stderr


def refusal(certificate, text):
    try:
        checker.check(certificate, text)
    except Exception as error:  # as the program does
        return str(error) or type(error).__name__
    return None


def fingerprinted(c, text):
    claim = [c["pusher"], *c["twist"]] + [x for side in c["box"] for x in (*side["paths"], side["low"], side["high"])] + [
        x for one in c["conditions"] for x in (*one["corner"], one["least"])]
    c["sha256"] = [hashlib.sha256(part).hexdigest() for part in (text, ",".join(claim).encode())]
    return c


def fields(data, path=()):
    if isinstance(data, (dict, list)):
        for key in data if isinstance(data, dict) else range(len(data)):
            yield from fields(data[key], path + (key,))
    else:
        yield path


def changed(value):
    if isinstance(value, int):
        return value + 1
    try:
        return str(Fraction(value) + Fraction(1, 10**9))
    except ValueError:
        return value[:-1] + chr(ord(value[-1]) ^ 1)


def with_change(certificate, path, change):
    other = copy.deepcopy(certificate)
    at = other
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = change(at[path[-1]])
    return other


def expect(truth, *what):
    if not truth:
        faults.append(what)


def mutations(scene, *words):
    certificate, verdict, said = certified(scene, *words)
    text = pathlib.Path(scene).read_bytes()
    expect(verdict == "always" and certificate is not None, scene, verdict, said)
    expect(refusal(certificate, text) is None, refusal(certificate, text))
    paths = list(fields(certificate))
    for path in paths:
        expect(refusal(with_change(certificate, path, changed), text) is not None, "accepted", path)
    for path in paths:  # what says more than is true, with the right fingerprints
        if path[0] == "conditions" or path[0] == "pusher" or path[-1] in ("statement", "proof", "certificate"):
            forged = with_change(certificate, path, lambda x: str(Fraction(x) * 2 + 1) if path[-1] == "least" else changed(x))
            expect(refusal(fingerprinted(forged, text), text) is not None, "forgery accepted", path)
    shorter = dict(certificate, conditions=certificate["conditions"][:3])
    expect(refusal(fingerprinted(shorter, text), text) is not None, "three conditions")
    for at in range(0, len(text) - 8, max(1, len(text) // 40)):  # one character of the scene
        other = text[:at] + bytes([text[at] ^ 1]) + text[at + 1:]
        expect(refusal(certificate, other) is not None, "another scene", at)
    return certificate, text


def set_side(certificate, path, end, value):
    other = copy.deepcopy(certificate)
    next(side for side in other["box"] if path in side["paths"])[end] = value
    return other


certificate, text = mutations(UNCERTAIN)
for path, end, value in (("wall.friction", "low", "1/10"), ("object.mass", "high", "1"), ("left.grip_force", "low", "1"),
                         ("left.friction", "low", "1/50"), ("wall.friction", "low", "-1/5")):
    forged = set_side(certificate, path, end, value)
    for one in forged["conditions"]:  # the worst corner, and a value to it that would do
        one["corner"] = [value if side["paths"][0] == path and x in (certificate["box"][k][end],) else x
                         for k, (side, x) in enumerate(zip(certificate["box"], one["corner"]))]
        one["least"] = "0"
    expect("fails" in (refusal(fingerprinted(forged, text), text) or "") or value[0] == "-", "a wider box", path)
    expect(refusal(fingerprinted(forged, text), text) is not None, "a wider box", path)
turned = fingerprinted(dict(certificate, twist=["0", "1", "0"]), text)
expect(refusal(turned, text) is not None, "another motion")
places = copy.deepcopy(certificate)
places["box"].append({"paths": ["wall.shift[0]"], "low": "0", "high": "0"})
expect("affine" in (refusal(fingerprinted(places, text), text) or ""), "a number that may not be affine")
for old, new in ((b"planar = true", b"planar = false"), (b"planar = true", b"planar = true\nfacets = 8")):
    other = text.replace(old, new)
    expect("law" in (refusal(fingerprinted(copy.deepcopy(certificate), other), other) or ""), new)

sys.argv[1:] = [TOOL, str(ROOT)]
sys.path.insert(0, str(ROOT / "tests/cli"))
import test_tolerance  # noqa: E402

count = 0
for seed in range(60):
    rng = random.Random(seed)
    push = test_tolerance.Push(rng)
    scene = FOLDER / "push.toml"
    scene.write_text(push.text())
    words = ["--twist", " ".join(map(str, push.twist))]
    for path, value in push.middle.items():
        off = round(0.02 * abs(value), 6)
        if path != "gravity[1]":
            words += ["--tolerance", f"{path}={value - off!r}:{value + off!r}"]
    made, verdict, said = certified(scene, *words)
    expect((made is not None) == (verdict == "always" and not push.facets), seed, verdict, said)
    if made is not None:
        count += 1
        expect(refusal(made, scene.read_bytes()) is None, seed, refusal(made, scene.read_bytes()))
expect(count > 5, count)
for shape in ('shape = "disc"\ncenter = [0, 0, {0}]\nradius = 0.005', 'shape = "rectangle"\ncenter = [0, 0, {0}]\nsize = [0.01, 0.02]\npoints = [4, 5]',
              'shape = "line"\nends = [[-0.005, 0, {0}], [0.005, 0, {0}]]\npoints = 9', 'shape = "ring"\ncenter = [0, 0, {0}]\nradius = 0.005',
              'shape = "point"\ncenter = [0, 0, {0}]\ntorsion_radius = 0.003', 'shape = "disc"\ncenter = [0, 0, {0}]\nradius = 0.005\npoints = 40'):
    scene = FOLDER / "shape.toml"
    scene.write_text("planar = true\ngravity = [0, -1, 0]\n[object]\nmass = 0.2\nbox = [0.1, 0.1, 0.01]\n" + "".join(
        f'[[finger]]\nname = "{name}"\n{shape.format(z)}\nnormal = [0, 0, {-1 if z > 0 else 1}]\nfriction = 0.5\ngrip_force = 20\n'
        for name, z in (("left", 0.005), ("right", -0.005))) +
        '[[pusher]]\nname = "wall"\nshape = "line"\nends = [[-0.05, -0.03, 0], [-0.05, 0.03, 0]]\nnormal = [1, 0, 0]\nfriction = 0.5\nvelocity = [1, 0, 0]\n')
    made, verdict, said = certified(scene, "--twist", "1 0.1 2", "--tolerance", "*.friction=5%")
    expect(made is not None, shape, verdict, said)
    expect(made and refusal(made, scene.read_bytes()) is None, shape, made and refusal(made, scene.read_bytes()))

if faults:
    sys.exit("\n".join(map(str, faults)))
print(f"{count} boxes of random pushes, six shapes of fingers: accepted; every change refused")
