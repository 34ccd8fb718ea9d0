"""A page with a picture for each of the canonical motions, and the tables of canonical.md.

    docs/check/canonical_pages.py TOOL [--check]      with --check: are they what this makes? Exit status 1 if not

Pictures come from `lcpush move`, everything else from fixtures/canonical/canonical.json and the scenes.
"""
import importlib.util
import pathlib
import re
import subprocess
import sys

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
The symbols' numbers are the scene's; T is the time. [What four engines make of it](../engines.md); [all motions](../canonical.md);
the next one is [{next}]({next}.md).

```toml
{text}
```
"""
ASKED = """**{quantity} {when}: {value:.6g} {unit}**, within {tolerance:g} {unit}. Because: {source}.

    {formula}
{where}"""


def when(motion):
    if not motion.get("when"):
        return f"at {motion['time']:g} s"
    of, level = motion["when"].split(" reaches ")
    return f"where {of} reaches {score.evaluated(motion)[0].get(level, 0):.5g}"


def where(motion):
    numbers = [f"{symbol} = {number:.5g}" for symbol, number in score.evaluated(motion)[0].items()]
    return f"\nWith {', '.join(numbers)}.\n" if numbers else ""


def asked(motion):
    return ASKED.format(**motion | {"value": score.evaluated(motion)[1], "when": when(motion), "where": where(motion)})


def page(motions, following):
    """Of the questions about one scene: (its name, its page)."""
    path = (FOLDER / motions[0]["scene"]).resolve()
    lines = path.read_text().splitlines()
    comment = [line[1:].strip() for line in lines[:next(k for k, line in enumerate(lines) if line[:1] != "#")]]
    title = " ".join(comment[:comment.index("")] if "" in comment else comment)
    return path.stem, PAGE.format(stem=path.stem, title=title, scene=path.relative_to(ROOT), time=time_of(motions),
                                  asked="\n".join(map(asked, motions)), next=pathlib.Path(following[0]["scene"]).stem,
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
    for motions, following in zip(groups, groups[1:] + groups[:1]):
        stem, text = page(motions, following)
        yield HERE / f"canonical/{stem}.md", text
        yield HERE / f"canonical/{stem}.svg", picture(tool, motions)
    front = HERE / "canonical.md"
    yield front, with_tables(front.read_text())


def main(words):
    if not words or words[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    stale = [path for path, text in files(words[0]) if not path.exists() or path.read_text() != text]
    if words[1:]:
        return "".join(f"{path.relative_to(ROOT)} is not what canonical_pages.py makes\n" for path in stale)
    (HERE / "canonical").mkdir(exist_ok=True)
    for path, text in files(words[0]):
        path.write_text(text)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) or 0)
