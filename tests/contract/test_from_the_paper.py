"""docs/theory/from_the_paper.md shows whole functions of the headers, and a program that builds the coin's problem.

    python3 tests/contract/test_from_the_paper.py REPO_ROOT [--write]

A ```cpp block stands below a line "From [FILE](path), `function`:"; --write fills the blocks in. Every tag
[P.n] of laws.hpp has its section.
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
page = root / "docs/theory/from_the_paper.md"
text = page.read_text(encoding="utf-8")
BLOCK = re.compile(r"^(From \[\S+\]\((\S+)\), `(\w+)`:\n\n```cpp\n)(.*?)(^```$)", flags=re.M | re.S)


def code(path, function):
    """The first function of that name, from its template line to the brace that ends it."""
    source = (page.parent / path).resolve().read_text(encoding="utf-8")
    found = re.search(rf"^template <class S>\s(?:[\w<>:]+ )?{function}\(.*?^}}\n", source, flags=re.M | re.S)
    return found[0] if found else sys.exit(f"{path} has no {function}")


filled = BLOCK.sub(lambda block: block[1] + code(block[2], block[3]) + block[5], text)
if "--write" in sys.argv:
    page.write_text(filled, encoding="utf-8")
elif filled != text:
    sys.exit(f"{page}: code differs from its header; run this with --write")
blocks = BLOCK.findall(filled)
if len(blocks) < 9 or text.count("```cpp") != len(blocks):
    sys.exit(f"{len(blocks)} blocks are compared")

laws = (root / "include/lcpush/mechanics/model/laws.hpp").read_text(encoding="utf-8")
headings = " ".join(re.findall(r"^## .*", text, flags=re.M))
if missing := [tag for tag in re.findall(r"\[P\.(?!n)[\w-]+\]", laws) if tag not in headings]:
    sys.exit(f"no section on {missing}")

program = {}
exec(re.search(r"^```python\n(.*?)^```$", text, flags=re.M | re.S)[1], program)
for name, rows in (("M", program["M"]), ("q", [[x] for x in program["q"]])):
    numbers = [line for line in (root / f"fixtures/textbook/coin.{name}.mtx").read_text().split("\n")
               if line and line[0] != "%"][1:]
    if [float(x) for x in numbers] != [float(row[j]) for j in range(len(rows[0])) for row in rows]:
        sys.exit(f"the program's {name} is not the coin's: {rows}")
print(f"{len(blocks)} functions, a program: ok")
