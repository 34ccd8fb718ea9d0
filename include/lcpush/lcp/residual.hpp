// The referee of lcp/: is z a solution of the problem as it was given? Shares no code with the
// solvers; reads the problem's data only.
#pragma once

#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush {

template <class S> struct WorstRow {
  S residual{0}; ///< scaled, see natural_residual
  Index row = -1;
};

namespace detail {

template <class S> S size_of(const S& x) { return x < S(0) ? S(-x) : x; }

/// out_i = how large the terms of row i of M y are, for y >= 0: sum_j |M_ij| y_j, or for the
/// factored form the bound |W_i|' |A| sum_j |W_j| y_j on it, which costs O(n).
template <class S> void term_sizes(const Problem<S>& problem, const S* y, S* out) {
  const Index n = problem.size;
  for (Index i = 0; i < n; ++i) out[i] = S(0);
  if (problem.factored == nullptr) {
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) out[i] += size_of(problem.matrix[j * n + i]) * y[j];
    return;
  }
  const FactoredProblem<S>& f = *problem.factored;
  Vector6<S> wrench = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : f.cones)
    for (Index k = 0; k <= cone.generators; ++k)
      wrench += f.wrenches[cone.force + k].cwiseAbs() * y[cone.variable + k];
  const Vector6<S> a = f.mobility.cwiseAbs().lazyProduct(wrench);
  for (const ConeGroup<S>& cone : f.cones) {
    const Index i = cone.variable;
    for (Index k = 0; k <= cone.generators; ++k)
      out[i + k] += f.wrenches[cone.force + k].cwiseAbs().dot(a);
    out[i] += cone.compliance * y[i];
    if (cone.generators == 0) continue;
    out[cone.slip()] += cone.friction * y[i];
    for (Index k = 1; k <= cone.generators; ++k) {
      out[i + k] += y[cone.slip()];
      out[cone.slip()] += y[i + k];
    }
  }
  for (Index a_index = 0; a_index < f.sums.size; ++a_index) {
    const Index row = problem.free_begin + a_index;
    out[row] += f.sums[a_index].inertia * y[row];
    const Index first = f.sums[a_index].first;
    for (Index k = first; k < first + f.sums[a_index].count; ++k) {
      out[row] += size_of(f.coupling[k]) * y[f.coupled_variable[k]];
      out[f.coupled_variable[k]] += size_of(f.coupling[k]) * y[row];
    }
  }
}

} // namespace detail

/// [T.11] The natural residual of z, |min(z_i, w_i)| or |w_i| where z_i is free, each side by its scale:
///
///     z_i by u_i zmax,   w_i by |q_i| + sum_j |M_ij| (|z_j| + u_j zmax / 2^k),   w = M z + q.
///
/// zmax = max |z_i| / u_i; `unit` u > 0 is the size that z_j is measured in. A row is measured by
/// its own terms, so that a large answer elsewhere hides nothing; the second term (k = 16 in
/// double) is what rounding leaves of the largest unknowns, and keeps noise from being divided by
/// noise. `w` receives M z + q; `scratch` 2 n Scalars. Cost: two products with M.
template <class S, class IsFree>
WorstRow<S> natural_residual(const Problem<S>& problem, const S* q, const S* z, const S* unit,
                             IsFree is_free, S* w, S* scratch) {
  using detail::size_of;
  const Index n = problem.size;
  S z_max(0);
  for (Index i = 0; i < n; ++i)
    if (size_of(z[i]) > z_max * unit[i]) z_max = size_of(z[i]) / unit[i];
  S* const sizes = scratch + n;
  for (Index i = 0; i < n; ++i)
    scratch[i] = size_of(z[i]) + z_max * unit[i] * Tolerances<S>().noise;
  detail::term_sizes(problem, scratch, sizes);
  multiply(problem, z, w);
  WorstRow<S> worst;
  for (Index i = 0; i < n; ++i) {
    w[i] += q[i];
    const S scale = size_of(q[i]) + sizes[i];
    const S scaled_w = scale > S(0) ? S(w[i] / scale) : w[i];
    const S scaled_z = z_max > S(0) ? S(z[i] / (unit[i] * z_max)) : S(0);
    const bool row_counts = is_free(i) || scaled_w < scaled_z;
    const S residual = size_of(row_counts ? scaled_w : scaled_z);
    // Written so that a NaN becomes the worst row instead of slipping through.
    if (!(residual <= worst.residual)) worst = {residual, i};
  }
  return worst;
}

} // namespace lcpush
