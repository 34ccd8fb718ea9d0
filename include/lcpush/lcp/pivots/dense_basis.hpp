// Lemke's basis as a dictionary: all n (n + 1) numbers of it, changed by every pivot.
#pragma once

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/pivots/basis.hpp"
#include "lcpush/lcp/pivots/equilibrate.hpp"
#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush {

/// Any problem, every tie rule, any scalar: the teaching engine, and the exact one.
template <class S> class DenseBasis {
public:
  using Memory = DesktopMemory;
  using Integer = int;
  static constexpr bool takes_matrix = true; ///< a problem without its factors, too
  Dictionary<S> dictionary;

  static bool supports(const Problem<S>&, TieRule) { return true; }

  void carve(const Problem<S>& problem, Index right_hand_sides, Index /*exchanges*/,
             Block<S>& scalars, Block<int>& integers) {
    problem_ = problem;
    dictionary.carve(problem.size, problem.size + 1, right_hand_sides, scalars, integers);
  }
  /// Nothing is shared: the table is in use all the time.
  void seat(const MethodMemory<S, int>& method, Block<S>& scalars, Block<int>& integers) const {
    const Index n = problem_.size;
    for (VectorMap<S>* map :
         {&method.row_scale, &method.column_scale, &method.row_sum, &method.scratch})
      scalars.seat(*map, n);
    for (Span<int>* span : {&method.candidates, &method.target}) *span = integers.take(n);
  }

  /// Post: row_sum = sum_j |M_ij| column_scale_j as well.
  S scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale,
          VectorMap<S> row_sum, VectorMap<S> scratch) {
    const Index n = dictionary.size();
    MatrixMap<S> M(dictionary.table.data(), n, n);
    fill_matrix(problem_, M);
    if (equilibrates) equilibrate(M, row_scale, column_scale, scratch);
    holds_problem_ = true;
    row_sum.setZero();
    for (Index j = 0; j < n; ++j) row_sum += M.col(j).cwiseAbs();
    for (Index i = 0; i < n; ++i) row_sum[i] /= row_scale[i];
    return n > 0 ? S(row_sum.sum() - row_sum.sum()) : S(0);
  }
  void row_sums(const VectorMap<S>& /*column_scale*/, VectorMap<S>& /*row_sum*/) const {} // known

  void product(const S* z, S* out) const { multiply(problem_, z, out); }

  /// The basis of all w under a covering vector; its right-hand sides are there already.
  template <class Column>
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
            const Column& covering_vector) {
    const Index n = dictionary.size();
    if (!holds_problem_) {
      fill_matrix(problem_, MatrixMap<S>(dictionary.table.data(), n, n));
      for (Index j = 0; j < n; ++j)
        dictionary.table.col(j) = dictionary.table.col(j).cwiseProduct(row_scale) * column_scale[j];
    }
    holds_problem_ = false;
    dictionary.table.col(n) = covering_vector;
    dictionary.reset_basis();
  }

  /// Another covering vector: `as_given` in the basis of all w, here(row) in the present one.
  template <class Column, class Reader>
  void set_covering_vector(const Column& /*as_given*/, Reader here) {
    auto column = dictionary.table.col(dictionary.column_of(artificial(dictionary.size())));
    for (Index i = 0; i < dictionary.size(); ++i) column[i] = here(i);
  }

  /// The column of a nonbasic variable that is to enter.
  Index enter(Index variable) const { return dictionary.column_of(variable); }
  void exchange(Index row, Index column, Index /*entering*/, const VectorMap<S>& scratch) {
    dictionary.exchange(row, column, scratch);
  }
  bool is_basic(Index variable) const { return dictionary.row_of(variable) >= 0; }
  bool must_refactor() const { return false; }
  bool is_too_long() const { return false; }

  /// out = how the basic variables respond to nonbasic w_j = r_j; r is 0 where w_j is basic.
  void respond(const VectorMap<S>& r, VectorMap<S> out) const {
    const Index n = dictionary.size();
    out.setZero();
    for (Index c = 0; c <= n; ++c) {
      const Index j = dictionary.nonbasic[c];
      if (j >= n || r[j] == S(0)) continue;
      detail::add_scaled(out.data(), dictionary.table.col(c).data(), S(r[j]), n);
    }
  }

  /// After factoring: what is known of the right-hand side of S. Elimination has kept it exact.
  void set_bound_rhs(Index, const VectorMap<S>&, const S&) {}

  /// Gauss-Jordan with complete pivoting from the basis of all w to the one in target (basic
  /// variables in any order). Returns how many of its z are left when pivots above `smallest_pivot`
  /// end: then candidates holds the w that should have left, target the z that should have entered.
  Index factor(Span<int> target, Span<int> candidates, const S& smallest_pivot,
               const VectorMap<S>& scratch, const Wanted& /*all come along*/) {
    const Index n = dictionary.size();
    // candidates: rows whose w is to leave; target: columns whose variable is to enter.
    Index wanted = 0, leaving = 0;
    for (Index i = 0; i < n; ++i) candidates[i] = 1;
    for (Index k = 0; k < n; ++k)
      if (target[k] < n) candidates[target[k]] = 0;
    for (Index i = 0; i < n; ++i)
      if (candidates[i] != 0) candidates[leaving++] = static_cast<int>(i);
    for (Index k = 0; k < n; ++k)
      if (target[k] >= n) target[wanted++] = static_cast<int>(target[k] - n);
    return exchange_largest(
        candidates, target, wanted, smallest_pivot,
        [&](Index row, Index column) -> const S& { return dictionary.table(row, column); },
        [&](Index row, Index column) { dictionary.exchange(row, column, scratch); });
  }

  /// After factor has left some: makes the basis complementary again, without them. Where w_i
  /// has stayed but z_i has entered, and z_j has not entered but w_j has left, z_i leaves for w_j.
  /// False if that is singular too.
  bool drop_pairs(Index left, Span<int> target, Span<int> candidates, const S& smallest_pivot,
                  const VectorMap<S>& scratch) {
    const Index n = dictionary.size();
    const auto row = [&](Index i) { return dictionary.row_of(unknown(i, n)); };
    const auto column = [&](Index j) { return dictionary.column_of(slack(j)); };
    Index both = 0, neither = 0; // of a pair's two variables: basic
    for (Index k = 0; k < left; ++k)
      if (row(candidates[k]) >= 0) candidates[both++] = candidates[k];
    for (Index k = 0; k < left; ++k)
      if (column(target[k]) >= 0) target[neither++] = target[k];
    return exchange_largest(
               target, candidates, both, smallest_pivot,
               [&](Index j, Index i) -> const S& { return dictionary.table(row(i), column(j)); },
               [&](Index j, Index i) { dictionary.exchange(row(i), column(j), scratch); }) == 0;
  }

private:
  Problem<S> problem_;
  bool holds_problem_ = false; // the table is the scaled M, from scale() to the first load()
};

} // namespace lcpush
