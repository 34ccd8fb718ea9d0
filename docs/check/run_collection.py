"""Scores a solver on fixtures/collection (docs/check/collection.md):
    run_collection.py --command "build/release/lcpush lcp {M} {q} [--free {free}] --json"
    run_collection.py --plugin my_solver.py:solve [--tag degenerate] [--seconds 10] [--all]"""
import argparse, collections, importlib.util, json, pathlib, re, shlex, signal, subprocess, sys, tempfile
from fractions import Fraction
FOLDER = pathlib.Path(__file__).resolve().parents[2] / "fixtures/collection"
TOLERANCE = 1e-6  # of what a row consists of
def load(tag=None):
    names = [entry["name"] for entry in json.loads((FOLDER / "index.json").read_text())["problems"]]
    return [p for p in (json.loads((FOLDER / f"{name}.json").read_text()) for name in names) if not tag or tag in p["tags"]]
def matrix_market(rows, columns):  # rows of [column from 1, value]
    cells = [f"{i} {j} {value!r}" for i, row in enumerate(rows, 1) for j, value in row]
    return "\n".join(["%%MatrixMarket matrix coordinate real general", f"{len(rows)} {columns} {len(cells)}", *cells, ""])
def texts(p):  # of M.mtx and q.mtx
    return matrix_market(p["M"], len(p["q"])), matrix_market([[[1, v]] if v else [] for v in p["q"]], 1)
def is_right(p, z):  # every row is judged by its own terms, those of the certified answer among them
    known = [abs(float(Fraction(x))) for x in p["certificate"]["x"]] if p["expected"] == "answer" else [0.0] * len(z)
    sizes, top = [abs(x) + y for x, y in zip(z, known)], max(map(abs, z))
    w = [q + sum(v * z[j - 1] for j, v in row) for row, q in zip(p["M"], p["q"])]
    scale = [abs(q) + sum(abs(v) * sizes[j - 1] for j, v in row) + TOLERANCE * top * max((abs(v) for _, v in row), default=0)
             for row, q in zip(p["M"], p["q"])]
    felt = [0.0] * len(z)  # how much of some row an unknown makes up
    for row, size in zip(p["M"], scale):
        for j, v in row: felt[j - 1] = max(felt[j - 1], abs(v * z[j - 1]) / size if size else 0)
    small, gone = [abs(a) <= TOLERANCE * b for a, b in zip(w, scale)], [share <= TOLERANCE for share in felt]
    return all(small[i] if i + 1 in p["free"] else (small[i] or w[i] > 0 and gone[i]) and (z[i] >= 0 or gone[i])
               for i in range(len(z)))
def by_command(command):  # which prints JSON with "z"; [..] is left out if no unknown is free
    def solve(p):
        with tempfile.TemporaryDirectory() as name:
            files = {k: pathlib.Path(name) / f"{k}.mtx" for k in "Mq"}
            for path, text in zip(files.values(), texts(p)): path.write_text(text)
            words = shlex.split(re.sub(r"\[(.*?)\]", r"\1" if p["free"] else "", command))
            words = [word.format(free=",".join(map(str, p["free"])), **files) for word in words]
            output = json.loads(subprocess.run(words, capture_output=True, text=True).stdout)
            return output["z"] if output.get("status", "solved") == "solved" else None
    return solve
def by_plugin(path, function):  # function(M, q, free), rows from 0: z, or None for no answer
    spec = importlib.util.spec_from_file_location("plugin", path)
    spec.loader.exec_module(module := importlib.util.module_from_spec(spec))
    dense = lambda p: [[{j: v for j, v in row}.get(j, 0.0) for j in range(1, len(p["q"]) + 1)] for row in p["M"]]
    return lambda p: getattr(module, function)(dense(p), p["q"], [i - 1 for i in p["free"]])
def verdict(p, solve, seconds=10):
    signal.signal(signal.SIGALRM, lambda *_: (_ for _ in ()).throw(TimeoutError())), signal.alarm(seconds)
    try: z = solve(p)
    except Exception as error: return f"missed ({type(error).__name__})"
    finally: signal.alarm(0)
    if z is None: return "missed" if p["expected"] == "answer" else "right"
    return "right" if is_right(p, [float(x) for x in z]) else "wrong"
if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("command", "plugin", "tag"): parser.add_argument("--" + name)
    parser.add_argument("--seconds", type=int, default=10), parser.add_argument("--all", action="store_true")
    asked = parser.parse_args()
    solve = by_command(asked.command) if asked.command else by_plugin(*asked.plugin.split(":"))
    verdicts = {p["name"]: verdict(p, solve, asked.seconds) for p in load(asked.tag)}
    print("\n".join(f"{name}: {said}" for name, said in verdicts.items() if asked.all or said != "right"))
    print(", ".join(f"{count} {said}" for said, count in collections.Counter(v.split()[0] for v in verdicts.values()).most_common()))
