"""Every gate of the checker that the docs ship refuses a certificate that is wrong in that one thing.

    test_refusals.py TOOL REPO_ROOT

Forgeries carry the right fingerprints: only the laws are left to notice them. Then each gate is taken
out of the checker, one at a time, and some forgery has to pass: none of them is there for nothing.
"""
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
SOURCE = (ROOT / "docs/check/lcpush_check.py").read_text()
FOLDER = pathlib.Path(tempfile.mkdtemp())
SCENES = ROOT / "fixtures/scenes"
faults = []


def checker(source):
    names = {"__name__": "checker"}
    exec(compile(source, "lcpush_check.py", "exec"), names)
    return names


GENUINE = checker(SOURCE)


def refusal(checking, certificate, texts):
    try:
        checking["check"](certificate, [text.encode() for text in texts])
    except Exception as error:  # as the program does
        return str(error) or type(error).__name__
    return None


def certified(verb, text):
    scene, path = FOLDER / "scene.toml", FOLDER / "certificate.json"
    scene.write_text(text)
    subprocess.run([TOOL, verb, scene, "--certify", path], capture_output=True)
    return json.loads(path.read_text())


def matrix(rows):
    cells = "".join(f"{row[j]}\n" for j in range(len(rows[0])) for row in rows)
    return f"%%MatrixMarket matrix array real general\n{len(rows)} {len(rows[0])}\n{cells}"


def raw(proof, M, q, x, **other):
    x = [str(Fraction(v)) for v in x]
    return {"certificate": 1, "law": "raw", "proof": proof, "statement": GENUINE["SAYS"][proof], "free": [],
            "push": "0" if proof == "no_answer" else "1", "x": x,
            "basis": [] if proof == "no_answer" else [i + 1 for i, v in enumerate(x) if v != "0"], **other}, [
                matrix(M), matrix([[v] for v in q])]


def changed(certificate, texts, **other):
    return {**certificate, **other}, texts


def stamped(forgery):
    """With the fingerprints of what it is."""
    certificate, texts = forgery
    files = [hashlib.sha256(t.encode()).hexdigest() for t in (*texts, ",".join(certificate["x"]))]
    return {**certificate, "sha256": files}, texts


def with_x(certificate, at, value):
    x = list(certificate["x"])
    x[at] = str(Fraction(value))
    free = len(x) - certificate["pairs"]
    return {**certificate, "x": x, "basis": [i + 1 for i, v in enumerate(x[:len(x) - free]) if v != "0"]}


def forgeries():
    """(what is wrong, forgery, the refusal); one without a refusal is genuine."""
    M, q = [[2, 1], [1, 2]], [-5, -6]
    right = ["4/3", "7/3"]
    yield "answer", raw("answer", M, q, right), None
    yield "answer, off by little", raw("answer", M, q, ["4/3", Fraction(7, 3) + Fraction(1, 10**30)]), "row 1 fails"
    yield "row negative", raw("answer", M, q, [0, 3]), "row 1 fails"
    yield "both positive", raw("answer", M, [-5, 0], ["5/2", 0]), None
    yield "unknown negative", raw("answer", [[1]], [1], [-1]), "row 1 fails"
    yield "not complementary", raw("answer", [[1]], [-1], [2]), "row 1 fails"
    yield "a free row left over", raw("answer", [[1]], [-1], [2], free=[1], basis=[]), "row 1 fails"
    yield "basis", raw("answer", M, q, right, basis=[1]), "another basis"
    yield "push of a raw problem", raw("answer", M, q, right, push="2"), "another push"
    yield "statement", raw("answer", M, q, right, statement=GENUINE["SAYS"]["squeeze"]), "another statement"
    yield "law", raw("answer", M, q, right, law="literal"), "another law"
    certificate, (of_M, of_q) = raw("answer", M, q, right)
    yield "a kind of matrix", (certificate, [of_M.replace("general", "symmetric"), of_q]), "another kind"
    yield "version", raw("answer", M, q, right, certificate=2), "another file"
    N, r = [[0, -1], [-1, 0]], [-1, -1]
    yield "no answer", raw("no_answer", N, r, [1, 1]), None
    yield "rows that gain", raw("no_answer", M, r, [1, 1]), "a force takes more"
    yield "a negative weight", raw("no_answer", [[1, 0], [1, 1]], [1, -1], [-3, -2]), "no contradiction"
    yield "no contradiction", raw("no_answer", N, [1, 1], [1, 1]), "no contradiction"
    yield "nothing", raw("no_answer", N, r, [0, 0]), "no contradiction"
    yield "a push of no answer", raw("no_answer", N, r, [1, 1], push="1"), "another length"
    yield "a free column that gains", raw("no_answer", [[0, 1], [0, -1]], [-1, 0], [1, 0], free=[2]), "a force takes more"
    yield "a free column that loses", raw("no_answer", [[0, -1], [0, 1]], [-1, 0], [1, 0], free=[2]), "a force takes more"
    dropped = (SCENES / "dropped.toml").read_text()
    falls = certified("break", dropped)
    yield "falls", (falls, [dropped]), None
    yield "friction holds", (falls, [dropped.replace("friction = 0.3", "friction = 0.6")]), "a force takes more"
    yield "a stop holds", (falls, [dropped + "[[finger]]\nname = \"stop\"\nshape = \"point\"\ncenter = [0, -0.015, 0]\n"
                           "normal = [0, 1, 0]\nfriction = 0\n"]), "a force takes more"
    yield "grip holds", (falls, [dropped.replace("grip_force = 2", "grip_force = 20")]), "no contradiction"
    yield "no motion", changed(falls, [dropped], x=["0"] * len(falls["x"])), "no contradiction"
    yield "length", changed(falls, [dropped], x=falls["x"] + ["0"]), "another length"
    yield "law of a scene", (falls, ["pressure = \"even\"\n" + dropped]), "another law"
    yield "facets of a scene", (falls, ["facets = 6\n" + dropped]), "another law"
    slide = (SCENES / "straight_slide.toml").read_text()
    away = slide.replace("acceleration = [0.1,", "acceleration = [-0.1,")
    yield "a wall that moves away", changed(certified("solve", away), [slide], push="-1"), "another push"
    # Opposed to 8e-10 in each coordinate, 1.1e-9 in all: a jaw to both.
    nearly = slide.replace("normal = [0, 0, 1]", "normal = [8e-10, 8e-10, 1]")
    yield "nearly opposed", (certified("solve", nearly), [nearly]), None
    jam = (SCENES / "jam.toml").read_text()
    squeeze = certified("solve", jam)
    problem = GENUINE["scene_problem"](jam, squeeze["facets"])
    squeeze["pairs"] = min(problem[3])
    yield "squeeze", (squeeze, [jam]), None
    slip = next(iter(problem[4]))
    loaded = next(i for i, v in enumerate(squeeze["x"]) if v != "0")
    yield "a slip is no force", (with_x(squeeze, slip, 1), [jam]), "not forces"
    yield "a force that pulls", (with_x(squeeze, loaded, -1), [jam]), "not forces"
    yield "out of balance", (with_x(squeeze, loaded, Fraction(squeeze["x"][loaded]) * 2), [jam]), "no squeeze"
    wedged = (ROOT / "fixtures/rays/coin_jammed.toml").read_text()
    wedge = certified("solve", wedged)
    yield "squeeze by friction", (wedge, [wedged]), None
    yield "outside the cones", (wedge, [wedged.replace("friction = 0.75", "friction = 0.5")]), "no squeeze"
    yield "no push", (squeeze, [re.sub(r"(?m)^acceleration = \[.*?\]", "acceleration = [0, 0, 0]", jam)]), "no squeeze"
    yield "another push", changed(squeeze, [jam], push="2"), "not forces"


