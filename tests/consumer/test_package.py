"""`cpack` makes a .deb and a .tar.gz. The .deb is installed by dpkg into a root that has nothing but what
it depends on, and the tool and the Python package solve a scene there; the archive, unpacked, has
tool, man page, headers, library and Python package, and they work.

    python3 test_package.py CPACK BUILD SOURCE
"""
import os
import pathlib
import re
import shutil
import sys
import tarfile
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from clean_root import as_root, make, output  # noqa: E402

CPACK, BUILD, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
VERSION = re.search(r"^\s*VERSION (\S+)$", (SOURCE / "CMakeLists.txt").read_text(), re.M).group(1)
SLIDE = SOURCE / "fixtures/scenes/straight_slide.toml"
PATH = "/usr/sbin:/usr/bin:/sbin:/bin"  # dpkg and chroot lie in sbin
PLACES = ("bin/lcpush", "include/lcpush/lcpush.hpp", "include/lcpush/lcpush.h",
          "include/lcpush/lcpush_desktop.h", "include/lcpush/version.hpp",
          "share/man/man1/lcpush.1", "share/doc/lcpush/copyright", "share/bash-completion/completions/lcpush",
          "lib/python3/dist-packages/lcpush/__init__.py",
          "lib/python3/dist-packages/lcpush/py.typed")
ASK = """
import sys, lcpush
print(lcpush.__file__, lcpush.__version__, lcpush.read(sys.argv[1]).solve().body("wall").force[0])
"""


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


def install(deb, root, depends, before):
    """By dpkg, which refuses it if `root` lacks what the package says that it depends on."""
    packages = make(root, depends)
    environment = {**os.environ, "PATH": PATH}
    dpkg = [*before, "dpkg", f"--root={root}"]
    output(*dpkg, "-i", deb, env=environment)
    for place in PLACES:
        assert (root / "usr" / place).is_file(), f"{root}: no {place}"
    shutil.copy(SLIDE, root / "tmp/slide.toml")

    def inside(*command):
        return output(*before, "chroot", root, *command, env={"PATH": PATH, "HOME": "/tmp"}, cwd="/")

    assert f"lcpush {VERSION}" in inside("/usr/bin/lcpush", "--version")
    assert "Push with 20.1 N" in inside("lcpush", "solve", "/tmp/slide.toml")
    if "python3" in depends:
        place, version, force = inside("/usr/bin/python3", "-B", "-c", ASK, "/tmp/slide.toml").split()
        assert place == "/usr/lib/python3/dist-packages/lcpush/__init__.py" and version == VERSION
        assert abs(float(force) - 20.02) < 1e-6, force
    output(*dpkg, "-r", "lcpush", env=environment)
    left = [str(path) for path in root.rglob("*lcpush*") if "/var/lib/dpkg/" not in str(path)]
    assert not left, f"removed, and left {left}"
    return packages


def refused_without_its_libraries(deb, root, before):
    """The guard of the guard: a root without a C++ library takes no package that needs it."""
    make(root, "libc6")
    try:
        output(*before, "dpkg", f"--root={root}", "-i", deb,
               env={**os.environ, "PATH": PATH, "LC_ALL": "C"})
    except AssertionError as error:
        assert "depends on libstdc++6" in str(error), error
        return
    raise AssertionError("a root without libstdc++6 has taken the package")


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder).resolve()
    output(CPACK, "--config", pathlib.Path(BUILD) / "CPackConfig.cmake", "-B", folder / "made",
           cwd=BUILD)
    deb, = (folder / "made").glob("*.deb")
    archive, = (folder / "made").glob("*.tar.gz")
    assert output("dpkg-deb", "-f", deb, "Version").strip() == VERSION
    depends = output("dpkg-deb", "-f", deb, "Depends").strip()
    assert "libstdc++6" in depends, depends
    before = as_root()
    if before is None or not shutil.which("dpkg"):
        print("not installed: that takes root, or unshare -r")
    else:
        alone = install(deb, folder / "root", depends, before)
        assert not any("python" in name for name in alone), alone
        if pathlib.Path("/usr/bin/python3").exists():
            install(deb, folder / "with_python", depends + ", python3", before)
        refused_without_its_libraries(deb, folder / "bare", before)
        print(f"installed beside {len(alone)} packages: {' '.join(sorted(alone))}")
    with tarfile.open(archive) as files:
        files.extractall(folder / "archive")
    found, = (folder / "archive").glob("lcpush-*")
    check(found / "usr" if (found / "usr").is_dir() else found)
    print(f"{deb.name} ({deb.stat().st_size / 1e6:.1f} MB), {archive.name}: ok")
