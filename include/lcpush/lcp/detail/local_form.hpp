// A factored problem, scaled, in a form that principal pivots inside a cone leave alone: every
// unknown has a *role*, a direction in the space that all cones share, and local coefficients. A
// sliding point, whose slip and one friction force are basic, is such a pivot: unknowns swap roles
// and directions change, the form does not. So a basis of thousands of sliding points is as cheap
// as one of a few.
//
//     row i = h_i' v + local terms,   v = (A F_0..5, -s),   F = sum_j g_j x_j
//
// h_i has 6 + k entries: the wrench, and the couplings to the k actuators that several forces
// share. g_j = h_j, but of a normal force h_j plus mu times the direction in which its point
// slides. x_j is the variable of slot j that is not basic at x = 0, row j its complement.
#pragma once

#include "lcpush/lcp/equilibrate.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush::detail {

enum LocalRole : int { normal_role, generator_role, slip_role, own_role, shared_role };

template <class S> class LocalForm {
public:
  static constexpr Index scalars(Index n, Index cones, Index shared) {
    return (n + 3) * (6 + shared) + n + 3 * cones + shared;
  }
  static constexpr Index integers(Index n, Index cones) { return 3 * n + 3 * cones; }

  void carve(const Problem<S>& problem, Block<S>& scalars, Block<int>& integers);
  S scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale,
          VectorMap<S> rowsum) const;
  template <class Column>
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale, const Column& cover);
  template <class IsBasic> void pivot_locally(IsBasic is_basic);
  template <class Column> void set_cover(const Column& as_given) {
    cover_ = as_given;
    cover_force_.setZero();
    transform(cover_, cover_force_);
  }

  bool is_flipped(Index slot) const { return flipped_[slot] != 0; }

  /// Entries (row, slot) of the matrix, slot n the cover: along one column after
  /// begin_column(slot), along one row after begin_row(row). Cost: O(1).
  void begin_column(Index slot) {
    force_.setZero();
    add_force(slot, S(1));
    find_velocity();
    if (slot < n_ && role_[slot] == shared_role) v_[6 + group_[slot]] = S(-1);
  }
  S entry_of_column(Index row, Index slot) const {
    const S felt = role_[row] == shared_role ? force_[6 + group_[row]]
                                             : S(directions_.row(row).dot(v_.transpose()));
    return felt + local(row, slot);
  }
  void begin_row(Index row) {
    v_.setZero();
    const Vector6<S> direction = directions_.row(row).template head<6>().transpose();
    v_.template head<6>() = problem_->mobility.lazyProduct(direction);
    for (Index k = 6; k < width(); ++k) v_[k] = directions_(row, k);
  }
  S entry_of_row(Index row, Index slot);

  /// out = M x, x given by inputs(visit) calling visit(slot, x) for each entry that is not zero.
  /// Cost: O(n) and O(1) an input.
  template <class Inputs, class Column> void multiply(Inputs inputs, Column&& out);

  /// A right-hand side of the problem as given becomes the rows' values at x = 0.
  template <class Column> void evaluate(Column&& rhs) {
    force_.setZero();
    transform(rhs, force_);
    find_velocity();
    add_felt(rhs);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index n_ = 0, free_begin_ = 0;
  MatrixMap<S> directions_{nullptr, 0, 0}; // n x width, row i: h_i
  VectorMap<S> cover_{nullptr, 0}, cover_force_{nullptr, 0}, force_{nullptr, 0}, v_{nullptr, 0};
  Span<S> friction_, compliance_, own_coupling_, inertia_;
  Span<int> role_, group_, flipped_; // of slots; group_: cone, or number of the shared actuator
  Span<int> normal_, slip_, own_;    // of cones: the slots in these roles, -1 for none

  Index width() const { return directions_.cols(); }
  bool pulls(Index cone) const { return problem_->cones[cone].normals == 2; }
  bool has_friction(Index cone) const { return problem_->cones[cone].generators > 0; }
  void swap_roles(Index i, Index j) {
    const int role = role_[i];
    role_[i] = role_[j];
    role_[j] = role;
    flipped_[i] = flipped_[j] = 1;
  }
  void add_force(Index slot, const S& x);
  void find_velocity();
  S local(Index row, Index slot) const;
  template <class Column> void add_local(Index slot, const S& x, Column& out) const;
  template <class Column> void add_felt(Column& out) const;
  template <class Column> void transform(Column& rhs, VectorMap<S>& force) const;
  void press_by_own_actuator(Index cone);
  void slide(Index cone, Index generator);
};

