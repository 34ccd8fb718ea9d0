"""Dictionaries as scene files, in the strict subset of TOML that they are written in."""
from __future__ import annotations

import dataclasses
import json
import math
import re
from typing import Any, List, Mapping

from ._errors import InputError

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_LISTS = ("finger", "pusher", "actuator")  # of tables, which may be none


def as_toml(value: Any, where: str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(int(value))
    if isinstance(value, str):  # JSON's escapes are TOML's, but for what is none of JSON's
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if hasattr(value, "tolist"):
        return as_toml(value.tolist(), where)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(as_toml(entry, f"{where}[{k}]") for k, entry in enumerate(value)) + "]"
    try:
        if isinstance(value, (bytes, bytearray)):
            raise TypeError
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{where} must be a number, a text, true or false, or a list of these, not "
                         f"{value!r}") from None
    if not math.isfinite(number):
        raise InputError(f"{where} must be finite, not {number}")
    return repr(number)


def _pairs(table: Mapping[str, Any], where: str) -> List[str]:
    for key in table:
        if not _BARE.fullmatch(str(key)):
            raise InputError(f"{where}{key!r} is no key of a scene")
    return [f"{key} = {as_toml(value, where + str(key))}" for key, value in table.items()
            if value is not None]


def tables_of(given: Any) -> Any:
    """What dataclasses hold as dictionaries; all else as it is."""
    if dataclasses.is_dataclass(given) and not isinstance(given, type):
        return dataclasses.asdict(given)
    if isinstance(given, Mapping):
        return {key: tables_of(value) for key, value in given.items()}
    if isinstance(given, (list, tuple)):
        return [tables_of(entry) for entry in given]
    return given


def write(scene: Mapping[str, Any]) -> str:
    """`{"object": {..}, "finger": [{..}, ..]}` as a scene file."""
    top, lines = {}, []
    for key, value in scene.items():
        is_list = isinstance(value, (list, tuple)) and (len(value) > 0 or key in _LISTS)
        if isinstance(value, Mapping):
            lines += ["", f"[{key}]", *_pairs(value, f"{key}: ")]
        elif is_list and all(isinstance(entry, Mapping) for entry in value):
            for k, table in enumerate(value):
                lines += ["", f"[[{key}]]", *_pairs(table, f"{key}[{k}]: ")]
        else:
            top[key] = value
    return "\n".join([*_pairs(top, ""), *lines]).lstrip("\n") + "\n"
