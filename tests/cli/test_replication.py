"""docs/studies/replication.md is what its script prints, every row agrees, and a row that does not is told."""
import contextlib
import importlib.util
import io
import os
import subprocess
import sys
import unittest
from unittest import mock

from tool import SOURCE, TOOL, main

sys.dont_write_bytecode = True
SCRIPT = SOURCE / "docs/studies/replicate.py"
PAGE = (SOURCE / "docs/studies/replication.md").read_text()
spec = importlib.util.spec_from_file_location("replicate", SCRIPT)
spec.loader.exec_module(replicate := importlib.util.module_from_spec(spec))
replicate.LCPUSH = TOOL
os.chdir(SOURCE)


def pushes(**form):
    return [edge[0] for edge in replicate.edges(**form)]


class Replication(unittest.TestCase):
    def test_the_page_is_what_the_script_prints_and_every_row_agrees(self):
        done = subprocess.run([sys.executable, SCRIPT, TOOL], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        tables = done.stdout.split("\n\n")[:2]
        for name, rows, table in zip(("table", "faults"), (11, 2), tables, strict=True):
            self.assertIn(f"<!-- {name} -->\n{table}\n<!-- end of {name} -->\n", PAGE)
            self.assertEqual(table.count("| yes |"), rows)

    def test_the_closed_form_has_the_published_values(self):
        published = {(29.000, 4.80, 7.30), (5.5169, -0.53, 1.43)}
        found = {(round(n, 3 if n > 10 else 4), round(x, 2), round(y, 2)) for n, x, y in replicate.edges() if y > 0}
        self.assertEqual(found, published)
        right, wrong = pushes(moment=lambda fx, fy: -0.007 * fx - 0.012 * fy), pushes(moment=lambda fx, fy: 0.012 * fx - 0.007 * fy)
        self.assertAlmostEqual(max(right), 34.329, delta=5e-4)
        self.assertAlmostEqual(max(wrong), 30.995, delta=5e-4)
        self.assertAlmostEqual(max(pushes(s=1.0)), 36.141, delta=5e-4)

    def test_what_does_not_agree_is_told(self):
        with mock.patch.object(replicate, "MU", 0.79):
            self.assertFalse(replicate.cone_edges()[0])
            self.assertFalse(replicate.least_grip()[0])
            row = [row for row in replicate.ROWS if row[2] is replicate.cone_edges]
            with mock.patch.object(replicate, "ROWS", row), contextlib.redirect_stdout(io.StringIO()) as printed:
                self.assertEqual(replicate.main(), 1)
        self.assertIn("| **no** |", printed.getvalue())
        straight = {"pushes": [{"from": [0, 0, 0], "to": [0.055, 0.04, 0]}]}  # from the stem over the inner corner
        self.assertFalse(replicate.stays_on_the_t((0.03, 0), straight))


main()
