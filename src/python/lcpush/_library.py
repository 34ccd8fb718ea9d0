"""The shared library, by ctypes: a question as JSON, an answer as JSON."""
from __future__ import annotations

import ctypes
import ctypes.util
import json
import os
import pathlib
import signal
import sys
import sysconfig
import threading
from typing import Any, Callable, Dict, Optional, Tuple

from ._arrays import as_json
from ._errors import InputError

SOLVED, NOT_SOLVED, BAD_INPUT, CANCELLED = range(4)
Progress = Callable[[float], Any]

_Progress = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_double)
_IsCancelled = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p)


class _Listener(ctypes.Structure):
    _fields_ = [("context", ctypes.c_void_p), ("progress", _Progress),
                ("is_cancelled", _IsCancelled)]


def _multiarch() -> str:
    return sysconfig.get_config_var("MULTIARCH") or "lib"


def _path() -> str:
    given = os.environ.get("LCPUSH_LIBRARY")
    if given:
        return given
    suffix = {"darwin": ".dylib", "win32": ".dll"}.get(sys.platform, ".so")
    name = "liblcpush_desktop" + suffix
    here = pathlib.Path(__file__).resolve().parent
    # In a wheel beside this file; in a package of Debian's form it is a prefix' lib/python3/
    # dist-packages/lcpush that this stands in.
    for folder in (here, here.parents[2], here.parents[2] / _multiarch()):
        if (folder / name).exists():
            return str(folder / name)
    found = ctypes.util.find_library("lcpush_desktop")
    if found:
        return found
    raise ImportError("lcpush's shared library is not there: `pip install ./src/python` builds it, "
                      "or LCPUSH_LIBRARY names one")


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(_path())
    answer, text = ctypes.c_void_p, ctypes.c_char_p
    library.lcpush_desktop_ask.argtypes = [text, text, ctypes.POINTER(_Listener)]
    library.lcpush_desktop_ask.restype = answer
    for name, result in (("text", answer), ("length", ctypes.c_size_t), ("file", text),
                         ("message", text), ("line", ctypes.c_int), ("code", ctypes.c_int),
                         ("free", None)):
        function = getattr(library, f"lcpush_desktop_{name}")
        function.argtypes, function.restype = [answer], result
    library.lcpush_desktop_version.restype = text
    return library


_library = _load()
version: str = _library.lcpush_desktop_version().decode()


class _Interrupt:
    """Ctrl-C while the library works. Python would raise within a callback, where it is lost; here
    it is remembered, ends the work, and is raised after it."""

    def __init__(self) -> None:
        self.asked = False
        self._before: Any = None

    def __enter__(self) -> "_Interrupt":
        if threading.current_thread() is threading.main_thread():
            before = signal.getsignal(signal.SIGINT)
            if callable(before):
                self._before = before
                signal.signal(signal.SIGINT, self._note)
        return self

    def _note(self, number: int, frame: Any) -> None:
        self.asked = True

    def __exit__(self, *_: Any) -> None:
        if self._before is None:
            return
        signal.signal(signal.SIGINT, self._before)
        if self.asked:
            self._before(signal.SIGINT, None)


class Asker:
    """Asks again about the same thing: the answer's own question as it was asked but for changes;
    of others only what names the thing."""

    def __init__(self, question: str, subject: Dict[str, Any], options: Dict[str, Any]) -> None:
        self._question, self._subject, self._options = question, subject, options

    def __call__(self, question: str, changes: Dict[str, Any]) -> str:
        own = self._options if question == self._question else {}
        return ask(question, {**self._subject, **own, **changes})[1]


def ask(question: str, request: Dict[str, Any],
        progress: Optional[Progress] = None) -> Tuple[int, str]:
    """The answer's code and text. Raises InputError, KeyboardInterrupt, or what `progress` raises:
    both end the work within a fraction of a second."""
    try:
        words = json.dumps({key: value for key, value in request.items() if value is not None},
                           allow_nan=False, default=as_json).encode()
    except ValueError as error:
        raise InputError(f"{question}: every number must be finite ({error})") from None
    raised: Dict[str, BaseException] = {}

    def tell(_: Any, done: float) -> None:
        try:
            if progress is not None and not raised:
                progress(done)
        except BaseException as error:  # it may not leave a callback
            raised["by progress"] = error

    with _Interrupt() as interrupt:
        listener = _Listener(None, _Progress(tell),
                             _IsCancelled(lambda _: bool(interrupt.asked or raised)))
        answer = _library.lcpush_desktop_ask(question.encode(), words, ctypes.byref(listener))
        try:
            code = _library.lcpush_desktop_code(answer)
            text = ctypes.string_at(_library.lcpush_desktop_text(answer),
                                    _library.lcpush_desktop_length(answer)).decode()
            file = _library.lcpush_desktop_file(answer).decode()
            message = _library.lcpush_desktop_message(answer).decode()
            line = _library.lcpush_desktop_line(answer)
        finally:
            _library.lcpush_desktop_free(answer)
    if raised:
        raise raised["by progress"]
    if code == BAD_INPUT and file == "request":  # the options are no file of the user's
        raise InputError(message)
    if code == BAD_INPUT:
        raise InputError(message, file, line)
    if code == CANCELLED:
        raise KeyboardInterrupt
    if code not in (SOLVED, NOT_SOLVED):
        raise MemoryError(message) if "alloc" in message else RuntimeError(message)
    return code, text