/// Is this sum group one normal force's own affair? Then its unknown and that force can be pivoted
/// on their coupling.
template <class S> Index own_cone(const FactoredProblem<S>& problem, const SumGroup<S>& sum) {
  if (sum.count != 1 || sum.inertia != S(0)) return -1;
  const Index variable = problem.coupled_variable[sum.first];
  Index low = 0, high = problem.cones.size;
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (problem.cones[middle].variable <= variable ? low : high) = middle;
  }
  const ConeGroup<S>& cone = problem.cones[low];
  return cone.variable == variable && cone.normals == 1 ? low : -1;
}

template <class S> Index shared_actuators(const FactoredProblem<S>& problem) {
  Index shared = 0;
  for (const SumGroup<S>& sum : problem.sums) shared += own_cone(problem, sum) < 0 ? 1 : 0;
  return shared;
}

template <class S>
void LocalForm<S>::carve(const Problem<S>& problem, Block<S>& scalars, Block<int>& integers) {
  problem_ = problem.factored;
  n_ = problem.size;
  free_begin_ = problem.free_begin;
  const Index shared = shared_actuators(*problem_), cones = problem_->cones.size;
  const Index width = 6 + shared;
  const auto vector = [&](VectorMap<S>& map, Index size) {
    new (&map) VectorMap<S>(scalars.take(size).data, size);
  };
  new (&directions_) MatrixMap<S>(scalars.take(n_ * width).data, n_, width);
  vector(cover_, n_);
  for (VectorMap<S>* map : {&cover_force_, &force_, &v_}) vector(*map, width);
  for (Span<S>* span : {&friction_, &compliance_, &own_coupling_}) *span = scalars.take(cones);
  inertia_ = scalars.take(shared);
  for (Span<int>* span : {&role_, &group_, &flipped_}) *span = integers.take(n_);
  for (Span<int>* span : {&normal_, &slip_, &own_}) *span = integers.take(cones);
}

/// Symmetric scales that bring the diagonal of G' A G near 1; then no entry of it is larger
/// (Cauchy and Schwarz). One scale for the generators of a cone, its reciprocal for the slip, so
/// that these entries stay 1. Returns 0, or NaN if a number is not finite.
template <class S>
S LocalForm<S>::scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale,
                      VectorMap<S> rowsum) const {
  const FactoredProblem<S>& f = *problem_;
  S finite_sum = f.mobility.sum() - f.mobility.sum();
  const auto diagonal = [&](Index force) {
    const Vector6<S> moved = f.mobility.lazyProduct(f.wrenches[force]);
    return S(f.wrenches[force].dot(moved));
  };
  Vector6<S> total = Vector6<S>::Zero();
  for (const ConeGroup<S>& cone : f.cones) {
    S slips(0);
    for (Index k = cone.normals; k < cone.forces(); ++k)
      slips = Eigen::numext::maxi(slips, diagonal(cone.force + k));
    const S normal = equilibrates ? reciprocal_root(S(diagonal(cone.force) + cone.compliance)) : S(1);
    const S slip = equilibrates ? reciprocal_root(slips) : S(1);
    for (Index k = 0; k < cone.forces(); ++k) {
      row_scale[cone.variable + k] = column_scale[cone.variable + k] = k < cone.normals ? normal : slip;
      total += f.wrenches[cone.force + k].cwiseAbs() * column_scale[cone.variable + k];
    }
    if (cone.generators > 0) row_scale[cone.slip()] = column_scale[cone.slip()] = S(1) / slip;
    finite_sum += (cone.friction - cone.friction) + (cone.compliance - cone.compliance);
  }
  finite_sum += total.sum() - total.sum();
  const Vector6<S> moved = f.mobility.cwiseAbs().lazyProduct(total);
  for (const ConeGroup<S>& cone : f.cones) {
    S* const sum = &rowsum[cone.variable];
    for (Index k = 0; k < cone.forces(); ++k)
      sum[k] = f.wrenches[cone.force + k].cwiseAbs().dot(moved);
    for (Index k = 0; k < cone.normals; ++k)
      sum[k] += cone.compliance * column_scale[cone.variable] * S(static_cast<int>(cone.normals));
    if (cone.generators == 0) continue;
    S& slip = rowsum[cone.slip()];
    slip = cone.friction * column_scale[cone.variable] * S(static_cast<int>(cone.normals));
    for (Index k = cone.normals; k < cone.forces(); ++k) {
      sum[k] += column_scale[cone.slip()];
      slip += column_scale[cone.variable + k];
    }
  }
  for (Index a = 0; a < f.sums.size; ++a) {
    const SumGroup<S>& sum = f.sums[a];
    const Index s = free_begin_ + a;
    S largest(0);
    rowsum[s] = S(0);
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const S size = Eigen::numext::abs(S(f.coupling[k])) * column_scale[f.coupled_variable[k]];
      largest = Eigen::numext::maxi(largest, size);
      rowsum[s] += size;
    }
    finite_sum += (rowsum[s] - rowsum[s]) + (sum.inertia - sum.inertia);
    row_scale[s] = column_scale[s] = equilibrates ? S(S(1) / power_below(largest)) : S(1);
    rowsum[s] += sum.inertia * column_scale[s];
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      rowsum[f.coupled_variable[k]] += Eigen::numext::abs(S(f.coupling[k])) * column_scale[s];
  }
  return finite_sum;
}

