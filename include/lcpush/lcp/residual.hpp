// The referee of lcp/: is z a solution of the problem as it was given? Shares no code with the
// solvers; reads the problem's data only.
#pragma once

#include "lcpush/lcp/problem.hpp"

namespace lcpush {

template <class S> struct WorstRow {
  S residual{0}; ///< scaled, see natural_residual
  Index row = -1;
};

/// The natural residual of z, scaled row by row:
///
///     | min( z_i / (u_i zmax), w_i / (|q_i| + rowsum_i zmax) ) |,   w = M z + q,
///
/// with |w_i| / (..) alone where z_i is free. zmax = max |z_i| / u_i, rowsum_i = sum_j |M_ij| u_j;
/// `unit` u > 0 is the size that z_j is measured in. The scale of a row is what its terms could
/// amount to, never what they happen to amount to: that would divide noise by noise.
/// `w` receives M z + q. Cost: one product M z.
template <class S>
WorstRow<S> natural_residual(const Problem<S>& problem, const S* q, const S* z, const S* unit,
                             const S* rowsum, S* w) {
  const auto size_of = [](const S& x) { return x < S(0) ? S(-x) : x; };
  multiply(problem, z, w);
  S z_max(0);
  for (Index i = 0; i < problem.size; ++i) {
    const S scaled = size_of(z[i]) / unit[i];
    if (scaled > z_max) z_max = scaled;
  }
  WorstRow<S> worst;
  for (Index i = 0; i < problem.size; ++i) {
    w[i] += q[i];
    const S scale = size_of(q[i]) + rowsum[i] * z_max;
    const S scaled_w = scale > S(0) ? S(w[i] / scale) : w[i];
    const S scaled_z = z_max > S(0) ? S(z[i] / (unit[i] * z_max)) : S(0);
    const bool row_counts = i >= problem.free_begin || scaled_w < scaled_z;
    const S residual = size_of(row_counts ? scaled_w : scaled_z);
    // Written so that a NaN becomes the worst row instead of slipping through.
    if (!(residual <= worst.residual)) worst = {residual, i};
  }
  return worst;
}

} // namespace lcpush
