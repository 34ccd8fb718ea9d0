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
// = 1 + 1; row 1: F_1 + s = 3. Now lambda becomes basic on its compliance (is_spring_): slot 0
// stands for w_0, lambda = 2 (w_0 - h_0' v), so that h_0 becomes (-2, -2), compliance_ 2, springs_
// [2 2; 2 2], I + A springs_ in the wrench's row [3 2; 0 1] and its inverse core_ [1/3 -2/3; 0 1].
// At w_0 = 2, s = 1: force_ = (4, 4), core_input_ = (4, -1), v_ = core_ core_input_ = (2, -1) as
// before, and row 0 says lambda = h_0' v + 2 w_0 = -2 + 4.
//
// Without inertia the actuator is the contact's own: own_actuator_ = (1), M = [3/2 -1; 1 0]. lambda
// and s become basic together, and the inverse [0 1; -1 3/2] has the form of M, roles swapped.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/pivots/equilibrate.hpp"
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
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
            const Column& covering_vector);
  template <class IsBasic> bool pivot_locally(IsBasic is_basic);
  template <class Column> void set_covering_vector(const Column& as_given) {
    d_ = as_given;
    transform(d_, d_force_, d_actuator_input_);
  }

  bool is_flipped(Index slot) const { return flipped_[slot] != 0; }

  /// Entries (row, slot) of the matrix, slot n the covering vector: along one column after
  /// begin_column(slot), along one row after begin_row(row). Cost: O(1).
  void begin_column(Index slot) {
    force_.setZero();
    actuator_input_.setZero();
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
    transform(rhs, force_, actuator_input_);
    find_velocity();
    add_felt(rhs);
  }

private:
  const FactoredProblem<S>* problem_ = nullptr;
  Index n_ = 0, free_begin_ = 0;
  MatrixMap<S> directions_{nullptr, 0, 0}; // n x width, row i: h_i
  VectorMap<S> d_{nullptr, 0}, d_force_{nullptr, 0}, force_{nullptr, 0};
  VectorMap<S> v_{nullptr, 0}, core_input_{nullptr, 0};
  // Of shared actuators, the variable that is not basic: s, or w once s is basic.
  VectorMap<S> actuator_input_{nullptr, 0}, d_actuator_input_{nullptr, 0};
  MatrixMap<S> springs_{nullptr, 0, 0}, core_{nullptr, 0, 0}; // sum of g h' / c, and C
  bool has_springs_ = false;
  Span<S> friction_, compliance_, own_coupling_, inertia_;
  Span<int> role_, group_, flipped_; // of slots; group_: cone, or number of the shared actuator
  Span<int> normal_, slip_, own_actuator_; // of cones: the slots in these roles, -1 for none
  Span<int> is_spring_;                    // of cones: is the normal force basic on its compliance?

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
  void transform(Column& rhs, VectorMap<S>& force, VectorMap<S>& actuator_input) const;
  /// What a shared actuator's row feels: its forces' sum, or its unknown.
  S shared_row(Index row) const {
    const Index k = 6 + group_[row];
    if (flipped_[row] != 0) return -v_[k];
    return has_springs_ ? S(force_[k] - springs_.row(k).dot(v_.transpose())) : force_[k];
  }
  template <class IsBasic> bool has_springs(IsBasic is_basic) const;
  template <class IsBasic> bool load_springs(IsBasic is_basic);
  void load_spring(Index cone);
  bool invert_core();
  void press_by_own_actuator(Index cone);
  void slide(Index cone, Index generator);
};

} // namespace lcpush::detail

#include "lcpush/lcp/pivots/structured/local_pivots.hpp"
#include "lcpush/lcp/pivots/structured/local_products.hpp"
#include "lcpush/lcp/pivots/structured/local_setup.hpp"
