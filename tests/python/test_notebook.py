"""docs/guide/prehensile.ipynb: its cells, run in order without a notebook server, say what stands below them.

    python3 test_notebook.py TOOL LIBRARY SOURCE
"""
import ast
import contextlib
import io
import json
import os
import pathlib
import sys
import tempfile
import unittest

LIBRARY, SOURCE = sys.argv[2], pathlib.Path(sys.argv[3])
os.environ["LCPUSH_LIBRARY"] = LIBRARY
sys.path.insert(0, str(SOURCE / "src/python"))


def run(code, names):
    """What a notebook shows below the cell: what is printed, and its last expression."""
    tree = ast.parse(code)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    shown = {}
    if value is not None:
        shown["text/plain"] = repr(value)
        picture = getattr(value, "_repr_html_", lambda: None)()
        if picture is not None:
            shown["text/html"] = picture
    return printed.getvalue(), shown


def outputs(cell):
    printed, shown = "", {}
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            printed += "".join(output["text"])
        else:
            shown.update({kind: "".join(text) for kind, text in output["data"].items()})
    return printed, shown


class Notebook(unittest.TestCase):
    def test_says_what_stands_below_its_cells(self):
        notebook = json.loads((SOURCE / "docs/guide/prehensile.ipynb").read_text(encoding="utf-8"))
        self.assertEqual((notebook["nbformat"], notebook["nbformat_minor"]), (4, 5))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertGreaterEqual(len(cells), 7)
        self.assertEqual([cell["execution_count"] for cell in cells], list(range(1, len(cells) + 1)))
        names = {}
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for cell in cells:
                    code = "".join(cell["source"])
                    with self.subTest(code=code):
                        self.assertEqual(run(code, names), outputs(cell))
                page = pathlib.Path("report.html").read_text(encoding="utf-8")
            finally:
                os.chdir(here)
        self.assertIn("<svg", page)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
