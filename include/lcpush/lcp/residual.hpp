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

/// One of the two for the factored form: M x; or `of_sizes`, every number in it by its size.
template <class S>
void multiply_terms(const FactoredProblem<S>& f, Index free_begin, bool of_sizes, const S* x,
                    S* out) {
  const auto term = [&](const S& number) {
    return of_sizes ? S(Eigen::numext::abs(number)) : number;
  };
  const S minus = of_sizes ? S(1) : S(-1);
  Vector6<S> wrench = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : f.cones)
    for (Index k = 0; k < cone.forces(); ++k) {
      const Vector6<S>& column = f.wrenches[cone.force + k];
      const S force = x[cone.variable + k];
      if (force == S(0)) continue; // most are
      for (Index d = 0; d < 6; ++d) wrench[d] += term(column[d]) * force;
    }
  const Vector6<S> a = of_sizes ? Vector6<S>(f.mobility.cwiseAbs().lazyProduct(wrench))
                                : Vector6<S>(f.mobility.lazyProduct(wrench));
  for (const ConeGroup<S>& cone : f.cones) {
    const Index first = cone.variable, xi = cone.slip();
    const bool has_friction = cone.generators > 0;
    const S slip = has_friction ? x[xi] : S(0);
    S room(0);
    for (Index k = 0; k < cone.forces(); ++k) {
      const Index i = first + k;
      const Vector6<S>& column = f.wrenches[cone.force + k];
      out[i] = of_sizes ? S(column.cwiseAbs().dot(a)) : S(column.dot(a));
      if (k < cone.normals) {
        out[i] += cone.compliance * (cone.normals == 2 ? S(x[i] + minus * x[first + 1 - k]) : x[i]);
        room += cone.friction * x[i];
      } else {
        out[i] += slip;
        room += minus * x[i];
      }
    }
    if (has_friction) out[xi] = room;
  }
  for (Index a_index = 0; a_index < f.sums.size; ++a_index) {
    const SumGroup<S>& sum = f.sums[a_index];
    const S closing = x[free_begin + a_index], closes = minus * closing;
    S row = sum.inertia * closing;
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const S coupling = term(f.coupling[k]);
      const Index force = f.coupled_variable[k];
      row += coupling * x[force];
      out[force] += coupling * closes;
    }
    out[free_begin + a_index] = row;
  }
}

template <class S>
void factored_rows(const Problem<S>& problem, const S* z, const S* y, S* w, S* sizes) {
  multiply_terms(*problem.factored, problem.free_begin, false, z, w);
  multiply_terms(*problem.factored, problem.free_begin, true, y, sizes);
}

/// out_j = the largest |z_l| / u_l among the unknowns that share a row with z_j: whose rounding z_j
/// may have caught. In the factored form all forces meet in the object: the largest of all.
/// `largest` is that.
template <bool may_be_dense, class S>
void neighbour_sizes(const Problem<S>& problem, const S* z, const S* unit, const S& largest,
                     S* row_largest, S* out) {
  const Index n = problem.size;
  const bool is_dense = may_be_dense && problem.matrix != nullptr;
  for (Index j = 0; j < n; ++j) out[j] = is_dense ? S(0) : largest;
  if (!is_dense) return;
  for (Index i = 0; i < n; ++i) row_largest[i] = S(0);
  for (Index j = 0; j < n; ++j) {
    const S size = Eigen::numext::abs(z[j]) / unit[j];
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
/// over M. A caller without dense problems says so, and links nothing for them.
template <bool may_be_dense = true, class S, class Q, class IsFree>
WorstRow<S> natural_residual(const Problem<S>& problem, Q q, const S* z, const S* unit,
                             IsFree is_free, S* w, S* scratch) {
  using Eigen::numext::abs;
  const Index n = problem.size;
  S z_max(0);
  for (Index i = 0; i < n; ++i)
    if (abs(z[i]) > z_max * unit[i]) z_max = abs(z[i]) / unit[i];
  S* const sizes = scratch + n;
  detail::neighbour_sizes<may_be_dense>(problem, z, unit, z_max, sizes, scratch);
  for (Index i = 0; i < n; ++i) {
    const S noise = z[i] != S(0) ? S(scratch[i] * unit[i] * Tolerances<S>().noise) : S(0);
    scratch[i] = abs(z[i]) + noise;
  }
  if (may_be_dense && problem.factored == nullptr)
    detail::dense_rows(problem, z, scratch, w, sizes);
  else
    detail::factored_rows(problem, z, scratch, w, sizes);
  WorstRow<S> worst;
  for (Index i = 0; i < n; ++i) {
    const S given = q[i], scale = abs(given) + sizes[i];
    w[i] += given;
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
extern template void neighbour_sizes<true, double>(const Problem<double>&, const double*,
                                                   const double*, const double&, double*, double*);
extern template void neighbour_sizes<false, double>(const Problem<double>&, const double*,
                                                    const double*, const double&, double*, double*);
extern template void dense_rows<double>(const Problem<double>&, const double*, const double*,
                                        double*, double*);
extern template void factored_rows<double>(const Problem<double>&, const double*, const double*,
                                           double*, double*);
} // namespace detail
#endif

} // namespace lcpush
