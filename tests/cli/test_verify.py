"""lcpush verify: right answers pass, whole or in part; any one number changed is found and named.

    test_verify.py TOOL SOURCE
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(source / "tests/support"))
from scene_tables import finger, pusher, table
scenes = source / "fixtures/scenes"
folder = tempfile.TemporaryDirectory()
answer_path = pathlib.Path(folder.name, "answer.json")


def run(*words):
    return subprocess.run([tool, *map(str, words)], capture_output=True, text=True)


def verify(scene, answer, *options):
    """Exit status and report (or message) of one answer."""
    answer_path.write_text(answer if isinstance(answer, str) else json.dumps(answer))
    result = run("verify", scene, answer_path, "--json", "--seconds", 600, *options)
    return result.returncode, json.loads(result.stdout) if result.stdout else result.stderr


def own_answer(scene, *options):
    result = run("solve", scene, "--json", *options)
    if result.returncode != 0:
        return None
    answer = json.loads(result.stdout)
    return {key: answer[key] for key in ("object", "contacts", "bodies")}


def parts(answer):
    """What somebody may send of an answer, by name."""
    contacts, bodies, motion = answer["contacts"], answer["bodies"], {"object": answer["object"]}

    def only(*keys, of=contacts):
        return [{key: one[key] for key in keys} for one in of]

    yield "all", answer
    yield "no names", {"contacts": only("normal_force", "friction_force", "torsion", "acceleration")}
    yield "forces", {"contacts": only("normal_force", "friction_force", "torsion")}
    yield "motion", {"object": answer["object"]}
    yield "motion and normals", {"object": answer["object"], "contacts": only("normal_force")}
    yield "motion and friction", {"object": answer["object"], "contacts": only("friction_force")}
    yield "names in another order", {"object": answer["object"], "contacts": contacts[::-1]}
    for keys in (("force", "moment"), ("force",), ("moment",), ("normal_force",)):
        sums = {"bodies": only("name", *keys, of=bodies)}
        yield f"bodies' {keys}", sums
        yield f"motion and bodies' {keys}", {**motion, **sums}
    for one in (contacts[0], contacts[-1], bodies[0], bodies[-1]):
        yield f"{one['name']} alone", {"contacts" if "position" in one else "bodies": [one]}
    yield "every other contact", {**motion, "contacts": contacts[::2]}
    yield "accelerations", {"contacts": only("name", "acceleration")}


def off_by_5_percent(answer):
    """Bodies' forces of which one component is wrong, with the motion and without."""
    for k, axis in ((k, axis) for k in range(len(answer["bodies"])) for axis in range(3)):
        bodies = [{key: body[key] for key in ("name", "force", "moment")} for body in copy.deepcopy(answer["bodies"])]
        force = bodies[k]["force"]
        if abs(force[axis]) > max(1e-9, 1e-3 * max(map(abs, force))):
            force[axis] *= 1.05
            yield f"{bodies[k]['name']} along {axis}", {"bodies": bodies}
            yield f"{bodies[k]['name']} along {axis}, motion", {"bodies": bodies, "object": answer["object"]}


def numbers(value, path=()):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from numbers(inner, path + (key,))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from numbers(inner, path + (index,))
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


def key_of(path):
    return next(word for word in reversed(path) if isinstance(word, str))


FAMILIES = {  # where a change of this number may show
    "normal_force": {"newton", "grip", "normal", "cone", "given", "dissipation", "pusher"},
    "friction_force": {"newton", "cone", "given", "dissipation", "grip"},
    "torsion": {"newton", "cone", "given", "dissipation"},
    "spin": {"given"}, "force": {"given"}, "moment": {"given"}, "closing_acceleration": None,
    "acceleration": None, "position": None,
}


