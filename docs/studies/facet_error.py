"""What facets cost a push off the grip's axis: its force, and how fast the bar turns.

    python3 docs/studies/facet_error.py [LCPUSH]
"""

import csv
import io
import subprocess
import sys

LCPUSH = sys.argv[1] if len(sys.argv) > 1 else "lcpush"
FACETS = [4, 8, 16, 32]
RADIUS, PUSH = 0.005, 0.1  # m, of the fingertips; m/s^2, of the rod
STEPS = 21


def sweep(scene, *more):
    """(breaking force, turning rate in u/R) at each distance of the rod."""
    command = [LCPUSH, "sweep", scene, "--vary", "rod.shift[0]=0:0.04", *more,
               "--steps", str(STEPS), "--seconds", "60", "--format", "csv"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    rows = {float(row["rod.shift[0]"]): row for row in csv.DictReader(io.StringIO(text))}
    at = [rows[min(rows, key=lambda x: abs(x - k * 0.04 / (STEPS - 1)))] for k in range(STEPS)]
    return [(float(row["break_force"]), float(row["twist_6"]) * RADIUS / PUSH) for row in at]


def main():
    true = sweep("docs/studies/round_push.toml")
    fastest = max(abs(rate) for _, rate in true)
    print(f"The bar turns at up to {fastest:.2f} u/R.")
    print("facets  force off by  turning rate off by")
    for g in FACETS:
        found = sweep("docs/studies/offset_push.toml", "--each", f"facets={g}")
        force = max(abs(f - f_true) / f_true for (f, _), (f_true, _) in zip(found, true))
        rate = max(abs(w - w_true) for (_, w), (_, w_true) in zip(found, true))
        print(f"{g:6}  {100 * force:10.2f} %  {rate:15.4f} u/R")


main()
