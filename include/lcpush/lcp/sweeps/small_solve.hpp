// A few equations in as many unknowns, dense, in place.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

/// Solves J x = b by elimination with partial pivoting; J is used up and b becomes x. False if J is
/// singular. Cost: n^3 / 3 multiply-adds.
template <class S> [[nodiscard]] bool solve_small(MatrixMap<S> J, S* b) {
  using Eigen::numext::abs;
  const Index n = J.rows();
  for (Index k = 0; k < n; ++k) {
    Index p = k;
    for (Index i = k + 1; i < n; ++i)
      if (abs(J(i, k)) > abs(J(p, k))) p = i;
    if (!(abs(J(p, k)) > S(0))) return false;
    if (p != k) {
      J.row(k).swap(J.row(p));
      Eigen::numext::swap(b[k], b[p]);
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

} // namespace lcpush
