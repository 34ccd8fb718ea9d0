"""NumPy's arrays where NumPy is there, else lists; and what is given as readable numbers."""
from __future__ import annotations

import math
import operator
from typing import AbstractSet, Any, Callable, Dict, Iterable, List, Mapping, Optional, Tuple

from ._errors import InputError

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

Entries = Tuple[int, int, List[int], List[int], List[Any]]  # height, width, rows, columns, values


def array(numbers: Any) -> Any:
    """`numbers` as numpy.ndarray of floats (null: nan), or as it is, in lists."""
    if numpy is None or numbers is None:
        return numbers
    return numpy.array(numbers, dtype=float)


def _is_list(thing: Any) -> bool:
    return hasattr(thing, "__iter__") and not isinstance(thing, (str, bytes, Mapping, AbstractSet))


def _listed(thing: Any, name: str) -> Any:
    """Matrices and vectors of SciPy, NumPy, pandas, .. as NumPy's arrays; "[2 1; 1 2]" as rows;
    others as they are."""
    if isinstance(thing, str):
        if name not in ("M", "A", "B"):
            return thing.strip("[] ;\n").replace(",", " ").replace(";", " ").split()
        return [row.replace(",", " ").split() for row in thing.strip("[] ;\n").split(";")]
    if hasattr(thing, "toarray"):
        thing = thing.toarray()
    if numpy is None or not hasattr(thing, "__array__"):
        return thing
    if isinstance(thing, numpy.ma.MaskedArray) and numpy.any(thing.mask):
        raise InputError(f"{name} has masked entries, which are no numbers: fill them first")
    return numpy.asarray(thing)


def _floats(numbers: Iterable[Any], where: Callable[[int], str], finite: bool) -> List[float]:
    """`where` names the k-th in messages."""
    found = []
    for k, x in enumerate(numbers):
        try:
            value = float(x)
        except (TypeError, ValueError, OverflowError):
            raise InputError(f"{where(k)} must be a number, not {x!r}") from None
        if math.isnan(value) or (finite and math.isinf(value)):
            raise InputError(f"{where(k)} must be {'finite' if finite else 'a number'}, not {value}")
        found.append(value)
    return found


def number(x: Any, name: str) -> float:
    """A finite one."""
    return _floats([x], lambda _: name, True)[0]


def as_json(thing: Any) -> Any:
    """For json.dumps: NumPy's arrays and numbers as it knows them."""
    if hasattr(thing, "tolist"):
        return thing.tolist()
    raise InputError(f"{thing!r} is no number, text, list or dictionary")


def plain(numbers: Any, name: str, count: Optional[int] = None, finite: bool = True) -> List[float]:
    """A vector as a list of floats; an n x 1 or 1 x n array counts as one. `name` is its in
    messages, `count` how many they have to be."""
    numbers = _listed(numbers, name)
    if hasattr(numbers, "ravel"):
        numbers = numbers.ravel()
    if not _is_list(numbers):
        raise InputError(f"{name} must be a vector, not {numbers!r}")
    found = _floats(numbers, lambda k: f"{name}[{k}]", finite)
    if count is not None and len(found) != count:
        raise InputError(f"{name} must have {count} numbers, one a row of M, not {len(found)}")
    return found


def rows(given: Any, count: int) -> Optional[List[int]]:
    """Rows counted from 0 as the library counts them, from 1."""
    if given is None:
        return None
    if not _is_list(given) and not isinstance(given, AbstractSet):
        raise InputError(f"free must be a list of rows, not {given!r}")
    found = []
    for row in given:
        try:
            if str(row) in ("True", "False"):  # of a mask, NumPy's or not
                raise TypeError
            k = operator.index(row)
        except TypeError:
            raise InputError(f"free must hold rows, whole numbers from 0, not {row!r}") from None
        if not 0 <= k < count:
            raise InputError(f"free must hold rows from 0 to {count - 1}, not {k}")
        found.append(k + 1)
    return found


def findex(given: Any, count: int) -> Optional[List[float]]:
    """For each row -1, or None, or the row from 0 that its ends follow."""
    if given is None:
        return None
    if isinstance(given, (list, tuple)):
        given = [-1 if row is None else row for row in given]
    return plain(given, "findex", count)


def ends(numbers: Any, name: str, count: int, none: float) -> Optional[List[Optional[float]]]:
    """A bound of each row, of one number for all, or of a vector; the infinity `none`, or None, is
    null."""
    if numbers is None:
        return None
    if not _is_list(numbers) and not hasattr(numbers, "ravel"):
        numbers = [numbers] * count
    if isinstance(numbers, (list, tuple)):
        numbers = [none if x is None else x for x in numbers]
    listed = plain(numbers, name, finite=False)
    if len(listed) == 1:
        listed *= count
    for k, x in enumerate(plain(listed, name, count, finite=False)):
        if x == -none:
            raise InputError(f"{name}[{k}] is {x}: no number is "
                             f"{'below' if none > 0 else 'above'} that")
    return [None if math.isinf(x) else x for x in listed]


def table_of(M: Any, name: str) -> List[List[Any]]:
    """A matrix as a list of rows of one length, whatever they hold."""
    M = _listed(M, name)
    table = M.tolist() if hasattr(M, "tolist") else M
    if not _is_list(table) or getattr(M, "ndim", 2) != 2:
        raise InputError(f"{name} must be a matrix: a list of rows, an array or a sparse matrix, "
                         f"not {M!r}")
    found: List[List[Any]] = []
    for row in table:
        if not _is_list(row):
            raise InputError(f"{name} must be a list of rows, but {row!r} is no row")
        found.append(list(row))
        if len(found[-1]) != len(found[0]):
            raise InputError(f"the rows of {name} are not of one length: row 0 has "
                             f"{len(found[0])} numbers, row {len(found) - 1} has {len(found[-1])}")
    return found


def _entries(M: Any) -> Entries:
    """Those that are not zero, in order."""
    if hasattr(M, "tocoo"):
        compact = M.tocsr(copy=True)
        compact.sum_duplicates()
        listed = compact.tocoo()
        height, width = listed.shape
        return (height, width, listed.row.tolist(), listed.col.tolist(), listed.data.tolist())
    M = _listed(M, "M")
    if numpy is not None and isinstance(M, numpy.ndarray) and M.ndim == 2 and M.dtype.kind in "fiub":
        row, column = numpy.nonzero(M)
        return (M.shape[0], M.shape[1], row.tolist(), column.tolist(), M[row, column].tolist())
    table = table_of(M, "M")
    found = [(i, j, x) for i, line in enumerate(table) for j, x in enumerate(line)
             if not isinstance(x, (int, float)) or x != 0]
    return (len(table), len(table[0]) if table else 0, [i for i, _, _ in found],
            [j for _, j, _ in found], [x for _, _, x in found])


def entries(M: Any) -> Dict[str, Any]:
    """A square matrix's entries that are not zero, in order: of SciPy's sparse matrices, NumPy's
    arrays, or a list of rows."""
    height, width, row, column, given = _entries(M)
    if height != width or height == 0:
        raise InputError(f"M must be square, but it is {height} x {width}")
    value = _floats(given, lambda k: f"M[{row[k]}, {column[k]}]", True)
    return {"rows": height, "row": row, "column": column, "value": value}