def check_mutations(name, answer):
    """Every number, changed by a thousandth of the scene's unit for it."""
    force = max(abs(contact["normal_force"]) for contact in answer["contacts"])
    length = max(abs(x) for contact in answer["contacts"] for x in contact["position"])
    mass = {"straight_slide": 0.2, "soft_fingers": 0.2, "rolling": 0.5, "dropped": 0.2}[name]
    rate = max(force / mass, max(map(abs, answer["object"]["acceleration"][:3])))
    unit = {"moment": force * length, "torsion": force * length, "spin": rate / length,
            "acceleration": rate, "closing_acceleration": rate, "position": length}
    count = 0
    for path in list(numbers(answer)):
        changed = copy.deepcopy(answer)
        at = changed
        for word in path[:-1]:
            at = at[word]
        key = key_of(path)
        turns = path[0] == "object" and path[-1] >= 3
        at[path[-1]] += 1e-3 * unit.get(key, force) * (1 / length if turns else 1)
        status, report = verify(scenes / f"{name}.toml", changed)
        assert status == 1, (name, path, report)
        broken = {family for family, law in report.get("laws", {}).items() if not law["holds"]}
        if key == "position":
            assert report["verdict"] == "not this scene's data", (name, path, report)
        else:
            assert broken and report["because"].split(":")[0] in broken, (name, path, report)
        if FAMILIES[key]:
            assert broken <= FAMILIES[key], (name, path, broken)
        count += 1
    return count


# Right answers, whole and in part, for every scene that has one; with round friction, too.
count = refused = 0
copied = pathlib.Path(folder.name, "round.toml")
for scene in sorted(scenes.glob("*.toml")):
    given_facets = "".join(line for line in scene.read_text().splitlines(True) if not line.startswith("facets"))
    for law in ('facets = 8', 'facets = "round"') if scene.stem in ("tipping", "rolling", "soft_fingers") else (None,):
        at = scene if law is None else copied
        copied.write_text(f"{law}\n{given_facets}")
        answer = own_answer(at)
        if answer is None:
            continue
        for part, given in parts(answer):
            status, report = verify(at, given)
            assert status == 0 and report["verdict"] in ("same solution", "same motion, other forces"), (
                scene.stem, law, part, report)
            count += 1
        for what, given in off_by_5_percent(answer):
            assert verify(at, given)[1]["verdict"] == "not a solution", (scene.stem, law, what)
            refused += 1
        broken = run("break", at, "--json")
        if broken.returncode == 0 and '"break_force": null' not in broken.stdout:
            force = json.loads(broken.stdout)["break_force"]
            assert verify(at, broken.stdout)[1]["verdict"] == "same solution", scene.stem
            assert verify(at, {"break_force": force})[0] == 0, scene.stem
            status, report = verify(at, {"break_force": 1.05 * force + 0.01})
            assert status == 1 and "lcpush's own push breaks" in report["because"], (scene.stem, report)
assert count > 400 and refused > 150, (count, refused)

# Even pressure shares each body's sums among its points, which press one by one.
even = pathlib.Path(folder.name, "even.toml")
even.write_text(table("", gravity=[-4.8, -2.5, -0.6], planar=True, pressure="even") +
                table("[object]", mass=0.62, box=[0.09, 0.025, 0.052], force=[-1.4, -1.7, -1.2]) +
                table("[gripper]", jaws="independent") +
                "".join(finger(name, "disc", on=face, friction=friction, radius=0.005, grip_force=19.8)
                        for name, face, friction in (("l", "+z", 1.06), ("r", "-z", 0.9))) +
                pusher("p", "line", on="-y", along="z", length=0.012, points=2, friction=0.22, normal_force=19,
                       acceleration=[0.2, 0, 0]))
answer = own_answer(even)
for part, given in parts(answer):
    status, report = verify(even, given)
    assert status == 0, (part, report)
    assert (report["own"]["force_difference"] is None) == ("force" not in json.dumps(given)), (part, report)
for what, given in off_by_5_percent(answer):
    assert verify(even, given)[1]["verdict"] == "not a solution", what

# Right answers of another road: sweeps; and rounded to six digits.
for name in ("straight_slide", "rolling", "tipping"):
    scene = scenes / f"{name}.toml"
    status, report = verify(scene, own_answer(scene, "--solver", "gauss-seidel"))
    assert status == 0, (name, report)
    rounded = json.loads(json.dumps(own_answer(scene)), parse_float=lambda x: float(f"{float(x):.6g}"))
    status, report = verify(scene, rounded, "--tolerance", "1e-4")
    assert status == 0 and report["verdict"] == "same solution", (name, report)
    assert report["basis"]["refined"] and report["basis"]["residual"] < max(1e-12, report["residual"]), (name, report)

