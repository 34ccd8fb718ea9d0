// One quantity along one parameter: pieces on which it is a straight line.
#pragma once

#include <cmath>
#include <functional>

#include "sweep/sweep_solver.hpp"

namespace lcpush::desktop {

/// t runs from 0 at the variation's `from` to 1 at its `to`.
struct Piece {
  double from = 0, to = 1;
  SegmentKind kind = SegmentKind::exact;
  Outputs at_from, at_to; ///< limits from inside; the contacts are those of the middle
  std::string why;        ///< why the path did not simply go on at `to`
};

using Progress = std::function<void(double done)>;

/// `rigid` and `even`, a linear parameter: by parametric pivoting.
std::vector<Piece> exact_pieces(SweepSolver& solver, Quantity quantity, Index most,
                                const Progress& progress);

/// Everything else: by bisection, down to 1e-6 of the range.
std::vector<Piece> bisected_pieces(SweepSolver& solver, Quantity quantity, Index most,
                                   const Progress& progress);

/// The straight line through two answers: at `t` if they are at t0 and t1.
Outputs on_line(const Outputs& first, double t0, const Outputs& second, double t1, double t);

/// Do two answers differ by more than `tolerance` (relative) and what rounding leaves? Of the
/// instant of breaking the normal force alone is compared: the first motion need not be continuous.
bool differ(const Outputs& a, const Outputs& b, Quantity quantity, double tolerance);

/// Does the object move in another way? Both are pushes as prescribed.
bool other_motion(const Outputs& a, const Outputs& b, double tolerance);

/// Pieces that go on in one line in the same modes become one.
std::vector<Piece> joined(const std::vector<Piece>& pieces, Quantity quantity, double tolerance);

/// "right.2 starts to slide along +x, wall.1 separates"; empty if the modes are the same.
std::string change_text(const SceneFile& file, const Outputs& before, const Outputs& after);

/// The parameter's value at t; what rounding leaves of a zero is zero.
inline double value_at(const Variation& variation, double t) {
  if (t <= 0) return variation.from;
  if (t >= 1) return variation.to;
  const double range = variation.to - variation.from, value = variation.from + t * range;
  return std::abs(value) <= 1e-12 * std::abs(range) ? 0 : value;
}

} // namespace lcpush::desktop
