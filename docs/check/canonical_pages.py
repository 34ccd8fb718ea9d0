"""A page with a picture for each of the canonical motions, and the tables of canonical.md.

    docs/check/canonical_pages.py TOOL [--check]      with --check: are they what this makes? Exit status 1 if not

Pictures and what the tool finds come from `lcpush move`, engines' words from engines.md, everything else from
fixtures/canonical/canonical.json and the scenes.
"""
import importlib.util
import pathlib
import re
import subprocess
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FOLDER = ROOT / "fixtures/canonical"
spec = importlib.util.spec_from_file_location("score", FOLDER / "score.py")
score = importlib.util.module_from_spec(spec)
spec.loader.exec_module(score)

PAGE = """# {stem}

{title}

![{title}]({stem}.svg)

    lcpush move {scene} --time {time:g}

{asked}
The symbols' numbers are the scene's; T is the time. The engines' words are explained on [their page](../engines.md).
Before: [{before}]({before}.md), next: [{next}]({next}.md); [all motions](../canonical.md).

```toml
{text}
```
"""
ASKED = """**{quantity} {when}: {value:.6g} {unit}**, within {tolerance:g} {unit}. Because: {source}.

    {formula}
    = {put_in}
{where}
{tests}

| lcpush | Bullet | DART | ODE | MuJoCo's defaults | MuJoCo, stiffer |
|---|---|---|---|---|---|
| {found} | {engines} |
"""


def when(motion):
    if not motion.get("when"):
        return f"at {motion['time']:g} s"
    of, level = motion["when"].split(" reaches ")
    return f"where {of} reaches {score.evaluated(motion)[0].get(level, 0):.5g}"


def where(motion):
    numbers = [f"{symbol} = {number:.5g}" for symbol, number in score.evaluated(motion)[0].items()]
    return f"\nWith {', '.join(numbers)}.\n" if numbers else ""


def put_in(motion):
    """The formula with the scene's numbers for its symbols."""
    numbers = score.evaluated(motion)[0] | {"T": motion["time"]}
    return re.sub(r"[A-Za-z_]\w*", lambda name: f"{numbers[name[0]]:.5g}" if name[0] in numbers else name[0], motion["formula"])


def found(tool, motion):
    """What the tool gives, in the digits that the tolerance lets count."""
    path = (FOLDER / motion["scene"]).resolve()
    said = subprocess.run([tool, "move", path, "--time", str(motion["time"]), "--frames", "401", "--json", "--seconds", "600"],
                          capture_output=True, text=True, check=True).stdout
    got = score.measured(motion, score.series(score.from_text(said)))[0]
    digits = len(f"{motion['tolerance']:.10f}".rstrip("0").split(".")[1]) + 1
    part = abs(got - score.evaluated(motion)[1]) / motion["tolerance"]
    used = f"{part:.0%}" if part > 0.01 else "below 1 %"
    return f"{round(got, digits) + 0.0:.{digits}f} {motion['unit']}: {used} of the tolerance"


def engines(motion):
    """The cells of docs/check/engines.md; what its first table leaves out is within."""
    rows = re.findall(rf"^\| {motion['name']}: \S+ \|(.*)\|$", (HERE / "engines.md").read_text(), flags=re.M)
    cells = {len(row): row for row in ([cell.strip() for cell in row.split("|")] for row in rows)}
    return " | ".join(cells.get(3, ["within"] * 3) + cells.get(4, ["not run"] * 4)[2:])


def asked(tool, motion):
    return ASKED.format(**motion | {"value": score.evaluated(motion)[1], "when": when(motion), "where": where(motion),
                                    "put_in": put_in(motion), "found": found(tool, motion), "engines": engines(motion),
                                    "tests": textwrap.fill("*It tests:* " + motion["tests"], 130)})


def page(tool, motions, before, following):
    """Of the questions about one scene: (its name, its page)."""
    path = (FOLDER / motions[0]["scene"]).resolve()
    lines = path.read_text().splitlines()
    comment = [line[1:].strip() for line in lines[:next(k for k, line in enumerate(lines) if line[:1] != "#")]]
    title = " ".join(comment[:comment.index("")] if "" in comment else comment)
    return path.stem, PAGE.format(stem=path.stem, title=title, scene=path.relative_to(ROOT), time=time_of(motions),
                                  asked="\n".join(asked(tool, motion) for motion in motions),
                                  before=pathlib.Path(before[0]["scene"]).stem, next=pathlib.Path(following[0]["scene"]).stem,
                                  text="\n".join(line for line in lines if line[:1] != "#").strip())


def time_of(motions):
    return max(motion["time"] for motion in motions)


def picture(tool, motions):
    return subprocess.run([tool, "move", FOLDER / motions[0]["scene"], "--time", str(time_of(motions)), "--format", "svg"],
                          capture_output=True, text=True, check=True).stdout


def with_tables(text):
    """canonical.md, each family's table made again."""
    for family in dict.fromkeys(motion["family"] for motion in score.MOTIONS):
        rows = [f"| [{m['name']}](canonical/{pathlib.Path(m['scene']).stem}.md): {m['quantity']} {when(m)} | `{m['formula']}` "
                f"| {score.evaluated(m)[1]:.6g} {m['unit']} | {m['tolerance']:g} |" for m in score.MOTIONS if m["family"] == family]
        table = "\n".join([f"| {family} | formula | value | tolerance |", "|---|---|---|---|", *rows])
        text, found = re.subn(rf"\| {family} \|.*\n(?:\|.*\n)*", lambda _: table + "\n", text)
        assert found == 1, f"canonical.md: {found} tables of {family}"
    return text


def files(tool):
    """(path, text) of all that is made."""
    scenes = list(dict.fromkeys(motion["scene"] for motion in score.MOTIONS))
    groups = [[motion for motion in score.MOTIONS if motion["scene"] == scene] for scene in scenes]
    for motions, before, following in zip(groups, groups[-1:] + groups[:-1], groups[1:] + groups[:1]):
        stem, text = page(tool, motions, before, following)
        yield HERE / f"canonical/{stem}.md", text
        yield HERE / f"canonical/{stem}.svg", picture(tool, motions)
    front = HERE / "canonical.md"
    yield front, with_tables(front.read_text())


def main(words):
    if not words or words[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    made = list(files(words[0]))
    stale = [path for path, text in made if not path.exists() or path.read_text() != text]
    if words[1:]:
        return "".join(f"{path.relative_to(ROOT)} is not what canonical_pages.py makes\n" for path in stale)
    (HERE / "canonical").mkdir(exist_ok=True)
    for path, text in made:
        path.write_text(text)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) or 0)
