"""How the push depends on the grip: a sweep, and a plot where matplotlib is installed."""
import pathlib
import sys

import lcpush

root = pathlib.Path(__file__).resolve().parents[2]
scene = lcpush.read(root / "fixtures/scenes/straight_slide.toml")
print([name for name in scene.parameters if name.startswith("wall.f")])

sweep = scene.sweep("*.grip_force", 5, 30, pressure="rigid")  # exact: a line between two values
print(sweep)
for grip, force in zip(sweep.values, sweep.break_force):
    print(f"{grip:8.3f} {sweep.unit}  breaks at {force:7.3f} N")

try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    pyplot = None
if pyplot and len(sys.argv) > 1:
    pyplot.plot(sweep.values, sweep.break_force)
    pyplot.xlabel("grip force, N")
    pyplot.ylabel("breaking force, N")
    pyplot.savefig(sys.argv[1])
elif len(sys.argv) > 1:  # lcpush's own plot
    pathlib.Path(sys.argv[1]).with_suffix(".svg").write_text(sweep._repr_html_(), encoding="utf-8")
