// The finish of the sweeps: all groups answer at once, and the few numbers that they share - the
// six accelerations of the object and one a sum group - are solved for by Newton's method.
//
// With forces near their last values f^c held by a proximal term, every group has a closed form
// for its forces at given rates r = W' u + q - coupling s:
//
//     lambda = max(0, (eps lambda^c - r) / (eps + c)),
//     beta   = the point of { beta >= 0, sum beta <= mu lambda } nearest to beta^c - r / eps.
//
// What is left is a system of 6 + (sums) equations, piecewise linear in x = [u; s]:
//
//     u = A G f(x),      sum coupling f(x) + inertia s = target.
//
// Its solution becomes the next f^c, and eps falls. The proximal term vanishes where f = f^c, so
// that the limit solves the problem as given: no penalty is left in it. [Rockafellar 1976]
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush {

namespace detail {

/// Solves J x = b for a small dense J by elimination with partial pivoting, in place: b becomes x.
/// False if J is singular.
template <class S> bool solve_small(MatrixMap<S> J, S* b) {
  using Eigen::numext::abs;
  const Index n = J.rows();
  for (Index k = 0; k < n; ++k) {
    Index p = k;
    for (Index i = k + 1; i < n; ++i)
      if (abs(J(i, k)) > abs(J(p, k))) p = i;
    if (!(abs(J(p, k)) > S(0))) return false;
    for (Index j = k; j < n && p != k; ++j) {
      const S swapped = J(k, j);
      J(k, j) = J(p, j);
      J(p, j) = swapped;
    }
    if (p != k) {
      const S swapped = b[k];
      b[k] = b[p];
      b[p] = swapped;
    }
    for (Index i = k + 1; i < n; ++i) {
      const S factor = J(i, k) / J(k, k);
      if (factor == S(0)) continue;
      for (Index j = k; j < n; ++j) J(i, j) -= factor * J(k, j);
      b[i] -= factor * b[k];
    }
  }
  for (Index k = n - 1; k >= 0; --k) {
    for (Index j = k + 1; j < n; ++j) b[k] -= J(k, j) * b[j];
    b[k] /= J(k, k);
  }
  return true;
}

/// The threshold theta with sum max(0, y_j - theta) = total > 0, given that sum max(0, y_j) >=
/// total. Cost: a few passes over y.
template <class S> S simplex_threshold(const S* y, Index count, const S& total) {
  S theta(0);
  for (Index pass = 0; pass <= count; ++pass) { // Michelot: every pass drops entries for good
    S sum(0);
    Index support = 0;
    for (Index j = 0; j < count; ++j)
      if (y[j] > theta) {
        sum += y[j];
        ++support;
      }
    if (support == 0) return theta;
    const S next = (sum - total) / S(support);
    if (!(next > theta)) return theta;
    theta = next;
  }
  return theta;
}

} // namespace detail

} // namespace lcpush
