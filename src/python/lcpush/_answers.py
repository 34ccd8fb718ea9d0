"""Answers: what the tool prints with --json, with attributes, arrays, words and a picture.

Every key of an answer is an attribute too: `answer.valid_to` is `answer.to_dict()["valid_to"]`.
docs/guide/answers.md has the keys. SI units, the scene's axes, the gripper's frame.
"""
from __future__ import annotations

import json
from typing import Any, Callable, Dict, List, Optional

from ._arrays import array

_nan = float("nan")

# question, changes of the request -> text
Asker = Callable[[str, Dict[str, Any]], str]


class Record:
    """A part of an answer: its keys are attributes; lists of numbers are arrays."""

    _arrays = ("position", "friction_force", "acceleration", "force", "moment", "velocity",
               "rotation", "twist", "break_twist")

    def __init__(self, data: Dict[str, Any]) -> None:
        self._data = data

    def __getattr__(self, name: str) -> Any:
        data = self.__dict__.get("_data", {})
        if name not in data:
            raise AttributeError(f"{type(self).__name__} has no {name!r}; it has "
                                 + ", ".join(sorted(data)))
        return array(data[name]) if name in self._arrays else data[name]

    def __dir__(self) -> List[str]:
        return sorted({*super().__dir__(), *self._data})

    def to_dict(self) -> Dict[str, Any]:
        """The keys and values as JSON has them."""
        return self._data

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._data.get('name', '')}>"


class Contact(Record):
    """A contact point: `name`, `body`, `position` (3,) m, `normal_force` N, `friction_force` (3,) N,
    `torsion` N m, `acceleration` (3,) m/s^2 of the object against its body, `mode` ("stick",
    "slide" or "separate")."""


class Body(Record):
    """A finger or pusher: `name`, `role`, `force` (3,) N and `moment` (3,) N m on the object,
    `normal_force` N, `closing_acceleration` m/s^2 or None."""


class Answer(Record):
    """An answer. `repr()` is its first sentence, `text()` all of it in words."""

    _picture = ("report", {"format": "svg"})
    _texts = True

    def __init__(self, text: str, question: str, ask: Asker, title: str = "") -> None:
        super().__init__(json.loads(text))
        self._json, self._question, self._ask, self._title = text, question, ask, title

    @property
    def json(self) -> str:
        """The very text that the tool prints with --json."""
        return self._json

    def text(self, full: bool = False) -> str:
        """The answer in words, as the tool prints it (not wrapped); `full`: as with -v. Solves
        again."""
        return self._ask(self._question, {"format": "full_text" if full else "text"})

    @property
    def sentence(self) -> str:
        """The first sentence of text()."""
        lines = [line for line in self.text().splitlines() if line]
        return lines[1] if self._title and lines[0] == self._title else lines[0]

    @property
    def warnings(self) -> List[Record]:
        """What looks odd about the scene: `code`, `file`, `line`, `text`."""
        return [Record(warning) for warning in self._data.get("warnings", [])]

    def __repr__(self) -> str:
        return self.sentence if self._texts else super().__repr__()

    def _repr_html_(self) -> str:
        question, changes = self._picture
        return self._ask(question, dict(changes))

    def save(self, path: Any) -> None:
        """Writes `json` to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self._json)


class Solution(Answer):
    """What a push does, of `Scene.solve()`."""

    @property
    def acceleration(self) -> Any:
        """The object's, shape (6,): linear at its centre of mass, m/s^2; angular, rad/s^2."""
        return array(self._data["object"]["acceleration"])

    @property
    def contacts(self) -> List[Contact]:
        """In the file's order: fingers, pushers, their points."""
        return [Contact(contact) for contact in self._data["contacts"]]

    @property
    def bodies(self) -> List[Body]:
        """In the file's order."""
        return [Body(body) for body in self._data["bodies"]]

    def body(self, name: str) -> Body:
        """The body called `name`."""
        for body in self.bodies:
            if body.name == name:
                return body
        raise KeyError(name)

    @property
    def M(self) -> Any:
        """The matrix of the scene's problem w = M z + q, shape (n, n), in scaled units: the one that
        pressure "rigid" and "even" solve."""
        return array(self._problem()["M"])

    @property
    def q(self) -> Any:
        """Its right-hand side, shape (n,), scaled."""
        return array(self._problem()["q"])

    @property
    def names(self) -> List[str]:
        """What its unknowns z are: "normal of left.1", "friction of left.1 along +x", .."""
        return list(self._problem()["names"])

    @property
    def free(self) -> List[int]:
        """Rows, from 0, that are equalities with free unknowns: closings and pulls."""
        return [int(row) - 1 for row in self._problem()["free"]]

    @property
    def scales(self) -> Dict[str, float]:
        """"force" N, "length" m, "acceleration" m/s^2: what the problem's units are."""
        return dict(self._problem()["scales"])

    def _problem(self) -> Dict[str, Any]:
        if "_of_problem" not in self.__dict__:
            self._of_problem: Dict[str, Any] = json.loads(self._ask("problem", {"solver": None}))
        return self._of_problem


