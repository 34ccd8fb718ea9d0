// The local form: entries, rows and columns of its matrix. Included by local_form.hpp.
#pragma once

#include "lcpush/lcp/pivots/structured/local_form.hpp"

namespace lcpush::detail {

/// force_ and actuator_input_ += what slot does at x.
template <class S, class M> void LocalForm<S, M>::add_force(Index slot, S x) {
  if (slot == n_) {
    force_ += d_force_ * x;
    actuator_input_ += d_actuator_input_ * x;
    return;
  }
  const Index c = group(slot);
  switch (role(slot)) {
  case normal_role: {
    const TurnedCone<S> cone = turned(c);
    directions_.add(slot, cone, is_spring(c) ? S(-x) : x, force_);
    if (slides(c)) directions_.add(cone.cone.slip(), cone, -(friction_[c] * x), force_);
    break;
  }
  case generator_role: directions_.add(slot, turned(c), x, force_); break;
  case shared_role: actuator_input_[c] += x; break;
  default: break;
  }
}

template <class S, class M> void LocalForm<S, M>::find_velocity() {
  const Vector6<S> wrench = force_.template head<6>();
  VectorMap<S>& v = has_springs_ ? core_input_ : v_;
  const Vector6<S> moved = problem_->mobility.lazyProduct(wrench);
  for (Index k = 0; k < 6; ++k) v[k] = moved[k];
  for (Index k = 6; k < width(); ++k) v[k] = -actuator_input_[k - 6];
  if (!has_springs_) return;
  for (Index s = free_begin_; s < n_; ++s)
    if (role(s) == shared_role && is_flipped(s)) v[6 + group(s)] += force_[6 + group(s)];
  for (Index k = 0; k < width(); ++k)
    v_[k] = dot_along(core_.data() + k, width(), core_input_.data(), width());
}

/// v_ becomes what the row feels of each component of F, core_input_ of each s.
template <class S, class M> void LocalForm<S, M>::begin_row(Index row) {
  v_.setZero();
  if (has_direction(row)) directions_.add(row, turned(group(row)), S(1), v_);
  if (role(row) == shared_role && has_springs_) {
    const Index k = 6 + group(row);
    for (Index j = 0; j < width(); ++j)
      v_[j] = is_flipped(row) ? S(j == k ? -1 : 0) : S(-springs_(k, j));
  }
  if (has_springs_) {
    core_input_ = v_;
    for (Index k = 0; k < width(); ++k) v_[k] = column(core_, k).dot(core_input_);
  }
  core_input_ = v_;
  const Vector6<S> direction = v_.template head<6>();
  const Vector6<S> moved = problem_->mobility.lazyProduct(direction);
  for (Index k = 0; k < width(); ++k) v_[k] = k < 6 ? moved[k] : S(0);
  for (Index s = free_begin_; has_springs_ && s < n_; ++s)
    if (role(s) == shared_role && is_flipped(s)) v_[6 + group(s)] = core_input_[6 + group(s)];
  if (role(row) == shared_role && !is_flipped(row)) v_[6 + group(row)] += S(1);
}

template <class S, class M> S LocalForm<S, M>::entry_of_row(Index row, Index slot) const {
  const S here = local(row, slot);
  if (slot == n_) {
    S sum = here + d_force_.dot(v_);
    for (Index k = 6; k < width(); ++k) sum -= core_input_[k] * d_actuator_input_[k - 6];
    return sum;
  }
  const Index c = group(slot);
  switch (role(slot)) {
  case normal_role: {
    const S presses = is_spring(c) ? S(here - felt(slot)) : S(here + felt(slot));
    return slides(c) ? S(presses - felt(problem_->cones[c].slip()) * friction_[c]) : presses;
  }
  case generator_role: return here + felt(slot);
  case shared_role: return here - core_input_[6 + c];
  default: return here;
  }
}

/// The entry without what is felt through v.
template <class S, class M> S LocalForm<S, M>::local(Index row, Index slot) const {
  if (slot == n_) return d_[row];
  const int row_role = role(row), slot_role = role(slot);
  if (group(row) != group(slot)) return S(0);
  const Index c = group(slot);
  if (row_role == shared_role || slot_role == shared_role)
    return row == slot && !is_flipped(row) ? inertia_[c] : S(0);
  switch (row_role) {
  case normal_role:
    if (slot_role == normal_role) return row == slot ? compliance_[c] : S(-compliance_[c]);
    return slot_role == own_role ? S(-own_coupling_[c]) : S(0);
  case generator_role: return slot_role == slip_role ? S(1) : S(0);
  case slip_role:
    return slot_role == normal_role ? friction_[c] : slot_role == generator_role ? S(-1) : S(0);
  default: return slot_role == normal_role ? own_coupling_[c] : S(0);
  }
}

/// The same for a whole column.
template <class S, class M>
void LocalForm<S, M>::add_local(Index slot, S x, VectorMap<S>& out) const {
  const Index c = group(slot);
  switch (role(slot)) {
  case normal_role:
    out[slot] += compliance_[c] * x;
    if (pulls(c)) {
      const Index first = problem_->cones[c].variable;
      out[slot == first ? first + 1 : first] -= compliance_[c] * x;
    }
    if (slip_[c] >= 0) out[slip_[c]] += friction_[c] * x;
    if (own_actuator_[c] >= 0) out[own_actuator_[c]] += own_coupling_[c] * x;
    break;
  case generator_role: out[slip_[c]] -= x; break;
  case slip_role: {
    const ConeGroup<S>& cone = problem_->cones[c];
    for (Index k = cone.variable + cone.normals; k <= cone.slip(); ++k)
      if (k != slot) out[k] += x;
    break;
  }
  case own_role: out[normal_[c]] -= own_coupling_[c] * x; break;
  default:
    if (!is_flipped(slot)) out[slot] += inertia_[c] * x;
  }
}

/// out += what the rows feel of v_ and force_.
template <class S, class M> void LocalForm<S, M>::add_felt(VectorMap<S>& out) const {
  directions_.add_dots([&](Index c) { return turned(c); }, v_, out);
  for (Index s = free_begin_; s < n_; ++s)
    if (role(s) == shared_role) out[s] += shared_row(s);
}

template <class S, class M>
template <class Inputs>
void LocalForm<S, M>::multiply(const Inputs& inputs, VectorMap<S>& out) {
  force_.setZero();
  actuator_input_.setZero();
  out.setZero();
  inputs([&](Index slot, const S& x) {
    add_force(slot, x);
    if (slot == n_) out = d_ * x;
  });
  find_velocity();
  add_felt(out);
  Index count = 0;
  inputs([&](Index slot, const S& x) {
    ++count;
    if (slot < n_) add_local(slot, x, out);
  });
  add_work(StructuredSettings::work_a_row * n_ + StructuredSettings::work_an_input * count);
}

} // namespace lcpush::detail
