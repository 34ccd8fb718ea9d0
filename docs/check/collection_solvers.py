"""Other solvers as plug-ins of run_collection.py: solve(M, q, free) returns z, or None.

    /usr/bin/python3 docs/check/run_collection.py --plugin docs/check/collection_solvers.py:siconos_lemke

Debian's python3-siconos, python3-scipy and octave, each as its manual says. Solvers of pairs alone get
the problem without its free unknowns: what M can eliminate is eliminated, another one is bounded below.
"""
import subprocess

import numpy

BOUND, LARGEST, SECONDS = 100.0, 1e4, 1.0  # of a free unknown; of a mixed-integer unknown; of a program


def in_pairs(solve):
    """With a solver of z, w >= 0: M z + q, and None or z."""
    def with_free(M, q, free):
        M, q = numpy.array(M, float), numpy.array(q, float)
        gone = [i for i in free if M[i, i] != 0]
        kept = [i for i in range(len(q)) if i not in gone]
        inside = numpy.linalg.solve(M[numpy.ix_(gone, gone)], numpy.c_[M[numpy.ix_(gone, kept)], q[gone]])
        A = M[numpy.ix_(kept, kept)] - M[numpy.ix_(kept, gone)] @ inside[:, :-1]
        shift = numpy.array([BOUND if i in free else 0.0 for i in kept])
        z = solve(A, q[kept] - M[numpy.ix_(kept, gone)] @ inside[:, -1] - A @ shift)
        if z is None:
            return None
        whole = numpy.zeros(len(q))
        whole[kept] = z - shift
        whole[gone] = -inside @ numpy.r_[whole[kept], 1]
        return whole.tolist()
    return with_free


def siconos(name):
    def solve(M, q):
        import siconos.numerics as numerics
        z, w = numpy.zeros(len(q)), numpy.zeros(len(q))
        info = numerics.linearComplementarity_driver(numerics.LCP(M, q), z, w,
                                                     numerics.SolverOptions(getattr(numerics, "SICONOS_LCP_" + name)))
        return z if info == 0 else None
    return in_pairs(solve)


siconos_lemke, siconos_pivot, siconos_newton_min, siconos_newton_fb, siconos_rpgs = map(
    siconos, ("LEMKE", "PIVOT", "NEWTONMIN", "NEWTON_FB_FBLSA", "RPGS"))


def scipy_milp(M, q, free):
    """HiGHS: which of each pair may be positive is an integer, both at most LARGEST."""
    from scipy.optimize import Bounds, LinearConstraint, milp
    M, q, n = numpy.array(M, float), numpy.array(q, float), len(q)
    pairs = [i for i in range(n) if i not in free]
    I, lo, hi = numpy.eye(n)[pairs], numpy.full(n, -LARGEST), numpy.full(n, LARGEST)
    lo[pairs] = 0
    k = len(pairs)
    upper = numpy.full(n, numpy.inf)
    upper[list(free)] = -q[list(free)]
    rows = [LinearConstraint(numpy.c_[M, numpy.zeros((n, k))], -q, upper),
            LinearConstraint(numpy.c_[M[pairs], LARGEST * numpy.eye(k)], -numpy.inf, LARGEST - q[pairs]),
            LinearConstraint(numpy.c_[I, -LARGEST * numpy.eye(k)], -numpy.inf, 0)]
    found = milp(numpy.zeros(n + k), constraints=rows, integrality=numpy.r_[numpy.zeros(n), numpy.ones(k)],
                 bounds=Bounds(numpy.r_[lo, numpy.zeros(k)], numpy.r_[hi, numpy.ones(k)]), options={"time_limit": SECONDS})
    return None if found.x is None else found.x[:n].tolist()


def scipy_slsqp(M, q, free):
    """The quadratic program z'w to its minimum, from zero; right only if that is zero."""
    from scipy.optimize import minimize
    M, q, n = numpy.array(M, float), numpy.array(q, float), len(q)
    pairs = [i for i in range(n) if i not in free]
    rows = [{"type": "ineq", "fun": lambda z: M[pairs] @ z + q[pairs], "jac": lambda z: M[pairs]}]
    if free:
        rows.append({"type": "eq", "fun": lambda z: M[list(free)] @ z + q[list(free)], "jac": lambda z: M[list(free)]})
    P, p = M[pairs], q[pairs]
    found = minimize(lambda z: z[pairs] @ (P @ z + p), numpy.zeros(n), method="SLSQP", constraints=rows,
                     jac=lambda z: numpy.bincount(pairs, P @ z + p, n) + P.T @ z[pairs],
                     bounds=[(None, None) if i in free else (0, None) for i in range(n)], options={"maxiter": 200})
    return found.x.tolist() if found.success and found.fun <= 1e-6 * (1 + numpy.abs(p) @ found.x[pairs]) else None


OCTAVE = """
  data = str2num(fgetl(stdin)); n = data(2); M = reshape(data(3:2+n*n), n, n)'; q = data(3+n*n:2+n*n+n)';
  is_free = logical(data(3+n*n+n:end)'); k = sum(!is_free); z = []; info = 1;
  try
    if data(1) == 0
      C = M; c = q; C(is_free, :) = 0; c(is_free) = 0;
      lo = zeros(n, 1); lo(is_free) = -Inf;
      [z, ~, r] = qp(zeros(n, 1), C + C', c, M(is_free, :), -q(is_free), lo, Inf(n, 1), -q(!is_free), M(!is_free, :), Inf(k, 1));
      if r.info == 0 && z'(!is_free) * (M(!is_free, :) * z + q(!is_free)) <= 1e-6 * (1 + abs(q(!is_free))' * abs(z(!is_free))) info = 0; end
    else
      U = 1e4; I = eye(n)(!is_free, :); m = sum(is_free);
      A = [M(!is_free, :), zeros(k); M(!is_free, :), U * eye(k); I, -U * eye(k); M(is_free, :), zeros(m, k)];
      b = [-q(!is_free); U - q(!is_free); zeros(k, 1); -q(is_free)];
      lo = [-U * is_free; zeros(k, 1)]; hi = [U * ones(n, 1); ones(k, 1)];
      kinds = [repmat("L", 1, k), repmat("U", 1, 2 * k), repmat("S", 1, m)];
      p.msglev = 0; p.tmlim = 1000; p.presol = 1;
      [z, ~, e, r] = glpk(zeros(n + k, 1), A, b, lo, hi, kinds, [repmat("C", 1, n), repmat("I", 1, k)], 1, p);
      z = z(1:n); info = !(e == 0 && (r.status == 5 || r.status == 2));
    end
  catch
  end
  if info != 0 || any(!isfinite(z)) disp("none"); else printf("%.17g ", z); printf("\\n"); end
"""


def octave(kind, M, q, free):
    numbers = [kind, len(q), *(v for row in M for v in row), *q, *(int(i in free) for i in range(len(q)))]
    done = subprocess.run(["octave-cli", "--quiet", "--norc", "--eval", OCTAVE], text=True, timeout=9,
                          input="[" + " ".join(map(repr, numbers)) + "]\n", capture_output=True)
    line = done.stdout.strip()
    return None if line in ("none", "") else [float(word) for word in line.split()]


def octave_qp(M, q, free):
    return octave(0, M, q, free)


def octave_glpk(M, q, free):
    return octave(1, M, q, free)
