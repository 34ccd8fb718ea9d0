// One step along the solutions of w = M z + q + t d, 0 <= z _|_ w >= 0, as the parameter t grows:
// as far as a complementary basis holds, and past the breakpoint where it ends.
//
// At the breakpoint t takes the place of the variable that has come to zero, and that variable's
// complement enters: from there on these are Lemke's pivots with t as the artificial variable,
// until t grows again (a new basis, and the solutions go on), falls (the path turns back: no
// solution near this one lies beyond) or nothing blocks (a ray). [Cottle, Pang, Stone 1992, 4.5]
//
// Where q = q0 + sigma q1 has an infinitesimal part, t moves q0 or q1, whichever the caller says;
// sigma stays smaller than any step in t.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

enum class PathEnd {
  unbounded,   ///< nothing blocks: the basis holds for every larger t
  forward,     ///< past the breakpoint t grows again, in another basis
  turned_back, ///< the path goes back to smaller t
  ray,         ///< at the breakpoint the solution grows without bound
  lost,        ///< too many pivots, or a basis that is singular to working precision
};

template <class S> struct PathStep {
  PathEnd end = PathEnd::lost;
  S until{0};            ///< the breakpoint, unless unbounded
  S next_until{0};       ///< forward: the next one
  bool next_ends = true; ///< forward: false if there is no next one
  bool jumps = false;    ///< forward: z has moved at the breakpoint itself, while t stood still
  Index pivots = 0;
};

constexpr Index parametric_scalars(Index n) { return n * (n + 1) + 6 * n; }
constexpr Index parametric_integers(Index n) { return 3 * n + 1; }

