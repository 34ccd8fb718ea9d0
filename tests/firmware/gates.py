#!/usr/bin/env python3
"""Runs the firmware under QEMU and holds it to its gates.

    gates.py --build DIR m3 m4f m7d            all gates of these microcontrollers
    gates.py --build DIR --record m3 m4f m7d   writes their figures to recorded.txt, at a release
    gates.py --build DIR planted               every gate fails where a fault was planted
    gates.py --build DIR --tool lcpush --fixtures DIR scenes
                                               the programs answer as the shipped files do
    gates.py --build DIR --page FILE page      writes the page's tables, at a release
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

from programs import MACHINE, PRECISION, Programs, instructions, number, table
from tables import code_at_once, code_table, flash_table, loop_table, size_table, unit_costs, work_table

PROGRAMS = ("push", "sizes", "small", "loop", "hold", "pivots", "kernel")

FLASH = {"m4f": 44 * 1024}  # describe, solve by pivots, read: linked at once
KERNEL_BYTES = 2048  # a pivot: ratio test, exchange, bookkeeping
KERNEL_STACK = {"float": 512, "double": 768}
REST_OF_RAM = {"push": 512, "pivots": 4096}  # beside the block of memory; pivots keeps two scenes
GROWTH = 1.1  # over what the last release has recorded
RECORDED = re.compile(r"\.(pivots|break)$")  # the runs of `push` whose figures are
# Instructions of a pivot, at most, by 16 n + 3 t^2 for n unknowns and t exchanges: soft float takes
# ten times as many.
PER_ENTRY = {"m3": 100, "m4f": 10, "m7d": 10}
SET_UP = 20  # pivots that set-up and final check take as much as
SLIDE_ENTRIES = 16 * (10 * (8 + 2) + 2) + 3 * (10 + 2 * 2 + 16) ** 2
WORK_OFF = (0.14, 0.3)  # of a unit of work's instructions: nine of ten solves, and all
# What leaves a program that does not call it.
LEAVES = {"break_grasp": "find_breaking", "a motion": "TimeStepper", "sweeps": "BlockGaussSeidel",
          "a hold": "RevisedSimplex"}

FORBIDDEN = re.compile(
    r"malloc|^_?free(_r)?$|calloc|realloc|sbrk|^_Zn[wa]|^_Zd[la]|__cxa_throw|__cxa_.*exception"
    r"|_Unwind_|__gxx_personality|printf|^_ZT[IS]|ios_base"
)
FORBIDDEN_IN_SINGLE = re.compile(r"__aeabi_d|__aeabi_.*2d$|__.*df[23]$")


# Gates: each yields what is wrong. `program` and `target` name what is looked at.


def gate_symbols(programs, program, target):
    for symbol in programs.symbols(program, target):
        if FORBIDDEN.search(symbol):
            yield f"{program}: links {symbol}"
        if PRECISION[target] == "float" and FORBIDDEN_IN_SINGLE.search(symbol):
            yield f"{program}: double precision in single: {symbol}"


def gate_data(programs, program, target):
    size = programs.sections(program, target).get(".data", 0)
    if size != 0:
        yield f"{program}: .data has {size} bytes"


def gate_ram(programs, program, target, like=None):
    """.bss is what the macro or push_bytes says for the largest scene, and a constant."""
    like = like or program
    if like == "push":
        memory = max(int(run["bytes"]) for run in programs.runs(program, target).values())
    else:
        memory = next(int(line.split()[1]) for line in programs.run(program, target)
                      if line.startswith("memory "))
    rest = programs.sections(program, target)[".bss"] - memory
    if not 0 <= rest <= REST_OF_RAM[like]:
        yield f"{program}: {rest} bytes of RAM beside the block, allowed {REST_OF_RAM[like]}"


def gate_flash(target, size):
    """The least that a controller links."""
    if target in FLASH and size > FLASH[target]:
        yield f"small: {size} bytes of flash, allowed {FLASH[target]}"


def gate_kernel(programs, target, source="kernel"):
    program = "kernel" if source == "kernel" else source
    size = programs.code_of(program, target, source)
    if size > KERNEL_BYTES:
        yield f"a pivot takes {size} bytes of code, allowed {KERNEL_BYTES}"


def gate_kernel_stack(programs, target, program="kernel"):
    deepest = {int(run["stack"]) for run in programs.runs(program, target).values()}
    allowed = KERNEL_STACK[PRECISION[target]]
    if len(deepest) != 1 or max(deepest) > allowed:
        yield f"a pivot takes {sorted(deepest)} bytes of stack, allowed one number <= {allowed}"


def gate_step_stack(programs, target):
    """A step of Lemke's method that pivots; the last one refines and checks as well."""
    steps = {name: int(run["stack"]) for name, run in programs.runs("pivots", target).items()
             if "last_stack" in run}
    allowed = KERNEL_STACK[PRECISION[target]]
    if len(set(steps.values())) != 1 or max(steps.values()) > allowed:
        yield f"steps take {steps} bytes of stack, allowed one number <= {allowed}"


