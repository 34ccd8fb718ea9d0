"""No tolerance, factor or size threshold stands bare in solving code.

    python3 tests/contract/test_numbers.py REPO_ROOT

Such numbers belong to `Tolerances` (lcp/tolerances.hpp) or to a room's settings.hpp, each with its
unit, its reason and the figure that chose it. Prints FILE:LINE: what is wrong and exits 1; exits 0 if
all is well, and if numbers planted in a copy of the sources are found.
"""

import pathlib
import re
import sys

ROOMS = ("include/lcpush/lcp include/lcpush/mechanics src/solve src/sweep src/spread src/raw src/cone "
         "src/plan src/move src/certify src/verify src/dense").split()
# Where numbers belong, and files that draw: coordinates are no tolerances.
PLACES = re.compile(r"(tolerances|settings)\.hpp$|svg|html|painter|picture")

# Counts, halves and squares, series' exact coefficients, and degrees: numbers that nobody chose.
NEUTRAL = {*range(9), 0.5, 0.25, 90, 180, 360}
PI = re.compile(r"3\.14159|6\.28318")
# Numbers above that nobody chose either: file, literal, what it is.
EXACT = {
    ("include/lcpush/lcp/pivots/structured/local_form.hpp", "flipped = 8"): "a bit beside those of roles",
    ("include/lcpush/lcp/pivots/structured/local_form.hpp", "16"): "a bit beside those of roles",
    ("include/lcpush/mechanics/model/contact.hpp", "16"): "a table of 16 steps round the circle",
    ("include/lcpush/mechanics/model/contact.hpp", "26"): "terms of a series, to rounding",
    ("include/lcpush/mechanics/model/contact.hpp", "12"): "30 degrees are a twelfth of a circle",
    ("include/lcpush/mechanics/model/pose.hpp", "40"): "terms of a series, to rounding",
    ("include/lcpush/mechanics/model/validate.hpp", "256"): "the most facets, scene.hpp",
    ("include/lcpush/mechanics/paper/patch_rigidity.hpp", "most_references = 4"): "of an affine space",
}
# Bare numbers that are left in each folder. These counts may only fall, and are exact.
LEFT = {
    "include/lcpush/mechanics/solve": 30,
    "include/lcpush/mechanics/study": 6,
    "src/certify": 25,
    "src/cone": 1,
    "src/move": 4,
    "src/plan": 38,
    "src/solve": 39,
    "src/sweep": 1,
    "src/verify": 2,
}

NUMBER = re.compile(r"(?<![\w.])(0[xX][0-9a-fA-F']+(?:\.[0-9a-fA-F]*)?(?:[pP][-+]?\d+)?"
                    r"|(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][-+]?\d+)?)[fFlLuUzZ]*(?![\w.])")
SILENT = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'|//.*|/\*.*?\*/')
NO_THRESHOLD = re.compile(r"\[\d+\]|(?:<<|>>)=?\s*\d+U?|\b0[xX][0-9a-fA-F]+U?(?![\w.])|static_assert\(.*")
CONSTANT = re.compile(r"\bconstexpr\s+(?:static\s+)?(?:Index|int|std::size_t|unsigned)\s+(\w+)\s*=\s*(\d+)\s*[,;]")


def value_of(literal):
    text = literal.rstrip("fFlLuUzZ").replace("'", "")
    if text[:2] in ("0x", "0X"):
        return float.fromhex(text)
    return float(text)


def bare_numbers(name, text):
    """(line, what) of each bare number; `name` is the file's path."""
    text = re.sub(r"/\*.*?\*/", lambda found: "\n" * found.group().count("\n"), text, flags=re.S)
    for number, line in enumerate(text.splitlines(), 1):
        code = SILENT.sub("0", line)
        if code.lstrip().startswith("#"):
            continue
        if re.search(r"\bepsilon\(\)", code):
            yield number, "a multiple of epsilon"
        constant = CONSTANT.search(code)
        if constant and 3 < int(constant.group(2)) < 9 and not constant.group(1).endswith("count"):
            what = f"{constant.group(1)} = {constant.group(2)}"
            if (name, what) not in EXACT:
                yield number, what
        for found in NUMBER.finditer(NO_THRESHOLD.sub("0", code)):
            literal = found.group()
            if PI.match(literal) or value_of(literal) in NEUTRAL or (name, literal) in EXACT:
                continue
            yield number, literal


def sources(root):
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix in (".hpp", ".cpp") and not PLACES.search(path.name):
                yield name, path.read_text(encoding="utf-8")


# A line of code, and the numbers that the check has to see in it.
PLANTED = [
    ("if (error < 1e-9 * size) return;", ["1e-9"]),
    ("const S least = slides ? S(0.7) : S(0.9999);", ["0.7", "0.9999"]),
    ("const S most = S(100) * given;", ["100"]),
    ("if (n >= 600) return far(n);", ["600"]),
    ("constexpr Index few = 64;", ["64"]),
    ("constexpr Index few = 4;", ["few = 4"]),
    ("const S slack = S(16) * Eigen::NumTraits<S>::epsilon();", ["a multiple of epsilon", "16"]),
    ("options.tolerance = 0x1p-20 / 0.125F;", ["0x1p-20", "0.125F"]),
    ("return x / 2 + S(0.5) * y + pow(4, 2) - 1.0 * angle / 180;", []),
    ("x = 6.283185307179586 * j; // 1e-9 in a comment", []),
    ('print("%.40g", text[40], bits >> 32, 0xFFFFU);', []),
]


def missed_faults():
    for line, expected in PLANTED:
        seen = [what for _, what in bare_numbers("planted.hpp", line)]
        if seen != expected:
            yield f"planted {line!r}: saw {seen}"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[1]).resolve()
    count, found = 0, {}
    for name, text in sources(root):
        count += 1
        found.setdefault(name.rpartition("/")[0], []).extend(
            f"{name}:{number}: {what}: to Tolerances or the room's settings.hpp, with its reason"
            for number, what in bare_numbers(name, text))
    faults = list(missed_faults())
    for folder in sorted(found.keys() | LEFT.keys()):
        bare, allowed = found.get(folder, []), LEFT.get(folder, 0)
        if len(bare) > allowed:
            faults += bare + [f"{folder}/: {len(bare)} bare numbers, {allowed} allowed"]
        elif len(bare) < allowed:
            faults.append(f"tests/contract/test_numbers.py: {folder}/ has {len(bare)} left: say so in LEFT")
    if count == 0 or faults:
        sys.exit("\n".join(faults) or f"{root}: no sources there")
    print(f"{count} files, {sum(LEFT.values())} bare numbers left; {len(PLANTED)} planted lines judged")


if __name__ == "__main__":
    main()
