"""NumPy's arrays where NumPy is there, else lists."""
from __future__ import annotations

import math
from typing import Any, Dict, List, Optional, Sequence

from ._errors import InputError

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


def array(numbers: Any) -> Any:
    """`numbers` as numpy.ndarray of floats (null: nan), or as it is, in lists."""
    if numpy is None or numbers is None:
        return numbers
    return numpy.array(numbers, dtype=float)


def plain(numbers: Any) -> List[float]:
    """A vector as a list of floats; an n x 1 or 1 x n array counts as one."""
    if hasattr(numbers, "toarray"):
        numbers = numbers.toarray()
    if hasattr(numbers, "ravel"):
        numbers = numbers.ravel()
    return [float(x) for x in numbers]


def ends(numbers: Any, count: int, none: float) -> Optional[List[Optional[float]]]:
    """A bound of each row, of one number for all, or of a vector; the infinity `none` is null."""
    if numbers is None:
        return None
    single = isinstance(numbers, (int, float))
    listed = [float(numbers)] * count if single else plain(numbers)
    for k, x in enumerate(listed):
        if x != x or x == -none:
            raise InputError(f"row {k} has the {'upper' if none > 0 else 'lower'} end {x}")
    return [None if math.isinf(x) else x for x in listed]


def entries(M: Any) -> Dict[str, Any]:
    """A square matrix's entries that are not zero, in order: of SciPy's sparse matrices, NumPy's
    arrays, or a list of rows."""
    if hasattr(M, "tocoo"):
        coordinates = M.tocsr().tocoo()
        rows, columns = coordinates.shape
        summed: Dict[Any, float] = {}
        for i, j, x in zip(coordinates.row, coordinates.col, coordinates.data):
            summed[int(i), int(j)] = summed.get((int(i), int(j)), 0.0) + float(x)
        found = sorted((i, j, x) for (i, j), x in summed.items() if x != 0)
    else:
        table: Sequence[Sequence[float]] = M.tolist() if hasattr(M, "tolist") else M
        rows, columns = len(table), len(table[0]) if len(table) > 0 else 0
        if any(len(row) != columns for row in table):
            raise InputError("the rows of M are not of one length")
        found = [(i, j, float(x)) for i, row in enumerate(table) for j, x in enumerate(row)
                 if x != 0]
    if rows != columns or rows == 0:
        raise InputError(f"M must be square, but it is {rows} x {columns}")
    return {"rows": rows, "row": [i for i, _, _ in found], "column": [j for _, j, _ in found],
            "value": [x for _, _, x in found]}
