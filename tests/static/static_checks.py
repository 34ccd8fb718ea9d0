#!/usr/bin/env python3
"""Static checks of what goes into a device: no findings but those justified in cppcheck.txt and .clang-tidy.

    static_checks.py --eigen FOLDER cppcheck      cppcheck on the core, with MISRA on the C headers and example
    static_checks.py --eigen FOLDER clang-tidy    clang-tidy's bugprone checks on core and C interface

Each also looks at sources with a planted fault, and fails if it finds nothing there.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = "docs/embed/main.c"


def run(*words):
    done = subprocess.run([str(word) for word in words], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def everything(root, place):
    """One source that includes all that is checked, from a tree at `root`."""
    headers = sorted(path.relative_to(root / "include") for folder in ("lcp", "mechanics")
                     for path in (root / "include/lcpush" / folder).rglob("*.hpp"))
    parts = sorted(path.relative_to(root) for path in (root / "src/c").glob("*.cpp"))
    if len(headers) < 50 or not parts:
        sys.exit(f"{root}: only {len(headers)} headers, {len(parts)} sources")
    source = place / "everything.cpp"
    lines = [f'#include "{path.as_posix()}"' for path in headers]
    lines += [f'#include "{path.as_posix()}" // NOLINT(bugprone-suspicious-include)' for path in parts]
    source.write_text("\n".join(lines) + "\n")
    return source, len(headers) + len(parts)


def cppcheck(root, args, place, quick=None):
    """Findings; `quick`: in that file alone."""
    source, _ = everything(root, place)
    common = [args.cppcheck, "--quiet", "--inline-suppr", "--error-exitcode=1",
              f"--suppressions-list={ROOT / 'tests/static/cppcheck.txt'}", "--suppress=missingIncludeSystem",
              "--enable=style,warning,performance,portability", f"-I{root / 'include'}", f"-I{root}",
              "--template={file}:{line}: {id}: {message}"]
    found = ""
    if quick is None or quick.suffix != ".c":
        found += run(*common, "--std=c++17", "--language=c++", quick or source)[1]
    if quick is None or quick.suffix == ".c":
        for hosted in (0, 1):
            found += run(*common, "--std=c99", "--language=c", "--addon=misra",
                         f"-D__STDC_HOSTED__={hosted}", quick or root / EXAMPLE)[1]
    return sorted(set(found.splitlines()))


def clang_tidy(root, args, place, quick=None):
    source, _ = everything(root, place)
    code, said = run(args.clang_tidy, "--quiet", f"--config-file={ROOT / '.clang-tidy'}", quick or source, "--",
                     "-std=c++17", f"-I{root / 'include'}", f"-I{root}", "-isystem", args.eigen,
                     "-DEIGEN_DONT_VECTORIZE")
    found = [line for line in said.splitlines() if ": error:" in line or ": warning:" in line]
    return found or ([said] if code != 0 else [])


# For each tool: a file, what is changed there, and what has to be found.
PLANTED = {
    cppcheck: [
        (EXAMPLE, "ticks = 8;", "ticks = 010;", "misra-c2012-7.1"),
        ("include/lcpush/lcp/loops.hpp", "#pragma once",
         "#pragma once\ninline int planted(int k) { int a[2] = {0, 1}; return k == 0 ? a[2] : 0; }",
         "arrayIndexOutOfBounds")],
    clang_tidy: [
        ("include/lcpush/lcp/loops.hpp", "#pragma once",
         "#pragma once\ninline double planted(int k) { return k / 2; }", "bugprone-integer-division")],
}


def missed(check, args, place):
    """Planted faults that are not found."""
    for name, before, after, expected in PLANTED[check]:
        copy = place / "planted"
        shutil.rmtree(copy, ignore_errors=True)
        for part in ("include", "src/c", "docs/embed"):
            shutil.copytree(ROOT / part, copy / part)
        text = (copy / name).read_text()
        if before not in text:
            sys.exit(f"{name} has no {before!r}")
        (copy / name).write_text(text.replace(before, after, 1))
        found = [line for line in check(copy, args, place, copy / name) if expected in line]
        print(f"planted in {name}:", found[:1])
        if not found:
            yield f"a fault planted in {name} is not found: {expected}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", choices=["cppcheck", "clang-tidy"])
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    parser.add_argument("--cppcheck", default="cppcheck")
    parser.add_argument("--clang-tidy", default="clang-tidy-14")
    args = parser.parse_args()
    check = {"cppcheck": cppcheck, "clang-tidy": clang_tidy}[args.tool]
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        wrong = [*check(ROOT, args, place), *missed(check, args, place)]
        count = everything(ROOT, place)[1]
    for line in wrong:
        print(line)
    print(f"{args.tool}: {count} headers and sources, {len(wrong)} findings")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
