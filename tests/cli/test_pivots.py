"""lcpush pivots: formats, switches, messages; and its traces pivoted again by other arithmetic."""
import json
import pathlib
import random
import subprocess
import sys
from fractions import Fraction

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*words, typed=""):
    return subprocess.run([tool, "pivots", *map(str, words)], cwd=source, text=True, input=typed,
                          capture_output=True)


def trace(*words, status=0):
    result = run(*words, "--json")
    assert result.returncode == status, (words, result.returncode, result.stderr)
    return json.loads(result.stdout)


def pair(value):
    """(times S, finite) of a VALUE."""
    numbers = value if isinstance(value, list) else [0, value]
    return tuple(Fraction(x) for x in numbers)


class Replay:
    """The dictionary, pivoted in fractions from what the trace starts with."""

    def __init__(self, start):
        self.rows, self.columns = list(start["rows"]), list(start["columns"])
        self.entries = [[Fraction(x) for x in row] for row in start["entries"]]
        self.values = [list(pair(v)) for v in start["values"]]

    def exchange(self, r, c):
        pivot = self.entries[r][c]
        solved = [-x / pivot for x in self.entries[r]]
        solved[c] = 1 / pivot
        value = [-x / pivot for x in self.values[r]]
        for i, row in enumerate(self.entries):
            if i == r:
                continue
            factor = row[c]
            self.entries[i] = [factor * s if j == c else x + factor * s
                               for j, (x, s) in enumerate(zip(row, solved))]
            self.values[i] = [x + factor * v for x, v in zip(self.values[i], value)]
        self.entries[r], self.values[r] = solved, value
        self.rows[r], self.columns[c] = self.columns[c], self.rows[r]


def check_exact(t):
    """Every number of an exact trace, and that every choice was right."""
    n = t["size"]
    replay = Replay(t["runs"][0]["start"])
    for k, pivot in enumerate(t["pivots"]):
        shown = pivot["tableau"]
        assert shown["rows"] == replay.rows and shown["columns"] == replay.columns, k
        assert [[Fraction(x) for x in row] for row in shown["entries"]] == replay.entries, k
        assert [pair(v) for v in shown["values"]] == [tuple(v) for v in replay.values], k
        r, c = shown["row"], shown["column"]
        assert replay.rows[r] == pivot["leaving"] and replay.columns[c] == pivot["entering"], k
        ratios = []
        for value, row, ratio in zip(replay.values, replay.entries, pivot["ratios"]):
            falls = row[c] > 0 and tuple(value) < (0, 0) if k == 0 else row[c] < 0
            assert falls == (ratio is not None), k
            ratios.append(tuple(-x / row[c] for x in value) if falls else None)
            assert ratio is None or pair(ratio) == ratios[-1], k
        best = (max if k == 0 else min)(ratio for ratio in ratios if ratio is not None)
        tied = [name for name, ratio in zip(replay.rows, ratios) if ratio == best]
        assert pivot["leaving"] in tied, k
        assert sorted(pivot["ties"]) == (sorted(tied) if len(tied) > 1 else []), k
        assert (pivot["tie_break"] == "none") == (len(tied) == 1) or t["free"] > 0, k
        if "z0" in tied:
            assert pivot["leaving"] == "z0", k
        replay.exchange(r, c)
        assert pivot["basis"] == replay.rows, k
        z0 = replay.values[replay.rows.index("z0")] if "z0" in replay.rows else (0, 0)
        assert pair(pivot["z0"]) == tuple(z0), k
        if k > 0:
            left = t["pivots"][k - 1]["leaving"]
            complement = {"w": "z", "z": "w"}[left[0]] + left[1:]
            assert pivot["entering"] == complement, k
    # Before a ray is believed the basis is factored afresh, its rows in another order.
    assert sorted(t["final"]["basis"]) == sorted(replay.rows)
    assert len(t["variables"]) == 2 * n + 1
    return replay


# Traces of problems and scenes, number by number.
books = sorted((source / "fixtures/textbook").glob("*.M.mtx"))
assert len(books) > 10
for M in books:
    q = M.with_name(M.name.replace(".M.", ".q."))
    result = run(M, q, "--exact", "--json")
    assert result.returncode in (0, 1), (M, result.stderr)
    t = json.loads(result.stdout)
    check_exact(t)
    assert t["status"] in ("solved", "ray") and (t["status"] == "solved") == t["proved"], M
