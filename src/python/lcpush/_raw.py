"""Raw problems: w = M z + q."""
from __future__ import annotations

import json
import math
from typing import Any, Dict, Iterable, Optional

from ._answers import ContactForces, LcpAnswer, LcpSolutions, LcpVerdict, Pivots
from ._arrays import as_json, ends, entries, findex as followed, plain, rows, table_of
from ._errors import NotSolved
from ._library import NOT_SOLVED, Asker, Progress, ask


def _problem(M: Any, q: Any, free: Optional[Iterable[int]], lo: Any, hi: Any,
             findex: Any) -> Dict[str, Any]:
    matrix = entries(M)
    count = matrix["rows"]
    return {"M": matrix, "q": plain(q, "q", count), "free": rows(free, count),
            "lo": ends(lo, "lo", count, -math.inf), "hi": ends(hi, "hi", count, math.inf),
            "findex": followed(findex, count)}


def lcp(M: Any, q: Any, *, free: Optional[Iterable[int]] = None, lo: Any = None, hi: Any = None,
        findex: Any = None, solver: Optional[str] = None, sweeps: Optional[int] = None,
        relaxation: Optional[float] = None, check: bool = True,
        progress: Optional[Progress] = None) -> LcpAnswer:
    """Finds z with w = M z + q, z >= 0, w >= 0, z'w = 0.

    Args:
        M: shape (n, n): a list of rows, a NumPy array, a SciPy sparse matrix or "[2 1; 1 2]"
        q: shape (n,)
        free: rows, from 0, that are equalities w_i = 0 with a free z_i
        lo, hi: ends of a box instead, shape (n,) or one for all, infinities among them:
            lo <= z <= hi, w >= 0 where z is at lo, <= 0 at hi, 0 in between; from 1e15 on they are
            infinite
        findex: shape (n,): -1, or the row j, from 0, of the ends -hi z_j and hi z_j
        solver: "lemke" (default), "gauss-seidel" or "hybrid"
        sweeps, relaxation: most sweeps of the last two, and their over-relaxation, between 0 and 2
        check: raise NotSolved if there is no answer

    >>> answer = lcp([[2, 1], [1, 2]], [-5, -6])
    >>> [round(float(z), 6) for z in answer.z]
    [1.333333, 2.333333]
    """
    problem = _problem(M, q, free, lo, hi, findex)
    options = {"solver": solver, "sweeps": sweeps, "relaxation": relaxation}
    code, text = ask("lcp", {**problem, **options}, progress)
    answer = LcpAnswer(text, "lcp", Asker("lcp", problem, options))
    if check and code == NOT_SOLVED:
        raise NotSolved(answer.sentence, answer.to_dict())
    return answer


def _text(M: Any, name: str) -> str:
    return "; ".join(" ".join(map(str, row)) for row in table_of(M, name))


def _vector(q: Any) -> str:
    numbers = table_of(q, "q") if getattr(q, "ndim", 1) > 1 else [q]
    return " ".join(str(x) for row in table_of(numbers, "q") for x in row)


def _all(problem: Dict[str, Any], exact: bool, most: Optional[int],
         progress: Optional[Progress]) -> LcpSolutions:
    options = {"all": True, "exact": exact or None, "most": most}
    text = ask("lcp", {**problem, **options}, progress)[1]
    return LcpSolutions(text, "lcp", Asker("lcp", problem, options))


def lcp_all(M: Any, q: Any, *, free: Optional[Iterable[int]] = None, exact: bool = False,
            most: Optional[int] = None, progress: Optional[Progress] = None) -> LcpSolutions:
    """Every z with w = M z + q, z >= 0, w >= 0, z'w = 0, found in fractions.

    Args:
        M: shape (n, n), n <= 64: a list of rows, or an array; its numbers may be fractions.Fraction,
            or texts such as "1/3"
        q: shape (n,), the same
        free: rows, from 0, that are equalities w_i = 0 with a free z_i
        exact: answer in fractions
        most: end at so many vertices (10000)

    >>> lcp_all([[1, 2], [2, 1]], [-2, -2])
    3 solutions, and that is all.
    """
    problem = {"M": _text(M, "M"), "q": _vector(q), "free": rows(free, len(table_of(M, "M")))}
    return _all(problem, exact, most, progress)


