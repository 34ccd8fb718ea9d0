"""Scenes as dictionaries: the strict subset of TOML that scene files are written in."""
from __future__ import annotations

import dataclasses
import json
import math
import re
import sys
from typing import Any, Dict, List, Mapping

from ._errors import InputError

Tables = Dict[str, Any]

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _value(value: Any, where: str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(int(value))
    if isinstance(value, str):  # JSON's escapes are TOML's, but for what is none of JSON's
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if hasattr(value, "tolist"):
        return _value(value.tolist(), where)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(entry, f"{where}[{k}]") for k, entry in enumerate(value)) + "]"
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
    return [f"{key} = {_value(value, where + str(key))}" for key, value in table.items()
            if value is not None]


def _is_table(value: Any) -> bool:
    return isinstance(value, Mapping)


def _are_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(map(_is_table, value))


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
    top = {key: value for key, value in scene.items()
           if not _is_table(value) and not _are_tables(value) and value != []}
    lines = _pairs(top, "")
    for key, value in scene.items():
        if _is_table(value):
            lines += ["", f"[{key}]", *_pairs(value, f"{key}: ")]
        elif _are_tables(value):
            for k, table in enumerate(value):
                lines += ["", f"[[{key}]]", *_pairs(table, f"{key}[{k}]: ")]
    return "\n".join(lines).lstrip("\n") + "\n"


_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|#[^\n]*|[\[\],=]|[^\s\[\],=#"]+|\n')


def read(text: str) -> Tables:
    """The dictionary of a scene file that lcpush has accepted."""
    if sys.version_info < (3, 11):
        return _read(text)
    import tomllib
    return tomllib.loads(text)


def _scalar(word: str) -> Any:
    if word.startswith('"'):
        return json.loads(re.sub(r"\\U([0-9A-Fa-f]{8})",
                                 lambda found: json.dumps(chr(int(found[1], 16)))[1:-1], word))
    if word in ("true", "false"):
        return word == "true"
    word = word.replace("_", "")
    return int(word) if re.fullmatch(r"[+-]?\d+", word) else float(word)


def _read(text: str) -> Tables:
    words = [word for word in _TOKEN.findall(text.replace("\r\n", "\n")) if word[0] != "#"]
    root: Tables = {}
    table, at = root, 0

    def value() -> Any:
        nonlocal at
        word = words[at]
        at += 1
        if word != "[":
            return _scalar(word)
        entries: List[Any] = []
        while True:
            while words[at] in ("\n", ","):
                at += 1
            if words[at] == "]":
                at += 1
                return entries
            entries.append(value())

    while at < len(words):
        if words[at] == "\n":
            at += 1
        elif words[at:at + 2] == ["[", "["]:
            table = {}
            root.setdefault(words[at + 2], []).append(table)
            at += 5
        elif words[at] == "[":
            table = root[words[at + 1]] = {}
            at += 3
        else:
            key = words[at]
            at += 2
            table[key] = value()
    return root