# Places count to the six digits that are given, or to the tolerance; numbers differ in the digits that are told.
rounded = json.loads(json.dumps(own_answer(even)), parse_float=lambda x: float(f"{float(x):.6g}"))
assert verify(even, rounded, "--tolerance", "1e-4")[0] == 0
for digits, tolerance, status in ((3, "0.03", 0), (2, "1e-4", 1)):
    rounded["contacts"][0]["position"] = [float(f"{x:.{digits}g}") for x in answer["contacts"][0]["position"]]
    assert verify(even, rounded, "--tolerance", tolerance)[0] == status, digits
# The one that is farthest off is named.
elsewhere = copy.deepcopy(answer)
for k, off in ((0, 1e-4), (-1, 1e-3)):
    elsewhere["contacts"][k]["position"][0] += off
said = json.dumps(verify(even, elsewhere)[1])
assert f"contact {answer['contacts'][-1]['name']} is at another place, 0.001 m" in said, said
almost = copy.deepcopy(answer)
almost["bodies"][0]["force"][1] *= 1 + 1e-7
found, lawful = re.search(r"force of l along y is (\S+) N, where its points make (\S+) N",
                          verify(even, almost, "--tolerance", "1e-9")[1]["laws"]["given"]["row"]).groups()
assert found != lawful, found

# A small grip that is missing beside a large one is missing at every tolerance.
hand = (table("", gravity=[0, 0, -9.81]) + table("[object]", mass=1e-4, box=[0.01, 0.01, 0.01]) +
        table("[gripper]", jaws="independent"))
for name, n, force, friction in (("right", [-1, 0, 0], 1e6, 0), ("left", [1, 0, 0], 1e6, 0),
                                 ("front", [0, 1, 0], 3e-4, 0.5), ("back", [0, -1, 0], 3e-4, 0.5)):
    hand += finger(name, "point", center=[-0.005 * x for x in n], normal=n, friction=friction, grip_force=force)
hand += pusher("rod", "point", center=[0, 0, -0.005], normal=[0, 0, 1], friction=0, acceleration=[0, 0, 1])
cube = pathlib.Path(folder.name, "cube.toml")
cube.write_text(hand)
given = own_answer(cube)
assert verify(cube, given)[0] == 0
for contact, normal in zip(given["contacts"], (None, None, 0, 0, 1.081e-3)):
    if normal is not None:
        contact["normal_force"], contact["friction_force"] = normal, [0, 0, 0]
given = {key: given[key] for key in ("contacts", "object")}
for tolerance in ("1e-9", "1e-6", "1e-4", "1e-2", "0.5"):
    assert verify(cube, given, "--tolerance", tolerance)[1]["verdict"] != "same solution", tolerance

# Every number counts.
mutations = sum(check_mutations(name, own_answer(scenes / f"{name}.toml"))
                for name in ("straight_slide", "soft_fingers", "rolling", "dropped"))
assert mutations > 300, mutations

# The same motion with other forces: of the slide's patches the law `pad` picks one.
slide = scenes / "straight_slide.toml"
rigid = pathlib.Path(folder.name, "rigid.toml")
text = slide.read_text()
rigid.write_text(text.replace('pressure = "pad"', 'pressure = "rigid"') if "pressure" in text
                 else 'pressure = "rigid"\n' + text)
status, report = verify(slide, own_answer(rigid))
assert status == 0 and report["verdict"] == "same motion, other forces", report
assert report["own"]["force_difference"] > 0.1, report

# One number a little wrong is that number, by so much, and not what a fit of the rest makes of it.
block = pathlib.Path(folder.name, "block.toml")
assert run("new", "box", "--size", "80 mm x 40 mm x 20 mm", "--mass", "120 g", "--pads", "20 mm x 10 mm",
           "--friction", "0.8", "--grip", "2.9 N", "-o", block).returncode == 0
own = own_answer(block)


def sums(digits=6, sign=1):
    return {"bodies": [{"name": body["name"], "force": [float(f"{sign * x:.{digits}g}") for x in body["force"]]}
                       for body in own["bodies"]]}


wrong = sums()
wrong["bodies"][2]["force"][0] = 4.7
status, report = verify(block, wrong)
assert status == 1 and [law for law in report["laws"] if not report["laws"][law]["holds"]] == ["given"], report
given = report["laws"]["given"]
assert "rounding" not in run("verify", block, answer_path).stdout  # 4.7 is not 4.64 in three digits
assert abs(given["si"] - 0.0588) < 1e-6 and given["found"] == 4.7 and abs(given["lawful"] - 4.6412) < 1e-6, given
assert abs(report["imbalance"][0] - 0.0588) < 1e-6, report
assert "because the force of wall along x is 4.7 N, where the laws leave 4.64 N: 0.059 N (1.27 %) too much" in " ".join(
    run("verify", block, answer_path).stdout.split()), given
