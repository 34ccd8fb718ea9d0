"""Certificates of fixtures, of random grasps and of raw problems are accepted by the checker that the
docs ship; what is changed in any digit is refused.

    test_certificates.py TOOL REPO_ROOT [FIRST LAST]      seeds of the random grasps
"""
import hashlib
import importlib.util
import json
import math
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "tests/support"))
from processor_time import processor_time

FIRST, LAST = (int(word) for word in sys.argv[3:5]) if len(sys.argv) > 4 else (0, 300)
SLOWEST = 8  # seconds of processor time up to 300 unknowns, of a command with its certificate and of the checker: the limit that commands have
SPEC = importlib.util.spec_from_file_location("lcpush_check", ROOT / "docs/check/lcpush_check.py")
CHECKER = importlib.util.module_from_spec(SPEC)
sys.dont_write_bytecode = True
SPEC.loader.exec_module(CHECKER)
FOLDER = pathlib.Path(tempfile.mkdtemp())
faults, missing = [], []  # missing: of random grasps, of which one or two in a thousand have none
spent_on = []  # (unknowns, seconds of the command, seconds of the checker)


def refusal(certificate, texts):
    """None if it is accepted."""
    try:
        CHECKER.check(json.loads(certificate) if isinstance(certificate, (str, bytes)) else certificate, texts)
    except Exception as error:  # as the program does
        return str(error) or type(error).__name__
    return None


def certify(verb, files, *options):
    path = FOLDER / "certificate.json"
    path.unlink(missing_ok=True)
    before = processor_time()
    done = subprocess.run([TOOL, verb, *map(str, files), "--json", "--certify", path, *options],
                          capture_output=True, text=True)
    status = json.loads(done.stdout)["status"] if done.stdout else done.stderr
    return status, path.read_text() if path.exists() else None, processor_time() - before


def expect(what, verb, files, proof, *options):
    """The certificate of an answer, which must be there, of this kind, and accepted."""
    status, certificate, search = certify(verb, files, *options)
    if certificate is None:
        return (missing if what.startswith("seed") else faults).append(f"{what}: {verb}: {status}, no certificate")
    begin = time.process_time()
    why = refusal(certificate, [pathlib.Path(f).read_bytes() for f in files])
    spent = time.process_time() - begin
    found = json.loads(certificate)
    if why or found["proof"] not in proof:
        faults.append(f"{what}: {verb}: {status}, {found['proof']}: {why}")
    spent_on.append((len(found["x"]), search, spent))
    if max(search, spent) > SLOWEST and len(found["x"]) <= 300:
        faults.append(f"{what}: the command took {search:.1f} s, the checker {spent:.1f} s")
    return certificate


def unit(pick):
    v = [pick.gauss(0, 1) for _ in range(3)]
    return [x / math.hypot(*v) for x in v]


def random_grasp(seed):
    """Two opposed fingers of 1 to 8 points and a pusher of 1 to 4, turned anyhow."""
    pick = random.Random(seed)
    n, away = unit(pick), unit(pick)
    if seed % 4 == 0:
        n = pick.choice([[0, 0, 1], [1, 0, 0], [0, -1, 0], [0.6, 0.8, 0]])
    t = CHECKER.cross(n, away)
    t = [x / math.hypot(*t) for x in t]
    o = CHECKER.cross(n, t)
    place = lambda x, y, z: [x * a + y * b + z * c for a, b, c in zip(t, o, n)]
    shape = pick.choice(["point", "soft", "points", "points", "disc", "rectangle", "line", "ring"])
    text = (f"pressure = \"rigid\"\nfacets = {pick.choice([4, 6, 8, 8, 12, 16])}\n"
            f"gravity = {[9.81 * x for x in unit(pick)]}\n[object]\nmass = {pick.uniform(.05, 2)}\n"
            f"{pick.choice(['box = [0.1, 0.04, 0.02]', 'inertia = [1e-4, 1.2e-4, 1.5e-4, 1e-5, 0, 2e-5]'])}\n"
            f"center_of_mass = {[pick.uniform(-.01, .01) for _ in range(3)]}\n")
    if pick.random() < .5:
        text += f"[gripper]\njaws = \"{pick.choice(['parallel', 'independent'])}\"\n"
    force = pick.uniform(1, 50)
    for name, side in (("left", 1), ("right", -1)):
        c = place(0, 0, .01 * side)
        k = pick.randint(2, 8)
        text += f"[[finger]]\nname = \"{name}\"\nnormal = {[-side * x for x in n]}\n"
        text += f"friction = {pick.uniform(.1, 1.2)}\ngrip_force = {force}\n"
        if shape in ("point", "soft"):
            text += f"shape = \"point\"\ncenter = {c}\n" + ("torsion_radius = 0.004\n" if shape == "soft" else "")
        elif shape == "points":
            text += f"shape = \"points\"\npoints = {[place(pick.uniform(-.01, .01), pick.uniform(-.01, .01), .01 * side) for _ in range(k)]}\n"
        elif shape == "line":
            text += f"shape = \"line\"\nends = {[place(-.01, 0, .01 * side), place(.01, .003, .01 * side)]}\n"
        elif shape == "rectangle":
            text += f"shape = \"rectangle\"\ncenter = {c}\nsize = [0.01, 0.02]\npoints = [2, {pick.randint(1, 4)}]\n"
        else:
            text += f"shape = \"{shape}\"\ncenter = {c}\nradius = 0.006\npoints = {k}\n"
    push = place(*(lambda a: (math.cos(a), math.sin(a), 0))(pick.uniform(0, 6.3)))
    points = [[-.04 * x + pick.uniform(-.01, .01) * y for x, y in zip(push, n)] for _ in range(pick.randint(1, 4))]
    return text + (f"[[pusher]]\nname = \"wall\"\nshape = \"points\"\npoints = {points}\nnormal = {push}\n"
                   f"friction = {pick.uniform(.1, 1.2)}\nacceleration = {[x * pick.uniform(.05, 2) for x in push]}\n"
                   f"angular_acceleration = {[pick.uniform(-1, 1) for _ in range(3)]}\n")


