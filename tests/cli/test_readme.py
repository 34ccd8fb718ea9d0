"""README.md does what it says, as written; so do docs/README.md, the gallery, and the two listed programs.

    test_readme.py TOOL ROOT [--write]    --write draws and tells the gallery's scenes again
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

tool, source = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
build = pathlib.Path(tool).parent
readme = (source / "README.md").read_text()


def output(*command, folder=source, codes=(0,)):
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert result.returncode in codes, (command, result.returncode, result.stderr)
    return result.stdout


def must_show(page, what, text):
    if text.rstrip("\n") not in (source / page).read_text():
        sys.exit(f"{page} does not show {what} as it is now:\n{text}")


assert len(readme.splitlines()) <= 85, "README.md is a first page of 80 lines or so"

# The set-up commands: what .ci/run makes of their lines, here and on the page for those who have no README.
reader = re.search(r"^readme_command\(\) \{.*?^\}", (source / ".ci/run").read_text(), flags=re.M | re.S)[0]
found = {}
for page in ("README.md", "docs/building.md"):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "README.md").write_text((source / page).read_text())
        found[page] = [output("bash", "-c", f"{reader}\nreadme_command '{end}'", folder=folder)
                       for end in ("release.*lcpush solve .*", "test")]
    for command in found[page]:
        assert command.count("\n") == 1 and "\\" not in command and command.startswith("$("), command
assert found["README.md"] == found["docs/building.md"], found
first = shlex.split(found["README.md"][0].split("&&")[-1])
assert first[0] == "build/release/lcpush", first
shown = re.search(r"```text\n(.*?)```", readme, flags=re.S)[1]
assert output(tool, *first[1:]).startswith(shown), shown

# The other commands, in a folder that has what a clone has.
with tempfile.TemporaryDirectory() as folder:
    for name in ("fixtures", "docs"):
        (pathlib.Path(folder) / name).symlink_to(source / name)
    doors = re.findall(r"`build/release/lcpush ([^`]*)`", readme)
    assert len(doors) == 4, doors
    for door in doors:
        output(tool, *shlex.split(door), folder=folder)
    for page in ("play.html", "pivots.html", "mine.toml"):
        assert (pathlib.Path(folder) / page).stat().st_size > 0, page

for page, folder, example, program in (("docs/guide/cpp.md", "docs/guide", "slide", "slide"),
                                       ("docs/embed/embedding.md", "docs/embed", "embedded", "embedded_main")):
    must_show(page, f"{example}.cpp",
              "```cpp\n" + (source / f"{folder}/{example}.cpp").read_text().rstrip("\n") + "\n```")
    must_show(page, f"the output of {program}", "```text\n" + output(build / f"example_{program}"))

# The gallery has every shipped scene, with what `lcpush solve` says first (tests/cli/test_report.py has the pictures).
gallery = (source / "docs/README.md").read_text()
for scene in sorted((source / "fixtures/scenes").glob("*.toml")):
    words = " ".join(output(tool, "solve", scene, codes=(0, 1)).split("\n\n")[1].split())
    says = re.match(r"(No answer\. )?.*?\.(?= [A-Z]|$)", words)[0]
    cell = re.search(rf'<img src="scenes/{scene.stem}\.svg"[^|]*<br>\*([^|]*)\* \|', gallery)
    assert cell is not None, f"docs/README.md does not show {scene.stem}"
    if "--write" in sys.argv:
        gallery = gallery[:cell.start(1)] + says + gallery[cell.end(1):]
        if scene.stem != "two_pushers":
            output(tool, "report", scene, "--format", "svg", "--picture", "isometric", "-o",
                   source / f"docs/scenes/{scene.stem}.svg", codes=(0, 1))
    elif cell[1] != says:
        sys.exit(f"docs/README.md says of {scene.stem}:\n{cell[1]}\nand lcpush solve:\n{says}")
if "--write" in sys.argv:
    (source / "docs/README.md").write_text(gallery)

# Links inside the project lead somewhere, in the README and in docs/.
for page in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.S)
    for target in re.findall(r"\]\(([^)#\s]+)", text) + re.findall(r'(?:src|href)="([^"#]+)"', text):
        if "://" not in target and not target.startswith("live/") and not (page.parent / target).exists():
            sys.exit(f"{page.relative_to(source)}: link to {target}, which does not exist")
print("README: ok")
