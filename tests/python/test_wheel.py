"""The package as pip installs it, without a network and away from the sources: it imports, finds the
library beside it, and solves.

    python3 test_wheel.py TOOL LIBRARY SOURCE
"""
import base64
import hashlib
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

LIBRARY, SOURCE = sys.argv[2], pathlib.Path(sys.argv[3])
PACKAGE = SOURCE / "src/python"
SOLVE = """
import lcpush, pathlib, sys
assert pathlib.Path(lcpush.__file__).is_relative_to(sys.argv[1])
print(lcpush.__version__, lcpush.read(sys.argv[2]).solve().body("wall").force[0])
"""


class Wheel(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.environ["LCPUSH_LIBRARY"] = LIBRARY  # built already

    def backend(self):
        spec = importlib.util.spec_from_file_location("lcpush_build", PACKAGE / "lcpush_build.py")
        backend = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(backend)
        return backend

    def build(self):
        return pathlib.Path(self.folder.name) / self.backend().build_wheel(self.folder.name)

    def solved(self, place):
        without = {key: value for key, value in os.environ.items()
                   if key not in ("LCPUSH_LIBRARY", "PYTHONPATH")}
        result = subprocess.run([sys.executable, "-c", SOLVE, str(place),
                                 str(SOURCE / "fixtures/scenes/straight_slide.toml")],
                                env={**without, "PYTHONPATH": str(place)}, cwd=self.folder.name,
                                capture_output=True, text=True, timeout=100)
        self.assertEqual(result.returncode, 0, result.stderr)
        version, force = result.stdout.split()
        self.assertAlmostEqual(float(force), 20.02, places=6)
        return version

    def test_carries_the_library_and_a_true_record(self):
        path = self.build()
        with zipfile.ZipFile(path) as wheel:
            names = wheel.namelist()
            record, = [name for name in names if name.endswith("/RECORD")]
            for line in wheel.read(record).decode().splitlines():
                name, digest, size = line.split(",")
                names.remove(name)
                if name != record:
                    data = wheel.read(name)
                    hashed = base64.urlsafe_b64encode(hashlib.sha256(data).digest())
                    self.assertEqual(digest, "sha256=" + hashed.rstrip(b"=").decode(), name)
                    self.assertEqual(int(size), len(data), name)
            self.assertEqual(names, [])
            place = pathlib.Path(self.folder.name) / "unpacked"
            wheel.extractall(place)
        self.assertTrue((place / "lcpush/py.typed").exists())
        version = self.solved(place)
        self.assertIn(f"VERSION {version}\n", (SOURCE / "CMakeLists.txt").read_text())
        self.assertIn(f"lcpush-{version}-py3-none-", path.name)

    def test_is_built_once(self):
        """pip asks for the metadata first; without this hook it builds a wheel to read them."""
        folder = pathlib.Path(self.folder.name) / "metadata"
        folder.mkdir()
        name = self.backend().prepare_metadata_for_build_wheel(str(folder))
        with zipfile.ZipFile(self.build()) as wheel:
            for part in ("METADATA", "WHEEL"):
                self.assertEqual((folder / name / part).read_bytes(), wheel.read(f"{name}/{part}"))

    def test_the_tools_own_build_is_used_where_there_is_one(self):
        del os.environ["LCPUSH_LIBRARY"]
        backend = self.backend()
        backend.SOURCES = pathlib.Path(self.folder.name)
        asked = []
        backend.subprocess = type("", (), {"run": lambda words, check: asked.append(words)})
        for of_tool in (False, True):
            build = backend.SOURCES / "build/release" if of_tool else backend.SOURCES / "own"
            (build / "src").mkdir(parents=True)
            (build / "src/liblcpush_desktop.so").touch()
            if of_tool:
                (build / "CMakeCache.txt").touch()
            found = backend.library(backend.SOURCES / "own")
            self.assertEqual(found, (build / "src/liblcpush_desktop.so").resolve())
            self.assertIn(str(build), asked[-1])
        self.assertEqual([words[1] == "--build" for words in asked], [False, True, True])

    def test_is_what_pip_installs(self):
        if importlib.util.find_spec("pip") is None:
            self.skipTest("pip is not installed")
        place = pathlib.Path(self.folder.name) / "installed"
        for more in ([], ["--no-build-isolation"]):
            result = subprocess.run([sys.executable, "-m", "pip", "install", "--no-index",
                                     "--disable-pip-version-check", "--upgrade", *more, "--target",
                                     str(place), str(PACKAGE)], capture_output=True, text=True,
                                    timeout=300)
            self.assertEqual(result.returncode, 0, result.stderr + result.stdout)
            self.solved(place)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
