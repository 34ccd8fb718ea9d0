#!/usr/bin/env python3
"""Every equation tag that the sources cite is a heading of docs/theory/theory.md, and the other way round.

Usage: test_equation_tags.py REPO_ROOT

A tag is "T." and a number in square brackets. Exit 1 and one line a fault if a cited tag has no
heading, a heading is cited neither in include/ nor in src/, or two headings carry the same tag.
"""

import re
import sys
import tempfile
from pathlib import Path

TAG = re.compile(r"\[T\.(\d+)\]")
HEADING = re.compile(r"#{1,6}\s")
FENCE = re.compile(r"\s*(```|~~~)")
THEORY = Path("docs/theory/theory.md")
CITING = ("include", "src", "tests", "docs")
MUST_CITE = ("include", "src")
SUFFIXES = {".hpp", ".h", ".cpp", ".c", ".in", ".cmake", ".txt", ".py", ".toml", ".md", ".sh"}


def tag(number):
    return f"[T.{number}]"


def headings(root):
    """Tag number -> line numbers of the headings that carry it."""
    found, fenced = {}, False
    for line, text in enumerate((root / THEORY).read_text(encoding="utf-8").splitlines(), 1):
        if FENCE.match(text):
            fenced = not fenced
        if not fenced and HEADING.match(text):
            for number in TAG.findall(text):
                found.setdefault(int(number), []).append(line)
    return found


def citations(root):
    """(tag number, folder, "path:line") of every tag in the sources and the documents."""
    for folder in CITING:
        for path in sorted((root / folder).rglob("*")):
            if not path.is_file() or path.suffix not in SUFFIXES:
                continue
            text = path.read_text(encoding="utf-8", errors="replace")
            for line, content in enumerate(text.splitlines(), 1):
                for number in TAG.findall(content):
                    yield int(number), folder, f"{path.relative_to(root).as_posix()}:{line}"


def faults(root):
    """One sentence a fault; empty if every tag has both its ends."""
    if not (root / THEORY).is_file():
        return [f"{THEORY.as_posix()} is missing"]
    defined = headings(root)
    found, cited = [], set()
    for number, folder, place in citations(root):
        if folder in MUST_CITE:
            cited.add(number)
        if number not in defined:
            found.append(f"{place}: {tag(number)} has no heading in {THEORY.as_posix()}")
    for number, lines in sorted(defined.items()):
        place = f"{THEORY.as_posix()}:{lines[0]}"
        if len(lines) > 1:
            found.append(f"{place}: {tag(number)} heads line {lines[1]} too")
        if number not in cited:
            found.append(f"{place}: {tag(number)} is cited nowhere in {' or '.join(MUST_CITE)}")
    if not defined:
        found.append(f"{THEORY.as_posix()}: no heading carries a tag")
    return found


def check_the_check():
    """Faults planted in a small tree must be found, each on its own, and a sound tree must pass."""
    sound = {
        "docs/theory/theory.md": f"# Theory\n\n## {tag(1)} One\n\n## {tag(2)} Two\n",
        "include/a.hpp": f"// {tag(1)}\n",
        "src/b.cpp": f"// {tag(2)}\n",
        "tests/c.cpp": f"// {tag(2)}\n",
    }
    planted = [
        ({}, []),
        ({"include/a.hpp": f"// {tag(1)}\n\n// {tag(3)}\n"}, ["include/a.hpp:3"]),
        ({"tests/c.cpp": f"// {tag(7)}\n"}, ["tests/c.cpp:1"]),
        ({"src/b.cpp": "// nothing\n"}, ["docs/theory/theory.md:5"]),  # a test alone does not cite
        ({THEORY.as_posix(): sound[THEORY.as_posix()] + f"## {tag(1)} Again\n"},
         ["docs/theory/theory.md:3"]),
        ({"docs/theory/theory.md": f"## {tag(1)} One\n```\n## {tag(2)} in a listing\n```\n"},
         ["src/b.cpp:1", "tests/c.cpp:1", "docs/theory/theory.md:3"]),
        ({"docs/theory/theory.md": None}, ["docs/theory/theory.md is missing"]),
    ]
    for change, expected in planted:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in {**sound, **change}.items():
                if text is not None:
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).write_text(text, encoding="utf-8")
            found = faults(root)
            places = {fault.split(": ")[0] for fault in found}
            assert places == set(expected), f"planted {change}: expected {expected}, got {found}"


def main():
    if len(sys.argv) < 2 or not Path(sys.argv[1]).is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    check_the_check()
    found = faults(Path(sys.argv[1]))
    for fault in found:
        print(fault)
    if not found:
        print("every equation tag has its heading, and every heading its code")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
