"""The worked example of docs/embed/embedding.md, pasted as a new user would.

Usage: test_embedding.py REPO_ROOT
"""
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
page = (root / "docs/embed/embedding.md").read_text()
[program] = re.findall(r"```c\n(.*?)```", page, flags=re.S)
shell = [block for block in re.findall(r"```sh\n(.*?)```", page, flags=re.S) if "./push" in block]
[expected] = re.findall(r"```text\n(.*?)```", page, flags=re.S)
assert len(shell) == 1

with tempfile.TemporaryDirectory() as folder:
    work = pathlib.Path(folder)
    for part in ("include", "src"):
        (work / part).symlink_to(root / part)
    (work / "main.c").write_text(program)
    result = subprocess.run(["sh", "-ec", shell[0]], cwd=work, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stderr == "", result.stderr
    if result.stdout != expected:
        sys.exit(f"docs/embed/embedding.md: the example prints now\n{result.stdout}")
print("the example of docs/embed/embedding.md: ok")
