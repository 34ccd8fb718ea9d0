// A factored problem, scaled, in a form that principal pivots inside a cone leave alone: every
// unknown has a *role*, a direction in the space that all cones share, and local coefficients.
// Where the slip and one friction force are basic, the cone *slides*: that is such a pivot, the
// unknowns swap roles and directions change, the form does not. So a basis with thousands of
// sliding cones is as cheap as one with a few.
//
//     row i = h_i' v + local terms,   v = C (A F_0..5, -s),   F = sum_j g_j x_j
//
// h_i has 6 + k entries: the wrench, and the couplings to the k actuators that several forces
// share. g_j = h_j, but of a normal force h_j plus mu times the direction in which its cone
// slides. x_j is the variable of slot j that is not basic at x = 0, row j its complement.
//
// Compliant cones with a basic normal force are pivoted too, each on its own compliance c: their
// forces answer v as springs, lambda = (w - h'v - q) / c, and all of them together change C, a
// matrix of 6 + k rows; without them it is the identity.
#pragma once

#include "lcpush/lcp/equilibrate.hpp"
#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush::detail {

enum LocalRole : int { normal_role, generator_role, slip_role, own_role, shared_role };

template <class S> class LocalForm {
public:
  static constexpr Index scalars(Index n, Index cones, Index shared) {
    return (n + 4 + 2 * (6 + shared)) * (6 + shared) + n + 3 * cones + 3 * shared;
  }
  static constexpr Index integers(Index n, Index cones) { return 3 * n + 4 * cones; }

  void carve(const Problem<S>& problem, Block<S>& scalars, Block<int>& integers);
  S scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale,
          VectorMap<S> rowsum) const;
  template <class Column>
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale, const Column& cover);
  template <class IsBasic> bool pivot_locally(IsBasic is_basic);
  template <class Column> void set_cover(const Column& as_given) {
    cover_ = as_given;
    transform(cover_, cover_force_, cover_held_);
  }

  bool is_flipped(Index slot) const { return flipped_[slot] != 0; }

  /// Entries (row, slot) of the matrix, slot n the cover: along one column after
  /// begin_column(slot), along one row after begin_row(row). Cost: O(1).
  void begin_column(Index slot) {
    force_.setZero();
    held_.setZero();
    add_force(slot, S(1));
    find_velocity();
  }
  S entry_of_column(Index row, Index slot) const {
    const S felt =
        role_[row] == shared_role ? shared_row(row) : S(directions_.row(row).dot(v_.transpose()));
    return felt + local(row, slot);
  }
  void begin_row(Index row);
  S entry_of_row(Index row, Index slot) const;

  /// out = M x, x given by inputs(visit) calling visit(slot, x) for each entry that is not zero.
  /// Cost: O(n) and O(1) an input.
  template <class Inputs, class Column> void multiply(Inputs inputs, Column&& out);

  /// A right-hand side of the problem as given becomes the rows' values at x = 0.
  template <class Column> void evaluate(Column&& rhs) {
    transform(rhs, force_, held_);
    find_velocity();
    add_felt(rhs);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index n_ = 0, free_begin_ = 0;
  MatrixMap<S> directions_{nullptr, 0, 0}; // n x width, row i: h_i
  VectorMap<S> cover_{nullptr, 0}, cover_force_{nullptr, 0}, force_{nullptr, 0};
  VectorMap<S> v_{nullptr, 0}, cause_{nullptr, 0};
  VectorMap<S> held_{nullptr, 0}, cover_held_{nullptr, 0};    // of shared actuators: s, or w at C
  MatrixMap<S> springs_{nullptr, 0, 0}, core_{nullptr, 0, 0}; // sum of g h' / c, and C
  bool has_springs_ = false;
  Span<S> friction_, compliance_, own_coupling_, inertia_;
  Span<int> role_, group_, flipped_; // of slots; group_: cone, or number of the shared actuator
  Span<int> normal_, slip_, own_;    // of cones: the slots in these roles, -1 for none
  Span<int> pressed_;                // of cones: is the normal force a spring's?

  Index width() const { return directions_.cols(); }
  bool pulls(Index cone) const { return problem_->cones[cone].normals == 2; }
  /// Then row slip() of the directions is where its friction force points.
  bool slides(Index c) const {
    const ConeGroup<S>& cone = problem_->cones[c];
    return cone.generators > 0 && flipped_[cone.slip()] != 0;
  }
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
  template <class Column>
  void transform(Column& rhs, VectorMap<S>& force, VectorMap<S>& held) const;
  /// What a shared actuator's row feels: its forces' sum, or its unknown.
  S shared_row(Index row) const {
    const Index k = 6 + group_[row];
    if (flipped_[row] != 0) return -v_[k];
    return has_springs_ ? S(force_[k] - springs_.row(k).dot(v_.transpose())) : force_[k];
  }
  template <class IsBasic> bool has_springs(IsBasic is_basic) const;
  template <class IsBasic> bool press_springs(IsBasic is_basic);
  void press(Index cone);
  bool invert_core();
  void press_by_own_actuator(Index cone);
  void slide(Index cone, Index generator);
};

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
  for (VectorMap<S>* map : {&cover_force_, &force_, &v_, &cause_}) vector(*map, width);
  for (VectorMap<S>* map : {&held_, &cover_held_}) vector(*map, shared);
  for (MatrixMap<S>* map : {&springs_, &core_})
    new (map) MatrixMap<S>(scalars.take(width * width).data, width, width);
  for (Span<S>* span : {&friction_, &compliance_, &own_coupling_}) *span = scalars.take(cones);
  inertia_ = scalars.take(shared);
  for (Span<int>* span : {&role_, &group_, &flipped_}) *span = integers.take(n_);
  for (Span<int>* span : {&normal_, &slip_, &own_, &pressed_}) *span = integers.take(cones);
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
    const S normal =
        equilibrates ? reciprocal_root(S(diagonal(cone.force) + cone.compliance)) : S(1);
    const S slip = equilibrates ? reciprocal_root(slips) : S(1);
    for (Index k = 0; k < cone.forces(); ++k) {
      row_scale[cone.variable + k] = column_scale[cone.variable + k] =
          k < cone.normals ? normal : slip;
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
  has_springs_ = false;
  for (Index c = 0; c < f.cones.size; ++c) {
    const ConeGroup<S>& cone = f.cones[c];
    const Index slip = cone.generators > 0 ? cone.slip() : -1;
    const S scale = row_scale[cone.variable];
    normal_[c] = static_cast<int>(cone.variable);
    slip_[c] = static_cast<int>(slip);
    own_[c] = -1;
    pressed_[c] = 0;
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

/// The normal force of a compliant cone becomes basic. Precondition: it slides already if it is
/// to.
template <class S> void LocalForm<S>::press(Index c) {
  const ConeGroup<S>& cone = problem_->cones[c];
  const Index normal = normal_[c];
  const S stiffness = S(1) / compliance_[c];
  auto direction = directions_.row(normal);
  v_ = direction.transpose(); // g
  if (slides(c)) v_ -= directions_.row(cone.slip()).transpose() * friction_[c];
  for (Index k = 0; k < width(); ++k) springs_.col(k) += v_ * (direction[k] * stiffness);
  direction *= -stiffness;
  if (slip_[c] >= 0) directions_.row(slip_[c]) = direction * friction_[c];
  friction_[c] *= stiffness;
  compliance_[c] = stiffness;
  flipped_[normal] = pressed_[c] = 1;
}

/// Are there so many loaded springs that they do not fit among the exchanges? Few do, and then
/// nothing is divided by a compliance.
template <class S> template <class IsBasic> bool LocalForm<S>::has_springs(IsBasic is_basic) const {
  constexpr Index many = 24;
  Index loaded = 0;
  for (Index c = 0; c < problem_->cones.size; ++c)
    loaded += compliance_[c] > S(0) && is_basic(normal_[c]) ? 1 : 0;
  return loaded >= many;
}

/// All of them, the actuators that they carry, and C. False if it is singular.
template <class S> template <class IsBasic> bool LocalForm<S>::press_springs(IsBasic is_basic) {
  has_springs_ = true;
  springs_.setZero();
  for (Index c = 0; c < problem_->cones.size; ++c)
    if (compliance_[c] > S(0) && own_[c] < 0 && !pulls(c) && is_basic(normal_[c])) press(c);
  for (Index s = free_begin_; s < n_; ++s)
    if (role_[s] == shared_role && is_basic(s) && springs_(6 + group_[s], 6 + group_[s]) > S(0))
      flipped_[s] = 1;
  // (I + A T_aa) v_a + A T_as v_s = A F_a,   T_sa v_a + (T_ss + m) v_s = F_s - w_s.
  core_.setIdentity();
  core_.template topRows<6>() += problem_->mobility.lazyProduct(springs_.template topRows<6>());
  for (Index s = free_begin_; s < n_; ++s) {
    const Index k = 6 + group_[s];
    if (role_[s] != shared_role || flipped_[s] == 0) continue;
    core_.row(k) = springs_.row(k);
    core_(k, k) += inertia_[group_[s]];
  }
  return invert_core();
}

/// Gauss-Jordan with row pivoting, in place, on rows of largest entry 1.
template <class S> bool LocalForm<S>::invert_core() {
  const Index size = width();
  constexpr int most = 6 + 32; // few actuators are shared by many cones
  if (size > most) return false;
  Index from[most];
  for (Index i = 0; i < size; ++i) {
    from[i] = i;
    cause_[i] = core_.row(i).cwiseAbs().maxCoeff();
    if (!(cause_[i] > S(0))) return false;
    core_.row(i) /= cause_[i];
  }
  for (Index k = 0; k < size; ++k) {
    Index row = k;
    core_.col(k).tail(size - k).cwiseAbs().maxCoeff(&row);
    row = k + (row < size - k ? row : 0);
    if (core_(row, k) == S(0)) return false;
    if (row != k) {
      core_.row(row).swap(core_.row(k));
      Eigen::numext::swap(from[row], from[k]);
      Eigen::numext::swap(cause_[row], cause_[k]);
    }
    const S pivot = core_(k, k);
    core_(k, k) = S(1);
    core_.row(k) /= pivot;
    for (Index i = 0; i < size; ++i) {
      if (i == k) continue;
      const S factor = core_(i, k);
      core_(i, k) = S(0);
      core_.row(i) -= core_.row(k) * factor;
    }
  }
  // Column k belongs to row from[k] of the scaled matrix.
  for (Index k = 0; k < size; ++k) core_.col(k) /= cause_[k];
  for (Index k = 0; k < size; ++k)
    while (from[k] != k) {
      const Index to = from[k];
      core_.col(k).swap(core_.col(to));
      Eigen::numext::swap(from[k], from[to]);
    }
  return true;
}

/// Principal pivots inside the cones towards a basis, is_basic(slot) for its z. Precondition: as
/// loaded. False if they are singular together.
template <class S> template <class IsBasic> bool LocalForm<S>::pivot_locally(IsBasic is_basic) {
  const bool springs = has_springs(is_basic);
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
  if (springs && !press_springs(is_basic)) return false;
  set_cover(VectorMap<S>(cover_));
  return true;
}

/// What these pivots do to a right-hand side: the rows' part, and the force and what the shared
/// actuators are held at, at x = 0.
template <class S>
template <class Column>
void LocalForm<S>::transform(Column& rhs, VectorMap<S>& force, VectorMap<S>& held) const {
  force.setZero();
  held.setZero();
  for (Index c = 0; c < problem_->cones.size; ++c) {
    const ConeGroup<S>& cone = problem_->cones[c];
    const Index normal = normal_[c];
    if (flipped_[normal] != 0 && pressed_[c] == 0) {
      const Index given = own_[c], own = normal;
      const S target = rhs[own], pressed = -target * own_coupling_[c];
      rhs[own] = rhs[given] * own_coupling_[c] - target * compliance_[c];
      rhs[given] = pressed;
      force -= directions_.row(own).transpose() * target;
      if (cone.generators > 0) rhs[cone.slip()] -= friction_[c] * target;
    }
    if (slides(c)) {
      const Index slip = cone.slip(), generator = slip_[c];
      const S moves = rhs[generator], saturates = rhs[slip];
      for (Index slot = cone.variable + cone.normals; slot < slip; ++slot) rhs[slot] -= moves;
      rhs[slip] = -moves;
      rhs[generator] = saturates;
      force -= directions_.row(slip).transpose() * saturates;
    }
    if (pressed_[c] != 0) {
      const S yields = rhs[normal];
      rhs[normal] = -yields * compliance_[c];
      force += directions_.row(normal).transpose() * yields;
      if (cone.generators == 0) continue;
      if (slides(c)) force += directions_.row(cone.slip()).transpose() * (friction_[c] * yields);
      rhs[slip_[c]] -= friction_[c] * yields;
    }
  }
  for (Index s = free_begin_; has_springs_ && s < n_; ++s)
    if (role_[s] == shared_role && flipped_[s] != 0) {
      held[group_[s]] = -rhs[s];
      rhs[s] = S(0);
    }
}

/// force_ and held_ += what slot does at x.
template <class S> void LocalForm<S>::add_force(Index slot, const S& x) {
  if (slot == n_) {
    force_ += cover_force_ * x;
    held_ += cover_held_ * x;
    return;
  }
  const Index c = group_[slot];
  switch (role_[slot]) {
  case normal_role:
    force_ += directions_.row(slot).transpose() * (pressed_[c] != 0 ? S(-x) : x);
    if (slides(c))
      force_ -= directions_.row(problem_->cones[c].slip()).transpose() * (friction_[c] * x);
    break;
  case generator_role: force_ += directions_.row(slot).transpose() * x; break;
  case shared_role: held_[c] += x; break;
  default: break;
  }
}

template <class S> void LocalForm<S>::find_velocity() {
  const Vector6<S> wrench = force_.template head<6>();
  VectorMap<S>& v = has_springs_ ? cause_ : v_;
  v.template head<6>() = problem_->mobility.lazyProduct(wrench);
  for (Index k = 6; k < width(); ++k) v[k] = -held_[k - 6];
  if (!has_springs_) return;
  for (Index s = free_begin_; s < n_; ++s)
    if (role_[s] == shared_role && flipped_[s] != 0) v[6 + group_[s]] += force_[6 + group_[s]];
  v_ = core_.lazyProduct(cause_);
}

/// v_ becomes what the row feels of each component of F, cause_ of each s.
template <class S> void LocalForm<S>::begin_row(Index row) {
  v_ = directions_.row(row).transpose();
  if (role_[row] == shared_role && has_springs_) {
    const Index k = 6 + group_[row];
    v_ = -springs_.row(k).transpose();
    if (flipped_[row] != 0) {
      v_.setZero();
      v_[k] = S(-1);
    }
  }
  if (has_springs_) {
    cause_ = v_;
    v_ = core_.transpose().lazyProduct(cause_);
  }
  cause_ = v_;
  const Vector6<S> direction = v_.template head<6>();
  v_.template head<6>() = problem_->mobility.lazyProduct(direction);
  if (width() == 6) return;
  v_.tail(width() - 6).setZero();
  for (Index s = free_begin_; has_springs_ && s < n_; ++s)
    if (role_[s] == shared_role && flipped_[s] != 0) v_[6 + group_[s]] = cause_[6 + group_[s]];
  if (role_[row] == shared_role && flipped_[row] == 0) v_[6 + group_[row]] += S(1);
}

template <class S> S LocalForm<S>::entry_of_row(Index row, Index slot) const {
  const auto felt = [&](Index i) { return S(directions_.row(i).dot(v_.transpose())); };
  const S here = local(row, slot);
  if (slot == n_) {
    S sum = here + cover_force_.dot(v_);
    for (Index k = 6; k < width(); ++k) sum -= cause_[k] * cover_held_[k - 6];
    return sum;
  }
  const Index c = group_[slot];
  switch (role_[slot]) {
  case normal_role: {
    const S presses = pressed_[c] != 0 ? S(here - felt(slot)) : S(here + felt(slot));
    return slides(c) ? S(presses - felt(problem_->cones[c].slip()) * friction_[c]) : presses;
  }
  case generator_role: return here + felt(slot);
  case shared_role: return here - cause_[6 + c];
  default: return here;
  }
}

/// The entry without what is felt through v.
template <class S> S LocalForm<S>::local(Index row, Index slot) const {
  if (slot == n_) return cover_[row];
  const int row_role = role_[row], role = role_[slot];
  if (group_[row] != group_[slot]) return S(0);
  const Index c = group_[slot];
  if (row_role == shared_role || role == shared_role)
    return row == slot && flipped_[row] == 0 ? inertia_[c] : S(0);
  switch (row_role) {
  case normal_role:
    if (role == normal_role) return row == slot ? compliance_[c] : S(-compliance_[c]);
    return role == own_role ? S(-own_coupling_[c]) : S(0);
  case generator_role: return role == slip_role ? S(1) : S(0);
  case slip_role: return role == normal_role ? friction_[c] : role == generator_role ? S(-1) : S(0);
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
  default:
    if (flipped_[slot] == 0) out[slot] += inertia_[c] * x;
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
    if (role_[s] == shared_role) out[s] += shared_row(s);
}

template <class S>
template <class Inputs, class Column>
void LocalForm<S>::multiply(Inputs inputs, Column&& out) {
  force_.setZero();
  held_.setZero();
  out.setZero();
  inputs([&](Index slot, const S& x) {
    add_force(slot, x);
    if (slot == n_) out = cover_ * x;
  });
  find_velocity();
  add_felt(out);
  inputs([&](Index slot, const S& x) {
    if (slot < n_) add_local(slot, x, out);
  });
}

} // namespace lcpush::detail
