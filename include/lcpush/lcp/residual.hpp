// The referee of lcp/: is z a solution of the problem as it was given? Shares no code with the
// solvers; reads the problem's data only.
#pragma once

#include "lcpush/lcp/problem.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush {

template <class S> struct WorstRow {
  S residual{0}; ///< scaled, see natural_residual; NaN if a number is not finite
  Index row = -1;
};

namespace detail {

/// w_i = sum_j M_ij z_j, and sizes_i = how large its terms are: sum_j |M_ij| y_j for y >= 0, or for
/// the factored form the bound |W_i|' |A| sum_j |W_j| y_j on it. The solvers' product is not used.
template <class S>
void dense_rows(const Problem<S>& problem, const S* z, const S* y, S* w, S* sizes) {
  const Index n = problem.size;
  using Column = Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, 1>>;
  VectorMap<S> sum(w, n), size(sizes, n);
  sum.setZero();
  size.setZero();
  for (Index j = 0; j < n; ++j) {
    const Column column(problem.matrix + j * n, n);
    sum += column * z[j];
    size += column.cwiseAbs() * y[j];
  }
}

template <class S>
void factored_rows(const Problem<S>& problem, const S* z, const S* y, S* w, S* sizes) {
  using Eigen::numext::abs;
  const FactoredProblem<S>& f = *problem.factored;
  Vector6<S> wrench = Vector6<S>::Zero(), wrench_size = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : f.cones)
    for (Index k = 0; k < cone.forces(); ++k) {
      wrench += f.wrenches[cone.force + k] * z[cone.variable + k];
      wrench_size += f.wrenches[cone.force + k].cwiseAbs() * y[cone.variable + k];
    }
  const Vector6<S> a = f.mobility.lazyProduct(wrench);
  const Vector6<S> a_size = f.mobility.cwiseAbs().lazyProduct(wrench_size);
  for (const ConeGroup<S>& cone : f.cones) {
    const Index first = cone.variable, xi = cone.slip();
    const bool has_friction = cone.generators > 0, pulls = cone.normals == 2;
    if (has_friction) w[xi] = sizes[xi] = S(0);
    for (Index k = 0; k < cone.forces(); ++k) {
      const Index i = first + k;
      w[i] = f.wrenches[cone.force + k].dot(a);
      sizes[i] = f.wrenches[cone.force + k].cwiseAbs().dot(a_size);
      if (k < cone.normals) {
        const Index other = pulls ? first + 1 - k : -1;
        w[i] += cone.compliance * (pulls ? S(z[i] - z[other]) : z[i]);
        sizes[i] += cone.compliance * (pulls ? S(y[i] + y[other]) : y[i]);
        if (!has_friction) continue;
        w[xi] += cone.friction * z[i];
        sizes[xi] += cone.friction * y[i];
      } else {
        w[i] += z[xi];
        sizes[i] += y[xi];
        w[xi] -= z[i];
        sizes[xi] += y[i];
      }
    }
  }
  for (Index a_index = 0; a_index < f.sums.size; ++a_index) {
    const SumGroup<S>& sum = f.sums[a_index];
    const Index s = problem.free_begin + a_index;
    w[s] = sum.inertia * z[s];
    sizes[s] = sum.inertia * y[s];
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index force = f.coupled_variable[k];
      w[s] += f.coupling[k] * z[force];
      w[force] -= f.coupling[k] * z[s];
      sizes[s] += abs(f.coupling[k]) * y[force];
      sizes[force] += abs(f.coupling[k]) * y[s];
    }
  }
}

/// out_j = the largest |z_l| / u_l among the unknowns that share a row with z_j: whose rounding z_j
/// may have caught. In the factored form all forces meet in the object: the largest of all.
template <class S>
void neighbour_sizes(const Problem<S>& problem, const S* z, const S* unit, S* row_largest, S* out) {
  using Eigen::numext::abs;
  const Index n = problem.size;
  S largest(0);
  for (Index j = 0; j < n; ++j) {
    row_largest[j] = S(0);
    if (abs(z[j]) > largest * unit[j]) largest = abs(z[j]) / unit[j];
  }
  for (Index j = 0; j < n; ++j) out[j] = problem.matrix == nullptr ? largest : S(0);
  if (problem.matrix == nullptr) return;
  for (Index j = 0; j < n; ++j) {
    const S size = abs(z[j]) / unit[j];
    for (Index i = 0; size > S(0) && i < n; ++i)
      if (problem.matrix[j * n + i] != S(0) && row_largest[i] < size) row_largest[i] = size;
  }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n && out[j] < largest; ++i)
      if (problem.matrix[j * n + i] != S(0) && out[j] < row_largest[i]) out[j] = row_largest[i];
}

} // namespace detail

/// [T.11] The natural residual of z, |min(z_i, w_i)| or |w_i| where z_i is free, each side by its
/// scale:
///
///     z_i by u_i zmax,   w_i by |q_i| + sum_j |M_ij| (|z_j| + u_j zmax_j / 2^k),   w = M z + q.
///
/// zmax = max |z_i| / u_i; `unit` u > 0 is the size that z_j is measured in. A row is measured by
/// its own terms, so that a large answer elsewhere hides nothing. The second term (k = 16 in
/// double, zmax_j over the unknowns that share a row with z_j, nothing where z_j = 0) is what
/// rounding leaves of large unknowns in z_j: it keeps noise from being divided by noise. `w`
/// receives M z + q, `q` is anything with n numbers q[i]; `scratch` 2 n Scalars. Cost: three passes
/// over M.
template <class S, class Q, class IsFree>
WorstRow<S> natural_residual(const Problem<S>& problem, Q q, const S* z, const S* unit,
                             IsFree is_free, S* w, S* scratch) {
  using Eigen::numext::abs;
  const Index n = problem.size;
  S z_max(0);
  for (Index i = 0; i < n; ++i)
    if (abs(z[i]) > z_max * unit[i]) z_max = abs(z[i]) / unit[i];
  S* const sizes = scratch + n;
  detail::neighbour_sizes(problem, z, unit, sizes, scratch);
  for (Index i = 0; i < n; ++i) {
    const S noise = z[i] != S(0) ? S(scratch[i] * unit[i] * Tolerances<S>().noise) : S(0);
    scratch[i] = abs(z[i]) + noise;
  }
  if (problem.factored != nullptr)
    detail::factored_rows(problem, z, scratch, w, sizes);
  else
    detail::dense_rows(problem, z, scratch, w, sizes);
  WorstRow<S> worst;
  for (Index i = 0; i < n; ++i) {
    w[i] += q[i];
    const S scale = abs(q[i]) + sizes[i];
    const S scaled_w = scale > S(0) ? S(w[i] / scale) : w[i];
    const S scaled_z = z_max > S(0) ? S(z[i] / (unit[i] * z_max)) : S(0);
    const bool row_counts = is_free(i) || scaled_w < scaled_z;
    const S residual = abs(row_counts ? scaled_w : scaled_z);
    // x - x is 0 unless x is NaN or infinite, and then no other row can make up for it.
    const S not_finite = (z[i] - z[i]) + (scaled_w - scaled_w) + (scale - scale);
    if (!(not_finite == S(0))) return {not_finite, i};
    if (residual > worst.residual) worst = {residual, i};
  }
  return worst;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
namespace detail {
extern template void dense_rows<double>(const Problem<double>&, const double*, const double*,
                                        double*, double*);
extern template void factored_rows<double>(const Problem<double>&, const double*, const double*,
                                           double*, double*);
} // namespace detail
#endif

} // namespace lcpush
