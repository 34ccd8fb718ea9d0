// Lemke's method in fractions, without a fraction in its dictionary.
//
// The entries of a row are whole numbers over one denominator. A pivot multiplies and subtracts,
// and takes out of every row that it changes what divides all of it: a greatest common divisor a
// row instead of several an entry. [Edmonds 1967; with one denominator for all rows, Bareiss 1968
// and Avis's lrs, sparse problems would get longer numbers than fractions in lowest terms.]
#pragma once

#include <vector>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/desktop/rational.hpp"

namespace lcpush::desktop {

/// A fraction as it stands, for the moment.
struct Quotient {
  const BigInteger &above, &below; ///< below > 0
};

/// Lemke<Rational> of the core under one covering vector, pivot for pivot, as RecordingWatcher
/// knows it.
class ExactLemke {
public:
  explicit ExactLemke(Index n);

  /// Pre: options.cover, and a tie rule that needs no generic columns.
  [[nodiscard]] Status init(const Problem<Rational>& problem,
                            const LemkeOptions<Rational>& options);
  /// At most one pivot. The watcher outlives the call.
  template <class Watcher> [[nodiscard]] Status step(Watcher& watcher) {
    if (status_ != Status::running) return status_;
    if (entering_ < 0) watcher.starts(*this);
    if (find_pivot()) exchange(watcher.choose_leaving_row(*this, pending_));
    watcher.stepped(*this);
    return status_;
  }

  Status status() const { return status_; }
  Reason reason() const { return reason_; }
  Index covers_tried() const { return 1; }
  bool is_basic(Index i) const { return dictionary_.row_of(unknown(i, n_)) >= 0; }
  /// Which variables are basic, and the signs and ratios of a row; see entry() and value().
  const Dictionary<Rational>& dictionary() const { return dictionary_; }
  Rational slack_unit(Index) const { return 1; }
  Rational unknown_unit(Index) const { return 1; }

  /// basic = value + entries * nonbasic.
  Quotient entry(Index row, Index column) const {
    return {dictionary_.table(row, column).numerator(), denominator(row)};
  }
  Quotient value(Index row, Index right_hand_side) const {
    return {dictionary_.values(row, right_hand_side).numerator(), denominator(row)};
  }
  /// How far a column's variable grows until the row is zero.
  Rational ratio(Index row, Index column, Index right_hand_side) const {
    return {-dictionary_.values(row, right_hand_side).numerator(),
            dictionary_.table(row, column).numerator()};
  }

  const Rational* z() const { return solution_.data(); } ///< after solved
  const Rational* ray() const { return ray_.data(); }    ///< after ray: largest entry 1
  const Rational& ray_artificial() const { return ray_artificial_; }

private:
  Index n_, free_begin_ = 0, rhs_count_ = 1, pivots_ = 0, limit_ = 0, entering_ = -1;
  TieRule rule_ = TieRule::lexicographic;
  Status status_ = Status::bad_input;
  Reason reason_ = Reason::none;
  SolverMemory<Rational> memory_;
  Dictionary<Rational> dictionary_;     // whole numbers: a row's true ones times its denominator
  std::vector<BigInteger> denominator_; // a row, > 0
  std::vector<Rational> solution_, ray_;
  Rational ray_artificial_;
  PendingPivot pending_{};
  Span<int> candidates_;

  void end(Status status, Reason reason = Reason::none);
  void make_whole(Index row);
  bool find_pivot();
  bool find_first_pivot(RatioTest<Rational>& test);
  void exchange(Index row);
  void subtract(Index row, Index from);
  void shorten(Index row);
  void accept();
  void conclude_ray(Index column);
  const BigInteger& denominator(Index row) const {
    return denominator_[static_cast<std::size_t>(row)];
  }
  /// All numbers of a row but its denominator: of the columns, then of the right-hand sides.
  Index width() const { return n_ + 1 + rhs_count_; }
  Rational& number(Index row, Index k) {
    return k <= n_ ? dictionary_.table(row, k) : dictionary_.values(row, k - n_ - 1);
  }
};

} // namespace lcpush::desktop
