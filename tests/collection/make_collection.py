"""Makes fixtures/collection: 300 problems, each with a certificate that docs/check/lcpush_check.py accepts.

    python3 tests/collection/make_collection.py build/release/lcpush .            writes the folder
    python3 tests/collection/make_collection.py build/release/lcpush . --check    says what would differ

What has no certificate, or would take much room, is left out; random pushes fill up what is missing.
--check compares the problems, not the certificates: there may be other answers.
"""
import collections
import hashlib
import importlib.util
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

TOOL, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
FOLDER, COUNT, ROOM, MOST_PAIRS = ROOT / "fixtures/collection", 300, 25000, 10
sys.path.insert(0, str(ROOT / "tests/collection"))
sys.dont_write_bytecode = True
import collection_matrices
import collection_scenes


def module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    spec.loader.exec_module(loaded := importlib.util.module_from_spec(spec))
    return loaded


CHECKER, RUNNER = (module(ROOT / "docs/check" / name) for name in ("lcpush_check.py", "run_collection.py"))


def certified(problem):
    """The certificate that the tool writes, once the checker has accepted it; or None."""
    given = [problem["scene"]] if "scene" in problem else RUNNER.texts(problem)
    with tempfile.TemporaryDirectory() as name:
        files = [pathlib.Path(name) / f"{k}{'.toml' if 'scene' in problem else '.mtx'}" for k in range(len(given))]
        for path, text in zip(files, given):
            path.write_text(text)
        words = ["solve" if "scene" in problem else "lcp", *files]
        words += ["--free", ",".join(map(str, problem["free"]))] if problem["free"] and "scene" not in problem else []
        into = pathlib.Path(name) / "certificate.json"
        subprocess.run([TOOL, *words, "--json", "--certify", into], capture_output=True, check=False)
        if not into.exists():
            return None
        certificate = json.loads(into.read_text())
    CHECKER.check(certificate, [text.encode() for text in given])
    return certificate


def exact(value):
    return Fraction(value if isinstance(value, int) else repr(value))


def solved(A, b):
    """The one x with A x = b; None if there is none, False if there are many."""
    rows, n, at = [row[:] + [v] for row, v in zip(A, b)], len(b), 0
    for k in range(n):
        pivot = next((i for i in range(at, n) if rows[i][k]), None)
        if pivot is None:
            continue
        rows[at], rows[pivot] = rows[pivot], rows[at]
        rows[at] = [v / rows[at][k] for v in rows[at]]
        for i in range(n):
            if i != at and rows[i][k]:
                rows[i] = [v - rows[i][k] * u for v, u in zip(rows[i], rows[at])]
        at += 1
    if at < n:
        return None if any(row[-1] for row in rows[at:]) else False
    return [row[-1] for row in rows]


def all_answers(L, q, free):
    """Of all complementary cones; whether some cone has a whole set of them, or might."""
    n, pairs, found, several = len(q), [i for i in range(len(q)) if i not in free], set(), False
    for active in itertools.product((False, True), repeat=len(pairs)):
        basic = [i for i, on in zip(pairs, active) if on] + sorted(free)
        x = solved([[L[i].get(j, Fraction(0)) for j in basic] for i in basic], [-q[i] for i in basic])
        if x is False:
            several = True
        if not x and basic:
            continue
        z = [Fraction(0)] * n
        for i, value in zip(basic, x):
            z[i] = value
        w = [q[i] + sum((v * z[j] for j, v in L[i].items() if z[j]), Fraction(0)) for i in range(n)]
        if all(z[i] >= 0 and w[i] >= 0 for i in pairs):
            found.add(tuple(z))
    return sorted(found), several


def finish(problem, L, q):
    """With certificate and answers; None if it is none for the collection."""
    certificate = certified(problem)
    if certificate is None:
        return None
    problem["expected"] = {"answer": "answer", "squeeze": "jam", "no_answer": "none"}[certificate["proof"]]
    problem["certificate"] = certificate
    free = {i - 1 for i in problem["free"]}
    if len(q) - len(free) <= MOST_PAIRS:
        answers, several = all_answers(L, q, free)
        problem["answers"] = {"isolated": [[str(v) for v in z] for z in answers], "sets_besides": several}
        if problem["expected"] == "answer" and not several:
            assert [str(Fraction(v)) for v in certificate["x"]] in problem["answers"]["isolated"], problem["name"]
        if problem["expected"] == "none":
            assert not answers, problem["name"]
    return problem if len(text_of(problem)) <= ROOM else None


def text_of(problem):
    """A row of M a line, so that a change can be read."""
    short = lambda value: json.dumps(value, separators=(",", ":"), ensure_ascii=False)
    lines = [f'"{key}":' + ("[\n" + ",\n".join(map(short, value)) + "]" if key == "M" else short(value))
             for key, value in problem.items()]
    return "{" + ",\n".join(lines) + "}\n"


