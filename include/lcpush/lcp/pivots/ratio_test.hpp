// Which basic variable blocks the entering one first? Degeneracy is the norm in contact problems,
// so most of this file is about ties.
#pragma once

#include "lcpush/lcp/blocking.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush {

/// The ratio test over right-hand sides that count in order (each infinitely larger than the next).
/// `has_table`: whole rows can be read, which the lexicographic rule needs.
template <class S, class Int = int, bool has_table = true> class RatioTest {
public:
  /// `rhs_count`: leading columns of dictionary.values that are data; the rest only breaks ties.
  /// `candidates` is scratch for n integers.
  RatioTest(const Dictionary<S, Int>& dictionary, Index rhs_count, TieRule rule,
            const Tolerances<S>& tolerances, Span<Int> candidates)
      : d_(dictionary), rhs_count_(rhs_count), rule_(rule), tolerances_(tolerances),
        candidates_(candidates) {}

  /// Rows whose value falls as the variable of `column` grows; the smallest ratio blocks, and the
  /// artificial variable wins any tie, because then a solution is reached.
  Blocking blocking_row(Index column) { return select(column, S(-1), artificial(d_.size())); }

  /// The row that the artificial variable must repair: its pivot makes every value >= 0.
  Blocking most_violated_row(Index covering_column) { return select(covering_column, S(1), -1); }

  /// After either: the rows that block at the same point, in no order.
  Span<const Int> tied_rows() const { return {candidates_.data, tied_}; }

private:
  const Dictionary<S, Int>& d_;
  Index rhs_count_;
  TieRule rule_;
  Tolerances<S> tolerances_;
  Span<Int> candidates_;
  Index count_ = 0, tied_ = 0;
  const S* entering_ = nullptr;
  S direction_{0};

  S rate(Index row) const { return direction_ * entering_[row]; }

  /// `preferred`: the variable that wins ties, -1 for none.
  Blocking select(Index column, S direction, Index preferred) {
    entering_ = d_.table.data() + column * d_.size();
    direction_ = direction;
    using Column = Eigen::Map<const Eigen::Matrix<S, Eigen::Dynamic, 1>>;
    const S smallest = tolerances_.pivot * Column(entering_, d_.size()).cwiseAbs().maxCoeff();
    count_ = tied_ = 0;
    // Without a branch: about half of the rows fall, and a processor cannot guess which.
    for (Index i = 0; i < d_.size(); ++i) {
      candidates_[count_] = static_cast<Int>(i);
      count_ += rate(i) > smallest ? 1 : 0;
    }
    Blocking blocking;
    if (count_ == 0) return blocking;
    for (Index k = 0; k < rhs_count_ && count_ > 1; ++k) {
      const Index before = count_;
      keep_smallest(d_.values.data() + k * d_.size(), preferred);
      if (k > 0 && count_ < before) blocking.decided_by = TieBreak::right_hand_side;
    }
    blocking.tied = tied_ = count_;
    blocking.row = candidates_[0];
    if (count_ == 1) return blocking;
    for (Index k = 0; k < count_; ++k) {
      if (d_.basic[candidates_[k]] != preferred) continue;
      blocking.row = candidates_[k];
      blocking.decided_by = TieBreak::artificial;
      return blocking;
    }
    blocking.decided_by = break_tie();
    blocking.row = candidates_[0];
    return blocking;
  }

  /// Reduces the tied candidates to one.
  TieBreak break_tie() {
    if (rule_ == TieRule::first_row) return TieBreak::order;
    if constexpr (has_table)
      if (rule_ == TieRule::lexicographic) {
        for (Index i = 0; i < d_.size() && count_ > 1; ++i) keep_lexicographic(i);
        return TieBreak::lexicographic;
      }
    for (Index k = rhs_count_; k < d_.values.cols(); ++k) {
      keep_smallest(d_.values.data() + k * d_.size());
      if (count_ == 1) return TieBreak::tie_column;
    }
    Index best = 0;
    for (Index k = 1; k < count_; ++k)
      if (rate(candidates_[k]) > rate(candidates_[best])) best = k;
    swap(0, best);
    return TieBreak::size;
  }

  /// Column i of the basis inverse: w_i is perturbed by the i-th infinitesimal.
  void keep_lexicographic(Index i) {
    const Index column = d_.column_of(slack(i));
    const Index unit_row = column < 0 ? d_.row_of(slack(i)) : -1;
    keep_smallest([&](Index row) {
      return column >= 0 ? S(-d_.table(row, column)) : row == unit_row ? S(1) : S(0);
    });
  }

  void swap(Index i, Index k) { Eigen::numext::swap(candidates_[i], candidates_[k]); }

  void keep_smallest(const S* values, Index preferred = -1) {
    keep_smallest([&](Index row) -> const S& { return values[row]; }, preferred);
  }

  /// Harris: a bound on the step with the tolerance, then everything at or below that bound. What
  /// is dropped stays behind the rest: tied_rows() shows it.
  template <class Value> void keep_smallest(Value value, Index preferred = -1) {
    // That of the symbolic bound is zero almost everywhere, and then nothing is divided.
    Index first = 0;
    while (first < count_ && value(candidates_[first]) == S(0)) ++first;
    if (first == count_) return;
    S bound = (value(candidates_[0]) + tolerances_.tie) / rate(candidates_[0]);
    for (Index k = 1; k < count_; ++k) {
      const S reached = value(candidates_[k]) + tolerances_.tie, falls = rate(candidates_[k]);
      if (reached < bound * falls) bound = reached / falls; // few rows lower the bound
    }
    Index kept = 0;
    for (Index k = 0; k < count_; ++k) {
      const Index row = candidates_[k];
      const S more = d_.basic[row] == preferred ? tolerances_.finish : S(0);
      if (value(row) <= bound * rate(row) + more) swap(kept++, k);
    }
    count_ = kept;
  }
};

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class Dictionary<double>;
extern template class RatioTest<double>;
#endif

} // namespace lcpush
