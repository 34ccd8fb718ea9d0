"""Answers: what the tool prints with --json, with attributes, arrays, words and a picture.

Every key of an answer is an attribute too: `answer.valid_to` is `answer.to_dict()["valid_to"]`.
docs/guide/answers.md has the keys. SI units, the scene's axes, the gripper's frame.
"""
from __future__ import annotations

import html
import json
from collections.abc import Mapping
from typing import Any, Dict, Iterator, List, Optional

from ._arrays import array
from ._library import Asker


def _told(value: Any) -> Any:
    """Dictionaries as records, also in lists."""
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return [Record(entry) for entry in value]
    return value


def _brief(value: Any) -> str:
    """Of a value in a repr: what is longer than a vector by its size."""
    if isinstance(value, dict):
        return f"{{{len(value)} keys}}"
    if isinstance(value, list) and (len(value) > 6 or any(isinstance(entry, (dict, list)) for entry in value)):
        return f"[{len(value)} entries]"
    return f"{value:.6g}" if isinstance(value, float) else repr(value)


class Record(Mapping[str, Any]):
    """A part of an answer: its keys are attributes; lists of numbers are arrays. It is a read-only
    dictionary, too."""

    _arrays = ("position", "friction_force", "acceleration", "force", "moment", "velocity",
               "rotation", "twist", "break_twist")

    def __init__(self, data: Dict[str, Any]) -> None:
        self._data = data

    def __getattr__(self, name: str) -> Any:
        data = self.__dict__.get("_data", {})
        if name not in data:
            raise AttributeError(f"{type(self).__name__} has no {name!r}; it has "
                                 + ", ".join(sorted(data)))
        is_array = name in self._arrays and not isinstance(data[name], dict)
        return array(data[name]) if is_array else _told(data[name])

    def __getitem__(self, key: str) -> Any:
        return self._data[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)

    def __bool__(self) -> bool:
        return True

    __hash__ = object.__hash__

    def __dir__(self) -> List[str]:
        return sorted({*super().__dir__(), *self._data})

    def to_dict(self) -> Dict[str, Any]:
        """The keys and values as JSON has them: a copy, to be changed at will."""
        copied: Dict[str, Any] = json.loads(json.dumps(self._data))
        return copied

    def __repr__(self) -> str:
        told = self._data.get("name") or self._data.get("text") or ", ".join(
            f"{key}={_brief(value)}" for key, value in self._data.items())
        return f"<{type(self).__name__} {told}>"