def gate_static_stack(programs, name, target):
    """No frame depends on the input."""
    for line in programs.stack_usage(name, target):
        if not line.endswith("static"):
            yield f"{name}: {line}"


def gate_bits(programs, program, target, like):
    """Statuses, pivots, residuals, answers and paths: bit by bit those of the desktop."""
    here = programs.runs_here(like, PRECISION[target])
    there = programs.runs(program, target)
    if here.keys() != there.keys():
        yield f"{program}: other runs than on the desktop"
    for name in sorted(here.keys() & there.keys()):
        for key, value in here[name].items():
            if key.endswith(("ticks", "stack", "bytes")):
                continue
            if there[name].get(key) != value:
                yield f"{name}: {key} {there[name].get(key)}, on the desktop {value}"


def gate_limit(programs, program, target):
    """A pivot limit ends a solve, after instructions in proportion."""
    runs = {limit: programs.runs(program, target)[f"limit_{limit}"] for limit in (10, 20, 40)}
    for limit, run in runs.items():
        if run["status"] != "pivot_limit":
            yield f"{program}: limit_{limit} ends with {run['status']}"
    most = PER_ENTRY[target] * SLIDE_ENTRIES
    rest = instructions(runs[10]["ticks"]) - 10 * most
    if rest > SET_UP * most:
        yield f"{program}: {rest} instructions beside the pivots, allowed {SET_UP * most}"
    for few, many in ((10, 20), (20, 40)):
        took = instructions(runs[many]["ticks"]) - instructions(runs[few]["ticks"])
        if not 0 < took <= most * (many - few):
            yield f"{program}: {took} instructions for {many - few} pivots, allowed {most} each"


