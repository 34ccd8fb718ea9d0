"""The first two sections of docs/embed/embedding.md, pasted as a new user would: the bundle, its example.

Usage: test_embedding.py REPO_ROOT
"""
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1]).resolve()
page = (root / "docs/embed/embedding.md").read_text()
readme = (root / "docs/embed/bundle.md").read_text()
[program] = re.findall(r"```c\n(.*?)```", page, flags=re.S)
shell = re.findall(r"```sh\n(.*?)```", page, flags=re.S)
[making] = [block for block in shell if "--target device_bundle" in block]
[for_arm] = [block for block in shell if block.startswith("arm-none-eabi-g++")]
[running] = [block for block in shell if "./push" in block]
expected = re.findall(r"```text\n(.*?)```", page, flags=re.S)[0]  # the next is of C++: tests/cli/test_readme.py
assert for_arm in readme, "docs/embed/bundle.md compiles for Arm by another command"
assert program == (root / "docs/embed/main.c").read_text(), "docs/embed/main.c is another program"

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
print("the bundle and the example of docs/embed/embedding.md: ok")
