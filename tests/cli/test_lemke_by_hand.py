"""docs/teach/lemke_by_hand.md beyond its console blocks: typed answers, JSON keys, equations, exercises."""
import itertools
import json
import pathlib
import re
import subprocess
import sys
from fractions import Fraction

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])
page = (source / "docs/teach/lemke_by_hand.md").read_text()


def run(*words, typed=""):
    return subprocess.run([tool, "pivots", *words], cwd=source, text=True, input=typed,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout


def trace(*words):
    return json.loads(run(*words, "--json"))


def section(title):
    return page.split(f"\n## {title}", 1)[1].split("\n## ", 1)[0]


# The coin's fixtures are what its scene starts with, and the page that is written for nothing.
def read_mtx(name):
    lines = [line for line in (source / "fixtures/textbook" / name).read_text().split("\n")
             if line and not line.startswith("%")]
    rows, columns = map(int, lines[0].split())
    numbers = [Fraction(x) for x in lines[1:]]
    return [[numbers[j * rows + i] for j in range(columns)] for i in range(rows)]


start = trace("fixtures/scenes/coin.toml", "--exact")["runs"][0]["start"]
M, q = read_mtx("coin.M.mtx"), read_mtx("coin.q.mtx")
assert start["rows"] == [f"w{i}" for i in range(1, 8)]
assert [[Fraction(x) for x in row] for row in start["entries"]] == [row + [1] for row in M]
assert [[Fraction(x)] for x in start["values"]] == q
assert "A coin pushed over a table" in run("--format", "html")

# Section 3: every equation holds for all z1, z2, z0. Each side is linear, so a few points do.
equations = 0
by_hand = re.sub(r"```.*?```", "", section("3 Two unknowns"), flags=re.S)
for line in re.findall(r"^    (.*)$", by_hand, flags=re.M):
    line = line.split("]")[-1]  # beside M and q stand the first two
    sides = [re.sub(r"([\d)])\s+(?=[wz(])", r"\1*", side) for side in line.split("=")]
    sides = [re.sub(r"(?<![wz\d/])(\d+)(?![\d/])", r"Fraction(\1)", side) for side in sides]
    sides = [re.sub(r"(?<![wz\d])(\d+)/(\d+)", r"Fraction(\1, \2)", side) for side in sides]
    for z1, z2, z0 in itertools.product((0, 1), (0, 1), (0, 1)):
        at = {"z1": z1, "z2": z2, "z0": z0, "w1": -5 + 2 * z1 + z2 + z0,
              "w2": -6 + z1 + 2 * z2 + z0, "Fraction": Fraction}
        values = {eval(side.strip(), dict(at)) for side in sides}
        assert len(values) == 1, (line, sides, values)
    equations += len(sides) - 1
assert equations == 11, equations

# What is typed to --choose, as shown.
typed = re.findall(r"```text\n\$ printf '(.*?)' \| lcpush pivots (.*?)\n(.*?)\n```", page, flags=re.S)
assert len(typed) == 1
for answers, words, shown in typed:
    printed = run(*[word.strip('"') for word in re.findall(r'"[^"]*"|\S+', words)],
                  typed=answers.replace("\\n", "\n"))
    pattern = "\n".join(".*" if line == "..." else re.escape(line) for line in shown.split("\n"))
    assert re.fullmatch(pattern, printed.rstrip("\n"), flags=re.S), printed


# Every key of the JSON is described, and every key described exists. What is inside of the page's
# drawing is for the page alone.
DRAWING = {"views", "marks", "verbs", "key", "longest_force", "fastest"}


def keys(value):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            if key not in DRAWING:
                yield from keys(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from keys(inner)


written = set()
for words in (["fixtures/scenes/coin.toml", "--exact"], ["fixtures/scenes/squeeze.toml"],
              ["fixtures/rays/runaway.toml"],
              ["fixtures/textbook/kostreva_1.M.mtx", "fixtures/textbook/kostreva_1.q.mtx",
               "--first-row"]):
    written |= set(keys(trace(*words)))
assert not written & DRAWING, "the drawing is the page's own"
inside = run("--format", "html").split('id="trace">')[1].split("</script>")[0]
written |= set(keys(json.loads(inside)))
described_text = page.split("\n### JSON\n")[1].split("\n## ")[0].split("```\n")[-1]
described = set(re.findall(r"`([a-z_0-9]+)`", described_text))
assert written <= described, written - described
values = {"solved", "cycle", "pivot_limit", "numerical_breakdown", "fractions", "decimals",
          "lexicographic", "first_row", "generic", "chosen", "null", "none", "artificial",
          "tie_column", "largest_pivot", "solve"}
assert described - written <= values, described - written - values

# Ten exercises, each with an answer that is a transcript and with a test.
tests = (source / "tests/lcp/pivots/test_exercises.cpp").read_text()
exercises = re.split(r"^\*\*Exercise (\d+): ", section("7 Ten exercises"), flags=re.M)[1:]
assert exercises[::2] == [str(k) for k in range(1, 11)]
for number, text in zip(exercises[::2], exercises[1::2]):
    answer = re.search(r"<details><summary>Answer</summary>\n\n(.*)\n\n</details>", text, flags=re.S)
    assert answer and "lcpush pivots " in answer[1], number
    assert f'TEST_CASE("exercise {number}: ' in tests, number

print("lemke_by_hand: ok")
