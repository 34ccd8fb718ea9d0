"""What goes wrong."""
from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple


class InputError(ValueError):
    """A scene, a problem or an option is wrong; `str()` says what, where, and what to do.

    Attributes:
        file: as the scene was named, "" if none
        line: counted from 1, 0 if none
        message: without file and line
    """

    def __init__(self, message: str, file: str = "", line: int = 0) -> None:
        super().__init__(f"{file}:{line}: {message}" if line > 0 else message)
        self.file, self.line, self.message = file, line, message


class NotSolved(RuntimeError):
    """There is no answer, or none was found; `str()` is the sentence that says why.

    Attributes:
        status: "ray", "does_not_hold", "pivot_limit", ..
        reason: a sentence, "" if there is none
        ray: of a ray, its entries that are not zero: a list of {"name", "value"} of a scene's
            problem, of a raw one its numbers, shape (n,); else None
        answer: all of it, as `to_dict()` of an answer gives it
    """

    def __init__(self, sentence: str, answer: Dict[str, Any]) -> None:
        super().__init__(sentence)
        self.answer = answer
        self.status: str = answer.get("status", "")
        self.reason: str = answer.get("reason") or ""
        self.ray: Optional[List[Any]] = answer.get("ray")

    def __reduce__(self) -> Tuple[Any, ...]:  # for pickle: another process may have asked
        return type(self), (str(self), self.answer)
