"""After `cmake --install` the tool runs, and completions and the man page lie where shells and man look."""
import pathlib
import shutil
import subprocess
import sys

prefix = pathlib.Path(sys.argv[1])
tool = prefix / "bin" / "lcpush"
places = {  # below the prefix, as bash-completion, zsh's fpath, fish and man search their data folders
    "bash": "share/bash-completion/completions/lcpush",
    "zsh": "share/zsh/site-functions/_lcpush",
    "fish": "share/fish/vendor_completions.d/lcpush.fish",
    "man": "share/man/man1/lcpush.1",
}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


assert output(tool, "--version").startswith("lcpush "), "the installed tool does not run"
for reader, place in places.items():
    assert (prefix / place).read_text() == output(tool, "completion", reader), place
for typed, wanted in ((["so"], "solve"), (["solve", "--str"], "--strict"),
                      (["solve", "--format", "j"], "json")):
    script = (f"source {prefix / places['bash']}; COMP_WORDS=(lcpush {' '.join(typed)}); "
              f"COMP_CWORD={len(typed)}; _lcpush; echo ${{COMPREPLY[@]}}")
    assert output("bash", "-c", script).split() == [wanted], (typed, output("bash", "-c", script))
for shell in ("zsh", "fish"):
    if shutil.which(shell):
        output(shell, "-n", prefix / places[shell])
if shutil.which("man"):
    found = output("man", "-M", prefix / "share/man", "-w", "lcpush").strip()
    assert pathlib.Path(found) == prefix / places["man"], found
if shutil.which("groff"):
    page = subprocess.run(["groff", "-man", "-Tascii", "-P-bcou", "-ww", prefix / places["man"]],
                          capture_output=True, text=True, check=True)
    assert "lcpush sweep" in page.stdout and page.stderr == "", page.stderr
    wide = [line for line in page.stdout.splitlines() if len(line) > 80]
    assert not wide, wide
print("installed: ok")
