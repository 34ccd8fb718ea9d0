// The local form: its memory, its scales, and the problem as given. Included by local_form.hpp.
#pragma once

#include "lcpush/lcp/pivots/structured/local_form.hpp"

namespace lcpush {
namespace detail {

/// Is this sum group one normal force's own affair? Then its unknown and that force can be pivoted
/// on their coupling.
template <class S> Index own_cone(const FactoredProblem<S>& problem, const SumGroup<S>& sum) {
  if (sum.count != 1 || sum.inertia != S(0) || problem.coupling[sum.first] == S(0)) return -1;
  const Index variable = problem.coupled_variable[sum.first];
  Index low = 0, high = problem.cones.size;
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (problem.cones[middle].variable <= variable ? low : high) = middle;
  }
  const ConeGroup<S>& cone = problem.cones[low];
  return cone.variable == variable && cone.normals == 1 ? low : -1;
}

} // namespace detail

/// Actuators that drive more than one contact: each widens the border of the structured basis.
template <class S> Index shared_actuators(const FactoredProblem<S>& problem) {
  Index shared = 0;
  for (const SumGroup<S>& sum : problem.sums) shared += detail::own_cone(problem, sum) < 0 ? 1 : 0;
  return shared;
}

namespace detail {

template <class S>
void LocalForm<S>::carve(const Problem<S>& problem, Block<S>& scalars, Block<int>& integers) {
  problem_ = problem.factored;
  n_ = problem.size;
  free_begin_ = problem.free_begin;
  const Index shared = shared_actuators(*problem_), cones = problem_->cones.size;
  const Index width = 6 + shared;
  scalars.seat(directions_, n_, width);
  scalars.seat(d_, n_);
  for (VectorMap<S>* map : {&d_force_, &force_, &v_, &core_input_}) scalars.seat(*map, width);
  for (VectorMap<S>* map : {&actuator_input_, &d_actuator_input_}) scalars.seat(*map, shared);
  for (MatrixMap<S>* map : {&springs_, &core_}) scalars.seat(*map, width, width);
  for (Span<S>* span : {&friction_, &compliance_, &own_coupling_}) *span = scalars.take(cones);
  inertia_ = scalars.take(shared);
  for (Span<int>* span : {&role_, &group_, &flipped_}) *span = integers.take(n_);
  for (Span<int>* span : {&normal_, &slip_, &own_actuator_, &is_spring_})
    *span = integers.take(cones);
}

/// Symmetric scales that bring the diagonal of G' B G near 1; then no entry of it is larger
/// (Cauchy and Schwarz). One scale for the generators of a cone, its reciprocal for the slip, so
/// that these entries stay 1. Returns 0, or NaN if a number is not finite.
template <class S>
S LocalForm<S>::scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale,
                      VectorMap<S> rowsum) const {
  const FactoredProblem<S>& f = *problem_;
  const S finite_sum = f.mobility.sum() - f.mobility.sum();
  const auto diagonal = [&](Index force) {
    const Vector6<S> moved = f.mobility.lazyProduct(f.wrenches[force]);
    return S(f.wrenches[force].dot(moved));
  };
  Vector6<S> total = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : f.cones) {
    S slips(0);
    for (Index k = cone.normals; k < cone.forces(); ++k)
      slips = Eigen::numext::maxi(slips, diagonal(cone.force + k));
    const S normal =
        equilibrates ? reciprocal_root(S(diagonal(cone.force) + cone.compliance)) : S(1);
    const S slip = equilibrates ? reciprocal_root(slips) : S(1);
    for (Index k = 0; k < cone.forces(); ++k) {
      row_scale[cone.variable + k] = column_scale[cone.variable + k] =
          k < cone.normals ? normal : slip;
      total += f.wrenches[cone.force + k].cwiseAbs() * column_scale[cone.variable + k];
    }
    if (cone.generators > 0) row_scale[cone.slip()] = column_scale[cone.slip()] = S(1) / slip;
  }
  for (Index a = 0; a < f.sums.size; ++a) {
    const SumGroup<S>& sum = f.sums[a];
    const Index s = free_begin_ + a;
    S largest(0);
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const S size = Eigen::numext::abs(f.coupling[k]) * column_scale[f.coupled_variable[k]];
      largest = Eigen::numext::maxi(largest, size);
    }
    row_scale[s] = column_scale[s] = equilibrates ? S(S(1) / power_below(largest)) : S(1);
  }
  const Vector6<S> moved = f.mobility.cwiseAbs().lazyProduct(total);
  rowsum.setZero();
  for (const ConeGroup<S>& cone : f.cones)
    for (Index k = 0; k < cone.forces(); ++k)
      rowsum[cone.variable + k] = f.wrenches[cone.force + k].cwiseAbs().dot(moved);
  for_each_group_entry(f, free_begin_, [&](Index i, Index j, const S& entry) {
    rowsum[i] += Eigen::numext::abs(entry) * column_scale[j];
  });
  return finite_sum + (rowsum.sum() - rowsum.sum());
}

/// The problem as given, scaled, under a covering vector.
template <class S>
template <class Column>
void LocalForm<S>::load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
                        const Column& covering_vector) {
  const FactoredProblem<S>& f = *problem_;
  directions_.setZero();
  for (Index i = 0; i < n_; ++i) flipped_[i] = 0;
  has_springs_ = false;
  for (Index c = 0; c < f.cones.size; ++c) {
    const ConeGroup<S>& cone = f.cones[c];
    const Index slip = cone.generators > 0 ? cone.slip() : -1;
    const S scale = row_scale[cone.variable];
    normal_[c] = static_cast<int>(cone.variable);
    slip_[c] = static_cast<int>(slip);
    own_actuator_[c] = -1;
    is_spring_[c] = 0;
    compliance_[c] = cone.compliance * scale * scale;
    friction_[c] = slip < 0 ? S(0) : S(cone.friction * scale * row_scale[slip]);
    for (Index k = 0; k < cone.forces(); ++k) {
      const Index slot = cone.variable + k;
      role_[slot] = k < cone.normals ? normal_role : generator_role;
      for (Index d = 0; d < 6; ++d)
        directions_(slot, d) = f.wrenches[cone.force + k][d] * row_scale[slot];
    }
    if (slip >= 0) role_[slip] = slip_role;
    for (Index k = 0; k < cone.size(); ++k) group_[cone.variable + k] = static_cast<int>(c);
  }
  Index shared = 0;
  for (Index a = 0; a < f.sums.size; ++a) {
    const SumGroup<S>& sum = f.sums[a];
    const Index s = free_begin_ + a, c = own_cone(f, sum);
    if (c >= 0) {
      role_[s] = own_role;
      group_[s] = static_cast<int>(c);
      own_actuator_[c] = static_cast<int>(s);
      own_coupling_[c] = f.coupling[sum.first] * row_scale[s] * column_scale[f.cones[c].variable];
      continue;
    }
    role_[s] = shared_role;
    group_[s] = static_cast<int>(shared);
    inertia_[shared] = sum.inertia * row_scale[s] * column_scale[s];
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index slot = f.coupled_variable[k];
      directions_(slot, 6 + shared) += f.coupling[k] * row_scale[s] * column_scale[slot];
    }
    ++shared;
  }
  set_covering_vector(covering_vector);
}

} // namespace detail
} // namespace lcpush