for scene in ("coin", "lever", "straight_slide_point", "rolling", "dropped", "three_finger_hand"):
    t = trace(f"fixtures/scenes/{scene}.toml", "--exact")
    check_exact(t)
    assert t["proved"] and t["scene"]["bodies"], scene

# Random problems with many ties: whole numbers from -2 to 2.
rng = random.Random(7)
ends = set()
for case in range(60):
    n = rng.randint(1, 6)
    text = "; ".join(" ".join(str(rng.randint(-2, 2)) for _ in range(n)) for _ in range(n))
    q = " ".join(str(rng.randint(-2, 1)) for _ in range(n))
    for rule in ([], ["--first-row"]):
        result = run("--M", text, f"--q={q}", "--exact", "--json", *rule)
        t = json.loads(result.stdout)
        ends.add(t["status"])
        if t["pivots"]:
            check_exact(t)
        assert result.returncode == (0 if t["status"] == "solved" else 1)
        if t["cycle"]:
            first, length = t["cycle"]["from_pivot"], t["cycle"]["length"]
            assert sorted(t["pivots"][first]["basis"]) == sorted(
                t["pivots"][first + length]["basis"])
assert {"solved", "ray"} <= ends, ends

# A planted error is seen.
t = trace("--M", "2 1; 1 2", "--q", "-5 -6", "--exact")
t["pivots"][1]["tableau"]["entries"][0][0] = "7"
try:
    check_exact(t)
except AssertionError:
    pass
else:
    sys.exit("a wrong number in a tableau was not seen")

# Murty's family: 2^n - 1 pivots after the entry of z0, which is pivot 0 and counted.
for n in range(1, 13):
    M = "; ".join(" ".join("2" if j < i else "1" if j == i else "0" for j in range(n))
                  for i in range(n))
    q = " ".join(str(2 ** (n - i) - 2 ** (n + 1)) for i in range(n))
    t = trace("--M", M, f"--q={q}", "--exact")
    assert len(t["pivots"]) == 2 ** n and t["pivots"][0]["entering"] == "z0", n

# Formats.
latex = run("--M", "2 1; 1 2", "--q", "-5 -6", "--exact", "--format", "latex").stdout
assert latex.count("\\begin{array}") == latex.count("\\end{array}") == 4
assert latex.count("{") == latex.count("}") and "\\boxed{-3}" in latex
assert "\\tfrac{4}{3}" in latex
page = run("--format", "html").stdout
assert page.startswith("<!DOCTYPE html>") and "A coin pushed over a table" in page
assert "http://" not in page.replace("http://www.w3.org", "") and "https://" not in page
inside = page.split('id="trace">')[1].split("</script>")[0]
assert json.loads(inside)["pivots"][0]["tableau"] is None
evil = run("--M", "1", "--q", "-1", "--format", "html").stdout
assert evil.count("</script>") == page.count("</script>")

# A large problem: how it ended and the answer by body, in 20 lines; all of it with -v, ties cut.
slide = "fixtures/scenes/straight_slide.toml"
short, whole = run(slide).stdout, run(slide, "-v").stdout
assert short.splitlines()[2].startswith("61 unknowns, 49 pivots: too many") and len(short.splitlines()) <= 20, short
for body in ("left", "right"):
    row = next(line.split() for line in short.splitlines() if line.split()[:1] == [body])
    assert row[1:] == ["20", "4", "4", "4"], row  # 20 N on its four points, which all press and slide
tied = [line for line in whole.split("\n\n") if "  tied: " in line]
assert tied and all(len(block.split("tied: ")[1].split(";")[0].split(", ")) <= 6 for block in tied)

# As solved: the run behind `solve`.
solved = json.loads(subprocess.run(
    [tool, "solve", "fixtures/scenes/tipping.toml", "--json"], cwd=source, text=True,
    capture_output=True, check=True).stdout)
t = trace("fixtures/scenes/tipping.toml", "--as-solved")
assert len(t["pivots"]) == solved["pivots"] and t["as_solved"] and t["rule"] == "generic"
t = trace("fixtures/textbook/cps_4_4_7.M.mtx", "fixtures/textbook/cps_4_4_7.q.mtx", "--as-solved")
assert [round(z, 9) for z in t["final"]["z"]] == [0, 1, 3]

