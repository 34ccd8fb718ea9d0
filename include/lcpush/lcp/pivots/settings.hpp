// Every number of the pivots that is not a tolerance (tolerances.hpp), with its reason. None has a
// unit: pivots, rows and factors of scaled data. "Not measured": no recorded figure chose it.
#pragma once

#include <Eigen/Core>

#include "lcpush/types.hpp"

namespace lcpush {

/// Of Lemke's method.
struct LemkeSettings {
  /// Covering vectors tried before a failure is reported: with six, 10,000 of 10,000 random grasps
  /// are solved under every law (docs/theory/numerics.md). Fewer are not measured.
  static constexpr Index covers = 6;
  /// Pivots under one covering vector, at most: 1000 + 50 n. Random pushes take about a hundred
  /// and at most 5775 of them (docs/theory/numerics.md). The slope is not measured.
  static constexpr Index pivots = 1000, pivots_an_unknown = 50;
  static constexpr Index most_pivots(Index n) { return pivots + pivots_an_unknown * n; }
  /// Pivots between two looks at how far rounding has moved the values: a look costs one product.
  /// Not measured.
  static constexpr Index pivots_between_looks = 64;
  /// Values that are off by so many tie tolerances have drifted. Not measured.
  static constexpr int drift = 100;
  /// Passes of equilibration, at most. Not measured.
  static constexpr int equilibrations = 3;
  /// Passes of iterative refinement; it ends as soon as one gains nothing. More, while what is left
  /// would pass barely and each halves it. Points beside the centre of a turn slip 1e5 times as
  /// slowly as others, and their round friction leaves a thirtieth a pass.
  static constexpr int refinements = 4;
  /// How often an answer that fails its check is factored afresh and pivoted on from, with tie
  /// tolerances that are smaller by `closer` each time and zero the last time.
  static constexpr Index repairs = 3;
  static constexpr int closer = 1 << 10;
  /// An answer whose residual is above the tolerance over this has passed barely: a tie may hide a
  /// small violation. Not measured.
  static constexpr int barely = 16;
};

/// Of the structured basis.
struct StructuredSettings {
  /// Exchanges that the memory holds where the caller does not say: K^-1 of 256 rows takes 0.5 MB.
  /// A limit of memory (docs/decisions/0007-structured-basis.md).
  static constexpr Index exchanges = 256;
  /// Exchanges before the first factoring: the answer of a small problem has no more.
  static constexpr Index exchanges_at_first = 64;
  /// Exchanges from one factoring to the next: some fifty cost as much as it (numerics.md).
  static constexpr Index exchanges_between = 48;
  /// Corrections of values for rounding in K^-1, while more than that of the largest is left of
  /// them. Not measured.
  static constexpr int corrections = 2;
  template <class S> static S rounding() { return Eigen::NumTraits<S>::epsilon(); }
  /// From so many contacts on pads with a pressing point are pivoted as springs: fewer are cheaper
  /// as exchanges.
  static constexpr Index contacts_with_springs = 24;
  /// Actuators that drive several contacts each, at most, where pads are springs: their matrix
  /// stands on the stack. A hand has a few.
  static constexpr int actuators_with_springs = 32;
  /// Work, with all that goes with it: of a product with the local form a row and an input, of a
  /// factoring a row beside t^3. Fitted to a Cortex-M4F's instructions: 90 % of solves are within a
  /// tenth of theirs (docs/embed/tables.md, "Work").
  static constexpr Index work_a_row = 10, work_an_input = 70, work_a_factored_row = 80;
};

/// Of a look at a basis that may still hold.
struct HeldSettings {
  /// What rounding leaves of a product with values about 1.
  template <class S> static S rounding() { return S(64) * Eigen::NumTraits<S>::epsilon(); }
};

/// Of a path along a line of right-hand sides.
struct PathSettings {
  /// An answer that moves by so many tie tolerances at a breakpoint has jumped.
  static constexpr int jump = 1000;
  /// Pivots at one breakpoint, at most: 100 + 4 n. More is a cycle.
  static constexpr Index pivots = 100, pivots_an_unknown = 4;
  static constexpr Index most_pivots(Index n) { return pivots + pivots_an_unknown * n; }
};

} // namespace lcpush