def equilibria(A: Any, B: Any, *, exact: bool = False, most: Optional[int] = None,
               progress: Optional[Progress] = None) -> LcpSolutions:
    """All Nash equilibria of the game in which the row player gets A, the column player B, both of
    shape (m, n); the rest as of lcp_all.

    >>> equilibria([[2, 0], [0, 1]], [[1, 0], [0, 2]], exact=True).equilibria[2].row
    ['2/3', '1/3']
    """
    return _all({"game": [_text(A, "A"), _text(B, "B")]}, exact, most, progress)


def check(M: Any, q: Any, z: Any, *, free: Optional[Iterable[int]] = None, lo: Any = None,
              hi: Any = None, findex: Any = None, tolerance: Optional[float] = None) -> LcpVerdict:
    """Is z, shape (n,), a solution of lcp(M, q)? Judged by code that solves nothing.

    >>> bool(check([[2, 1], [1, 2]], [-5, -6], [4 / 3, 7 / 3]))
    True
    >>> bool(check([[2, 1], [1, 2]], [-5, -6], [1.3, 2.3]))
    False
    """
    problem = _problem(M, q, free, lo, hi, findex)
    options = {"z": plain(z, "z", problem["M"]["rows"]), "tolerance": tolerance}
    text = ask("verify_lcp", {**problem, **options})[1]
    return LcpVerdict(text, "verify_lcp", Asker("verify_lcp", problem, options))


def contacts(W: Any, g: Any, mu: Any, *, r: Any = None, facets: Optional[int] = None,
             normal: str = "first", tolerance: Optional[float] = None, check: bool = True,
             progress: Optional[Progress] = None) -> ContactForces:
    """Contact forces r, three a contact, with u = W r + g by the laws of Signorini and Coulomb.

    Args:
        W: shape (3k, 3k), symmetric and positive semidefinite: rows, an array or a sparse matrix
        g: shape (3k,)
        mu: shape (k,), friction; or a number for all contacts
        r: shape (3k,), somebody's forces: they are judged instead, to `tolerance` (1e-6)
        facets: pyramids of so many sides instead of round cones
        normal: "first" or "last" of each contact's three numbers
        check: raise NotSolved if there is no answer

    >>> contacts([[2, 0, 0], [0, 2, 0], [0, 0, 2]], [-4, 1, 0], [0.5]).modes
    ['stick']
    """
    friction = mu if isinstance(mu, (int, float)) else plain(mu, "mu")
    problem: Dict[str, Any] = {"W": table_of(W, "W"), "g": plain(g, "g"), "mu": friction}
    if r is not None:
        problem["r"] = plain(r, "r")
    request = {"problem": json.dumps(problem, default=as_json)}
    options = {"facets": facets, "normal": normal, "tolerance": tolerance}
    code, text = ask("contacts", {**request, **options}, progress)
    answer = ContactForces(text, "contacts", Asker("contacts", request, options))
    if check and r is None and code == NOT_SOLVED:
        raise NotSolved(answer.sentence, answer.to_dict())
    return answer


def pivots(M: Any, q: Any, *, exact: bool = False,
           progress: Optional[Progress] = None) -> Pivots:
    """Lemke's method on M and q pivot by pivot, as textbooks do it.

    Args:
        M: shape (n, n): a list of rows, or an array; its numbers may be fractions.Fraction, or
            texts such as "1/3"
        q: shape (n,), the same
        exact: pivot and answer in fractions

    >>> from fractions import Fraction
    >>> pivots([[2, 1], [1, Fraction(1, 2)]], ["-5", "-6"], exact=True).status
    'solved'
    """
    problem = {"M": _text(M, "M"), "q": _vector(q)}
    options = {"exact": exact or None}
    text = ask("pivots", {**problem, **options}, progress)[1]
    return Pivots(text, "pivots", Asker("pivots", problem, options))
