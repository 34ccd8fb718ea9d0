"""A solver that nobody watches is the machine code of one that cannot be watched.

Usage: test_trace_is_free.py REPO_ROOT CXX EIGEN_INCLUDE

Compiles Lemke and both Gauss-Seidel solvers to assembly twice: as they are, and from a copy of the
headers in which every call of a watcher is deleted. Not a line may differ. Then a watcher call
that does something is planted, and the comparison has to see it.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root, compiler, eigen = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]

PROGRAM = """
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"
#include "lcpush/lcp/sweeps/gauss_seidel.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"
namespace lcpush {
template class Lemke<double>;
Status run(Lemke<double>& lemke) { return lemke.solve(); }
Status step(Lemke<double>& lemke) { return lemke.step(); }
Status sweep(GaussSeidel<double>& sweeps) { return sweeps.solve(); }
Status sweep(BlockGaussSeidel<double>& sweeps, const Problem<double>& problem) {
  return sweeps.init(problem) == Status::running ? sweeps.solve() : sweeps.status();
}
} // namespace lcpush
"""

# What the headers say to a watcher: a statement of its own, or the row that leaves.
STATEMENT = re.compile(r"^ *watcher\.\w+\([^;]*\);\n", flags=re.M)
ROW = "watcher.choose_leaving_row(*this, pending)"


def without_watchers(text):
    return STATEMENT.sub("", text).replace(ROW, "pending.blocking.row")


def assembly(include, folder, level):
    source, listing = folder / "program.cpp", folder / "program.s"
    source.write_text(PROGRAM)
    subprocess.run([compiler, "-std=c++17", level, "-DNDEBUG", "-S", "-o", listing, f"-I{include}",
                    f"-isystem{eigen}", source], check=True)
    # gcc numbers its labels through all that it has parsed: only their order tells.
    numbers = {}
    renamed = re.sub(r"\.L\w+", lambda label: f".L{numbers.setdefault(label[0], len(numbers))}",
                     listing.read_text())
    return [line for line in renamed.splitlines() if ".file" not in line]


def copy_headers(folder, change):
    shutil.copytree(root / "include", folder / "include")
    changed = 0
    for path in (folder / "include" / "lcpush" / "lcp").rglob("*.hpp"):
        text = path.read_text()
        if path.name != "trace.hpp" and change(text) != text:
            changed += 1
            path.write_text(change(text))
    return folder / "include", changed


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    for part in ("bare", "loud"):
        (work / part).mkdir()
    bare, files = copy_headers(work / "bare", without_watchers)
    if files < 3:
        sys.exit(f"only {files} headers speak to watchers; does this test still know how they do?")
    left = [path for path in (bare / "lcpush" / "lcp").rglob("*.hpp")
            if path.name != "trace.hpp" and re.search(r"watcher\.", path.read_text())]
    if left:
        sys.exit(f"{left[0].name}: a watcher is called in a way that this test does not know")
    for level in ("-O2", "-Os"):
        shipped = assembly(root / "include", work, level)
        if shipped != assembly(bare, work, level):
            sys.exit(f"{level}: the code differs from that of a build without watchers")
    loud, _ = copy_headers(work / "loud", lambda text: text.replace(
        "watcher.stepped(*this);", "watcher.stepped(*this); pivots_ += 0x1234;"))
    if assembly(loud, work, "-Os") == shipped:
        sys.exit("a planted difference was not seen")
    print(f"{len(shipped)} lines of assembly: the same with and without watchers")
