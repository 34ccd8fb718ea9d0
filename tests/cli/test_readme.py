"""The README shows what the programs print, and the examples as they are compiled."""
import pathlib
import re
import subprocess
import sys

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])
build = pathlib.Path(tool).parent
readme = (source / "README.md").read_text()


def output(*command):
    return subprocess.run(command, cwd=source, capture_output=True, text=True, check=True).stdout


def must_show(what, text):
    if text.rstrip("\n") not in readme:
        sys.exit(f"README.md does not show {what} as it is now:\n{text}")


must_show("the first answer", output(tool, "solve", "fixtures/scenes/straight_slide.toml"))
must_show("lcpush lcp", output(tool, "lcp", "--M", "2 1; 1 2", "--q", "-5 -6"))
for folder, example, program in (("docs/guide", "slide", "slide"),
                                 ("docs/embed", "embedded", "embedded_main")):
    must_show(f"{folder}/{example}.cpp",
              "```cpp\n" + (source / f"{folder}/{example}.cpp").read_text().rstrip("\n") + "\n```")
    must_show(f"the output of {program}", "```text\n" + output(build / f"example_{program}"))

# Links inside the project lead somewhere, in the README and in docs/.
for page in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
    for target in re.findall(r"\]\(([^)#\s]+)", page.read_text()):
        if "://" not in target and not (page.parent / target).exists():
            sys.exit(f"{page.relative_to(source)}: link to {target}, which does not exist")
print("README: ok")
