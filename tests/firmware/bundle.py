#!/usr/bin/env python3
"""The device bundle, as somebody would use it who has nothing else.

    bundle.py OPTIONS bundle     made and compiled at a path with blanks by the commands of its README,
                                 for Arm, RISC-V and here; it reads nothing of ours elsewhere, and runs
    bundle.py OPTIONS planted    faults in a bundle are seen
    bundle.py OPTIONS hundred    a hundred pushes end in the same bits everywhere; with --page FILE
                                 they are written into the page, at a release

OPTIONS: --build FOLDER (where to work), --sources FOLDER, and what else `--help` lists.
"""
import argparse
import concurrent.futures
import pathlib
import re
import shutil
import sys
import tempfile

from bundle_targets import ALL, IN_BUNDLE_TEST, Bundle, Failed, run

BEGIN, END = "<!-- hundred -->\n", "<!-- end of hundred -->\n"


def make(args):
    """A bundle at a path with blanks, of sources whose path has one as well."""
    place = args.build / "somebody's own folder"
    place.mkdir(parents=True, exist_ok=True)
    sources = place / "our sources"
    sources.unlink(missing_ok=True)
    sources.symlink_to(args.sources)
    folder = place / "device bundle"
    run([args.cmake, f"-DSOURCES={sources}", f"-DEIGEN={args.eigen}", f"-DCOMPILER={args.compiler}",
         f"-DVERSION={args.version}", f"-DOUTPUT={folder}", "-P",
         args.sources / "src/cmake/device_bundle.cmake"])
    return Bundle(folder, args.build / "bundled")


def in_parallel(work, targets):
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(work, targets))


def check_bundle(args):
    bundle = make(args)
    made = args.target_made
    if made:
        same = {path.relative_to(made): path.read_bytes() for path in made.rglob("*") if path.is_file()}
        if same != bundle.files():
            yield "the target device_bundle makes another folder"
    licence = (bundle.folder / "LICENSE.Eigen").read_text()
    if "Mozilla Public License" not in licence or "BFloat16.h" not in licence:
        yield "LICENSE.Eigen does not say what Eigen's headers are under"
    page = (args.sources / "docs/embed/embedding.md").read_text()
    expected = re.findall(r"```text\n(.*?)```", page, re.S)[0]  # of C; the next is of C++
    for target in IN_BUNDLE_TEST:
        yield from bundle.foreign_headers(target)
    in_parallel(bundle.library, IN_BUNDLE_TEST)
    answers = set()
    for target in IN_BUNDLE_TEST:
        lines = bundle.run_example(target)
        answers.add(tuple(lines))
        print(f"{target.title}: {len(bundle.library(target).read_bytes())} bytes, {lines[0]}")
    if len(answers) != 1 or " result 0 " not in lines[0]:
        yield f"the example answers {answers}"
    said = bundle.as_the_readme_says()
    print(said, end="")
    if said != expected:
        yield f"the example prints {said!r}, docs/embed/embedding.md {expected!r}"
    print(f"{len(bundle.files())} files in the bundle")


def check_planted(args):
    bundle = make(args)
    target = IN_BUNDLE_TEST[0]
    with tempfile.TemporaryDirectory() as scratch:
        spoilt = Bundle(pathlib.Path(shutil.copytree(bundle.folder, f"{scratch}/a bundle")),
                        pathlib.Path(scratch) / "objects")
        (spoilt.folder / "include/Eigen/Core").unlink()
        try:
            print("a header that is missing:", list(spoilt.foreign_headers(target)))
            yield "a bundle without one of its headers is found whole"
        except Failed as error:
            print("a header that is missing:", str(error).splitlines()[-2:])
        target = target._replace(extra=target.extra + ("-isystem", str(args.eigen)))
        found = list(spoilt.foreign_headers(target))
        print("a header from elsewhere:", found)
        if not any("Eigen/src/Core/Stride.h is read" in line for line in found):
            yield "a header of Eigen's that is not the bundle's is read unseen"
        main = spoilt.folder / "main.c"
        main.write_text(main.read_text() + "static int unused(void) { return 1; }\n")
        try:
            spoilt.object_of(target, main, "main")
            yield "a warning passes"
        except Failed as error:
            print("a warning:", str(error).splitlines()[-4:-3])
    target = next(target for target in ALL if target.name == "x86_64")
    bit = args.sources / "tests/firmware/planted/bit.cpp"
    hashes = {target.name: bundle.hundred(target, "float")["hash"],
              "planted": bundle.hundred(target, "float", bit, "lcpushf_contact_at")["hash"]}
    found = list(differing({name: {"float": bits} for name, bits in hashes.items()}))
    print("a wrong bit:", found)
    if not found:
        yield "one wrong bit in a force leaves the hash as it was"


def differing(hashes):
    """Rows whose bits are not those of the first."""
    first = next(iter(hashes.values()))
    for name, row in hashes.items():
        for precision, bits in row.items():
            if bits != first[precision]:
                yield f"{name} in {precision}: {bits}, elsewhere {first[precision]}"


def hundred(args):
    bundle = make(args)
    in_parallel(bundle.library, ALL)
    runs = in_parallel(lambda target: {precision: bundle.hundred(target, precision)
                                       for precision in target.precisions}, ALL)
    hashes = {target.title: {precision: run["hash"] for precision, run in row.items()}
              for target, row in zip(ALL, runs)}
    yield from differing(hashes)
    solved = runs[0]["float"]["solved"], runs[0]["double"]["solved"]
    print(f"solved: {solved[0]} in float, {solved[1]} in double")
    if not args.page:
        return
    lines = [f"| 100 pushes, {solved[0]} / {solved[1]} of them solved | float | double |", "|---|---|---|"]
    for title, row in hashes.items():
        cells = [f"`{row[key]}`" if key in row else "" for key in ("float", "double")]
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    before, rest = args.page.read_text().split(BEGIN)
    table = "".join(f"{line}\n" for line in lines)
    args.page.write_text(before + BEGIN + table + END + rest.split(END)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["bundle", "planted", "hundred"])
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--sources", type=pathlib.Path, default=pathlib.Path(__file__).parents[2])
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    parser.add_argument("--compiler", default="c++", help="the one that says what is read")
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--version", default="0")
    parser.add_argument("--target-made", type=pathlib.Path, help="what the target device_bundle made")
    parser.add_argument("--page", type=pathlib.Path)
    args = parser.parse_args()
    args.build, args.sources = args.build.resolve(), args.sources.resolve()
    check = {"bundle": check_bundle, "planted": check_planted, "hundred": hundred}[args.what]
    try:
        wrong = list(check(args))
    except Failed as error:
        wrong = [str(error)]
    for line in wrong:
        print(f"WRONG {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