class Breaking(Answer):
    """The force that just moves the object, of `Scene.break_()`.

    `breaks`; `break_force` N, or None; `force` (3,) N and `moment` (3,) N m of the pusher on the
    object; `twist` (6,): the object's acceleration per unit push; `smallest_grip` N; `closings`.
    """

    @property
    def closings(self) -> Dict[str, float]:
        """How each driven body closes along its normal, m/s^2 per m/s^2 of the push."""
        return {entry["name"]: entry["value"] for entry in self._data["closings"]}


class Spread(Answer):
    """The answer as a set, of `Scene.spread()`: `verdict`, `push_force` {pusher: [least, most]} N,
    `twist` (6, 2), `contacts`, `complete`."""


class Sweep(Answer):
    """How the push changes with a number of the scene, of `Scene.sweep()`: `parameter`, `unit`,
    `segments`, `complete`."""

    _picture = ("sweep", {"format": "svg"})

    @property
    def points(self) -> List[Record]:
        """The values at which it was solved, as evenly as asked; between exact segments none."""
        return [Record(point) for point in self._data["points"]]

    def _column(self, key: str, size: int = 0) -> Any:
        """Of the points, or of the segments' ends where nothing was sampled; nan where there is no
        answer."""
        none: Any = [_nan] * size if size > 0 else _nan
        found = [point.get(key) for point in self._data["points"]]
        if not found:
            for segment in self._data["segments"]:
                found += [segment[key][k] if segment.get(key) else None for k in range(2)]
        return array([none if value is None else value for value in found])

    @property
    def values(self) -> Any:
        """The parameter's, shape (n,), in `unit`: of the points, or, where nothing was sampled, both
        ends of each segment."""
        if self._data["points"]:
            return self._column("value")
        return array([segment[side] for segment in self._data["segments"]
                      for side in ("from", "to")])

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


class Verdict(Answer):
    """Is somebody's answer right? Of `Scene.verify()` and `lcpush.check()`: `valid`, `verdict`,
    `because`, `residual`, `tolerance`. True where it is valid."""

    def __bool__(self) -> bool:
        return bool(self._data["valid"])


class Motion(Answer):
    """Where the object goes, of `Scene.move()`: `status`, `end`, `events`, `jumps`, `phases`."""

    _picture = ("move", {"format": "svg"})

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


class LcpAnswer(Answer):
    """Of `lcpush.lcp()`: `status`, `residual`, `pivots`, `basis`, .."""

    @property
    def z(self) -> Any:
        """Shape (n,)."""
        return array(self._data["z"])

    @property
    def w(self) -> Any:
        """w = M z + q, shape (n,)."""
        return array(self._data["w"])

    def _repr_html_(self) -> Optional[str]:  # type: ignore[override]
        return None


class LcpVerdict(Verdict):
    """Of `lcpush.check()`: also `row`, `z` and `w` of the worst row (from 1)."""

    def _repr_html_(self) -> Optional[str]:  # type: ignore[override]
        return None


class MotionVerdict(Answer):
    """Of `Scene.verify_motion()`: `verdict` ("follows", "creeps", "differs" or "stopped"), `worst` m/s,
    `worst_time` s, `creep` m/s, `held`. True where it follows."""

    def __bool__(self) -> bool:
        return bool(self._data["verdict"] == "follows")
