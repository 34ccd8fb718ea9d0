"""`cpack` makes a .deb and a .tar.gz; unpacked into a folder that has nothing else, the tool, its man
page, the headers, the library and the Python package are there and work.

    python3 test_package.py CPACK BUILD SOURCE
"""
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile

CPACK, BUILD, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
VERSION = re.search(r"^\s*VERSION (\S+)$", (SOURCE / "CMakeLists.txt").read_text(), re.M).group(1)
SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"
PLACES = ("bin/lcpush", "include/lcpush/lcpush.hpp", "include/lcpush/lcpush.h",
          "include/lcpush/lcpush_desktop.h", "include/lcpush/version.hpp",
          "share/man/man1/lcpush.1", "share/bash-completion/completions/lcpush",
          "lib/python3/dist-packages/lcpush/__init__.py",
          "lib/python3/dist-packages/lcpush/py.typed")
ASK = """
import sys, lcpush
print(lcpush.__file__, lcpush.__version__, lcpush.read(sys.argv[1]).solve().body("wall").force[0])
"""


def output(*command, **more):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, **more)
    assert result.returncode == 0, f"{command}: {result.stdout}{result.stderr}"
    return result.stdout


def check(prefix):
    for place in PLACES:
        assert (prefix / place).is_file(), f"{prefix}: no {place}"
    assert list(prefix.glob("lib/**/liblcpush_desktop.so.*")), f"{prefix}: no library"
    assert list(prefix.glob("lib/**/lcpushConfig.cmake")), f"{prefix}: nothing for find_package"
    assert f"lcpush {VERSION}" in output(prefix / "bin/lcpush", "--version")
    assert "Push with 20.1 N" in output(prefix / "bin/lcpush", "solve", SLIDE)
    packages = prefix / "lib/python3/dist-packages"
    clean = {key: value for key, value in os.environ.items() if key != "LCPUSH_LIBRARY"}
    place, version, force = output(sys.executable, "-B", "-c", ASK, SLIDE, cwd=prefix,
                                   env={**clean, "PYTHONPATH": str(packages)}).split()
    assert place.startswith(str(packages)) and version == VERSION, (place, version)
    assert abs(float(force) - 20.02) < 1e-6, force


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder).resolve()
    output(CPACK, "--config", pathlib.Path(BUILD) / "CPackConfig.cmake", "-B", folder / "made",
           cwd=BUILD)
    deb, = (folder / "made").glob("*.deb")
    archive, = (folder / "made").glob("*.tar.gz")
    output("dpkg-deb", "-x", deb, folder / "root")
    check(folder / "root/usr")
    fields = output("dpkg-deb", "-f", deb)
    assert re.search(rf"^Version: {re.escape(VERSION)}", fields, re.M), fields
    assert re.search(r"^Depends: .*libstdc\+\+6", fields, re.M), fields
    with tarfile.open(archive) as files:
        files.extractall(folder / "archive")
    found, = (folder / "archive").glob("lcpush-*")
    check(found / "usr" if (found / "usr").is_dir() else found)
    print(f"{deb.name} ({deb.stat().st_size / 1e6:.1f} MB), {archive.name}: ok")
