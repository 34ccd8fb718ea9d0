"""Core headers keep their promises: no heap, no exceptions, no streams; referees apart from solvers.

    python3 tests/contract/check_headers.py REPO_ROOT

Prints FILE:LINE: what is wrong, and exits 1; exits 0 if all is well.
"""

import pathlib
import re
import sys

FORBIDDEN_INCLUDES = set(
    "vector string map memory functional iostream ostream istream sstream fstream iomanip list "
    "deque set unordered_map unordered_set stdexcept exception any variant thread mutex regex "
    "filesystem locale".split())
FORBIDDEN_CODE = [
    (re.compile(r"\bnew\b(?!\s*\()"), "a new-expression that is not placement new"),
    (re.compile(r"\bnew\s*\(\s*std\s*::\s*nothrow"), "a new-expression that is not placement new"),
    (re.compile(r"(?<!=)(?<!= )\bdelete\b"), "a delete-expression"),
    (re.compile(r"\bthrow\b"), "throw"),
    (re.compile(r"\btry\b"), "try"),
    (re.compile(r"\bcatch\s*\("), "catch"),
    (re.compile(r"\b(malloc|calloc|realloc|free)\s*\("), "the C heap"),
    (re.compile(r"\b(dynamic_cast|typeid)\b"), "run-time type information"),
]
# The referees share no code with what they judge.
REFEREES = ["lcp/residual.hpp", "mechanics/model/check.hpp", "src/verify/trajectory_forces.cpp",
            "src/verify/trajectory_points.cpp", "src/verify/trajectory_steps.cpp"]
SOLVERS = re.compile(r"^lcp/(pivots|sweeps)/"
                     r"|^mechanics/model/(assemble|read_answer)\b|^mechanics/(solve|study)/")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def code_of(text):
    """The text with comments and string literals blanked, lines kept."""
    return COMMENT_OR_TEXT.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def includes_of(text):
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        if found:
            yield number, found.group(2)


def is_core(name):
    return not name.startswith(("desktop/", "src/"))


def name_of(include):
    """'lcp/pivots/lemke.hpp' for "lcpush/lcp/pivots/lemke.hpp"; others stand in src/, or are foreign."""
    return include[len("lcpush/"):] if include.startswith("lcpush/") else f"src/{include}"


def place_of(name):
    return name if name.startswith("src/") else f"include/lcpush/{name}"


def own_faults(name, text):
    for number, include in includes_of(text):
        if include in FORBIDDEN_INCLUDES:
            yield number, f"includes <{include}>"
    for number, line in enumerate(code_of(text).splitlines(), 1):
        if INCLUDE.match(line) or line.lstrip().startswith("#"):
            continue
        for pattern, what in FORBIDDEN_CODE:
            if pattern.search(line):
                yield number, what


def path_to_solver(start, headers):
    """The chain of includes from `start` to a solver's header, or None."""
    paths = [[start]]
    seen = {start}
    while paths:
        path = paths.pop()
        if len(path) > 1 and SOLVERS.match(path[-1]):
            return path
        for _, include in includes_of(headers.get(path[-1], "")):
            inner = name_of(include)
            if inner not in seen:
                seen.add(inner)
                paths.append(path + [inner])
    return None


def check(root):
    base = pathlib.Path(root) / "include" / "lcpush"
    headers = {path.relative_to(base).as_posix(): path.read_text(encoding="utf-8")
               for path in sorted(base.rglob("*.h*"))}
    headers |= {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
                for room in ("src/move", "src/verify")
               for path in sorted((pathlib.Path(root) / room).glob("*.[hc]pp"))}
    core = {name: text for name, text in headers.items() if is_core(name)}
    faults = [f"include/lcpush/{name}:{number}: {what}"
              for name, text in core.items() for number, what in own_faults(name, text)]
    for referee in REFEREES:
        if referee not in headers:
            faults.append(f"{place_of(referee)}: missing")
            continue
        path = path_to_solver(referee, headers)
        if path is not None:
            faults.append(f"{place_of(referee)}:1: reaches a solver: {' -> '.join(path)}")
    return len(core), faults


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    count, faults = check(sys.argv[1])
    for fault in faults:
        print(fault, file=sys.stderr)
    if count == 0:
        sys.exit(f"{sys.argv[1]}: no core headers there")
    if faults:
        sys.exit(1)
    print(f"{count} core headers: no heap, no exceptions, no streams; referees apart from solvers")


if __name__ == "__main__":
    main()
