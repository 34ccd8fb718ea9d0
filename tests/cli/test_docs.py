"""Every console block of docs/ and fixtures/ shows what its command prints now.

A block begins with ```console; a line "$ lcpush ..." is run from the project's root, and what stands
between it and the next such line or the block's end must be its output, standard error included. A
line of only "..." stands for any lines. In docs/guide, teach, embed and check, a command in a ```sh or ```text
block that ends in "-o docs/X.svg" draws that picture.
"""
import pathlib
import re
import shlex
import subprocess
import sys
from xml.etree import ElementTree

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])


def transcripts(text):
    """(command, expected output) of every command in the console blocks."""
    for block in re.findall(r"```console\n(.*?)```", text, flags=re.S):
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, expected = part.partition("\n")
            yield command, expected.rstrip("\n")


def matches(expected, printed):
    pattern = "\n".join(".*" if line == "..." else re.escape(line)
                        for line in expected.split("\n"))
    return re.fullmatch(pattern, printed.rstrip("\n"), flags=re.S) is not None


def run(command, errors=subprocess.STDOUT):
    words = shlex.split(command)
    assert words[0] == "lcpush", command
    result = subprocess.run([tool, *words[1:]], cwd=source, text=True, stdout=subprocess.PIPE,
                            stderr=errors)
    # A slow machine sees progress: a line a second.
    return re.sub(r"^lcpush: \d+ s, .*\n|^lcpush: \d+ % of .*\n", "", result.stdout, flags=re.M)


def drawn(svg):
    """What a picture says, the form of its lines and their numbers, but for its labels: rounding decides where they stand."""
    shown = [e for e in ElementTree.fromstring(svg).iter()
             if not e.tag.endswith("style") and not {"label", "leader", "leader-end"} & set(e.get("class", "").split())]
    lines = "\n".join(f"{e.tag} {sorted(e.attrib.items())}" for e in shown)
    number = r"-?\d+(?:\.\d+)?"
    return [e.text for e in shown], re.sub(number, "#", lines), [float(x) for x in re.findall(number, lines)]


def same_drawing(kept, now):
    (*words, numbers), (*words_now, numbers_now) = drawn(kept), drawn(now)
    return words == words_now and all(abs(a - b) < 0.1 for a, b in zip(numbers, numbers_now))


assert list(transcripts("```console\n$ a b\nc\n$ d\n```")) == [("a b", "c"), ("d", "")]
assert matches("a\n...\nc", "a\nb\nb\nc") and not matches("a\n...\nc", "a\nb\nd")
count = 0
for page in [*sorted((source / "docs").rglob("*.md")), *sorted((source / "fixtures").rglob("*.md"))]:
    for command, expected in transcripts(page.read_text()):
        printed = run(command)
        if not matches(expected, printed):
            sys.exit(f"{page.relative_to(source)}: `{command}` prints now\n{printed}")
        count += 1
if count == 0:
    sys.exit("no transcript found")

assert same_drawing('<a x="1.01"/>', '<a x="1.0"/>') and not same_drawing('<a x="1"/>', '<a x="2"/>')
assert not same_drawing("<a>1.43 N</a>", "<a>1.4 N</a>")
pictures = 0
for page in [page for room in ("guide", "teach", "embed", "check") for page in (source / "docs" / room).glob("*.md")]:
    for block in re.findall(r"```(?:sh|text)\n(.*?)```", page.read_text(), flags=re.S):
        for command, name in re.findall(r"^(lcpush .*?) -o (docs/\S+\.svg)$", block.replace("\\\n", " "), flags=re.M):
            if not same_drawing((source / name).read_text(), run(command, subprocess.DEVNULL)):
                sys.exit(f"{page.relative_to(source)}: `{command}` draws another picture than {name}")
            pictures += 1
if pictures < 20:
    sys.exit(f"{pictures} pictures found")
print(f"{count} transcripts, {pictures} pictures: ok")
