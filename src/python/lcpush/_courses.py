"""Answers that go on: over a number of the scene, and over time."""
from __future__ import annotations

from typing import Any, Dict, List

from ._answers import Answer, Record
from ._arrays import array, number, plain
from ._errors import InputError

_nan = float("nan")


def _parts(given: Any, count: int, name: str, example: str) -> Any:
    if not isinstance(given, (tuple, list)) or len(given) != count:
        raise InputError(f"{name} must be {example}, not {given!r}")
    return given


def variation(given: Any, name: str) -> Dict[str, Any]:
    """(path, start, stop) as the library takes it; `name` is its in messages."""
    path, start, stop = _parts(given, 3, name, '("left.friction", 0.1, 0.5)')
    return {"path": path, "from": number(start, f"{name}'s start"),
            "to": number(stop, f"{name}'s stop")}


def values_of(given: Any) -> Dict[str, Any]:
    """The (path, values) of `each`."""
    path, values = _parts(given, 2, "each", '("facets", [4, 8, 16])')
    return {"path": path, "values": plain(values, "each's values")}


class Curve(Record):
    """A curve of a sweep: `label`, `each_value`, `parameter`, `unit`, `segments`."""

    def _curve(self) -> Dict[str, Any]:
        return self._data

    @property
    def points(self) -> List[Record]:
        """The values at which it was solved, as evenly as asked; between exact segments none."""
        return [Record(point) for point in self._curve()["points"]]

    def _column(self, key: str, size: int = 0) -> Any:
        """Of the points, or of the segments' ends where nothing was sampled; nan where there is no
        answer."""
        none: Any = [_nan] * size if size > 0 else _nan
        found = [point.get(key) for point in self._curve()["points"]]
        if not found:
            for segment in self._curve()["segments"]:
                found += [segment[key][k] if segment.get(key) else None for k in range(2)]
        return array([none if value is None else value for value in found])

    @property
    def values(self) -> Any:
        """The parameter's, shape (n,), in `unit`: of the points, or, where nothing was sampled, both
        ends of each segment."""
        if self._curve()["points"]:
            return self._column("value")
        return array([segment[side] for segment in self._curve()["segments"]
                      for side in ("from", "to")])

    @property
    def second_values(self) -> Any:
        """Of a map, the parameter's of `over`, shape (n,), in `second_unit`: row by row, so that
        `break_force.reshape(steps, steps)[j, i]` is at the j-th of these and the i-th of `values`."""
        return self._column("second_value")

    @property
    def break_force(self) -> Any:
        """N, at `values`, shape (n,); nan where nothing breaks."""
        return self._column("break_force")

    @property
    def force(self) -> Any:
        """N, the pusher's on the object as the scene pushes, at `values`, shape (n, 3)."""
        return self._column("force", 3)

    @property
    def twist(self) -> Any:
        """The object's acceleration as the scene pushes, at `values`, shape (n, 6)."""
        return self._column("twist", 6)

    def __repr__(self) -> str:
        return f"<Curve {self._data.get('label') or self._data['parameter']}>"


class Sweep(Answer, Curve):
    """How the push changes with a number of the scene, of `Scene.sweep()`: `parameter`, `unit`,
    `segments`, `complete`. Also what its Curve has; with `each` it has `curves`
    instead."""

    _picture = "sweep"

    @property
    def curves(self) -> "List[Curve]":
        """One for each value of `each`; else one."""
        return [Curve(curve) for curve in self._data.get("curves", [self._data])]

    def _curve(self) -> Dict[str, Any]:
        if "curves" in self._data:
            raise InputError("this sweep has a curve for each value: ask one of its `curves`")
        return self._data

    @property
    def sentence(self) -> str:
        """The first sentence of text(); of several curves their names."""
        if "curves" not in self._data:
            return super().sentence
        return (f"{len(self.curves)} curves over {self.curves[0].parameter}: "
                + ", ".join(curve.label for curve in self.curves))


class Cone(Answer):
    """The pushes with which a pusher sticks, of `Scene.cone()`: `edges`, `sides`, `sticks`, `margin` rad,
    `smallest_grip` N. True where the push sticks."""

    _picture = "cone"

    def __bool__(self) -> bool:
        return bool(self._data["sticks"])


class Hold(Answer):
    """How well the grasp holds, of `Scene.hold()`: `held`, `least_grip`, `margin`, `disturbances`, `weakest`,
    `added_mass` kg, `tilt` rad. True where it is held."""

    _picture = "hold"

    def __bool__(self) -> bool:
        return bool(self._data["held"])

    @property
    def sentence(self) -> str:
        """The first sentence of text()."""
        return super().sentence if "box" in self._data else str(self._data["answer"])


class Design(Answer):
    """What to choose, of `Scene.design()`: `choice`, `margin`, `binds`, `alone`, and as `scene` the text of the scene
    with it. True where the push sticks."""

    _picture = "design"

    def __bool__(self) -> bool:
        return bool(self._data["margin"])


class Funnel(Answer):
    """What a flat edge aligns, of `Scene.funnel()`: `flush`, `capture`, `way`, `stop`, `along`, `pushes`. True where it leaves the
    object flush from every pose of the box that was tried."""

    _picture = None

    def __bool__(self) -> bool:
        return bool(self._data["flush"])


class Plan(Answer):
    """Pushes that take the object to another place, of `Scene.plan()`: `found`, `pushes`, `cost`,
    `replay`, and as `scene` the text of the scene with its strokes. True where it was found."""

    _picture = None

    def __bool__(self) -> bool:
        return bool(self._data["found"])

    def page(self) -> str:
        """An HTML page that plays it."""
        return self._ask("plan", {"format": "html"})


class Motion(Answer):
    """Where the object goes, of `Scene.move()`: `status`, `end`, `events`, `jumps`, `phases`."""

    _picture = "move"

    @property
    def times(self) -> Any:
        """s, of the kept frames, shape (n,)."""
        return array([frame["time"] for frame in self._data["frames"]])

    @property
    def positions(self) -> Any:
        """m, how far the centre of mass has gone, shape (n, 3)."""
        return array([frame["position"] for frame in self._data["frames"]])

    @property
    def rotations(self) -> Any:
        """Row by row, shape (n, 3, 3); the identity at the start."""
        return array([[frame["rotation"][3 * k:3 * k + 3] for k in range(3)]
                      for frame in self._data["frames"]])

    @property
    def twists(self) -> Any:
        """At the centre of mass, shape (n, 6): m/s, rad/s."""
        return array([frame["twist"] for frame in self._data["frames"]])

    @property
    def frames(self) -> List[Record]:
        """`time`, `position`, `rotation` (9,), `twist`, `bodies`, `contacts` of each."""
        return [Record(frame) for frame in self._data["frames"]]

    def page(self) -> str:
        """An HTML page that plays it."""
        return self._ask("move", {"format": "html"})
