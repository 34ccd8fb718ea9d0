"""lcpush as a part of another project. It would compile the libraries by the same commands as this build: those are
compared, and this build's libraries linked. The project's own programs are compiled by its commands, and run.

    test_add_subdirectory.py CMAKE NINJA BUILD SOURCE WORK [-DOPTION ...]
"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

CMAKE, NINJA = sys.argv[1:3]
BUILD, SOURCE, WORK = map(pathlib.Path, sys.argv[3:6])
PROGRAMS = ("use_lcpush", "use_desktop", "use_c")
LIBRARIES = ("src/liblcpush_desktop.a", "src/liblcpush.a")


def output(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return done.stdout


def commands(build, inside):
    """Of each object of the libraries its command, without the folders of the build."""
    entries = json.loads(output(NINJA, "-C", build, "-t", "compdb"))
    found = {}
    for entry in entries:
        name = entry["output"].removeprefix(inside)
        if re.match(r"src/CMakeFiles/lcpush_(kernels|desktop|c)\.dir/.*\.(o|gch)$", name):
            text = entry["command"].replace(f"{build}/{inside}", "BUILD/").replace(inside + "src/", "src/")
            found[name] = sorted(set(shlex.split(text)))  # CMake may set options twice
    return found


shutil.rmtree(WORK, ignore_errors=True)
output(CMAKE, "-G", "Ninja", f"-DCMAKE_MAKE_PROGRAM={NINJA}", "-S", SOURCE / "tests/consumer", "-B", WORK,
       f"-DCONSUMER_LCPUSH_SOURCES={SOURCE}", *sys.argv[6:])
ours, theirs = commands(BUILD, ""), commands(WORK, "lcpush/")
assert len(ours) > 20 and ours.keys() == theirs.keys(), ours.keys() ^ theirs.keys()
for name, command in ours.items():
    assert command == theirs[name], (name, set(command) ^ set(theirs[name]))
for library in LIBRARIES:
    shutil.copy(BUILD / library, WORK / "lcpush" / library)
for line in output(NINJA, "-C", WORK, "-t", "commands", *PROGRAMS).splitlines():
    if "embed_text.cmake" in line or re.search(r"use_(lcpush|desktop|c)\b", line):
        subprocess.run(line, shell=True, check=True, cwd=WORK)
made = [(build / "src/embedded_texts.cpp").read_bytes() for build in (BUILD, WORK / "lcpush")]
assert made[0] == made[1], "embedded_texts.cpp is another"
for name in PROGRAMS:
    print(name, output(WORK / name).strip())
