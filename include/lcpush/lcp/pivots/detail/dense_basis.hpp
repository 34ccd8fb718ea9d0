// Lemke's basis as a dictionary: all n (n + 1) numbers of it, changed by every pivot.
#pragma once

#include <limits>

#include "lcpush/lcp/complete_pivoting.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "lcpush/lcp/pivots/equilibrate.hpp"
#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush {

/// What Lemke asks of a basis. Everything is scaled; the right-hand sides are dictionary.values.
/// With narrow integers it is the basis of TableLemke, in little code: of factored problems alone,
/// rows and columns scaled alike.
template <class S, class Int = int> class DenseBasis {
public:
  using Integer = Int;
  Dictionary<S, Int> dictionary;
  static constexpr bool is_little = is_narrow<Int>; ///< little code counts more than little work
  static constexpr bool one_scale = is_little;      ///< are rows and columns scaled alike?
  static constexpr bool of_groups = is_little;      ///< does it know factored problems alone?
  static constexpr bool carries_push = !is_little;  ///< may the problem have a push?
  static constexpr bool has_table = true;           ///< else there is but the entering column

  static bool supports(const Problem<S>& problem, TieRule rule) {
    if constexpr (!is_little) return true;
    return problem.factored != nullptr && problem.push == nullptr &&
           rule != TieRule::lexicographic && numbers(problem.size);
  }
  /// Is Int wide enough for as many unknowns?
  static constexpr bool numbers(Index n) { return n <= std::numeric_limits<Int>::max() / 2; }

  void carve(const Problem<S>& problem, Index right_hand_sides, Index /*exchanges*/,
             Block<S>& scalars, Block<Int>& integers) {
    problem_ = problem;
    dictionary.carve(problem.size, problem.size + 1, right_hand_sides, scalars, integers);
  }

  /// Scales, and rowsum_i = sum_j |M_ij| column_scale_j. Returns 0, or NaN if M is not finite.
  S scale(bool equilibrates, VectorMap<S> row_scale, VectorMap<S> column_scale, VectorMap<S> rowsum,
          VectorMap<S> scratch) {
    if constexpr (of_groups) return scale_alike(equilibrates, row_scale);
    const Index n = dictionary.size();
    MatrixMap<S> M(dictionary.table.data(), n, n);
    fill_matrix(problem_, M);
    if (equilibrates) equilibrate(M, row_scale, column_scale, scratch);
    holds_problem_ = true;
    rowsum.setZero();
    for (Index j = 0; j < n; ++j) rowsum += M.col(j).cwiseAbs();
    for (Index i = 0; i < n; ++i) rowsum[i] /= row_scale[i];
    return n > 0 ? S(rowsum.sum() - rowsum.sum()) : S(0);
  }

  /// The basis of all w under a covering vector; its right-hand sides are there already.
  template <class Column>
  void load(const VectorMap<S>& row_scale, const VectorMap<S>& column_scale,
            const Column& covering_vector) {
    const Index n = dictionary.size();
    if constexpr (of_groups) {
      fill_columns();
      for (Index j = 0; j < n; ++j) scale_pair(j, row_scale[j]);
    } else if (!holds_problem_) {
      fill_matrix(problem_, MatrixMap<S>(dictionary.table.data(), n, n));
      for (Index j = 0; j < n; ++j)
        dictionary.table.col(j) = dictionary.table.col(j).cwiseProduct(row_scale) * column_scale[j];
    }
    holds_problem_ = false;
    dictionary.table.col(n) = covering_vector;
    dictionary.reset_basis();
  }

  /// Another covering vector: `as_given` in the basis of all w, here(row) in the present one.
  template <class Column, class Here>
  void set_covering_vector(const Column& /*as_given*/, Here here) {
    auto column = dictionary.table.col(dictionary.column_of(artificial(dictionary.size())));
    for (Index i = 0; i < dictionary.size(); ++i) column[i] = here(i);
  }

  /// The column of a nonbasic variable that is to enter.
  Index enter(Index variable) const { return dictionary.column_of(variable); }
  void exchange(Index row, Index column, Index /*entering*/, const VectorMap<S>& scratch) {
    dictionary.exchange(row, column, scratch);
  }
  bool is_basic(Index variable) const { return dictionary.row_of(variable) >= 0; }
  /// Has the basis grown so that factoring it afresh pays?
  bool is_long() const { return false; }
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
  Index factor(Span<Int> target, Span<Int> candidates, const S& smallest_pivot,
               const VectorMap<S>& scratch, const Wanted& /*all come along*/) {
    const Index n = dictionary.size();
    // candidates: rows whose w is to leave; target: columns whose variable is to enter.
    Index wanted = 0, leaving = 0;
    for (Index i = 0; i < n; ++i) candidates[i] = 1;
    for (Index k = 0; k < n; ++k)
      if (target[k] < n) candidates[target[k]] = 0;
    for (Index i = 0; i < n; ++i)
      if (candidates[i] != 0) candidates[leaving++] = static_cast<Int>(i);
    for (Index k = 0; k < n; ++k)
      if (target[k] >= n) target[wanted++] = static_cast<Int>(target[k] - n);
    return exchange_largest(
        candidates, target, wanted, smallest_pivot,
        [&](Index row, Index column) -> const S& { return dictionary.table(row, column); },
        [&](Index row, Index column) { dictionary.exchange(row, column, scratch); });
  }

  /// After factor has left some: makes the basis complementary again, without them. Where w_i
  /// has stayed but z_i has entered, and z_j has not entered but w_j has left, z_i leaves for w_j.
  /// False if that is singular too.
  bool drop_pairs(Index left, Span<Int> target, Span<Int> candidates, const S& smallest_pivot,
                  const VectorMap<S>& scratch) {
    if constexpr (of_groups) return false; // the start is a cold one then
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
  /// The columns of M, by one product each: refinement links that code anyway.
  void fill_columns() {
    const Index n = dictionary.size();
    VectorMap<S> unit(dictionary.table.data() + n * n, n); // where the covering vector will stand
    unit.setZero();
    for (Index j = 0; j < n; ++j) {
      unit[j] = S(1);
      detail::multiply_factored(*problem_.factored, problem_.free_begin, unit.data(),
                                dictionary.table.data() + j * n);
      unit[j] = S(0);
    }
  }
  void scale_pair(Index j, const S& factor) {
    for (Index i = 0; i < dictionary.size(); ++i) {
      dictionary.table(i, j) *= factor;
      dictionary.table(j, i) *= factor;
    }
  }
  /// Row and column j by what brings the largest entry of the column near 1, twice.
  S scale_alike(bool equilibrates, VectorMap<S> scale) {
    const Index n = dictionary.size();
    fill_columns();
    S total(0);
    for (int pass = 0; pass < 2; ++pass)
      for (Index j = 0; j < n; ++j) {
        S largest(0);
        for (Index i = 0; i < n; ++i) {
          const S size = Eigen::numext::abs(dictionary.table(i, j));
          largest = Eigen::numext::maxi(largest, size);
          total += size;
        }
        const S factor = equilibrates ? reciprocal_root(largest) : S(1);
        scale[j] *= factor;
        scale_pair(j, factor);
      }
    return total - total;
  }

  Problem<S> problem_;
  bool holds_problem_ = false; // the table is the scaled M, from scale() to the first load()
};

} // namespace lcpush