class Document(Record):
    """What the tool writes as JSON."""

    def __init__(self, text: str) -> None:
        super().__init__(json.loads(text))
        self._json = text

    @property
    def json(self) -> str:
        """The very text that the tool writes."""
        return self._json

    def save(self, path: Any) -> None:
        """Writes `json` to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self._json)


class Contact(Record):
    """A contact point: `name`, `body`, `position` (3,) m, `normal_force` N, `friction_force` (3,) N,
    `torsion` N m, `acceleration` (3,) m/s^2 of the object against its body, `mode` ("stick",
    "slide" or "separate")."""


class Body(Record):
    """A finger or pusher: `name`, `role`, `force` (3,) N and `moment` (3,) N m on the object,
    `normal_force` N, `closing_acceleration` m/s^2 or None."""


class Answer(Document):
    """An answer. `repr()` is its first sentence, `text()` all of it in words."""

    _picture: Optional[str] = "report"  # the question that has it as SVG
    _has_text = True

    def __init__(self, text: str, question: str, ask: Asker, title: str = "") -> None:
        super().__init__(text)
        self._question, self._ask, self._title = question, ask, title

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
        return self.sentence if self._has_text else super().__repr__()

    def _repr_html_(self) -> Optional[str]:
        return None if self._picture is None else self._ask(self._picture, {"format": "svg"})


class Solution(Answer):
    """What a push does, of `Scene.solve()`."""

    @property
    def acceleration(self) -> Any:
        """The object's, shape (6,): linear at its centre of mass, m/s^2; angular, rad/s^2. None
        where there is no answer."""
        return array(self._data.get("object", {}).get("acceleration"))

    @property
    def contacts(self) -> List[Contact]:
        """In the file's order: fingers, pushers, their points. Empty where there is no answer."""
        return [Contact(contact) for contact in self._data.get("contacts", [])]

    @property
    def bodies(self) -> List[Body]:
        """In the file's order. Empty where there is no answer."""
        return [Body(body) for body in self._data.get("bodies", [])]

    def body(self, name: str) -> Body:
        """The body called `name`."""
        for body in self.bodies:
            if body.name == name:
                return body
        names = ", ".join(body.name for body in self.bodies)
        raise KeyError(f"no body is called {name!r}; there are {names}" if names
                       else "there is no answer, and no body's force in it")

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

    `breaks`; `force` (3,) N and `moment` (3,) N m of the pusher on the object; `twist` (6,): the
    object's acceleration per unit push; `smallest_grip` N.
    """

    @property
    def break_force(self) -> Optional[float]:
        """N, of the pusher along its normal; None where nothing breaks, or the grasp does not hold."""
        force: Optional[float] = self._data.get("break_force")
        return force

    @property
    def closings(self) -> Dict[str, float]:
        """How each driven body closes along its normal, m/s^2 per m/s^2 of the push."""
        return {entry["name"]: entry["value"] for entry in self._data.get("closings", [])}


class Spread(Answer):
    """The answer as a set, of `Scene.spread()`: `verdict`, `push_force` {pusher: [least, most]} N,
    `twist` (6, 2), `contacts`, `complete`; with modes=True `combinations`, `why` instead of the
    ranges."""


class Pivots(Answer):
    """Lemke's method pivot by pivot, of `Scene.pivots()` and `lcpush.pivots()`: `status`, `pivots`,
    `variables`, `final`, .. (docs/teach/command.md)."""

    @property
    def sentence(self) -> str:
        """How it ended."""
        count = len(self._data["pivots"])
        return (f"{self._data['size']} unknowns, {count} pivot{'s' if count != 1 else ''}: "
                f"{self._data['reason'] or self._data['status']}")

    def text(self, full: bool = False) -> str:
        """Every pivot, as the tool prints it (not wrapped)."""
        return self._ask(self._question, {"format": "text"})

    def latex(self) -> str:
        """Every tableau."""
        return self._ask(self._question, {"format": "latex"})

    def page(self) -> str:
        """An HTML page to explore it."""
        return self._ask(self._question, {"format": "html"})

    def _repr_html_(self) -> str:
        return ('<iframe style="width: 100%; height: 720px; border: 0" srcdoc="'
                + html.escape(self.page()) + '"></iframe>')


class Certificate(Document):
    """A proof in fractions, of `Scene.certify()`: `proof`, `statement`, `x`, `basis`, ..
    (docs/check/certificates.md). `save()` writes what docs/check/lcpush_check.py reads."""

    def __repr__(self) -> str:
        return str(self._data["statement"])


class Verdict(Answer):
    """Is somebody's answer right? Of `Scene.verify()` and `lcpush.check()`: `valid`, `verdict`,
    `because`, `residual`, `tolerance`. True where it is valid."""

    def __bool__(self) -> bool:
        return bool(self._data["valid"])


class LcpAnswer(Answer):
    """Of `lcpush.lcp()`: `status`, `residual`, `pivots`, `basis`, .."""

    _picture = None

    @property
    def z(self) -> Any:
        """Shape (n,)."""
        return array(self._data["z"])

    @property
    def w(self) -> Any:
        """w = M z + q, shape (n,)."""
        return array(self._data["w"])


class ContactForces(Answer):
    """Of `lcpush.contacts()`: `status`, `modes`, `residuals`, .."""

    _picture = None

    @property
    def r(self) -> Any:
        """Shape (3k,)."""
        return array(self._data["r"])

    @property
    def u(self) -> Any:
        """u = W r + g, shape (3k,)."""
        return array(self._data["u"])


class LcpSolutions(Answer):
    """Of `lcpush.lcp_all()` and `lcpush.equilibria()`: `solutions` (`z`, `w`) or `equilibria` (`row`,
    `column`, `payoffs`), the isolated ones; `components` (`vertices`, `rays`, `cells`); `complete`:
    there are no others. Numbers are floats, or texts that `fractions.Fraction` takes."""

    _picture = None


class LcpVerdict(Verdict):
    """Of `lcpush.check()`: also `row`, `z` and `w` of the worst row (from 1)."""

    _picture = None


class MotionVerdict(Answer):
    """Of `Scene.verify_motion()`: `verdict` ("follows", "creeps", "differs", "stopped" or
    "wrong_forces"), `worst` m/s, `worst_time` s, `creep` m/s, `held`, and `forces` (`broken`, and of
    each law in `laws` where it is obeyed least), None where the frames have none. True where it
    follows."""

    def __bool__(self) -> bool:
        return bool(self._data["verdict"] == "follows")
