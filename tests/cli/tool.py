"""What the tests of the command line share. Each is run as `test_X.py TOOL ROOT`."""
import functools
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENES = SOURCE / "fixtures/scenes"
sys.path.insert(0, str(SOURCE / "tests/support"))


def run(*words, text=None, **more):
    return subprocess.run([TOOL, *map(str, words)], input=text, capture_output=True, text=True,
                          timeout=120, **more)


def unwrapped(text):
    """Prose on one line: where it is wrapped depends on the length of the paths that it names."""
    return " ".join(text.split())


def command(name):
    """run() of one command."""
    return functools.partial(run, name)


def json_of(*words, text=None):
    return json.loads(run(*words, "--json", text=text).stdout)


class ToolTest(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def file(self, name, text):
        (self.path / name).write_text(text)
        return self.path / name

    def is_refused(self, result, pattern):
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(result.stdout, "")
        self.assertRegex(result.stderr.replace("\n", " "), pattern)  # wrapped


def main():
    unittest.main(argv=sys.argv[:1])