def main():
    for name in ("lcpush_check", "lcpush_check_box"):  # a slip of the hand is no refusal
        for words in ([], ["no_such.json", "no_such.toml"]):
            done = subprocess.run([sys.executable, ROOT / f"docs/check/{name}.py", *words], capture_output=True, text=True)
            if done.returncode != 2 or not done.stderr.startswith("usage:"):
                faults.append(f"{name} {words}: exit {done.returncode}, {done.stderr}")
    made = [(what, stamped(forgery), why) for what, forgery, why in forgeries()]
    for what, (certificate, texts), why in made:
        got = refusal(GENUINE, certificate, texts)
        if (got is None) != (why is None) or (why and why not in got):
            faults.append(f"{what}: {why}, but: {got}")
    certificate, texts = made[0][1]
    if refusal(GENUINE, {**certificate, "x": ["4/3", "14/6"]}, texts) is None:
        faults.append("another x under the old fingerprint is accepted")
    made.append(("another x", ({**certificate, "x": ["4/3", "14/6"]}, texts), "damaged"))
    gates = [m.start() for m in re.finditer(r"\brequire\(", SOURCE) if m.start() > SOURCE.index("def scene_problem")]
    for at in gates:
        without = checker(SOURCE[:at] + "(lambda *_: None)(" + SOURCE[at + len("require("):])
        if not any(why and refusal(without, *forgery) is None for _, forgery, why in made):
            line = SOURCE.count("\n", 0, at) + 1
            faults.append(f"nothing passes a checker without the gate of line {line}: "
                          f"{SOURCE[at:SOURCE.index(chr(10), at)]}")
    # What would take minutes is refused by name, with what to do.
    wide = (SCENES / "straight_slide.toml").read_text()
    wide = "facets = 256\n" + re.sub(r'shape = "points"\npoints = .*?(0\.005|-0\.005)\]\]', lambda m: (
        f'shape = "rectangle"\ncenter = [0, 0, {m.group(1)}]\nsize = [0.02, 0.02]\npoints = [20, 20]'), wide)
    (FOLDER / "wide.toml").write_text(wide)
    told = subprocess.run([TOOL, "solve", FOLDER / "wide.toml", "--certify", FOLDER / "c.json"], capture_output=True,
                          text=True, timeout=20)
    if told.returncode != 2 or "use fewer facets or points" not in " ".join(told.stderr.split()):
        faults.append(f"a wide pad of 256 facets: {told}")
    wrong = sum(why is not None for _, _, why in made)
    print(f"{wrong} forgeries refused, {len(made) - wrong} genuine ones accepted; {len(gates)} gates taken out")
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main())
