// One question's answers along one parameter: pieces on which they are a straight line.
#pragma once

#include <cmath>
#include <functional>

#include "sweep/settings.hpp"
#include "sweep/sweep_solver.hpp"

namespace lcpush::desktop {

/// The straight line through two answers: at `t` if they are at t0 and t1.
DetailedAnswer on_line(const DetailedAnswer& first, double t0, const DetailedAnswer& second,
                       double t1, double t);

/// t runs from 0 at the variation's `from` to 1 at its `to`.
struct Piece {
  double from = 0, to = 1;
  SegmentKind kind = SegmentKind::exact;
  DetailedAnswer at_from{}, at_to{}; ///< limits from inside; the contacts are those of the middle
  PathBreak path = PathBreak::none;  ///< at `to`

  bool is_unsolved() const { return kind == SegmentKind::unsolved; }
  DetailedAnswer at(double t) const { return on_line(at_from, from, at_to, to, t); }
};

using Progress = std::function<void(double done)>;
/// Tells of a part of the work as of `share` of the whole, from `begin` on.
inline Progress part_of(const Progress& whole, double begin, double share) {
  return [&whole, begin, share](double done) {
    if (whole) whole(begin + share * done);
  };
}

/// `rigid` and `even`, a linear parameter: by parametric pivoting.
std::vector<Piece> exact_pieces(SweepSolver& solver, Question question, const Progress& progress);

/// Do two answers differ by more than `tolerance` (relative) and what rounding leaves? Of the
/// instant of breaking the normal force alone is compared: the first motion need not be continuous.
bool differ(const SweepAnswer& a, const SweepAnswer& b, Question question, double tolerance);

/// Is what both ways tell at one value the same? Bistable is where it is not.
bool same_answer(const SweepAnswer& a, const SweepAnswer& b, Question question);

/// Have both answers the same status, and their contacts the same modes?
bool same_modes(const DetailedAnswer& a, const DetailedAnswer& b);

/// What happens from the one answer to the other, without jumps.
AnswerChange change_between(const DetailedAnswer& before, const DetailedAnswer& after);

/// Pieces that go on in one line in the same modes become one.
std::vector<Piece> joined(const std::vector<Piece>& pieces, Question question, double tolerance);

/// What the sweep tells of an answer: of one that is not solved the status alone; of noise 0.
SweepAnswer told(const DetailedAnswer& answer);

/// What the way there and the way back find in one part of the range, or at one value.
struct TwoWays {
  double from, to; ///< of the parameter
  SweepValue there, back;
};
/// The ranges in which they find different answers; `list` follows the sweep.
/// Ranges with a gap of at most `near` between them are one: no shorter stretch is told apart.
std::vector<BistableRange> disagreements(const std::vector<TwoWays>& list, double near);

/// Do both push the object as prescribed, and does it move in another way?
bool moves_otherwise(const SweepValue& a, const SweepValue& b);

/// The same range, the other way.
inline Variation reversed(const Variation& variation) {
  return {variation.parameter, variation.to, variation.from};
}

/// The parameter's value at t; what rounding leaves of a zero is zero.
inline double value_at(const Variation& variation, double t) {
  if (t <= 0) return variation.from;
  if (t >= 1) return variation.to;
  const double range = variation.to - variation.from, value = variation.from + t * range;
  return std::abs(value) <= SweepSettings::value_rounding * std::abs(range) ? 0 : value;
}

} // namespace lcpush::desktop
