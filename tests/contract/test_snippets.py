"""Code in the docs and in header comments compiles, as a reader would paste it.

    python3 tests/contract/test_snippets.py REPO_ROOT CXX EIGEN_INCLUDE VERSION_INCLUDE

A ```cpp block that begins with #include is a file of its own; any other continues the page's first
one: it stands in a function that has `file`, `push` and `report`. A further ```c block of the device's page
has `push`, `forces` and `stop`. Indented lines of a header's first comment that end in a semicolon are
statements.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

PAGES = ["docs/guide/cpp.md"]
CONTINUED = """
#include <cstdio>
#include <lcpush/desktop/input_error.hpp>
#include <lcpush/desktop/push.hpp>
using namespace lcpush;
void page(const desktop::SceneFile& file, desktop::Push& push, const desktop::PushReport& report);
void page(const desktop::SceneFile& file, desktop::Push& push, const desktop::PushReport& report) {
  (void)file, (void)push, (void)report;
%s
}
"""
IN_C = """
#include <lcpush/lcpush.h>
int page(lcpush_size size, lcpush_scene scene, lcpush_contact contact, const double* forces,
         const double* motions);
int page(lcpush_size size, lcpush_scene scene, lcpush_contact contact, const double* forces,
         const double* motions) {
%s
  return contact.mode == LCPUSH_STICK;
}
"""
IN_LOOP = """
#include <lcpush/lcpush.h>
void page(lcpushf_push* push, float forces[2]);
void stop(void);
void page(lcpushf_push* push, float forces[2]) {
%s
}
"""
USING = "#include <lcpush/desktop/push.hpp>\nusing namespace lcpush;\n"


def page_programs(root):
    for page in PAGES:
        blocks = re.findall(r"```cpp\n(.*?)```", (root / page).read_text(encoding="utf-8"), re.S)
        for number, block in enumerate(blocks, 1):
            name = f"{page}, block {number}"
            if not block.startswith("#include"):
                yield name, ".cpp", CONTINUED % block
            elif "using namespace" in block:
                yield name, ".cpp", block
            else:
                yield name, ".cpp", USING + block


def device_programs(root):
    page = "docs/embed/embedding.md"
    blocks = re.findall(r"```c\n(.*?)```", (root / page).read_text(encoding="utf-8"), re.S)
    for number, block in enumerate(blocks[1:], 2):
        yield f"{page}, block {number} of C", ".c", IN_LOOP % block


def header_programs(root):
    """lcpush.h says in its first comment how it is used."""
    comment = (root / "include/lcpush/lcpush.h").read_text(encoding="utf-8").split("*/")[0]
    lines = [line[2:].strip() for line in comment.splitlines() if line.startswith(" *     ")]
    statements = [re.split(r"(?<=[;)]) {4,}", line)[0] for line in lines]
    yield "include/lcpush/lcpush.h", ".c", IN_C % "\n".join(statements)


def mistake(program, suffix, compiler, includes, folder):
    """What the compiler says against it, or nothing."""
    source = pathlib.Path(folder, "snippet" + suffix)
    source.write_text(program, encoding="utf-8")
    language = ["-x", "c++", "-std=c++17"] if suffix == ".cpp" else ["-x", "c", "-std=c99"]
    result = subprocess.run([compiler, *language, "-Wall", "-Wextra", "-Werror", "-fsyntax-only",
                             *includes, source], capture_output=True, text=True)
    return result.stderr if result.returncode != 0 else ""


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    root, compiler, eigen, version = pathlib.Path(sys.argv[1]), *sys.argv[2:5]
    includes = [f"-I{root / 'include'}", f"-I{version}", f"-isystem{eigen}"]
    programs = [*page_programs(root), *device_programs(root), *header_programs(root)]
    with tempfile.TemporaryDirectory() as folder:
        for name, suffix, program in programs:
            said = mistake(program, suffix, compiler, includes, folder)
            if said:
                sys.exit(f"{name} does not compile:\n{said}")
        # A guard is believed once a planted fault has made it fail.
        name, suffix, program = programs[-1]
        if not mistake(program.replace("_make(memory", "_make(0x"), suffix, compiler, includes, folder):
            sys.exit("a planted mistake compiles")
        if not mistake(CONTINUED % "report.no_such_field;", ".cpp", compiler, includes, folder):
            sys.exit("a field that does not exist compiles")
    print(f"{len(programs)} snippets compile; 2 planted mistakes do not")


if __name__ == "__main__":
    main()
