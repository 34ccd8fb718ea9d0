"""The tables of docs/embed/tables.md, line by line."""
from programs import MACHINE, instructions


def size_table(programs, program="sizes"):
    """Memory, steps and instructions by points and facets."""
    yield "| points | facets | unknowns | solver | RAM float / double | steps | M3, soft float | M4F, float | M7, double |"
    yield "|---|---|---|---|---|---|---|---|---|"
    runs = {target: programs.runs(program, target) for target in MACHINE}
    for name, run in runs["m4f"].items():
        points, facets, law, solver = name.split(".")
        there = [runs[target][name] for target in MACHINE]
        instructions_of = [
            f"{instructions(int(r['describe_ticks']) + int(r['ticks'])) / 1e6:.1f} M"
            if r["status"] == "solved" else r["status"] for r in there]
        steps = dict.fromkeys((run["steps"], runs["m7d"][name]["steps"]))
        yield " | ".join(["| " + points[1:], facets[1:], run["unknowns"],
                          f"{solver}, `{law}`", f"{run['bytes']} / {runs['m7d'][name]['bytes']}",
                          " / ".join(steps), *instructions_of]) + " |"


def unit_costs(runs):
    """Instructions of a unit of work, the median of solves; and how far each is off, in order."""
    units = sorted(instructions(run["ticks"]) / int(run["work"]) for run in runs.values())
    median = units[len(units) // 2]
    return median, sorted(abs(unit / median - 1) for unit in units)


def work_table(programs):
    """What a unit of work takes, and calls of step_within."""
    yield "| | M3, soft float | M4F, float | M7, double |"
    yield "|---|---|---|---|"
    runs = {target: programs.runs("work", target) for target in MACHINE}
    costs = {target: unit_costs(runs[target]) for target in MACHINE}
    rows = {
        "instructions of a unit": lambda t: f"{costs[t][0]:.0f}",
        "nine of ten solves within": lambda t: f"{100 * costs[t][1][9 * len(costs[t][1]) // 10]:.0f} %",
        "all within": lambda t: f"{100 * costs[t][1][-1]:.0f} %",
        "`step_within(push, 4000)`, the most work": lambda t: max(int(r["most"]) for r in runs[t].values()),
        "`step_within(push, 4000)`, the dearest": lambda t:
            f"{max(instructions(r['dearest_ticks']) for r in runs[t].values()) / 1e6:.2f} M",
    }
    for name, figure in rows.items():
        yield " | ".join([f"| {name}", *(str(figure(target)) for target in MACHINE)]) + " |"


def code_table(programs):
    """Bytes of code, and the stack."""
    yield "| | M3, soft float | M4F, float | M7, double |"
    yield "|---|---|---|---|"
    rows = {
        "code and constants of the library, B": lambda t: programs.code_of("push", t, "core"),
        "of these, a pivot, B": lambda t: programs.code_of("kernel", t, "kernel"),
        "stack of a pivot, B": lambda t: max(int(run["stack"])
                                             for run in programs.runs("kernel", t).values()),
        "stack of a step that pivots, B": lambda t: max(
            int(run["stack"]) for run in programs.runs("pivots", t).values()
            if "last_stack" in run),
        "stack of `solve`, B": lambda t: max(int(run["stack"])
                                             for run in programs.runs("sizes", t).values()),
        "stack of `describe`, B": lambda t: max(int(run["describe_stack"])
                                                for run in programs.runs("sizes", t).values()),
        "stack of `break_grasp`, B": lambda t: max(
            int(run["stack"]) for name, run in programs.runs("push", t).items()
            if name.endswith("break")),
    }
    for name, figure in rows.items():
        yield " | ".join([f"| {name}", *(str(figure(target)) for target in MACHINE)]) + " |"


def loop_table(programs):
    """Instructions of a control loop's calls."""
    yield "| | M3, soft float | M4F, float | M7, double |"
    yield "|---|---|---|---|"
    rows = {"command.0": "a command, no pivot", "command.5": "a command, one to five pivots",
            "command.1000": "a command, more", "tick.1": "`step(push, 1)`, the dearest",
            "tick.4": "`step(push, 4)`, the dearest", "tick.16": "`step(push, 16)`, the dearest",
            "advance.0": "`advance`"}
    for law in ("pad", "rigid"):
        for key, name in rows.items():
            runs = [programs.runs("loop", target)[f"{law}.{key}"] for target in MACHINE]
            figures_of = [f"{instructions(run['ticks']) / 1e6:.2f} M" for run in runs]
            if key.startswith("command"):
                figures_of = [f"{figure}, {run['count']} times" if run["count"] != "0" else "never"
                              for figure, run in zip(figures_of, runs)]
            yield " | ".join([f"| `{law}`: {name}", *figures_of]) + " |"


def code_at_once(programs, program, target):
    """Of the library, linked with -flto: what is left of it has no names of objects any more."""
    apart, at_once = (programs.sections(name, target)[".text"] for name in (program, f"{program}_flto"))
    core = program.replace("small", "core")
    return programs.code_of(program, target, core) - (apart - at_once)


def flash_table(programs):
    """Bytes of code of the library in programs that call more and more of it."""
    yield "| | M3, soft float | M4F, float | M7, double |"
    yield "|---|---|---|---|"
    least = {target: programs.code_of("small", target, "core") for target in MACHINE}
    yield " | ".join(["| describe, solve by pivots, read, B",
                      *(str(least[target]) for target in MACHINE)]) + " |"
    for part, name in (("break", "`break_grasp` as well"), ("motion", "a motion as well"),
                       ("hold", "`least_grip` and `margin` as well")):
        more = [programs.code_of(f"small_{part}", target, "core") - least[target]
                for target in MACHINE]
        yield " | ".join([f"| {name}", *(f"+{size}" for size in more)]) + " |"
    yield " | ".join(["| with `-flto`, the first row",
                      *(str(code_at_once(programs, "small", target)) for target in MACHINE)]) + " |"
    yield " | ".join(["| sweeps instead of pivots",
                      *(str(programs.code_of("small_sweeps", target, "core"))
                        for target in MACHINE)]) + " |"