status, report = verify(block, sums(3))  # 4.64 and 1.18 of 4.6412 and 1.1772
assert status == 1 and abs(report["laws"]["given"]["si"] - 0.0028) < 1e-5, report
said = " ".join(run("verify", block, answer_path).stdout.split())
takes = said.split("That is within the rounding of 3 digits: --tolerance ")[1].split(" takes it.")[0]
assert verify(block, sums(3), "--tolerance", takes)[1]["verdict"] == "same solution", takes
assert verify(block, sums(3), "--tolerance", "0.01")[1]["verdict"] == "same solution"
def rounded(value, digits):
    if isinstance(value, float): return float(f"%.{digits}g" % value)
    if isinstance(value, list): return [rounded(v, digits) for v in value]
    return {k: rounded(v, digits) for k, v in value.items()} if isinstance(value, dict) else value


# A whole answer in a few digits: several laws are broken by a little, and the refusal says what takes it.
for name in ("pivot", "rolling", "tipping"):
    for digits in (3, 4):
        scene_ = source / f"fixtures/scenes/{name}.toml"
        answer_path.write_text(json.dumps(rounded(json.loads(subprocess.run([tool, "solve", scene_, "--json"], capture_output=True, text=True).stdout), digits)))
        said = " ".join(run("verify", scene_, answer_path).stdout.split())
        takes = said.split("That is within the rounding of 3 digits: --tolerance ")[1].split(" takes it.")[0]
        assert run("verify", scene_, answer_path, "--tolerance", takes).returncode == 0, (name, digits, said)
still = {**sums(), "object": {"acceleration": [0.02, 0, 0, 0, 0, 0]}}
status, report = verify(block, still)
assert status == 1 and abs(report["laws"]["given"]["si"] - 0.01) < 1e-6 and "acceleration" in report["because"], report

# Forces on the bodies, or frictions on them, are told from forces on the object.
for given, words in ((sums(sign=-1), "With every force turned round all laws hold"),
                     (sums(3, sign=-1), "With every force turned round the error is"),
                     ({"contacts": [{**one, "friction_force": [-x for x in one["friction_force"]]}
                                    for one in own["contacts"]]}, "With every friction force turned round all laws hold")):
    status, report = verify(block, given)
    assert status == 1 and report["hint"].startswith(words), report
assert verify(block, wrong)[1]["hint"] is None


def changed(factor=1, of_moments=1, vector=lambda v: v, moment=None):
    moment = moment or vector
    return {"bodies": [{"name": body["name"], "force": [factor * x for x in vector(body["force"])],
                        "moment": [factor * of_moments * x for x in moment(body["moment"])]} for body in own["bodies"]]}


# So are other units and other axes.
for given, words in ((changed(1 / 9.80665), "these look like kilogram-force"), (changed(1000), "these look like millinewtons"),
                     (changed(of_moments=1000), "these look like N mm"),
                     (changed(vector=lambda v: [v[1], v[0], v[2]], moment=lambda v: [-v[1], -v[0], -v[2]]),
                      "With x and y of every vector interchanged all laws hold"),
                     (changed(vector=lambda v: [v[0], -v[2], v[1]]), "With every vector turned by -90 degrees about x"),
                     ({"object": {"acceleration": [10, 0, 0, 0, 0, 0]}}, "it looks like mm/s^2")):
    status, report = verify(block, given)
    assert status == 1 and words in (report["hint"] or ""), (words, report)
# What was not given is not turned.
assert verify(block, {"bodies": [{"name": "wall", "moment": [0, 0, 0.5]}]})[1]["hint"] is None

# Twice the prescribed motion, or none, is no rounding beside gravity, and no tolerance takes it.
for acceleration in (0.02, 0):
    given = {"object": {"acceleration": [acceleration, 0, 0, 0, 0, 0]}}
    for options in ((), ("--tolerance", 0.001), ("--tolerance", 0.1)):
        assert verify(block, given, *options)[0] == 1, (given, options)
        assert "rounding" not in run("verify", block, answer_path, *options).stdout, (given, options)
