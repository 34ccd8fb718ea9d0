// The local form: the principal pivots that stay inside a cone. Included by local_form.hpp.
#pragma once

#include "lcpush/lcp/pivots/structured/local_form.hpp"

namespace lcpush::detail {

/// The normal force of a cone and the unknown of its own actuator become basic.
template <class S, class M> void LocalForm<S, M>::press_by_own_actuator(Index c) {
  const Index normal = normal_[c], own = own_actuator_[c];
  const S inverse = S(1) / own_coupling_[c];
  directions_.press(c, own, inverse);
  friction_[c] *= inverse;
  compliance_[c] *= inverse * inverse;
  own_coupling_[c] = inverse;
  swap_roles(normal, own);
  normal_[c] = static_cast<Int>(own);
  own_actuator_[c] = static_cast<Int>(normal);
}

/// The slip and the friction force along one generator become basic.
template <class S, class M> void LocalForm<S, M>::slide(Index c, Index generator) {
  const ConeGroup<S>& cone = problem_->cones[c];
  directions_.slide(c, generator);
  swap_roles(cone.slip(), generator);
  slip_[c] = static_cast<Int>(generator);
}

/// The normal force of a compliant cone becomes basic. Pre: it slides already if it is to.
template <class S, class M> void LocalForm<S, M>::load_spring(Index c) {
  const ConeGroup<S>& cone = problem_->cones[c];
  const Index normal = normal_[c];
  const S stiffness = S(1) / compliance_[c];
  VectorMap<S>&g = v_, &direction = core_input_; // both free until the core is there
  direction.setZero();
  directions_.add(normal, turned(c), S(1), direction);
  g = direction;
  if (slides(c)) directions_.add(cone.slip(), turned(c), -friction_[c], g);
  for (Index k = 0; k < width(); ++k)
    add_scaled(springs_.data() + k * width(), g.data(), S(direction[k] * stiffness), width());
  directions_.yield(c, slip_[c], stiffness, friction_[c]);
  friction_[c] *= stiffness;
  compliance_[c] = stiffness;
  flip(normal);
}

/// Are there so many loaded springs? If not, nothing is divided by a compliance.
template <class S, class M>
template <class IsBasic>
bool LocalForm<S, M>::has_springs(IsBasic is_basic) const {
  Index loaded = 0;
  for (Index c = 0; c < problem_->cones.size; ++c)
    loaded += compliance_[c] > S(0) && is_basic(normal_[c]) ? 1 : 0;
  return loaded >= StructuredSettings::contacts_with_springs;
}

/// All of them, the actuators that they carry, and C. False if it is singular.
template <class S, class M>
template <class IsBasic>
bool LocalForm<S, M>::load_springs(IsBasic is_basic) {
  has_springs_ = true;
  springs_.setZero();
  for (Index c = 0; c < problem_->cones.size; ++c)
    if (compliance_[c] > S(0) && own_actuator_[c] < 0 && !pulls(c) && is_basic(normal_[c]))
      load_spring(c);
  for (Index s = free_begin_; s < n_; ++s)
    if (role(s) == shared_role && is_basic(s) && springs_(6 + group(s), 6 + group(s)) > S(0))
      flip(s);
  // (I + A T_aa) v_a + A T_as v_s = A F_a,   T_sa v_a + (T_ss + m) v_s = F_s - w_s.
  core_.setIdentity();
  for (Index k = 0; k < width(); ++k) {
    const Vector6<S> wrench = column(springs_, k).template head<6>();
    const Vector6<S> moved = problem_->mobility.lazyProduct(wrench);
    for (Index i = 0; i < 6; ++i) core_(i, k) += moved[i];
  }
  for (Index s = free_begin_; s < n_; ++s) {
    const Index k = 6 + group(s);
    if (role(s) != shared_role || !is_flipped(s)) continue;
    for (Index j = 0; j < width(); ++j) core_(k, j) = springs_(k, j);
    core_(k, k) += inertia_[group(s)];
  }
  return invert_core();
}

/// Gauss-Jordan with row pivoting, in place, on rows of largest entry 1.
template <class S, class M> bool LocalForm<S, M>::invert_core() {
  const Index size = width();
  constexpr int most = 6 + StructuredSettings::actuators_with_springs;
  if (size > most) return false;
  Index from[most];
  VectorMap<S>& row_size = core_input_; // free until the core is there
  for (Index i = 0; i < size; ++i) {
    from[i] = i;
    S largest(0);
    for (Index j = 0; j < size; ++j)
      largest = Eigen::numext::maxi(largest, S(Eigen::numext::abs(core_(i, j))));
    if (!(largest > S(0))) return false;
    for (Index j = 0; j < size; ++j) core_(i, j) /= largest;
    row_size[i] = largest;
  }
  for (Index k = 0; k < size; ++k) {
    Index row = k;
    for (Index i = k + 1; i < size; ++i)
      if (Eigen::numext::abs(core_(i, k)) > Eigen::numext::abs(core_(row, k))) row = i;
    if (core_(row, k) == S(0)) return false;
    for (Index j = 0; j < size; ++j) Eigen::numext::swap(core_(row, j), core_(k, j));
    Eigen::numext::swap(from[row], from[k]);
    Eigen::numext::swap(row_size[row], row_size[k]);
    const S pivot = core_(k, k);
    core_(k, k) = S(1);
    for (Index j = 0; j < size; ++j) core_(k, j) /= pivot;
    for (Index i = 0; i < size; ++i) {
      if (i == k) continue;
      const S factor = core_(i, k);
      core_(i, k) = S(0);
      for (Index j = 0; j < size; ++j) core_(i, j) -= core_(k, j) * factor;
    }
  }
  // Column k belongs to row from[k] of the scaled matrix.
  for (Index k = 0; k < size; ++k)
    for (Index i = 0; i < size; ++i) core_(i, k) /= row_size[k];
  for (Index k = 0; k < size; ++k)
    while (from[k] != k) {
      const Index to = from[k];
      for (Index i = 0; i < size; ++i) Eigen::numext::swap(core_(i, k), core_(i, to));
      Eigen::numext::swap(from[k], from[to]);
    }
  return true;
}

/// Principal pivots inside the cones towards a basis, is_basic(slot) for its z. Precondition: as
/// loaded. False if they are singular together.
template <class S, class M>
template <class IsBasic>
bool LocalForm<S, M>::pivot_locally(IsBasic is_basic) {
  const bool springs = has_springs(is_basic);
  for (Index c = 0; c < problem_->cones.size; ++c) {
    const ConeGroup<S>& cone = problem_->cones[c];
    if (own_actuator_[c] >= 0 && is_basic(own_actuator_[c]) && is_basic(normal_[c]))
      press_by_own_actuator(c);
    if (cone.generators == 0 || !is_basic(cone.slip())) continue;
    for (Index slot = cone.variable + cone.normals; slot < cone.slip(); ++slot)
      if (is_basic(slot)) {
        slide(c, slot);
        break;
      }
  }
  if (springs && !load_springs(is_basic)) return false;
  set_covering_vector(VectorMap<S>(d_));
  return true;
}

/// What these pivots do to a right-hand side: the rows' part, and the force and what the shared
/// actuators are held at, at x = 0.
template <class S, class M>
void LocalForm<S, M>::transform(VectorMap<S>& rhs, VectorMap<S>& force,
                                VectorMap<S>& actuator_input) const {
  force.setZero();
  actuator_input.setZero();
  for (Index c = 0; c < problem_->cones.size; ++c) {
    const ConeGroup<S>& cone = problem_->cones[c];
    const Index normal = normal_[c];
    if (is_flipped(normal) && !is_spring(c)) {
      const Index given = own_actuator_[c], own = normal;
      const S target = rhs[own], normal_force = -target * own_coupling_[c];
      rhs[own] = rhs[given] * own_coupling_[c] - target * compliance_[c];
      rhs[given] = normal_force;
      directions_.add(own, turned(c), S(-target), force);
      if (cone.generators > 0) rhs[cone.slip()] -= friction_[c] * target;
    }
    if (slides(c)) {
      const Index slip = cone.slip(), generator = slip_[c];
      const S moves = rhs[generator], saturates = rhs[slip];
      for (Index slot = cone.variable + cone.normals; slot < slip; ++slot) rhs[slot] -= moves;
      rhs[slip] = -moves;
      rhs[generator] = saturates;
      directions_.add(slip, turned(c), S(-saturates), force);
    }
    if (is_spring(c)) {
      const S yields = rhs[normal];
      rhs[normal] = -yields * compliance_[c];
      directions_.add(normal, turned(c), yields, force);
      if (cone.generators == 0) continue;
      if (slides(c)) directions_.add(cone.slip(), turned(c), friction_[c] * yields, force);
      rhs[slip_[c]] -= friction_[c] * yields;
    }
  }
  for (Index s = free_begin_; has_springs_ && s < n_; ++s)
    if (role(s) == shared_role && is_flipped(s)) {
      actuator_input[group(s)] = -rhs[s];
      rhs[s] = S(0);
    }
}

} // namespace lcpush::detail
