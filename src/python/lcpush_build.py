"""Builds lcpush's wheel: CMake makes the shared library, and the rest is a zip file (PEP 517).

Of its own, so that `pip install ./src/python` needs neither a network nor setuptools.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sysconfig
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent.parent
SUMMARY = "The mechanics of prehensile pushing as a linear complementarity problem"


def version():
    text = (SOURCES / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^\s*VERSION (\S+)$", text, flags=re.M).group(1)


def tag():
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"py3-none-{platform}"


def library(build):
    """The shared library's path: $LCPUSH_LIBRARY if it is set; from the tool's own build where there is one,
    which leaves little to do; else built in the folder `build`."""
    if "LCPUSH_LIBRARY" in os.environ:
        return pathlib.Path(os.environ["LCPUSH_LIBRARY"]).resolve()
    run = lambda *words: subprocess.run(["cmake", *map(str, words)], check=True)
    of_tool = SOURCES / "build/release"
    if (of_tool / "CMakeCache.txt").exists():
        build = of_tool
    else:
        ninja = ["-G", "Ninja"] if shutil.which("ninja") and "CMAKE_GENERATOR" not in os.environ else []
        run(*ninja, "-S", SOURCES, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DLCPUSH_BUILD_TESTS=OFF",
            "-DLCPUSH_BUILD_TOOL=OFF", "-DLCPUSH_BUILD_SHARED=ON", "-DLCPUSH_INSTALL=OFF")
    run("--build", build, "--config", "Release", "--target", "lcpush_desktop_shared", "--parallel",
        os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "2"))
    found = [path for path in sorted(pathlib.Path(build, "src").rglob("*lcpush_desktop.*"))
             if path.suffix in (".so", ".dylib", ".dll")]
    return found[0].resolve()


def metadata():
    return ("Metadata-Version: 2.1\nName: lcpush\n"
            f"Version: {version()}\nSummary: {SUMMARY}\nRequires-Python: >=3.9\n"
            "Description-Content-Type: text/markdown\n\n"
            "See docs/guide/python.md in lcpush's sources.\n")


def wheel_facts():
    return ("Wheel-Version: 1.0\nGenerator: lcpush_build\n"
            f"Root-Is-Purelib: false\nTag: {tag()}\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Without it pip would build everything twice."""
    name = f"lcpush-{version()}.dist-info"
    folder = pathlib.Path(metadata_directory) / name
    folder.mkdir()
    (folder / "METADATA").write_text(metadata(), encoding="utf-8")
    (folder / "WHEEL").write_text(wheel_facts(), encoding="utf-8")
    return name


def write_wheel(folder, files):
    """`files`: name in the wheel -> bytes."""
    info = f"lcpush-{version()}.dist-info"
    files = dict(files)
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = wheel_facts().encode()
    record = f"{info}/RECORD"
    lines = []
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}")
    files[record] = ("\n".join([*lines, f"{record},,"]) + "\n").encode()
    name = f"lcpush-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for inside, data in files.items():
            entry = zipfile.ZipInfo(inside, (2026, 1, 1, 0, 0, 0))
            entry.external_attr = 0o100644 << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as build:
        built = library(build)
        files = {f"lcpush/{path.name}": path.read_bytes()
                 for path in sorted((HERE / "lcpush").iterdir())
                 if path.suffix == ".py" or path.name == "py.typed"}
        files["lcpush/" + "liblcpush_desktop" + re.search(r"\.(so|dylib|dll)", built.name).group(0)] = (
            built.read_bytes())
        return write_wheel(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """The sources where they stand; the library is found through $LCPUSH_LIBRARY."""
    return write_wheel(wheel_directory, {"lcpush.pth": f"{HERE}\n".encode()})


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("there is no source distribution: the package is built inside lcpush's sources")