def of_scene(name, text, tags, provenance):
    facets = int(re.search(r"^facets = (\d+)", text, flags=re.M)[1])
    L, q0, q1, free, _ = CHECKER.scene_problem(text, facets)
    q = [a + b for a, b in zip(q0, q1)]
    problem = {"name": name, "tags": tags, "provenance": provenance, "free": [i + 1 for i in free], "scene": text,
               "M": [[[j + 1, float(v)] for j, v in sorted(row.items()) if v] for row in L], "q": [float(v) for v in q]}
    return finish(problem, L, q)


def of_matrix(name, M, q, tags, provenance):
    problem = {"name": name, "tags": tags, "provenance": provenance, "free": [],
               "M": [[[j + 1, v] for j, v in enumerate(row) if v] for row in M], "q": q}
    return finish(problem, [{j: exact(v) for j, v in enumerate(row) if v} for row in M], [exact(v) for v in q])


def fixture_problems():
    tags = {"jam": ["jam"], "coin_jammed": ["jam"], "vise": ["bistable"], "rolling_two_answers": ["bistable"]}
    for folder in ("scenes", "rays", "regressions"):
        for path in sorted((ROOT / "fixtures" / folder).glob("*.toml")):
            text = collection_scenes.without_comments(path.read_text())
            if 'pressure = "even"' not in text:
                at = text.index("\n[")
                yield of_scene(path.stem, text[:at] + "\nfacets = 4" + text[at:], tags.get(path.stem, ["push"]) + ["fixture"],
                               f"fixtures/{folder}/{path.name} of lcpush, with four facets")
    for path in sorted((ROOT / "fixtures/textbook").glob("*.M.mtx")):
        rows, q = (CHECKER.matrix(path.with_name(path.name.replace(".M.", f".{k}.")).read_text()) for k in "Mq")
        plain = lambda v: int(v) if v.denominator == 1 else float(v)
        M = [[plain(row.get(j, Fraction(0))) for j in range(len(rows))] for row in rows]
        yield of_matrix("book_" + path.name.split(".")[0], M, [plain(row.get(0, Fraction(0))) for row in q], ["textbook"],
                        "fixtures/README.md of lcpush names the source")


def problems():
    yield from filter(None, fixture_problems())
    for family in collection_matrices.FAMILIES:
        source = collection_matrices.SOURCES.get(family, "tests/collection/collection_matrices.py of lcpush")
        yield from filter(None, (of_matrix(*made, source) for made in collection_matrices.problems(family)))
    for family, (_, count, _) in collection_scenes.FAMILIES.items():
        made = (of_scene(*given, "tests/collection/collection_scenes.py of lcpush") for given in collection_scenes.scenes(family))
        yield from itertools.islice(filter(None, made), count)
    yield from filter(None, (of_scene(f"more_{name}", text, tags, "tests/collection/collection_scenes.py of lcpush")
                             for name, text, tags in itertools.islice(collection_scenes.scenes("stack"), 100, None)))


def index_of(made):
    entries = [{"name": p["name"], "kind": "scene" if "scene" in p else "matrix", "n": len(p["q"]), "free": len(p["free"]),
                "expected": p["expected"], "answers": len(p["answers"]["isolated"]) if "answers" in p else None,
                "tags": p["tags"], "provenance": p["provenance"],
                "sha256": hashlib.sha256(text_of(p).encode()).hexdigest()} for p in made]
    head = '{"licence":"CC0-1.0",\n"problems":[\n'
    return head + ",\n".join(json.dumps(entry, separators=(",", ":"), ensure_ascii=False) for entry in entries) + "]}\n"


def main():
    made = list(itertools.islice(problems(), COUNT))
    assert len(made) == COUNT and len({p["name"] for p in made}) == COUNT, len(made)
    if "--check" in sys.argv:
        kept = {p["name"]: p for p in RUNNER.load()}
        core = lambda p: {k: p[k] for k in ("name", "tags", "free", "M", "q", "expected")} | {"scene": p.get("scene")}
        wrong = [p["name"] for p in made if p["name"] not in kept or core(kept[p["name"]]) != core(json.loads(text_of(p)))]
        print(f"{len(made)} problems made again, {len(wrong)} differ: {', '.join(wrong)}")
        return 1 if wrong or len(kept) != COUNT else 0
    for path in FOLDER.glob("*.json"):
        path.unlink()
    for p in made:
        (FOLDER / f"{p['name']}.json").write_text(text_of(p))
    (FOLDER / "index.json").write_text(index_of(made))
    print(collections.Counter(p["expected"] for p in made), collections.Counter(tag for p in made for tag in p["tags"]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
