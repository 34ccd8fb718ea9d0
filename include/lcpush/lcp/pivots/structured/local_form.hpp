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
//
// Example, with one direction instead of six: mobility A = 1, one contact without friction, of
// compliance c = 1/2, and an actuator of inertia 1 that drives it. With z = [lambda, s]
//
//     M = [ 3/2  -1 ]    slot 0: normal_role, h_0 = (1, 1), compliance_ 1/2
//         [  1    1 ]    slot 1: shared_role, inertia_ 1
//
// At lambda = 2, s = 1: force_ = (2, 2) is lambda along h_0 (wrench, then coupling),
// actuator_input_ = (1) is s, v_ = core_input_ = (A F_0, -s) = (2, -1). Row 0: h_0' v + lambda / 2
// = 1 + 1; row 1: F_1 + s = 3. Now lambda becomes basic on its compliance (is_spring): slot 0
// stands for w_0, lambda = 2 (w_0 - h_0' v), so that h_0 becomes (-2, -2), compliance_ 2, springs_
// [2 2; 2 2], I + A springs_ in the wrench's row [3 2; 0 1] and its inverse core_ [1/3 -2/3; 0 1].
// At w_0 = 2, s = 1: force_ = (4, 4), core_input_ = (4, -1), v_ = core_ core_input_ = (2, -1) as
// before, and row 0 says lambda = h_0' v + 2 w_0 = -2 + 4.
//
// Without inertia the actuator is the contact's own: own_actuator_ = (1), M = [3/2 -1; 1 0]. lambda
// and s become basic together, and the inverse [0 1; -1 3/2] has the form of M, roles swapped.
#pragma once

#include <cstdint>
#include <limits>

#include "lcpush/lcp/pivots/basis.hpp"
#include "lcpush/lcp/pivots/equilibrate.hpp"
#include "lcpush/lcp/pivots/settings.hpp"
#include "lcpush/lcp/pivots/structured/directions.hpp"
#include "lcpush/lcp/residual.hpp"

