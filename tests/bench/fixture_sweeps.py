"""Sweeps of 1,000 steps over every shipped scene: how long the slowest take.

    fixture_sweeps.py TOOL ROOT [PATTERN]      scenes whose name has PATTERN in it

Mass, friction, grip and the turn of all friction generators, and where and in which direction the
first pusher pushes. Processor seconds, the shorter of two runs.
"""
import pathlib
import subprocess
import sys
import tomllib

TOOL, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "tests/support"))
from processor_time import processor_time

PATTERN = sys.argv[3] if len(sys.argv) > 3 else ""


def ranges(scene):
    mass = scene["object"]["mass"]
    yield from (f"object.mass={mass / 2}:{2 * mass}", "*.friction=0.1:0.9", "*.grip_force=5:30", "*.tangent_turn=0:45")
    for pusher in scene.get("pusher", [])[:1]:
        yield from (f"{pusher['name']}.{what}" for what in ("shift[0]=0:0.005", "shift[1]=0:0.005", "turn=0:45"))


def main():
    times = []
    for path in sorted((ROOT / "fixtures/scenes").glob("*.toml")):
        if PATTERN not in path.stem:
            continue
        for what in ranges(tomllib.loads(path.read_text())):
            took = []
            for _ in range(2):
                before = processor_time()
                done = subprocess.run([TOOL, "sweep", path, "--vary", what, "--steps", "1000", "--json"],
                                      capture_output=True)
                took.append(processor_time() - before)
            if done.returncode != 2:  # the scene has no such number
                times.append((min(took), f"{path.stem} {what}"))
    times.sort(reverse=True)
    print(f"{len(times)} sweeps, {sum(time > 0.5 for time, _ in times)} of them above 0.5 s; the slowest:")
    print(*(f"{time:5.2f} s  {what}" for time, what in times[:12]), sep="\n")


if __name__ == "__main__":
    main()