# Doubles never blame the rule for a basis that comes back, and call nothing solved that is infinite.
t = trace("fixtures/scenes/screw_driving.toml", "--facets", "8")
assert t["status"] == "solved" and len(t["pivots"]) == 70
big = trace("--M", "1e-300", "--q=-1e300")
assert big["final"]["z"] == ["1" + "0" * 600], big["final"]
assert trace("--M", "1", "--q=-1e-400", "--exact")["final"]["z"] == ["1/1" + "0" * 400]

# Choosing: wrong rows are explained, ties may be taken, the end of the input leaves it to the rule.
result = run("--M", "2 1; 1 2", "--q", "-5 -6", "--choose", "--json", typed="w1\nz9\nw2\nz0\nw1\nz0\n")
said = result.stderr
assert result.returncode == 0 and json.loads(result.stdout)["status"] == "solved"
assert "w1 needs only z0 = 5" in said and '"z9" is no row' in said
assert "z0 reaches zero at 3, but w1 gets there first, at 1" in said
result = run("fixtures/textbook/kostreva_1.M.mtx", "fixtures/textbook/kostreva_1.q.mtx", "--choose",
             "--json", typed="3\n")
assert "Right" in result.stderr and "the rule's choice" in result.stderr
assert json.loads(result.stdout)["pivots"][0]["leaving"] == "w3"

# Cycling, limits and covers.
cycling = ("fixtures/textbook/kostreva_2.M.mtx", "fixtures/textbook/kostreva_2.q.mtx")
t = trace(*cycling, "--first-row", "--exact", status=1)
assert t["status"] == "cycle" and t["cycle"]["length"] == 4
t = trace("--M", "2 1; 1 2", "--q", "-5 -6", "--max-pivots", "1", status=1)
assert t["status"] == "pivot_limit" and len(t["pivots"]) == 1
assert trace("--M", "2 1; 1 2", "--q", "-5 -6", "--cover", "1/2,3", "--exact")["pivots"][0][
    "z0"] == "10"

# What the lexicographic rule compares, and that the run with such a q goes the same way.
kostreva = ["fixtures/textbook/kostreva_1.M.mtx", "fixtures/textbook/kostreva_1.q.mtx", "--exact"]
told = " ".join(run(*kostreva).stdout.split())
assert "w1 at 1 - e; w2 at 1 - e^2; w3 at 1 + ..; the largest leaves" in told, told
assert "w2 at 1/3 e + ..; z3 at e + ..; the least leaves" in told, told
small = ["1 2 0; 0 1 2; 2 0 1", f"-999/1000 {Fraction(1, 10 ** 6) - 1} {Fraction(1, 10 ** 9) - 1}"]
assert [pivot["leaving"] for pivot in trace(*kostreva)["pivots"]] == [
    pivot["leaving"] for pivot in trace("--M", small[0], "--q", small[1], "--exact")["pivots"]]
assert "z = 0" in run("--M", "1", "--q", "1").stdout

# Mistakes.
coin = "fixtures/scenes/coin.toml"

for words, message in [
    ([], "name a scene"),
    (["--M", "1"], "--M and --q go together"),
    ([coin, "--z0-last", "--choose"], "does not go with it"),
    (["--M", "1/0", "--q", "1"], "is not a fraction"),
    (["--M", "1", "--q", "1", "--cover", "0"], "numbers > 0"),
    (["--M", "1", "--q", "1", "--cover", "1,2"], "wants 1 numbers"),
    (["--M", "1", "--q", "1", "--facets", "8"], "is about scenes"),
    (["--M", "1 2", "--q", "1"], "must be square"),
    ([coin, "--facets", "5"], "even number from 4 to 256"),
    ([coin, "--pressure", "hard"], "pad, even or rigid"),
    ([coin, "--as-solved", "--exact"], "replays what"),
    ([coin, "--first-row", "--choose"], "does not go with it"),
    ([coin, "--max-pivots", "0"], "whole number from 1"),
    ([coin, "--format", "pdf"], "--format is text, json, latex, svg or html"),
    ([coin, "--M", "1", "--q", "1"], "not both"),
    (["no_such.toml"], "no_such.toml"),
]:
    result = run(*words)
    assert result.returncode == 2 and message in result.stderr, (words, result.stderr)
    assert result.stdout == "", words
print("pivots: ok")