template <class S> class ParametricPath {
public:
  /// Memory of at least parametric_scalars(n) and parametric_integers(n) elements.
  ParametricPath(Span<S> scalars, Span<int> integers) : scalars_(scalars), integers_(integers) {}

  /// Begins at the solution that `lemke` has just found of `problem`, where t = 0. `direction`: n
  /// numbers, the change of problem.q (or problem.push, if `moves_push`) by a unit of t, which is
  /// to be of the size of the range of interest: slower changes than rounding's are none. Post:
  /// running, or bad_input. Cost: O(n^2).
  [[nodiscard]] Status init(const Lemke<S>& lemke, const Problem<S>& problem, const S* direction,
                            bool moves_push) {
    const Dictionary<S>& from = lemke.dictionary();
    const Index n = from.size();
    rhs_count_ = problem.push != nullptr ? 3 : 2;
    moved_ = moves_push ? 2 : 1;
    entering_ = -1;
    if (lemke.status() != Status::solved || moved_ >= rhs_count_ ||
        from.column_of(artificial(n)) < 0 || !carve(n))
      return Status::bad_input;
    dictionary_.table = from.table;
    for (Index i = 0; i < n; ++i) dictionary_.basic[i] = from.basic[i];
    for (Index c = 0; c <= n; ++c) dictionary_.nonbasic[c] = from.nonbasic[c];
    const Index t = dictionary_.column_of(parameter());
    for (Index i = 0; i < n; ++i)
      dictionary_.values(i, 0) = S(dictionary_.basic[i] >= n + problem.free_begin ? 1 : 0);
    solve_basis(lemke, problem.q, S(1), t);
    dictionary_.values.col(1) = scratch_;
    S push_unit(1); // an infinitesimal is as large as any other
    if (rhs_count_ == 3) {
      S largest(0);
      for (Index j = 0; j < n; ++j) {
        const S size = Eigen::numext::abs(S(problem.push[j] / lemke.slack_unit(j)));
        largest = Eigen::numext::maxi(largest, size);
      }
      push_unit = power_below(largest);
      solve_basis(lemke, problem.push, push_unit, t);
      dictionary_.values.col(2) = scratch_;
    }
    solve_basis(lemke, direction, moves_push ? push_unit : S(1), t);
    dictionary_.table.col(t) = scratch_;
    for (Index k = 0; k < tie_columns; ++k)
      for (Index i = 0; i < n; ++i)
        dictionary_.values(i, rhs_count_ + k) =
            generic_number<S>(static_cast<std::uint32_t>(k + 1), i);
    return Status::running;
  }

  /// How far back the basis holds: the t <= 0 where it begins. False: for every smaller t.
  bool holds_back_to(S& t) const {
    S distance(0);
    if (!first_zero(S(-1), distance)) return false;
    t = S(0) - distance; // no negative zero
    return true;
  }

  /// Call once. Changes of t up to `least` count as none.
  PathStep<S> advance(const S& least) {
    PathStep<S> step;
    const Index column = dictionary_.column_of(parameter());
    const Blocking first = blocking_row(column);
    if (first.row < 0 || !first_zero(S(1), step.until)) {
      step.end = PathEnd::unbounded;
      return step;
    }
    entering_ = complement(dictionary_.basic[first.row], dictionary_.size());
    dictionary_.exchange(first.row, column, scratch_);
    step.end = follow(least, step);
    return step;
  }

  /// After `forward`: is z_i basic in the new basis?
  bool is_active(Index i) const {
    const Index z = unknown(i, dictionary_.size());
    return z == entering_ || dictionary_.row_of(z) >= 0;
  }

private:
  static constexpr Index tie_columns = 2;
  Span<S> scalars_;
  Span<int> integers_;
  Tolerances<S> tolerances_{};
  Dictionary<S> dictionary_; // z0 of dictionary.hpp is t
  VectorMap<S> scratch_{nullptr, 0};
  Span<int> candidates_;
  Index rhs_count_ = 2;
  Index moved_ =
      1; // the right-hand side that t moves: 1 is q, 2 is push; 0 marks the free unknowns
  Index entering_ = -1;

  bool is_free(Index row) const { return dictionary_.values(row, 0) > S(1) / S(2); }
  Index parameter() const { return artificial(dictionary_.size()); }
  S largest_of(Index column) const { return dictionary_.table.col(column).cwiseAbs().maxCoeff(); }

  bool carve(Index n) {
    Block<S> scalars(scalars_);
    Block<int> integers(integers_);
    dictionary_.carve(n, n + 1, rhs_count_ + tie_columns, scalars, integers);
    scalars.seat(scratch_, n);
    candidates_ = integers.take(n);
    return !scalars.exhausted() && !integers.exhausted();
  }

  /// scratch_ = the basic variables for the right-hand side q / unit, as the dictionary is scaled:
  /// the nonbasic columns of w hold the inverse of the basis.
  void solve_basis(const Lemke<S>& lemke, const S* q, const S& unit, Index skipped) {
    const Index n = dictionary_.size();
    scratch_.setZero();
    for (Index c = 0; c <= n; ++c) {
      const Index j = dictionary_.nonbasic[c];
      if (c == skipped || j >= n) continue;
      const S r = q[j] / unit / lemke.slack_unit(j);
      if (r != S(0)) scratch_ -= dictionary_.table.col(c) * r;
    }
    for (Index i = 0; i < n; ++i) {
      const Index j = dictionary_.basic[i];
      if (j < n) scratch_[i] += q[j] / unit / lemke.slack_unit(j);
    }
  }

  /// How far t can grow (sign = 1) or fall (-1) until a basic variable is zero. False: without end.
  bool first_zero(const S& sign, S& distance) const {
    const Index column = dictionary_.column_of(parameter());
    const S threshold =
        Eigen::numext::maxi(S(tolerances_.pivot * largest_of(column)), tolerances_.tie);
    bool found = false;
    for (Index i = 0; i < dictionary_.size(); ++i) {
      const S falls = -sign * dictionary_.table(i, column);
      if (is_free(i) || !(falls > threshold)) continue;
      // Below a larger value an infinitesimal change changes nothing.
      if (moved_ == 2 && dictionary_.values(i, 1) > tolerances_.tie) continue;
      const S value = dictionary_.values(i, moved_);
      const S zero = value > S(0) ? S(value / falls) : S(0);
      if (!found || zero < distance) distance = zero;
      found = true;
    }
    return found;
  }

  /// Free unknowns never block.
  Blocking blocking_row(Index column) {
    RatioTest<S> test(dictionary_, rhs_count_, TieRule::generic, tolerances_, candidates_);
    Blocking blocking = test.blocking_row(column);
    if (blocking.row >= 0 && is_free(blocking.row)) blocking.row = -1;
    return blocking;
  }

  /// From the breakpoint on: t is basic, entering_ is not.
  PathEnd follow(const S& least, PathStep<S>& step) {
    const Index n = dictionary_.size();
    const Index most_pivots = PathSettings::most_pivots(n);
    for (step.pivots = 1; step.pivots <= most_pivots; ++step.pivots) {
      const Index c = dictionary_.column_of(entering_), t_row = dictionary_.row_of(parameter());
      const S rate = dictionary_.table(t_row, c), largest = largest_of(c);
      const bool grows = rate > tolerances_.pivot * largest;
      const bool falls = rate < -tolerances_.pivot * largest;
      const Blocking blocking = blocking_row(c);
      if (blocking.row < 0) {
        step.next_ends = false;
        return grows ? PathEnd::forward : falls ? PathEnd::turned_back : PathEnd::ray;
      }
      if (blocking.row == t_row) return PathEnd::turned_back;
      // How far the entering variable goes: nowhere if a tie at the breakpoint decides.
      const S fall = -dictionary_.table(blocking.row, c);
      S move = dictionary_.values(blocking.row, moved_) / fall;
      if (moved_ == 2 && dictionary_.values(blocking.row, 1) > tolerances_.tie) {
        step.next_ends = !grows; // in units of the infinitesimal: for ever
        if (grows) return PathEnd::forward;
        if (falls) return PathEnd::turned_back;
        move = dictionary_.values(blocking.row, 1) / fall;
        step.jumps = true;
      }
      const S change = rate * move;
      if (grows && change > least) {
        step.next_until = dictionary_.values(t_row, moved_) + change;
        return PathEnd::forward;
      }
      if (falls && -change > least) return PathEnd::turned_back;
      if (!grows && !falls && move * largest > S(PathSettings::jump) * tolerances_.tie)
        step.jumps = true;
      entering_ = complement(dictionary_.basic[blocking.row], n);
      dictionary_.exchange(blocking.row, c, scratch_);
    }
    return PathEnd::lost;
  }
};

} // namespace lcpush
