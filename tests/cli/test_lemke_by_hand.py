"""docs/teach/ beyond its console blocks: equations, figures, typed answers, exercises, JSON keys, the
counts and the rules of from_coin_to_slide.md, and links to sections."""
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from xml.etree import ElementTree

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])
teach = source / "docs/teach"
lecture, exercise_page, command_page, bridge = (
    (teach / f"{name}.md").read_text()
    for name in ("lemke_by_hand", "exercises", "command", "from_coin_to_slide"))


def run(*words, typed=""):
    return subprocess.run([tool, "pivots", *words], cwd=source, text=True, input=typed,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout


def trace(*words):
    return json.loads(run(*words, "--json"))


def section(title):
    return lecture.split(f"\n## {title}", 1)[1].split("\n## ", 1)[0]


# The coin's fixtures are what its scene starts with, and the page that is written for nothing.
def read_mtx(name):
    lines = [line for line in (source / "fixtures/textbook" / name).read_text().split("\n")
             if line and not line.startswith("%")]
    rows, columns = map(int, lines[0].split())
    numbers = [Fraction(x) for x in lines[1:]]
    return [[numbers[j * rows + i] for j in range(columns)] for i in range(rows)]


start = trace("fixtures/scenes/coin.toml", "--exact")["runs"][0]["start"]
M, q = read_mtx("coin.M.mtx"), read_mtx("coin.q.mtx")
assert start["rows"] == [f"w{i}" for i in range(1, 6)]
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

# Its times add up.
minutes = [int(m) for m in re.findall(r"^\| \[\d .*?\]\(.*?\) \| (\d+) \|", lecture, flags=re.M)]
assert len(minutes) == 6 and f"about {sum(minutes)} minutes" in lecture, minutes


# The figures are to scale.
def svg_path(name, identifier):
    for element in ElementTree.parse(teach / name).iter("{http://www.w3.org/2000/svg}path"):
        if element.get("id") == identifier:
            return element.get("d")
    sys.exit(f"{name} has no path {identifier}")


# The cones' dots stand at q + z0 d; the text's table names the same points.
run_of_two = trace("--M", "2 1; 1 2", "--q", "-5 -6", "--exact")
corners = [tuple(q_i + Fraction(pivot["z0"]) for q_i in (-5, -6)) for pivot in run_of_two["pivots"]]
dots = sorted(tuple(float(dot.get(key)) for key in ("cx", "cy")) for dot in ElementTree.parse(
    teach / "complementary_cones.svg").iter("{http://www.w3.org/2000/svg}circle"))
scale = (dots[-1][0] - dots[0][0]) / float(corners[0][0] - corners[-1][0])
for (x, y), (px, py) in zip(sorted(corners), dots, strict=True):
    assert abs(px - dots[0][0] - scale * float(x - corners[-1][0])) < 0.02, (x, px)
    assert abs(py - dots[0][1] + scale * float(y - corners[-1][1])) < 0.02, (y, py)
table = re.findall(r"\((-?\d), (-?\d)\)(?= \||$)", section("3 Two unknowns").split("| z0 | the point")[1]
                   .split("\n\n")[0], flags=re.M)
assert [tuple(map(int, point)) for point in table] == corners, table
# The coin: 14 px a newton to the arrow's tip, the head ends 10 px beyond the shaft.
coin_z = [None, *map(Fraction, trace("fixtures/scenes/coin.toml", "--exact")["final"]["z"])]
for arrow, newtons in (("normal", coin_z[1]), ("weight", coin_z[1]), ("friction", coin_z[3]),
                       ("push", coin_z[5])):
    shaft = re.fullmatch(r"M288 209.5([HV])([0-9.]+)", svg_path("coin.svg", arrow))
    length = abs(Fraction(shaft[2]) - (288 if shaft[1] == "H" else Fraction("209.5")))
    assert length + 10 == 14 * newtons, (arrow, length)

# What is typed to --choose, as shown.
typed = re.findall(r"```text\n\$ printf '(.*?)' \| lcpush pivots (.*?)\n(.*?)\n```", exercise_page,
                   flags=re.S)
assert len(typed) == 1
for answers, words, shown in typed:
    printed = run(*[word.strip('"') for word in re.findall(r'"[^"]*"|\S+', words)],
                  typed=answers.replace("\\n", "\n"))
    pattern = "\n".join(".*" if line == "..." else re.escape(line) for line in shown.split("\n"))
    assert re.fullmatch(pattern, printed.rstrip("\n"), flags=re.S), printed


# Every command of the lecture, the exercises and the galleries is live below it, at a pivot that it
# shows or where it ends; every exercise asks first, before its answer.
sys.path.insert(0, str(teach))
import make_lecture  # noqa: E402

for name in ("lemke_by_hand", "exercises", "galleries"):
    text = (teach / f"{name}.md").read_text()
    for block in re.split(r"^```(?=console|text)", text, flags=re.M)[1:]:
        shown, _, below = block.partition("\n```\n")
        line = re.match(r"\n*(?:</details>\n\n)?Live: .*", below)
        links_below = re.findall(r"\]\((live/\S+?)\)", line[0] if line else "")
        wanted = list(make_lecture.commands(f"```{shown}\n```\n"))
        assert len(links_below) == len(wanted), (name, shown[:80], links_below)
        for link, (words, printed) in zip(links_below, wanted):
            step = int(link.split("step=")[1])
            assert link == make_lecture.live_link(words, step), (name, link)
            ends = re.search(r"olved.* after (\d+) pivot", printed)
            pivots = [int(k) for k in re.findall(r"^Pivot (\d+):", printed, flags=re.M)]
            assert step in (pivots or [int(ends[1]) if ends else 0]), (name, link)


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
with tempfile.TemporaryDirectory() as folder:  # a finger beside its object: a warning
    odd = pathlib.Path(folder) / "odd.toml"
    odd.write_text((source / "fixtures/scenes/squeeze.toml").read_text().replace(
        'on = "-x"', "normal = [1, 0, 0]\ncenter = [0.5, 0, 0]"))
    written |= set(keys(trace(str(odd))))
assert "warnings" in written
assert not written & DRAWING, "the drawing is the page's own"
inside = run("--format", "html").split('id="trace">')[1].split("</script>")[0]
written |= set(keys(json.loads(inside)))
described_text = command_page.split("\n### JSON\n")[1].split("```\n")[-1]
described = set(re.findall(r"`([a-z_0-9]+)`", described_text))
assert written <= described, written - described
values = {"solved", "cycle", "pivot_limit", "numerical_breakdown", "fractions", "decimals",
          "lexicographic", "first_row", "generic", "chosen", "null", "none", "artificial",
          "tie_column", "largest_pivot", "solve"}
assert described - written <= values, described - written - values

# Ten exercises, each with its time, its difficulty and an answer that is a transcript.
exercises = re.split(r"^## Exercise (\d+): ", exercise_page, flags=re.M)
assert exercises[1::2] == [str(k) for k in range(1, 11)]
total = 0
for number, text in zip(exercises[1::2], exercises[2::2]):
    effort = re.search(r"^(\d+) minutes, difficulty `(\*{1,3})`$", text, flags=re.M)
    assert effort, number
    assert re.search(rf"^\| \[{number}\].* \| {effort[1]} \| `{re.escape(effort[2])}` \|", exercises[0],
                     flags=re.M), number
    total += int(effort[1])
    answer = re.search(r"<details><summary>Answer</summary>\n\n(.*)\n\n</details>", text, flags=re.S)
    assert answer and "lcpush pivots " in answer[1], number
    words, _ = next(make_lecture.commands(answer[1]))
    step = 3 if number == "2" else 0
    assert make_lecture.live_link(words, step, True) in text.split("<details>")[0], number
assert re.search(rf"about\s+{total} minutes", exercises[0]), total

# From the coin to the slide: the counts of the table, and the rules on every pivot.
STEPS = [["fixtures/scenes/coin.toml"], ["docs/teach/coin_in_space.toml"],
         ["docs/teach/coin_in_space.toml", "--facets", "8"], ["docs/teach/two_points.toml"],
         ["docs/teach/two_patches.toml", "--pressure", "rigid"], ["docs/teach/two_patches.toml"],
         ["fixtures/scenes/straight_slide.toml"],
         ["fixtures/scenes/straight_slide.toml", "--facets", "8"]]
GROUPS = ("normal", "friction", "slip", "closing")


def number(value):
    """a S + b as a pair that compares like it."""
    return (Fraction(value[0]), Fraction(value[1])) if isinstance(value, list) else (0, Fraction(value))


def unknowns(run_):
    names = [v["meaning"] for v in run_["variables"] if re.fullmatch("z[1-9][0-9]*", v["name"])]
    return [(name.split()[0], name) for name in names]


def follow(run_):
    last, before = None, run_["runs"][0]["start"]["rows"]
    for k, pivot in enumerate(run_["pivots"]):
        rows = [number(ratio) for ratio in pivot["ratios"] if ratio is not None]
        leaving = number(pivot["ratios"][before.index(pivot["leaving"])])
        assert leaving == (max(rows) if k == 0 else min(rows)), (k, pivot["leaving"])
        if last is not None:
            assert pivot["entering"] == {"w": "z", "z": "w"}[last[0]] + last[1:], k
        assert pivot["leaving"] == "z0" or "z0" not in pivot["ties"] or k == 0, k
        for name in pivot["basis"]:
            partner = {"w": "z", "z": "w"}[name[0]] + name[1:]
            assert name == "z0" or partner not in pivot["basis"], (k, name)
        last, before = pivot["leaving"], pivot["basis"]
    assert last == "z0"


rows = re.findall(r"^\| \[(\d)\]\(#.*?\) \|.*\| (\d+) \| (\d+) \| ([0-9.]+) N \|$", bridge,
                  flags=re.M)
assert [row[0] for row in rows] == [str(k) for k in range(len(STEPS))], rows
counts = {}
for words, (step, size, pivots, push) in zip(STEPS, rows):
    steps = trace(*words, "--exact")
    assert steps["status"] == "solved" and steps["proved"], step
    assert (steps["size"], len(steps["pivots"])) == (int(size), int(pivots)), step
    named = unknowns(steps)
    pressed = sum(number(z)[1] for (group, name), z in zip(named, steps["final"]["z"])
                  if group == "normal" and re.search("(thumb|wall)", name))
    assert round(float(pressed), 2) == float(push), (step, pressed)
    counts[step] = [sum(group == wanted for group, _ in named) for wanted in GROUPS]
    assert sum(counts[step]) == steps["size"], step
    follow(steps)
shown = re.findall(r"^\| (?:normal force|friction force|slip|closing).* \| (\d+) \| (\d+) \|$", bridge,
                   flags=re.M)
assert [[int(n) for n in column] for column in zip(*shown)] == [counts["0"], counts["7"]], shown
assert counts["7"] == [10, 80, 10, 1]
# Entries that it explains: 1/m and turning in step 3, the pad's compliance and preload in step 5.
starts = [trace(*STEPS[k], "--exact")["runs"][0]["start"] for k in (3, 4, 5)]
assert starts[0]["entries"][2][2] == "13/2"
assert Fraction(starts[2]["entries"][0][0]) - Fraction(starts[1]["entries"][0][0]) == Fraction(1, 5)
assert number(starts[2]["values"][0])[1] - number(starts[1]["values"][0])[1] == -5 * Fraction(1, 5)
# Later rounds without pivots.
later = trace("fixtures/scenes/tipping.toml", "--as-solved")
assert [run_["first_pivot"] for run_ in later["runs"]] == [0, 17, 17] and len(later["pivots"]) == 17


# Links to a section of these pages, and from them, lead to one.
def anchors(text):
    for title in re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.S), flags=re.M):
        title = re.sub(r"\[(.*?)\]\(.*?\)", r"\1", title).lower()
        yield re.sub(r"[^\w\- ]", "", title).replace(" ", "-")


links = 0
for page in [source / "README.md", source / "fixtures/README.md",
             *sorted((source / "docs").rglob("*.md"))]:
    for target, anchor in re.findall(r"\]\(([^)#\s]*)#([^)\s]+)\)", page.read_text()):
        if "://" in target or target.startswith("live/"):
            continue
        other = (page.parent / target).resolve() if target else page
        if teach.resolve() in (page.resolve().parent, other.resolve().parent):
            assert anchor in set(anchors(other.read_text())), f"{page}: no section {target}#{anchor}"
            links += 1
assert links > 30, links

print("lemke_by_hand: ok")
