"""Scenes: a file, a text, or a dictionary; and the questions they are asked."""
from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, Type, TypeVar, Union

from . import _toml
from ._answers import (Answer, Breaking, Certificate, MotionVerdict, Pivots, Record, Solution, Spread,
                       Verdict)
from ._arrays import as_json, plain
from ._courses import Cone, Design, Funnel, Hold, Motion, Plan, Sweep, values_of, variation
from ._errors import InputError, NotSolved
from ._library import NOT_SOLVED, Asker, Progress, ask

A = TypeVar("A", bound=Answer)


class Scene:
    """An object, the fingers that hold it and the pushers that push it.

    Args:
        source: the text of a scene file, or a dictionary of the same tables and keys, such as
            {"object": {"mass": 0.2, ..}, "finger": [{"name": "left", ..}, ..], "pusher": [..]};
            docs/guide/scenes.md has them. Arrays may be NumPy's, tables dataclasses.
        name: what messages call the file

    Raises InputError, with file and line, if that is no scene.

    >>> scene = Scene({"object": {"mass": 0.2, "box": [0.1, 0.03, 0.01]},
    ...                "finger": [{"name": "table", "shape": "point", "center": [0, 0, 0.005],
    ...                            "normal": [0, 0, -1], "friction": 0.5, "grip_force": 10}],
    ...                "pusher": [{"name": "wall", "shape": "point", "center": [-0.05, 0, 0],
    ...                            "normal": [1, 0, 0], "friction": 0,
    ...                            "acceleration": [0.1, 0, 0]}]})
    >>> scene.names
    ['table', 'wall']
    """

    def __init__(self, source: Any, name: str = "scene") -> None:
        source = _toml.tables_of(source)
        if not isinstance(source, (str, Mapping)):
            raise InputError("a scene is the text of a scene file or a dictionary of its tables, not "
                             f"{type(source).__name__}; lcpush.read(path) reads a file")
        self._text = source if isinstance(source, str) else _toml.write(source)
        # A name that is no Unicode is shown as far as it can be.
        self._name = os.fsdecode(name).encode("utf-8", "replace").decode()
        if isinstance(source, str) and _is_path(source):
            raise InputError(f"this is no scene's text; of a file: lcpush.read({source!r})")
        self._facts = json.loads(self._ask("scene", {}))

    @property
    def text(self) -> str:
        """The scene file's text."""
        return self._text

    @property
    def title(self) -> str:
        """As the scene says, '' without one."""
        return str(self._facts["title"])

    @property
    def hand(self) -> str:
        """What moves the fingers: "parallel", "independent", "locked", "fixed", "actuators"."""
        return str(self._facts["hand"])

    @property
    def names(self) -> "list[str]":
        """Of the fingers and pushers, in the file's order."""
        return [body["name"] for body in self._facts["bodies"]]

    @property
    def parameters(self) -> "list[str]":
        """What sweep() can vary, such as "wall.friction"; "*." stands for all bodies."""
        return list(self._facts["parameters"])

    @property
    def warnings(self) -> "list[Record]":
        """What looks odd about the scene: `code`, `file`, `line`, `text`."""
        return [Record(warning) for warning in self._facts["warnings"]]

    def to_dict(self) -> Dict[str, Any]:
        """The tables and keys; `Scene(scene.to_dict())` is the same scene."""
        tables: Dict[str, Any] = json.loads(self._ask("tables", {}))
        return tables

    def with_values(self, values: Mapping[str, Any]) -> "Scene":
        """The scene with other values, as `--set` of the tool has them: {"wall.friction": 0.4,
        "object.mass": "120 g"}."""
        given = [f"{path}={_toml.as_toml(value, path)}" for path, value in values.items()]
        tables = json.loads(self._ask("tables", {"set": given}))
        del tables["set"]
        return Scene(tables, self._name)

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the scene file."""
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(self._text)

    def solve(self, *, solver: Optional[str] = None, check: bool = True,
              tolerance: Union[str, Sequence[str]] = (), box: bool = False,
              sensitivity: bool = False, progress: Optional[Progress] = None) -> Solution:
        """What the scene's push does: forces, motion in the grip, contact modes.

        Args:
            solver: "lemke" (default), "gauss-seidel" or "hybrid"
            check: raise NotSolved if there is no answer; else look at its `status`
            tolerance: as of `cone`: is it certain that the pusher sticks? `verdict`, `margin`, `corner`
            box: the same of the scene's own ranges
            sensitivity: also derivatives by each pusher's acceleration and each grip force
            progress: is called with the share that is done, as far as that is known, and with 1 at
                the end, as in all questions; what it raises ends the work
        """
        return self._answer(Solution, "solve", {"solver": solver, "tolerance": tolerance or None,
                                                "box": box or None,
                                                "sensitivity": sensitivity or None},
                            check and not (tolerance or box), progress)

    def break_(self, *, pusher: Optional[str] = None, solver: Optional[str] = None,
               check: bool = True, progress: Optional[Progress] = None) -> Breaking:
        """The force that just moves the object in the grip; `pusher`: whose, among several."""
        return self._answer(Breaking, "break", {"pusher": pusher, "solver": solver}, check,
                            progress)

    def sweep(self, path: str, start: float, stop: float, *, steps: Optional[int] = None,
              pressure: Optional[str] = None, pusher: Optional[str] = None,
              over: Optional[Tuple[str, float, float]] = None,
              each: Optional[Tuple[str, Sequence[float]]] = None,
              progress: Optional[Progress] = None) -> Sweep:
        """How the push changes with a number of the scene.

        Args:
            path: one of `parameters`, such as "*.grip_force"
            start, stop: its values, in the file's unit
            steps: values evenly spread, ends included; none where exact segments are found
            pressure: "pad", "even" or "rigid" instead of the file's
            over: a second number for a map, (path, start, stop)
            each: a curve for each value of another number, such as ("facets", [4, 8, 16]); see
                `curves` of the answer
        """
        vary = [variation((path, start, stop), "sweep")]
        if over is not None:
            vary.append(variation(over, "over"))
        curves = None if each is None else values_of(each)
        return self._answer(Sweep, "sweep",
                            {"vary": {"list": vary}, "each": curves, "steps": steps,
                             "pressure": pressure, "pusher": pusher}, False, progress)

    def spread(self, *, breaking: bool = False, enumerate_all: bool = False,
               modes: bool = False, paths_only: bool = False, covers: Optional[int] = None,
               seconds: Optional[float] = None, check: bool = True,
               progress: Optional[Progress] = None) -> Spread:
        """The answer as a set: bounds of the push, the motion and the contact forces.

        Args:
            breaking: of the force that just moves the object
            enumerate_all: look longer for all contact modes
            modes: each combination of sticking, slipping and opening contacts by itself
            paths_only: only what `covers` covering vectors (32) reach
            seconds: stop after that time with what is found
        """
        return self._answer(Spread, "spread",
                            {"break": breaking or None, "enumerate": enumerate_all or None,
                             "modes": modes or None, "paths": paths_only or None,
                             "covers": covers, "seconds": seconds},
                            check, progress)

    def verify(self, answer: Any, *, tolerance: Optional[float] = None) -> Verdict:
        """Is somebody's answer right? `answer`: a dictionary shaped as `solve().to_dict()`, or any
        part of it (arrays may be NumPy's), the text of such a JSON object, the pathlib.Path of its
        file, or an Answer.
        `tolerance`: what a row may be off by, scaled (1e-6)."""
        text = _text_of(answer, "answer")
        return self._answer(Verdict, "verify", {"answer": text, "tolerance": tolerance}, False,
                            None)

    def verify_motion(self, frames: Any, *, tolerance: Optional[float] = None) -> MotionVerdict:
        """Does somebody else's motion follow the laws, step by step, or does it creep? And do its
        forces obey them?

        Args:
            frames: a list of {"time": s, "position": (3,), "rotation": (9,) row by row, "twist":
                (6,)} (arrays may be NumPy's; a twist need not be known; "quaternion" (4,), w
                first, does for a rotation, and neither where nothing turns), how far the object has
                gone from the scene's place, and if they are to be judged the forces of "contacts"
                and "bodies" as a Motion has them; a Motion; the text of such a JSON object, or of
                CSV; or the pathlib.Path of its file
            tolerance: as a part of the fastest speed, and of the largest force (0.01)
        """
        is_list = not isinstance(frames, (str, os.PathLike, Answer, Mapping))
        text = _text_of({"frames": frames} if is_list else frames, "motion")
        return self._answer(MotionVerdict, "verify_motion",
                            {"motion": text, "tolerance": tolerance}, False, None)

    def move(self, *, time: Optional[float] = None, step: Optional[float] = None,
             tolerance: Optional[float] = None, stop_after: Optional[float] = None,
             frames: Optional[int] = None, progress: Optional[Progress] = None) -> Motion:
        """Where the object ends up: the push goes on, step by step.

        Args:
            time: s; to the end of the last stroke, else 1 s
            step: s, of equal steps; else as `tolerance` asks
            tolerance: m, of the whole path; a thousandth of the object's size
            stop_after: m, that a contact's place on the object goes
            frames: moments kept, ends included (101)

        A motion that ends early is an answer: see its `status` and `end`.
        """
        return self._answer(Motion, "move",
                            {"time": time, "step": step, "tolerance": tolerance,
                             "stop_after": stop_after, "frames": frames}, False, progress)

    def hold(self, *, at: Optional[Sequence[float]] = None, directions: Sequence[str] = (),
             press: bool = False, tolerance: Union[str, Sequence[str]] = ()) -> Hold:
        """How hard to grip, and what makes it slip: the grasp without a push.

        Args:
            at: shape (3,), m, the scene's frame, where forces act; the centre of mass
            directions: more than the axes, such as "force 1 0 0" or "moment 0 1 0"
            press: pushers with a normal_force press with it, without friction: a load to hold
            tolerance: as of `cone`
        """
        place = None if at is None else plain(at, "at")
        return self._answer(Hold, "hold", {"at": place, "direction": list(directions) or None,
                                           "press": press or None, "tolerance": tolerance or None},
                            False, None)

    def cone(self, twist: Optional[Sequence[float]] = None, *,
             pusher: Optional[str] = None,
             tolerance: Union[str, Sequence[str]] = ()) -> Cone:
        """The motion cone: all pushes with which the pusher sticks to the object, in the plane.

        Args:
            twist: shape (3,), the motion that is judged, v_x, v_y m/s and the turn rad/s, of the
                object at its centre of mass; the scene's own
            pusher: whose, among several
            tolerance: "*.friction=10%", "wall.friction=0.3:0.5" or "object.mass": does it stick for
                every value? `verdict`, `margin`, `corner`, `box`
        """
        judged = None if twist is None else plain(twist, "twist")
        return self._answer(Cone, "cone", {"twist": judged, "pusher": pusher,
                                     "tolerance": tolerance or None}, False, None)

    def design(self, choose: Union[Mapping[str, Tuple[float, float]], Sequence[str]], *,
               push: Optional[Sequence[float]] = None, pusher: Optional[str] = None,
               tolerance: Union[str, Sequence[str]] = ()) -> Design:
        """The numbers in these ranges with which the push sticks with the largest margin.

        Args:
            choose: {"wall.shift[1]": (-0.005, 0.005)}, or as the tool takes it
            push: shape (3,), the motion that is to stick, as the twist of `cone`; the scene's own
            pusher: whose, among several
            tolerance: as of `cone`; without it all frictions and grips, and the mass
        """
        choices = ([f"{path}={start!r}:{stop!r}" for path, (start, stop) in choose.items()]
                   if isinstance(choose, Mapping) else choose)
        return self._answer(Design, "design", {"choose": choices, "pusher": pusher,
                                               "push": None if push is None else plain(push, "push"),
                                               "tolerance": tolerance or None}, False, None)

    def funnel(self, box: Sequence[float], *, pusher: Optional[str] = None) -> Funnel:
        """From which poses a push with a flat edge leaves the object flush, and what is left of them.

        Args:
            box: shape (3,), half its sides along the push and along the edge, m, and of the angle,
                rad, about the scene's pose
            pusher: whose edge, among several
        """
        return self._answer(Funnel, "design", {"from_box": plain(box, "box"), "pusher": pusher},
                            False, None)

    def plan(self, to: Sequence[float], *, seconds: Optional[float] = None,
             tolerance: Union[str, Sequence[str]] = (),
             progress: Optional[Progress] = None) -> Plan:
        """Pushes against the scene's pushers that take the object to another place.

        Args:
            to: shape (3,), where the centre of mass is to go from where it is, x, y m, and the turn
                rad
            seconds: stop the search after that time
            tolerance: as of `cone`: pushes that stick for every value
        """
        return self._answer(Plan, "plan", {"to": plain(to, "to"), "seconds": seconds,
                                           "tolerance": tolerance or None}, False, progress)

    def report(self, *, vary: Optional[Tuple[str, float, float]] = None,
               steps: Optional[int] = None, pusher: Optional[str] = None,
               progress: Optional[Progress] = None) -> str:
        """One HTML page to look at; `vary`: with a plot of a sweep, (path, start, stop)."""
        request: Dict[str, Any] = {"steps": steps, "pusher": pusher}
        if vary:
            request["vary"] = {"list": [variation(vary, "vary")]}
        return self._ask("report", request, progress)

    def picture(self, name: str = "front") -> str:
        """One picture of the report, as SVG: "isometric", "front", "top", "side", "friction", .."""
        return self._ask("report", {"format": "svg", "picture": name})

    def certify(self, *, breaking: bool = False, pusher: Optional[str] = None,
                progress: Optional[Progress] = None) -> Certificate:
        """A proof in fractions, without rounding: of the answer, or of why there is none. It is tied
        to `text`: `save()` the scene for docs/check/lcpush_check.py.

        Args:
            breaking: of the push that just breaks the grasp
            pusher: whose, among several
        """
        code, text = ask("certify", self._request({"break": breaking or None, "pusher": pusher}),
                         progress)
        if code == NOT_SOLVED:
            raise NotSolved(json.loads(text)["reason"], json.loads(text))
        return Certificate(text)

    def pivots(self, *, exact: bool = False, as_solved: bool = False, facets: Optional[int] = None,
               pressure: Optional[str] = None, progress: Optional[Progress] = None) -> Pivots:
        """Lemke's method pivot by pivot, and what each pivot means.

        Args:
            exact: in fractions
            as_solved: the very run of solve(): scaled, with every round of the pressure law
            facets: sides of the friction pyramids (4)
            pressure: "pad" (its first round), "even" or "rigid" instead of the file's
        """
        return self._answer(Pivots, "pivots",
                            {"exact": exact or None, "as_solved": as_solved or None,
                             "facets": facets, "pressure": pressure}, False, progress)

    def export(self, folder: Union[str, "os.PathLike[str]"]) -> "list[str]":
        """Writes the problem for other solvers: M.mtx, q.mtx, names.txt, the paper's program, FCLIB's
        local problem (docs/check/export.md). The names of the files, in `folder`."""
        export = json.loads(self._ask("export", {}))
        for name in export["absent"]:
            pathlib.Path(folder, name).unlink(missing_ok=True)
        for file in export["files"]:
            path = pathlib.Path(folder, file["name"])
            path.parent.mkdir(parents=True, exist_ok=True)
            with open(path, "w", encoding="utf-8", newline="") as stream:
                stream.write(file["text"])
        return [file["name"] for file in export["files"]]

    def matrices(self) -> Record:
        """The paper's matrices: `M`, `w`, `G`, `G_bar`, `J`, `v`, each with `rows`, `columns` and
        `values`; SI units, at the object's centre of mass."""
        return Record(json.loads(self._ask("matrices", {})))

    def __repr__(self) -> str:
        return f"<Scene {self.title or self._name}: {', '.join(self.names)}>"

    def _repr_html_(self) -> str:
        return self.picture("isometric")

    def _request(self, changes: Mapping[str, Any]) -> Dict[str, Any]:
        return {"scene": self._text, "file": self._name, **changes}

    def _ask(self, question: str, changes: Mapping[str, Any],
             progress: Optional[Progress] = None) -> str:
        return ask(question, self._request(changes), progress)[1]

    def _answer(self, kind: Type[A], question: str, options: Dict[str, Any], check: bool,
                progress: Optional[Progress]) -> A:
        code, text = ask(question, self._request(options), progress)
        answer = kind(text, question, Asker(question, self._request({}), options), self.title)
        if check and code == NOT_SOLVED:
            raise NotSolved(answer.sentence, answer.to_dict())
        return answer


def _is_path(text: str) -> bool:
    return text.strip() != "" and not any(mark in text for mark in "\n=[{")


def _text_of(given: Any, name: str) -> str:
    """An answer or a motion, `name`, as the library reads it."""
    if isinstance(given, Answer):
        return given.json
    if isinstance(given, os.PathLike):
        return pathlib.Path(given).read_text(encoding="utf-8-sig")
    if isinstance(given, str):
        if _is_path(given):
            raise InputError(f"this is no {name}'s text; of a file: pathlib.Path({given!r})")
        return given
    try:
        return json.dumps(given, default=lambda thing: thing.to_dict() if isinstance(thing, Record)
                          else as_json(thing))
    except TypeError as error:
        raise InputError(f"this is no {name}: {error}") from None


def read(path: Union[str, "os.PathLike[str]"]) -> Scene:
    """The scene of a file. Raises InputError, or OSError if it cannot be read."""
    path = os.fsdecode(path)
    with open(path, "rb") as file:
        bytes_read = file.read()
    try:
        text = bytes_read.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = bytes_read[:error.start].count(b"\n") + 1
        raise InputError("is no UTF-8 text", path, line) from None
    return Scene(text, path)


def verify_scene(scene: Union[Scene, str, Mapping[str, Any]], answer: Any, *,
                 tolerance: Optional[float] = None) -> Verdict:
    """`scene.verify(answer)`, for a scene in whatever form."""
    if not isinstance(scene, Scene):
        scene = Scene(scene)
    return scene.verify(answer, tolerance=tolerance)