# Nor a fifth more of it, however light the block is beside its grip: then a tolerance of a third takes it.
for options, status in (((), 1), (("--tolerance", 0.001), 1), (("--tolerance", 0.3), 0)):
    light = ("--set", "object.mass=2 g")
    assert verify(block, {"object": {"acceleration": [0.012, 0, 0, 0, 0, 0]}}, *light, *options)[0] == status, options
# A contact that leaves its finger while it presses, at a fifth of the push.
for name in ("straight_slide", "rolling"):
    given = own_answer(scenes / f"{name}.toml", "--set", "object.mass=2 g")
    pressed = next(contact for contact in given["contacts"] if contact["normal_force"] > 0)
    pressed["acceleration"][0] += 0.02
    assert verify(scenes / f"{name}.toml", given, "--set", "object.mass=2 g")[0] == 1, name
# Digits that nobody prints are no rounding.
given = own_answer(slide_of := scenes / "straight_slide.toml")
given["contacts"][0]["normal_force"] *= 1.004
assert "rounding" not in run("verify", slide_of, answer_path).stdout if verify(slide_of, given)[0] == 1 else False
assert "rounding" not in run("verify", slide_of, answer_path).stdout if verify(slide_of, {"break_force": 20.2})[0] == 1 else False
assert "rounding" in run("verify", slide_of, answer_path).stdout if verify(slide_of, {"break_force": 20.05})[0] == 1 else False
# A push is slow beside F / m: what slips with it is at the limit of friction for every tolerance.
slide = scenes / "straight_slide.toml"  # 20 N
for force in (0, 2, 10, 18, 40):
    for tolerance in (0.001, 0.01):
        status, report = verify(slide, {"bodies": [{"name": "wall", "normal_force": force}]}, "--tolerance", tolerance)
        assert status == 1 and report["hint"] is None, (force, tolerance, report)
assert verify(slide, {"bodies": [{"name": "wall", "normal_force": 20.0}]}, "--tolerance", 0.001)[0] == 0
# Forces on the bodies, with normal forces of either sign.
for name in ("tipping", "straight_slide", "coin"):
    whole = json.loads(run("solve", scenes / f"{name}.toml", "--json").stdout)
    for sign in (1, -1):
        given = {"bodies": [{"name": one["name"], "force": [-x for x in one["force"]], "moment": [-x for x in one["moment"]],
                             "normal_force": sign * one["normal_force"]} for one in whole["bodies"]]}
        status, report = verify(scenes / f"{name}.toml", given)
        assert status == 1 and "With every force turned round all laws hold" in report["hint"], (name, sign, report)
# A breaking force is judged beside lcpush's own alone.
for name, said in (("jam", "it found none"), ("dropped", "the object moves before it is pushed")):
    answer_path.write_text('{"break_force": 1e9}')
    refused = run("verify", scenes / f"{name}.toml", answer_path)
    assert refused.returncode == 2 and said in " ".join(refused.stderr.split()), refused
# What is called the same is within what is allowed.
lawful = json.loads(run("break", block, "--json").stdout)["break_force"]
for off, right in ((0, True), (1e-7, True), (2e-5, False)):
    status, report = verify(block, {"break_force": lawful * (1 + off)})
    assert (status == 0) == right == (report["residual"] <= 1e-6), (off, report)

# Friction beyond its cone is so many newtons beyond it.
beyond = copy.deepcopy(own)
beyond["contacts"][0]["friction_force"][0] *= 1.5
cone = verify(block, beyond)[1]["laws"]["cone"]
more = abs(own["contacts"][0]["friction_force"][0]) / 2
assert cone["unit"] == "N" and abs(cone["si"] - more) < 1e-9 and "exceeds its cone" in cone["row"], cone

# The text: the verdict first, in words; what the solver and outsiders measure comes with -v.
for name in ("straight_slide", "straight_slide_point", "straight_slide_point_low"):
    words = ("verify", scenes / f"{name}.toml", source / f"fixtures/external/slsqp_{name}.json")
    brief, full = run(*words).stdout, run(*words, "-v").stdout
    for text in (brief, full):
        assert max(map(len, text.split("\n"))) <= 80, text
    assert "Natural map" in full and "Natural map" not in brief, (brief, full)
    assert full.split("\n\n")[1].startswith(brief.split("\n")[2]), (brief, full)
    assert " holds\n" in full and (" broken\n" in full) == (name != "straight_slide"), full
    low = " ".join(brief.split())
    assert "is allowed" in low and ("Every law holds" in low) == (name == "straight_slide"), brief
