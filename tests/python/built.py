"""The package of this source, with the library that was just built: each test is run as
test_X.py TOOL LIBRARY SOURCE."""
import os
import pathlib
import sys

TOOL, LIBRARY, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
os.environ["LCPUSH_LIBRARY"] = LIBRARY
sys.path.insert(0, str(SOURCE / "src/python"))
os.chdir(SOURCE)
import lcpush  # noqa: E402, F401