/// The problem as given, scaled, under a cover.
template <class S>
template <class Column>
void LocalForm<S>::load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
                        const Column& cover) {
  const FactoredProblem<S>& f = *problem_;
  directions_.setZero();
  for (Index i = 0; i < n_; ++i) flipped_[i] = 0;
  for (Index c = 0; c < f.cones.size; ++c) {
    const ConeGroup<S>& cone = f.cones[c];
    const Index slip = cone.generators > 0 ? cone.slip() : -1;
    const S scale = row_scale[cone.variable];
    normal_[c] = static_cast<int>(cone.variable);
    slip_[c] = static_cast<int>(slip);
    own_[c] = -1;
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
      own_[c] = static_cast<int>(s);
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
  set_cover(cover);
}

/// The normal force of a cone and the unknown of its own actuator become basic.
template <class S> void LocalForm<S>::press_by_own_actuator(Index c) {
  const Index normal = normal_[c], own = own_[c];
  const S inverse = S(1) / own_coupling_[c];
  directions_.row(own) = directions_.row(normal) * inverse;
  directions_.row(normal).setZero();
  friction_[c] *= inverse;
  compliance_[c] *= inverse * inverse;
  own_coupling_[c] = inverse;
  swap_roles(normal, own);
  normal_[c] = static_cast<int>(own);
  own_[c] = static_cast<int>(normal);
}

/// The slip and the friction force along one generator become basic.
template <class S> void LocalForm<S>::slide(Index c, Index generator) {
  const ConeGroup<S>& cone = problem_->cones[c];
  const Index first = cone.variable + cone.normals, slip = cone.slip();
  for (Index slot = first; slot < slip; ++slot)
    if (slot != generator) directions_.row(slot) -= directions_.row(generator);
  directions_.row(slip) = -directions_.row(generator);
  directions_.row(generator).setZero();
  swap_roles(slip, generator);
  slip_[c] = static_cast<int>(generator);
}

/// Principal pivots inside the cones towards a basis, is_basic(slot) for its z. Precondition: as
/// loaded.
template <class S> template <class IsBasic> void LocalForm<S>::pivot_locally(IsBasic is_basic) {
  for (Index c = 0; c < problem_->cones.size; ++c) {
    const ConeGroup<S>& cone = problem_->cones[c];
    if (own_[c] >= 0 && is_basic(own_[c]) && is_basic(normal_[c])) press_by_own_actuator(c);
    if (cone.generators == 0 || !is_basic(cone.slip())) continue;
    for (Index slot = cone.variable + cone.normals; slot < cone.slip(); ++slot)
      if (is_basic(slot)) {
        slide(c, slot);
        break;
      }
  }
  set_cover(VectorMap<S>(cover_));
}

/// What these pivots do to a right-hand side: the rows' part, and the force at x = 0.
template <class S>
template <class Column>
void LocalForm<S>::transform(Column& rhs, VectorMap<S>& force) const {
  for (Index c = 0; c < problem_->cones.size; ++c) {
    const ConeGroup<S>& cone = problem_->cones[c];
    const Index normal = normal_[c];
    if (flipped_[normal] != 0) {
      const Index given = own_[c], own = normal;
      const S target = rhs[own], pressed = -target * own_coupling_[c];
      rhs[own] = rhs[given] * own_coupling_[c] - target * compliance_[c];
      rhs[given] = pressed;
      force -= directions_.row(own).transpose() * target;
      if (cone.generators > 0) rhs[cone.slip()] -= friction_[c] * target;
    }
    if (cone.generators == 0 || flipped_[cone.slip()] == 0) continue;
    const Index slip = cone.slip(), generator = slip_[c];
    const S slides = rhs[generator], saturates = rhs[slip];
    for (Index slot = cone.variable + cone.normals; slot < slip; ++slot) rhs[slot] -= slides;
    rhs[slip] = -slides;
    rhs[generator] = saturates;
    force -= directions_.row(slip).transpose() * saturates;
  }
}

/// force_ += g x.
template <class S> void LocalForm<S>::add_force(Index slot, const S& x) {
  if (slot == n_) {
    force_ += cover_force_ * x;
    return;
  }
  if (role_[slot] == slip_role || role_[slot] >= own_role) return;
  force_ += directions_.row(slot).transpose() * x;
  const Index c = group_[slot];
  if (role_[slot] == normal_role && has_friction(c))
    force_ -= directions_.row(problem_->cones[c].slip()).transpose() * (friction_[c] * x);
}

template <class S> void LocalForm<S>::find_velocity() {
  v_.setZero();
  const Vector6<S> wrench = force_.template head<6>();
  v_.template head<6>() = problem_->mobility.lazyProduct(wrench);
}

template <class S> S LocalForm<S>::entry_of_row(Index row, Index slot) {
  if (slot < n_ && role_[slot] == shared_role) return local(row, slot) - v_[6 + group_[slot]];
  force_.setZero();
  add_force(slot, S(1));
  const S felt = role_[row] == shared_role
                     ? force_[6 + group_[row]]
                     : S(force_.template head<6>().dot(v_.template head<6>()));
  return felt + local(row, slot);
}

/// The entry without what is felt through v.
template <class S> S LocalForm<S>::local(Index row, Index slot) const {
  if (slot == n_) return cover_[row];
  const int row_role = role_[row], role = role_[slot];
  if (group_[row] != group_[slot]) return S(0);
  const Index c = group_[slot];
  if (row_role == shared_role || role == shared_role)
    return row_role == role ? inertia_[c] : S(0);
  switch (row_role) {
  case normal_role:
    if (role == normal_role) return row == slot ? compliance_[c] : S(-compliance_[c]);
    return role == own_role ? S(-own_coupling_[c]) : S(0);
  case generator_role: return role == slip_role ? S(1) : S(0);
  case slip_role:
    return role == normal_role ? friction_[c] : role == generator_role ? S(-1) : S(0);
  default: return role == normal_role ? own_coupling_[c] : S(0);
  }
}

/// The same for a whole column.
template <class S>
template <class Column>
void LocalForm<S>::add_local(Index slot, const S& x, Column& out) const {
  const Index c = group_[slot];
  switch (role_[slot]) {
  case normal_role:
    out[slot] += compliance_[c] * x;
    if (pulls(c)) {
      const Index first = problem_->cones[c].variable;
      out[slot == first ? first + 1 : first] -= compliance_[c] * x;
    }
    if (slip_[c] >= 0) out[slip_[c]] += friction_[c] * x;
    if (own_[c] >= 0) out[own_[c]] += own_coupling_[c] * x;
    break;
  case generator_role: out[slip_[c]] -= x; break;
  case slip_role: {
    const ConeGroup<S>& cone = problem_->cones[c];
    for (Index k = cone.variable + cone.normals; k <= cone.slip(); ++k)
      if (k != slot) out[k] += x;
    break;
  }
  case own_role: out[normal_[c]] -= own_coupling_[c] * x; break;
  default: out[slot] += inertia_[c] * x;
  }
}

/// out += what the rows feel of v_ and force_.
template <class S> template <class Column> void LocalForm<S>::add_felt(Column& out) const {
  const auto& h = directions_;
  out += h.col(0) * v_[0] + h.col(1) * v_[1] + h.col(2) * v_[2] + h.col(3) * v_[3] +
         h.col(4) * v_[4] + h.col(5) * v_[5];
  for (Index k = 6; k < width(); ++k)
    if (v_[k] != S(0)) out += h.col(k) * v_[k];
  for (Index s = free_begin_; s < n_; ++s)
    if (role_[s] == shared_role) out[s] += force_[6 + group_[s]];
}

template <class S>
template <class Inputs, class Column>
void LocalForm<S>::multiply(Inputs inputs, Column&& out) {
  force_.setZero();
  out.setZero();
  inputs([&](Index slot, const S& x) {
    add_force(slot, x);
    if (slot == n_) out = cover_ * x;
  });
  find_velocity();
  inputs([&](Index slot, const S& x) {
    if (slot < n_ && role_[slot] == shared_role) v_[6 + group_[slot]] = -x;
  });
  add_felt(out);
  inputs([&](Index slot, const S& x) {
    if (slot < n_) add_local(slot, x, out);
  });
}

} // namespace lcpush::detail