assert "Not a solution, because of dissipation: friction of wall.1" in low, brief
assert "The worst row's error is 1 m/s^2, 1.4e-01 in scaled units, where 1e-06" in low, brief

# Another scene's answer, and one with a point too few.
status, report = verify(slide, own_answer(scenes / "tipping.toml"))
assert status == 1 and report["verdict"] == "not this scene's data", report
short = own_answer(slide)
left_out = short["contacts"].pop()
assert verify(slide, short)[0] == 0
short["contacts"][0]["normal_force"] += left_out["normal_force"] + 1
assert verify(slide, short)[0] == 1
del short["contacts"][0]["name"]
status, report = verify(slide, short)
assert status == 1 and "not every contact has a name, and there are 9 instead of 10" in report["because"], report
for given, words in (({"bodies": [{"name": "wal", "force": [0, 0, 1]}]},
                      'no body is called "wal"; there are left, right and wall'),
                     ({"contacts": [{"name": "wall", "normal_force": 1}]}, 'no contact is called "wall"; there are left.1, '),
                     ({"bodies": [{"name": "wall", "force": [0, 0, 1]}] * 2}, 'body "wall" stands twice')):
    status, report = verify(slide, given)
    assert status == 1 and words in report["because"], report

# Raw problems: two solutions, a wrong one, a stationary point of z'w that is none.
def raw(M, q, z, *options):
    answer_path.write_text(json.dumps({"z": z}))
    result = run("verify", "--M", M, "--q", q, answer_path, "--json", *options)
    return result.returncode, json.loads(result.stdout) if result.stdout else result.stderr

two = ("1 2; 2 1", "-1 -1")  # (1, 0) and (0, 1) and (1/3, 1/3)
verdicts = sorted(raw(*two, z)[1]["verdict"] for z in ([1, 0], [0, 1], [1 / 3, 1 / 3]))
assert verdicts == ["another valid solution"] * 2 + ["same solution"], verdicts
status, report = raw(*two, [1, 0])  # exact: no row is the worst
assert report["residual"] == 0 and report["row"] is report["z"] is report["w"] is None, report
status, report = raw(*two, [1, 0.5])
assert status == 1 and report["verdict"] == "not a solution" and report["row"] in (1, 2), report
status, report = raw("0 1; -1 0", "-1 2", [1, 1])
assert status == 1, report
status, report = raw(*two, [1, 0, 0])
assert status == 1 and report["verdict"] == "not this scene's data", report
status, report = raw("1 0; 0 0", "-1 1", [1, 0], "--free", "2")
assert status == 1, report

# Bad input is exit 2, with file, line and what to do.
for text, words in (("{", "expected a key"), ("[1]", "an answer is a JSON object, got an array"),
                    ('{"status": "solved"}', "nothing to verify"),
                    ('{"object": {"acceleration": [1, 2]}}', "array of 6 numbers, got 2"),
                    ('{"object": {"acceleration": [1, 2, 3, 4, 5, NaN]}}', "NaN is no JSON"),
                    ('{"contacts": [{"normal_force": "1"}]}', "must be a number, got a string"),
                    ('{"a": 1, "a": 2}', '"a" comes twice'),
                    ('{"break_force": 1, "object": {"acceleration": [1, 2, 3, 4, 5, 6]}}', "another moment")):
    status, message = verify(slide, text)
    assert status == 2 and str(answer_path) in message and words in message.replace("\n", " "), (text, message)
status, message = verify(scenes / "jam.toml", '{"contacts": [{"name": "left.1", "normal_force": 1}]}')
assert status == 2 and "give also the object's acceleration" in message.replace("\n", " "), message
status, message = verify(slide, "\n\n  [1,]")
assert f"{answer_path}:3: " in message, message
for words in (("verify", slide), ("verify", slide, answer_path, answer_path),
              ("verify", slide, answer_path, "--tolerance", "2"),
              ("verify", slide, answer_path, "--free", "1"), ("verify", slide, "no_such_file.json")):
    result = run(*words)
    assert result.returncode == 2 and result.stderr and not result.stdout, (words, result)
print(f"verify: {count} right answers, {mutations} changed numbers: ok")
