"""fixtures/external: answers of other solvers, each with the verdict that it must get.

    test_external.py TOOL SOURCE
"""
import json
import pathlib
import subprocess
import sys
import tempfile

tool, source = sys.argv[1], pathlib.Path(sys.argv[2])
external = source / "fixtures/external"


def run(*words):
    return subprocess.run([tool, *map(str, words)], capture_output=True, text=True)


index = json.loads((external / "index.json").read_text())
with tempfile.TemporaryDirectory() as folder:
    for entry in index:
        scene = source / f"fixtures/scenes/{entry['scene']}.toml"
        answer = external / entry["file"]
        if entry.get("lcp"):
            parts = pathlib.Path(folder, entry["scene"])
            assert run("export", scene, "-o", parts).returncode == 0
            free = (parts / "free.txt").read_text().strip()
            result = run("verify", "--lcp", parts / "M.mtx", parts / "q.mtx", answer, "--json",
                         *(["--free", free] if free else []))
        else:
            result = run("verify", scene, answer, "--json")
        assert result.stdout, result.stderr
        report = json.loads(result.stdout)
        assert report["verdict"] == entry["verdict"], (entry, report)
        assert result.returncode == (0 if report["valid"] else 1), entry
files = {path.name for path in external.glob("*.json")} - {"index.json"}
assert files == {entry["file"] for entry in index}, "index.json does not list what is there"
print(f"{len(index)} answers of other solvers: ok")