def changed_digit(pick, text):
    """One digit of a number is another."""
    places = [m.start() for m in re.finditer(r"\d", text)]
    at = pick.choice(places)
    return text[:at] + pick.choice([d for d in "0123456789" if d != text[at]]) + text[at + 1:]


def told_times(what, times):
    """Median and slowest of the command and of the checker."""
    if times:
        print(f"{what}, {len(times)}: " + "; ".join(
            f"{who} {statistics.median(column):.3f} s, at most {max(column):.3f} s"
            for who, column in zip(("command", "checker"), list(zip(*times))[1:])))


def main():
    pick, accepted, tally = random.Random(1), [], {}
    for path in sorted((ROOT / "fixtures/scenes").glob("*.toml")) + sorted((ROOT / "fixtures/rays").glob("*.toml")) + [
            ROOT / "docs/guide/two_strokes.toml"]:  # velocities; a pusher that comes later
        text = path.read_text()
        if 'pressure = "even"' in text or path.stem == "runaway":  # a ray that presses nothing
            continue
        verbs = ["solve"] + (["break"] if text.count("[[pusher]]") == 1 and "acceleration" in text and path.stem != "vise" else [])
        for verb in verbs:
            made = expect(path.stem, verb, [path], ("squeeze",) if "jam" in path.stem else
                          ("cannot_hold",) if (path.stem, verb) == ("dropped", "break") else ("answer",))
            if made:
                accepted.append((made, [path.read_bytes()]))
    for path in sorted((ROOT / "fixtures/textbook").glob("*.M.mtx")):
        files = [path, path.with_name(path.name.replace(".M.", ".q."))]
        status, certificate, _ = certify("lcp", files)
        why = refusal(certificate, [f.read_bytes() for f in files]) if certificate else "none was written"
        tally[status] = tally.get(status, 0) + 1
        if why and (certificate or status == "solved"):
            faults.append(f"{path.name}: {status}: {why}")
        if certificate:
            accepted.append((certificate, [f.read_bytes() for f in files]))
    told_times("scenes shipped", spent_on)
    shipped, proofs = len(spent_on), {}
    for seed in range(FIRST, LAST):
        path = FOLDER / "scene.toml"
        path.write_text(random_grasp(seed))
        made = expect(f"seed {seed}", "solve", [path], ("answer", "squeeze"))
        if made:
            proof = json.loads(made)["proof"]
            proofs[proof] = proofs.get(proof, 0) + 1
            if seed % 10 == 0:
                accepted.append((made, [path.read_bytes()]))
    # No change of a digit is overlooked, in the file or in the certificate; nor one of the basis.
    overlooked, mended = [], [0, 0]
    for k in range(1000):
        certificate, texts = pick.choice(accepted)
        kind = k % 4
        if kind == 0:
            files = [t.decode() for t in texts]
            at = pick.randrange(len(files))
            files[at] = changed_digit(pick, files[at])
            if refusal(certificate, [f.encode() for f in files]) is None:
                overlooked.append(files[at])
            # With a new fingerprint only the laws are left to notice; some numbers do not matter.
            forged = json.loads(certificate)
            forged["sha256"][:-1] = [hashlib.sha256(f.encode()).hexdigest() for f in files]
            mended[refusal(forged, [f.encode() for f in files]) is None] += 1
        elif kind == 1:
            if refusal(changed_digit(pick, certificate), texts) is None:
                overlooked.append(certificate)
        else:
            forged = json.loads(certificate)
            if kind == 2 and forged["basis"]:
                forged["basis"].pop(pick.randrange(len(forged["basis"])))
            else:
                at = pick.randrange(len(forged["x"]))
                forged["x"][at] = str(CHECKER.F(forged["x"][at]) + CHECKER.F(pick.choice([1, -1]), 10**12))
            if refusal(forged, texts) is None:
                overlooked.append(json.dumps(forged))
            # Without the fingerprint the laws notice too, but where there is room: the slip of an open
            # contact may be larger, and a fall has many proofs.
            forged["sha256"][-1] = hashlib.sha256(",".join(forged["x"]).encode()).hexdigest()
            mended[refusal(forged, texts) is None] += 1
    if len(missing) > 0.003 * (LAST - FIRST):
        faults.extend(missing)
    if overlooked:
        faults.append(f"{len(overlooked)} changes were overlooked, such as {overlooked[0][:300]}")
    if mended[1] > 0.4 * mended[0]:
        faults.append(f"of {sum(mended)} changed numbers the laws noticed only {mended[0]}")
    print(f"{len(accepted)} certificates kept; raw problems {tally}; grasps {proofs}; 1000 changes, "
          f"{len(overlooked)} overlooked; of {sum(mended)} changed numbers with a new fingerprint "
          f"{mended[0]} refused by the laws")
    told_times("grasps", spent_on[shipped:])
    told_times("of them with 280 to 330 unknowns", [t for t in spent_on[shipped:] if 280 <= t[0] <= 330])
    print("\n".join(faults[:40]))
    return 1 if faults else 0


sys.exit(main())
