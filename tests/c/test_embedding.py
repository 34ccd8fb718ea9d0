"""The first two sections of docs/embed/embedding.md, pasted as a new user would: the bundle, its example; and programs
of `lcpush export --format c` in it, whose last tick is what `lcpush solve` says.

Usage: test_embedding.py REPO_ROOT TOOL
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
page = (root / "docs/embed/embedding.md").read_text()
readme = (root / "docs/embed/bundle.md").read_text()
program = re.findall(r"```c\n(.*?)```", page, flags=re.S)[0]  # the next: tests/contract/test_snippets.py
shell = re.findall(r"```sh\n(.*?)```", page, flags=re.S)
[making] = [block for block in shell if "--target device_bundle" in block]
[for_arm] = [block for block in shell if block.startswith("arm-none-eabi-g++")]
[running] = [block for block in shell if "./push" in block]
expected = re.findall(r"```text\n(.*?)```", page, flags=re.S)[0]  # the next is of C++: tests/cli/test_readme.py
assert for_arm in readme, "docs/embed/bundle.md compiles for Arm by another command"
assert program == (root / "docs/embed/main.c").read_text(), "docs/embed/main.c is another program"

HELD = "docs/guide/held_block.toml"
SCENES = [("fixtures/scenes/straight_slide.toml", []), (HELD, []), ("fixtures/scenes/pivot.toml", []),
          (HELD, ["pressure=even", "gripper.jaws=independent"]), (HELD, ["gripper.jaws=locked", "facets=4"]),
          (HELD, ["planar=true", "pin.follow=bilateral"]),
          (HELD, ["pin.torsion_radius=2 mm", "object.tilt=20 deg about x", "object.force=[1, 2, 3]"])]

with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    for part in ("CMakeLists.txt", "LICENSE", "docs", "fixtures", "include", "src"):
        (work / part).symlink_to(root / part)
    result = subprocess.run(["sh", "-ec", f"( {making} ) >made.txt\ncd build/lcpush\n{running}"], cwd=work,
                            capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stderr == "", result.stderr
    if result.stdout != expected:
        sys.exit(f"docs/embed/embedding.md: the example prints now\n{result.stdout}")
    bundle = work / "build/lcpush"
    for name, changes in SCENES:
        scene, options = root / name, [word for change in changes for word in ("--set", change)]
        made = [sys.argv[2], "export", scene, "--format", "c", "-o", work / "made", *options]
        subprocess.run(made, check=True, capture_output=True)
        subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror", "-Iinclude",
                        work / "made/main.c", "lcpush.o", "-o", "made"], cwd=bundle, check=True)
        lines = subprocess.run([bundle / "made"], capture_output=True, text=True, check=True).stdout.splitlines()
        answer = json.loads(subprocess.run([sys.argv[2], "solve", scene, "--json", *options], capture_output=True).stdout)
        last = lines[-len(answer["bodies"]) - 1:]
        assert last[0].startswith("tick 10: solved"), last[0]
        numbers = [[float(x) for x in re.findall(r" (-?[\d.]+(?:e[+-]\d+)?)(?= |$|\b)", line.split(";" if k == 0 else ":")[1])]
                   for k, line in enumerate(last)]
        wanted = [answer["object"]["acceleration"]] + [body["force"] + body["moment"] for body in answer["bodies"]]
        for given, want in zip(numbers, wanted):  # six digits are printed
            assert len(given) == 6 and all(abs(a - b) <= 1e-5 * max(1, abs(b)) for a, b in zip(given, want)), (name, changes, given, want)
        subprocess.run(["gcc", "-std=c99", "-Wall", "-Wextra", "-Wdouble-promotion", "-Werror", "-DIN_FLOAT", "-Iinclude",
                        work / "made/main.c", "lcpush.o", "-o", "made_in_float"], cwd=bundle, check=True)
        assert subprocess.run([bundle / "made_in_float"], capture_output=True, text=True).stdout.count("tick") == 10, name
print("the bundle and the example of docs/embed/embedding.md: ok")