namespace lcpush {
namespace detail {

/// The cone whose normal force alone the sum group couples, to be pivoted on the coupling; or -1.
template <class S> Index own_cone(const FactoredProblem<S>& problem, const SumGroup<S>& sum) {
  if (sum.count != 1 || sum.inertia != S(0) || problem.coupling[sum.first] == S(0)) return -1;
  const Index variable = problem.coupled_variable[sum.first];
  const Index c = cone_of(problem.cones, variable);
  return problem.cones[c].variable == variable && problem.cones[c].normals == 1 ? c : -1;
}

} // namespace detail

/// Actuators that drive more than one contact: each widens the border of the structured basis.
template <class S> Index shared_actuators(const FactoredProblem<S>& problem) {
  Index shared = 0;
  for (const SumGroup<S>& sum : problem.sums) shared += detail::own_cone(problem, sum) < 0 ? 1 : 0;
  return shared;
}

namespace detail {

enum LocalRole : int { normal_role, generator_role, slip_role, own_role, shared_role };

template <class S, class M> class LocalForm {
  using Int = typename M::Integer;
  using Directions = typename M::template Directions<S>;

public:
  LocalForm() {}
  static constexpr Index scalars(Index n, Index cones, Index shared) {
    const Index width = 6 + shared;
    return Directions::scalars(n, shared) + 4 * width + size_of_core(cones, width) + n + 3 * cones +
           3 * shared;
  }
  /// C, and what it is the inverse of.
  static constexpr Index size_of_core(Index cones, Index width) {
    return cones < StructuredSettings::contacts_with_springs ? 0 : 2 * width * width;
  }
  /// Cones, or shared actuators.
  static constexpr Index most_groups() {
    return std::numeric_limits<Int>::max() / Index(one_group);
  }
  static constexpr Index integers(Index n, Index cones, Index shared) {
    return n + 3 * cones + Directions::integers(cones, shared);
  }

  void carve(const Problem<S>& problem, Block<S>& scalars, Block<Int>& integers) {
    problem_ = problem.factored;
    n_ = problem.size;
    free_begin_ = problem.free_begin;
    const Index shared = shared_actuators(*problem_), cones = problem_->cones.size;
    const Index width = 6 + shared;
    directions_.carve(problem, shared, scalars, integers);
    scalars.seat(d_, n_);
    for (VectorMap<S>* map : {&d_force_, &force_, &v_, &core_input_}) scalars.seat(*map, width);
    for (VectorMap<S>* map : {&actuator_input_, &d_actuator_input_}) scalars.seat(*map, shared);
    for (MatrixMap<S>* map : {&springs_, &core_}) {
      const Index columns = size_of_core(cones, width) > 0 ? width : 0;
      scalars.seat(*map, width, columns);
    }
    for (Span<S>* span : {&friction_, &compliance_, &own_coupling_}) *span = scalars.take(cones);
    inertia_ = scalars.take(shared);
    state_ = integers.take(n_);
    for (Span<Int>* span : {&normal_, &slip_, &own_actuator_}) *span = integers.take(cones);
  }
  /// M z, and sums of the sizes in its rows, as given.
  void product(const S* z, S* out) const { multiply_factored(*problem_, free_begin_, z, out); }
  void row_sums(const S* z, S* out) const { multiply_terms(*problem_, free_begin_, true, z, out); }

  /// Symmetric scales that bring the diagonal of G' B G near 1; then no entry of it is larger
  /// (Cauchy and Schwarz). One scale for the generators of a cone, its reciprocal for the slip, so
  /// that these entries stay 1. Returns 0, or NaN if a number is not finite.
  S scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale) const {
    const FactoredProblem<S>& f = *problem_;
    S total = f.mobility.sum();
    for (const Vector6<S>& wrench : f.wrenches) total += wrench.sum();
    for (const ConeGroup<S>& cone : f.cones) total += cone.friction + cone.compliance;
    for (const SumGroup<S>& sum : f.sums) {
      total += sum.inertia;
      for (Index k = sum.first; k < sum.first + sum.count; ++k) total += f.coupling[k];
    }
    const auto diagonal = [&](Index force) {
      const Vector6<S> moved = f.mobility.lazyProduct(f.wrenches[force]);
      return S(f.wrenches[force].dot(moved));
    };
    for (const ConeGroup<S>& cone : f.cones) {
      S slips(0);
      for (Index k = cone.normals; k < cone.forces(); ++k)
        slips = Eigen::numext::maxi(slips, diagonal(cone.force + k));
      const S normal =
          equilibrates ? reciprocal_root(S(diagonal(cone.force) + cone.compliance)) : S(1);
      const S slip = equilibrates ? reciprocal_root(slips) : S(1);
      for (Index k = 0; k < cone.forces(); ++k)
        row_scale[cone.variable + k] = column_scale[cone.variable + k] =
            k < cone.normals ? normal : slip;
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
    return total - total;
  }
  /// The problem as given, scaled, under a covering vector.
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
            const VectorMap<S>& covering_vector) {
    const FactoredProblem<S>& f = *problem_;
    directions_.load(row_scale);
    has_springs_ = false;
    for (Index c = 0; c < f.cones.size; ++c) {
      const ConeGroup<S>& cone = f.cones[c];
      const Index slip = cone.generators > 0 ? cone.slip() : -1;
      const S scale = row_scale[cone.variable];
      normal_[c] = static_cast<Int>(cone.variable);
      slip_[c] = static_cast<Int>(slip);
      own_actuator_[c] = -1;
      compliance_[c] = cone.compliance * scale * scale;
      friction_[c] = slip < 0 ? S(0) : S(cone.friction * scale * row_scale[slip]);
      for (Index k = 0; k < cone.forces(); ++k) {
        const Index slot = cone.variable + k;
        begin(slot, k < cone.normals ? normal_role : generator_role, c);
      }
      if (slip >= 0) begin(slip, slip_role, c);
    }
    Index shared = 0;
    for (Index a = 0; a < f.sums.size; ++a) {
      const SumGroup<S>& sum = f.sums[a];
      const Index s = free_begin_ + a, c = own_cone(f, sum);
      if (c >= 0) {
        begin(s, own_role, c);
        own_actuator_[c] = static_cast<Int>(s);
        own_coupling_[c] = f.coupling[sum.first] * row_scale[s] * column_scale[f.cones[c].variable];
        continue;
      }
      begin(s, shared_role, shared);
      inertia_[shared] = sum.inertia * row_scale[s] * column_scale[s];
      directions_.share(a, shared++, row_scale[s], column_scale);
    }
    set_covering_vector(covering_vector);
  }
  template <class IsBasic> bool pivot_locally(IsBasic is_basic);
  void set_covering_vector(const VectorMap<S>& as_given) {
    d_ = as_given;
    transform(d_, d_force_, d_actuator_input_);
  }

  bool is_flipped(Index slot) const { return (state_[slot] & flipped) != 0; }

  /// Entries (row, slot) of the matrix, slot n the covering vector: along one column after
  /// begin_column(slot), along one row after begin_row(row). Cost: O(1).
  void begin_column(Index slot) {
    force_.setZero();
    actuator_input_.setZero();
    add_force(slot, S(1));
    find_velocity();
  }
  S entry_of_column(Index row, Index slot) const {
    return (role(row) == shared_role ? shared_row(row) : felt(row)) + local(row, slot);
  }
  void begin_row(Index row);
  S entry_of_row(Index row, Index slot) const;

  /// out = M x, x given by inputs(visit) calling visit(slot, x) for each entry that is not zero.
  /// Cost: O(n) and O(1) an input.
  template <class Inputs> void multiply(const Inputs& inputs, VectorMap<S>& out);
  /// Of all products so far, in StructuredSettings' unit, modulo 2^32.
  std::uint32_t work() const { return work_; }
  void add_work(Index work) { work_ += static_cast<std::uint32_t>(work); }

