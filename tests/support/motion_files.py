"""Tests of motions that `lcpush` reads from files."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOL = sys.argv[1]


def run(*words):
    return subprocess.run([TOOL, *map(str, words)], capture_output=True, text=True, timeout=100)


class MotionFiles(unittest.TestCase):
    """Each test has a folder of its own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, text):
        path = pathlib.Path(self.folder.name, name)
        path.write_text(text)
        return path