def gate_work(programs, program, target):
    """Instructions are in proportion to the work; a call takes its budget and one piece more."""
    runs = programs.runs(program, target)
    for name, run in runs.items():
        if run["status"] != "solved" or run["in_calls"] != "solved":
            yield f"{program} {name}: {run['status']}, in calls {run['in_calls']}"
    unit, off = unit_costs(runs)
    if off[9 * len(off) // 10] > WORK_OFF[0] or off[-1] > WORK_OFF[1]:
        yield (f"{program}: a unit takes {unit:.1f} instructions, nine of ten solves within "
               f"{off[9 * len(off) // 10]:.3f} of that, the last {off[-1]:.3f}")


def gate_leaves(programs, program, target):
    """What is not called is not linked."""
    symbols = " ".join(programs.symbols(program, target))
    for part, name in LEAVES.items():
        if name in symbols:
            yield f"{program}: carries {part}, which it does not call"


def gate_repeats(programs, program, target):
    if table(programs.run(program, target)) != programs.runs(program, target):
        yield f"{program}: a second run differs"


def figures(programs, program, target, like=None):
    """{name: {key: number or word}}: what is recorded of a program."""
    like = like or program
    found = {f"{like}.elf": {"code": programs.sections(program, target)[".text"]}}
    if like != "push":
        return found
    found["core"] = {"code": programs.code_of(program, target, "core")}
    for name, run in programs.runs(program, target).items():
        if RECORDED.search(name):
            found[name] = {"status": run["status"], "instructions": instructions(run["ticks"]),
                           "stack": int(run["stack"])}
    return found


def gate_recorded(programs, program, target, recorded, like=None):
    """Code, instructions and stack at most a tenth over the record; statuses as recorded."""
    for name, figure in figures(programs, program, target, like).items():
        known = recorded.get((target, name))
        if known is None:
            yield f"{name} is not recorded"
            continue
        for key, value in figure.items():
            if key == "status" and known.get(key) != value:
                yield f"{name}: {value}, recorded {known.get(key)}"
            elif key != "status" and value > GROWTH * int(known.get(key, 0)):
                yield f"{name}: {key} {value}, recorded {known.get(key)}"


# The record.


def versions(programs):
    compiler = programs.tool("g++", "-dumpfullversion").strip()
    return f"arm-none-eabi-g++ {compiler}"


def read_record(path):
    """{(target, name): {key: text}}, and what compiler made them."""
    recorded, compiler = {}, None
    for line in path.read_text().splitlines() if path.exists() else []:
        words = line.split()
        if line.startswith("# compiler "):
            compiler = line.removeprefix("# compiler ")
        elif words and not line.startswith("#"):
            recorded[words[0], words[1]] = dict(word.split("=") for word in words[2:])
    return recorded, compiler


def write_record(path, recorded, compiler):
    lines = ["# Code and stack in bytes, instructions as QEMU counts them; written by gates.py --record.",
             f"# compiler {compiler}"]
    for (target, name), figure in sorted(recorded.items()):
        lines.append(" ".join([target, name] + [f"{k}={v}" for k, v in figure.items()]))
    path.write_text("\n".join(lines) + "\n")


# Commands.


def check(programs, target, args):
    recorded, compiler = read_record(args.recorded)
    if args.record:
        recorded = {key: value for key, value in recorded.items() if key[0] != target}
        for program in PROGRAMS:
            for name, figure in figures(programs, program, target).items():
                recorded[target, name] = figure
        write_record(args.recorded, recorded, versions(programs))
        return
    for program in PROGRAMS:
        yield from gate_symbols(programs, program, target)
        yield from gate_data(programs, program, target)
        yield from gate_bits(programs, program, target, program)
        yield from gate_repeats(programs, program, target)
    for program in ("push", "pivots"):
        yield from gate_ram(programs, program, target)
    yield from gate_leaves(programs, "small", target)
    yield from gate_bits(programs, "small_flto", target, "small")
    yield from gate_kernel(programs, target)
    yield from gate_kernel_stack(programs, target)
    yield from gate_step_stack(programs, target)
    for name in ("core", "pivots", "kernel", "push"):
        yield from gate_static_stack(programs, name, target)
    yield from gate_limit(programs, "push", target)
    yield from gate_bits(programs, "work", target, "work")
    yield from gate_work(programs, "work", target)
    if compiler == versions(programs):
        for program in PROGRAMS:
            yield from gate_recorded(programs, program, target, recorded)
        yield from gate_flash(target, code_at_once(programs, "small", target))
    else:
        print(f"recorded with {compiler}, not {versions(programs)}: figures are not compared")
    show(programs, target)


def show(programs, target):
    push = programs.runs("push", target)
    print(f"{target} on {MACHINE[target]}: {programs.sections('push', target)['.text']} bytes of code, "
          f"{programs.code_of('push', target, 'core')} of them the library, "
          f"{programs.code_of('kernel', target, 'kernel')} a pivot")
    for name, run in push.items():
        print(f"  {name:28} {run['status']:20} residual {number(run['residual']):8.1e}  "
              f"{run['bytes']:>7} bytes  {instructions(run['ticks']):>10} instructions  "
              f"{run['stack']:>5} stack")


def scenes(programs, args):
    """The tool's answers to the shipped files, by the programs' scenes."""
    for precision, tolerance in (("float", 1e-3), ("double", 1e-9)):
        runs, compared = programs.runs_here("push", precision), 0
        for name, run in runs.items():
            scene, *rest = name.split(".")
            path = pathlib.Path(args.fixtures) / f"{scene}.toml"
            if not rest or rest[0] == "even" or run["status"] != "solved":
                continue
            verb = "break" if rest[1] == "break" else "solve"
            words = [] if "\nfacets" in path.read_text() else ["--facets", "8"]
            done = subprocess.run([args.tool, verb, str(path), "--json", *words],
                                  capture_output=True, text=True)
            answer = json.loads(done.stdout)
            if verb == "break":
                force = answer["break_force"]
            else:
                pusher = answer["bodies"][-1]["name"]
                force = sum(contact["normal_force"] for contact in answer["contacts"]
                            if contact["body"] == pusher)
            compared += 1
            if not abs(number(run["force"]) - force) <= tolerance * max(1, abs(force)):
                yield f"{precision} {name}: pushes with {number(run['force'])}, the file {force}"
        print(f"{precision}: {compared} answers compared")
        if compared < 8:
            yield f"{precision}: only {compared} runs have an answer to compare"


def page(programs, args):
    """Writes the tables between markers in a page."""
    path = pathlib.Path(args.page)
    text = path.read_text()
    for name, lines in (("sizes", size_table(programs)), ("loop", loop_table(programs)),
                        ("work", work_table(programs)), ("code", code_table(programs)),
                        ("flash", flash_table(programs))):
        begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->\n"
        before, rest = text.split(begin)
        text = before + begin + "".join(f"{line}\n" for line in lines) + end + rest.split(end)[1]
    path.write_text(text)
    return []


def planted(programs, args):
    """Yields the faults that no gate has seen."""
    recorded, _ = read_record(args.recorded)
    def gate(check, name, *rest):
        return lambda: check(programs, f"planted_{name}", "m4f", *rest)

    # The fault, the gate that must see it, and a part of what it must say.
    faults = [
        ("heap", gate(gate_symbols, "heap"), "links malloc"),
        ("double in single", gate(gate_symbols, "double"), "__aeabi_dmul"),
        ("data", gate(gate_data, "data"), ".data"),
        ("RAM", gate(gate_ram, "ram", "push"), "bytes of RAM"),
        ("code", gate(gate_recorded, "kernel", recorded, "kernel"), "code"),
        ("instructions", gate(gate_recorded, "work", recorded, "push"), "instructions"),
        ("stack", gate(gate_recorded, "stack", recorded, "push"), ": stack"),
        ("stack that depends on the input", gate(gate_static_stack, "stack"), "dynamic"),
        ("what is not called", gate(gate_leaves, "carries"), "carries break_grasp"),
        ("a wrong bit", gate(gate_bits, "bit", "push"), "hash"),
        ("a wrong pivot", gate(gate_bits, "path", "pivots"), "path"),
        ("a limit not heeded", gate(gate_limit, "limit"), "ends with solved"),
        ("a limit heeded late", gate(gate_limit, "late"), "instructions for"),
        ("flash", lambda: gate_flash("m4f", programs.code_of("small", "m4f", "core")), "of flash"),
        ("a pivot's code", lambda: gate_kernel(programs, "m4f", "planted_kernel"), "of code"),
        ("a pivot's stack", lambda: gate_kernel_stack(programs, "m4f", "planted_turn"), "of stack"),
    ]
    for name, look, words in faults:
        found = [line for line in look() if words in line]
        print(f"{name}: {found[0] if found else 'nothing seen'}")
        if not found:
            yield f"the fault '{name}' passes its gate"
    try:
        programs.run("push", "m7d", machine=MACHINE["m4f"])
        yield "double precision on a processor without it passes"
    except RuntimeError as error:
        print(f"fault: {error}")
        if "exit 99" not in str(error) or "FAULT" not in str(error):
            yield "a processor's fault is not reported as one"
    for symbol in ("malloc", "free", "calloc", "realloc", "_sbrk", "_Znwj", "_Znaj", "_ZdlPv",
                   "_ZdaPv", "__cxa_throw", "__cxa_allocate_exception", "_Unwind_Resume",
                   "__gxx_personality_v0", "printf", "vsnprintf", "_ZTIi", "_ZTSi",
                   "_ZNSt8ios_base4InitC1Ev"):
        if not FORBIDDEN.search(symbol):
            yield f"{symbol} is not forbidden"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="+", choices=[*MACHINE, "scenes", "planted", "page"])
    parser.add_argument("--build", required=True)
    parser.add_argument("--qemu", default="qemu-system-arm")
    parser.add_argument("--recorded", type=pathlib.Path,
                        default=pathlib.Path(__file__).with_name("recorded.txt"))
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--tool")
    parser.add_argument("--fixtures")
    parser.add_argument("--page")
    args = parser.parse_args()
    programs = Programs(args)
    wrong = []
    for what in args.what:
        command = {"scenes": scenes, "planted": planted, "page": page}.get(what)
        try:
            wrong += command(programs, args) if command else check(programs, what, args)
        except RuntimeError as error:
            wrong.append(str(error))
    for line in wrong:
        print(f"WRONG {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
