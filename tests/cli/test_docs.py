"""Every console block of docs/ and fixtures/ shows what its command prints now.

A block begins with ```console; a line "$ lcpush ..." is run from the project's root, and what stands
between it and the next such line or the block's end must be its output, standard error included. A
line of only "..." stands for any lines.
"""
import pathlib
import re
import shlex
import subprocess
import sys

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


def run(command):
    words = shlex.split(command)
    assert words[0] == "lcpush", command
    result = subprocess.run([tool, *words[1:]], cwd=source, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    # A slow machine sees progress: a line a second.
    return re.sub(r"^lcpush: \d+ s, .*\n|^lcpush: \d+ % of .*\n", "", result.stdout, flags=re.M)


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
print(f"{count} transcripts: ok")
