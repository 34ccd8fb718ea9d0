"""The shared library, by ctypes: a question as JSON, an answer as JSON."""
from __future__ import annotations

import _thread
import atexit
import ctypes
import ctypes.util
import json
import math
import os
import pathlib
import sys
import sysconfig
import threading
from typing import Any, Callable, Dict, Optional, Set, Tuple

from ._arrays import as_json
from ._errors import InputError

SOLVED, NOT_SOLVED, BAD_INPUT = range(3)
Progress = Callable[[float], Any]

_BETWEEN = 0.02  # s, from a look at the work to the next
_PATIENCE, _LAST_PATIENCE = 0.1, 10.0  # s, for work to end that is told to


class _Slate(ctypes.Structure):
    """What the library notes, and reads, while another thread waits for it."""
    _fields_ = [("done", ctypes.c_double), ("is_cancelled", ctypes.c_int)]


class _Listener(ctypes.Structure):
    _fields_ = [("slate", ctypes.c_void_p), ("progress", ctypes.c_void_p),
                ("is_cancelled", ctypes.c_void_p)]


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
_note, _is_cancelled = (ctypes.cast(getattr(_library, f"lcpush_desktop_{name}"), ctypes.c_void_p)
                        for name in ("note", "is_cancelled"))


class _Work:
    """A question that the library works on. It calls nothing of Python's: a signal's handler that
    raises would be lost there, and a thread that Python ends with itself would end all."""

    def __init__(self, question: str, words: bytes) -> None:
        self._question, self._words, self._slate = question.encode(), words, _Slate(-1, 0)
        # No threading.Event: a signal may come at any line of one, and leave it locked.
        self._is_busy = _thread.allocate_lock()
        self._is_busy.acquire()
        self.code, self.line, self.text, self.file, self.message = -1, 0, "", "", ""

    def run(self) -> None:
        """In this thread, to its end."""
        _running.add(self)
        try:
            if _is_ending and not _is_main():
                return
            listener = _Listener(ctypes.addressof(self._slate), _note, _is_cancelled)
            answer = _library.lcpush_desktop_ask(self._question, self._words, ctypes.byref(listener))
            try:
                self.text = ctypes.string_at(_library.lcpush_desktop_text(answer),
                                             _library.lcpush_desktop_length(answer)).decode()
                self.file = _library.lcpush_desktop_file(answer).decode()
                self.message = _library.lcpush_desktop_message(answer).decode()
                self.line = _library.lcpush_desktop_line(answer)
                self.code = _library.lcpush_desktop_code(answer)
            finally:
                _library.lcpush_desktop_free(answer)
        except MemoryError:  # for the text
            self.message = "no memory for the answer: bad_alloc"
        except Exception as error:
            self.message = str(error)
        finally:
            _running.discard(self)
            self._is_busy.release()

    def end(self, patience: float) -> None:
        """What cannot end so soon, in s, is left to itself."""
        self._slate.is_cancelled = 1
        self._has_ended(patience)

    def _has_ended(self, patience: float) -> bool:
        """Within so many seconds."""
        if not self._is_busy.acquire(True, patience):
            return False
        self._is_busy.release()  # another thread may wait as well
        return True

    def watch(self, progress: Optional[Progress]) -> None:
        """In another thread. Signals, and what `progress` raises, end it."""
        try:
            if _is_ending:
                self.run()
            else:
                _thread.start_new_thread(self.run, ())
            told = -1.0
            while not self._has_ended(_BETWEEN):
                done = self._slate.done
                if progress is not None and done > told:
                    told = done
                    progress(done)
        except BaseException:
            self.end(_PATIENCE)
            raise


_running: Set[_Work] = set()
_is_ending = False


def _is_main() -> bool:
    return threading.current_thread() is threading.main_thread()


@atexit.register
def _end_all() -> None:
    """Before the process ends, and with it what its threads still use."""
    global _is_ending
    _is_ending = True
    for work in list(_running):
        work.end(_LAST_PATIENCE)


if hasattr(os, "register_at_fork"):  # the threads stay behind in the parent
    os.register_at_fork(after_in_child=_running.clear)


class Asker:
    """Asks again about the same thing: the answer's own question as it was asked but for changes;
    of others only what names the thing."""

    def __init__(self, question: str, subject: Dict[str, Any], options: Dict[str, Any]) -> None:
        self._question, self._subject, self._options = question, subject, options

    def __call__(self, question: str, changes: Dict[str, Any]) -> str:
        own = self._options if question == self._question else {}
        return ask(question, {**self._subject, **own, **changes})[1]


def _as_words(request: Dict[str, Any]) -> bytes:
    given = {key: value for key, value in request.items() if value is not None}
    for key, value in given.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise InputError(f"{key} must be finite, not {value}")
    try:
        return json.dumps(given, allow_nan=False, default=as_json).encode()
    except InputError:
        raise
    except ValueError:
        raise InputError("every number must be finite") from None


def ask(question: str, request: Dict[str, Any],
        progress: Optional[Progress] = None) -> Tuple[int, str]:
    """The answer's code and text. Raises InputError, or what a signal's handler (KeyboardInterrupt)
    or `progress` raises: they end the work."""
    work = _Work(question, _as_words(request))
    if progress is not None or _is_main():
        work.watch(progress)
    else:
        work.run()
    if work.code == BAD_INPUT and work.file == "request":  # the options are no file of the user's
        raise InputError(work.message)
    if work.code == BAD_INPUT:
        raise InputError(work.message, work.file, work.line)
    if work.code not in (SOLVED, NOT_SOLVED):
        if _is_ending:  # Python, and this thread with it
            raise SystemExit
        raise MemoryError(work.message) if "alloc" in work.message else RuntimeError(work.message)
    if progress is not None:
        progress(1.0)
    return work.code, work.text
