"""The table of docs/check/collection.md, from scores of every solver there is on this machine.

    /usr/bin/python3 docs/check/collection_table.py build/release/lcpush           writes the page
    /usr/bin/python3 docs/check/collection_table.py build/release/lcpush --check lcpush siconos_lemke
"""
import contextlib
import os
import pathlib
import platform
import subprocess
import sys

sys.dont_write_bytecode = True
# OpenBLAS rounds as the processor's own kernel does: pinned, the scores are those of any x86 machine.
os.environ.update(OPENBLAS_CORETYPE="Prescott", OPENBLAS_NUM_THREADS="1")
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import run_collection as runner

PAGE, SECONDS = HERE / "collection.md", 10
BEGIN, END = "<!-- table -->\n", "<!-- end of table -->"
TAGS = ["push", "frictional stack", "jam", "near-unsolvable", "bistable", "badly scaled", "degenerate", "textbook", "unsolvable"]
PLUGINS = {"siconos_lemke": "python3-siconos", "siconos_pivot": "python3-siconos",
           "siconos_newton_min": "python3-siconos", "siconos_newton_fb": "python3-siconos", "siconos_rpgs": "python3-siconos",
           "scipy_milp": "python3-scipy", "scipy_slsqp": "python3-scipy", "octave_qp": "octave", "octave_glpk": "octave"}


@contextlib.contextmanager
def hushed():
    """Compiled solvers print what they meet on the way."""
    sys.stdout.flush()
    kept, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    yield
    os.dup2(kept, 1)


def version(package):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
    return f"{package} {done.stdout or 'of ' + platform.system()}"


def row(name, tool, problems):
    command = f"{tool} lcp {{M}} {{q}} [--free {{free}}] --json"
    solve = runner.by_command(command) if name == "lcpush" else runner.by_plugin(HERE / "collection_solvers.py", name)
    with hushed():
        said = [runner.verdict(p, solve, SECONDS).split()[0] for p in problems]
    right = [f"{sum(v == 'right' for p, v in zip(problems, said) if tag in p['tags'])}" for tag in TAGS]
    package = "this version" if name == "lcpush" else version(PLUGINS[name])
    return f"| {name} | {package} | " + " | ".join(f"{said.count(v)}" for v in ("right", "missed", "wrong")) + \
        " | " + " | ".join(right) + " |\n"


def main():
    problems, text = runner.load(), PAGE.read_text()
    if "--check" in sys.argv:
        missing = [name for name in sys.argv[3:] if row(name, sys.argv[1], problems) not in text]
        print("differs: " + ", ".join(missing) if missing else "the table is what is found now")
        return 1 if missing else 0
    table = "| solver | package | right | missed | wrong | " + " | ".join(TAGS) + " |\n" + "|---" * (5 + len(TAGS)) + "|\n"
    table += "| all problems | | " + str(len(problems)) + " | 0 | 0 | " + \
        " | ".join(str(sum(tag in p["tags"] for p in problems)) for tag in TAGS) + " |\n"
    for name in ["lcpush", *PLUGINS]:
        table += row(name, sys.argv[1], problems)
        print(table.splitlines()[-1], flush=True)
    before, rest = text.split(BEGIN)
    PAGE.write_text(before + BEGIN + table + END + rest.split(END)[1])
    return 0


if __name__ == "__main__":
    sys.exit(main())