  /// A right-hand side of the problem as given becomes the rows' values at x = 0.
  void evaluate(VectorMap<S>& rhs) {
    transform(rhs, force_, actuator_input_);
    find_velocity();
    add_felt(rhs);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index n_ = 0, free_begin_ = 0;
  std::uint32_t work_ = 0;
  static constexpr int flipped = 8;         // a bit that no role has
  static constexpr unsigned one_group = 16; // above those of roles and flipped
  Directions directions_;
  LCPUSH_SEATED(VectorMap<S>, d_);
  LCPUSH_SEATED(VectorMap<S>, d_force_);
  LCPUSH_SEATED(VectorMap<S>, force_);
  LCPUSH_SEATED(VectorMap<S>, v_); // v = C (A F, -s), and what C is applied to
  LCPUSH_SEATED(VectorMap<S>, core_input_);
  // Of shared actuators, the variable that is not basic: s, or w once s is basic.
  LCPUSH_SEATED(VectorMap<S>, actuator_input_);
  LCPUSH_SEATED(VectorMap<S>, d_actuator_input_);
  LCPUSH_SEATED(MatrixMap<S>, springs_); // sum of g h' / c, and C
  LCPUSH_SEATED(MatrixMap<S>, core_);
  bool has_springs_ = false;
  LCPUSH_SEATED(Span<S>, friction_);
  LCPUSH_SEATED(Span<S>, compliance_);
  LCPUSH_SEATED(Span<S>, own_coupling_);
  LCPUSH_SEATED(Span<S>, inertia_);
  // Of slots: role, `flipped`, and its cone or the number of a shared actuator.
  LCPUSH_SEATED(Span<Int>, state_);
  LCPUSH_SEATED(Span<Int>, normal_); // of cones: the slots in these roles, -1 for none
  LCPUSH_SEATED(Span<Int>, slip_);
  LCPUSH_SEATED(Span<Int>, own_actuator_);

  Index width() const { return directions_.width(); }
  bool pulls(Index cone) const { return problem_->cones[cone].normals == 2; }
  /// Then h of its slip() is where its friction force points.
  bool slides(Index c) const {
    const ConeGroup<S>& cone = problem_->cones[c];
    return cone.generators > 0 && is_flipped(cone.slip());
  }
  /// Is its normal force basic on its compliance? One that its own actuator presses is none.
  bool is_spring(Index c) const { return is_flipped(normal_[c]) && own_actuator_[c] < 0; }
  int role(Index slot) const { return state_[slot] & (flipped - 1); }
  Index group(Index slot) const { return static_cast<unsigned>(state_[slot]) / one_group; }
  void begin(Index slot, LocalRole role, Index group) {
    state_[slot] = static_cast<Int>(group * Index(one_group) + role);
  }
  void flip(Index slot) { state_[slot] = static_cast<Int>(state_[slot] | flipped); }
  void swap_roles(Index i, Index j) {
    Eigen::numext::swap(state_[i], state_[j]);
    flip(i);
    flip(j);
  }
  bool has_direction(Index i) const {
    return role(i) < slip_role || (role(i) == slip_role && has_springs_);
  }
  TurnedCone<S> turned(Index c) const {
    TurnedCone<S> cone{
        problem_->cones[c], c, normal_[c], slides(c) ? Index(slip_[c]) : -1, S(1), S(0)};
    if (!is_flipped(cone.normal)) return cone;
    const bool springs = own_actuator_[c] < 0;
    cone.normal_by = springs ? S(-compliance_[c]) : own_coupling_[c];
    if (springs) cone.slip_by = -friction_[c];
    return cone;
  }
  /// h_i' v.
  S felt(Index i) const {
    return has_direction(i) ? directions_.dot(i, turned(group(i)), v_) : S(0);
  }
  void add_force(Index slot, S x);
  void find_velocity();
  S local(Index row, Index slot) const;
  void add_local(Index slot, S x, VectorMap<S>& out) const;
  void add_felt(VectorMap<S>& out) const;
  void transform(VectorMap<S>& rhs, VectorMap<S>& force, VectorMap<S>& actuator_input) const;
  /// What a shared actuator's row feels: its forces' sum, or its unknown.
  S shared_row(Index row) const {
    const Index k = 6 + group(row);
    if (is_flipped(row)) return -v_[k];
    return has_springs_ ? S(force_[k] - springs_.row(k).dot(v_.transpose())) : force_[k];
  }
  template <class IsBasic> bool has_springs(IsBasic is_basic) const;
  template <class IsBasic> bool load_springs(IsBasic is_basic);
  void load_spring(Index cone);
  bool invert_core();
  void press_by_own_actuator(Index cone);
  void slide(Index cone, Index generator);
};

} // namespace detail
} // namespace lcpush

#include "lcpush/lcp/pivots/structured/local_pivots.hpp"
#include "lcpush/lcp/pivots/structured/local_products.hpp"
