// The numbers of this room.
#pragma once

#include "lcpush/types.hpp"

#include <cstddef>

namespace lcpush::desktop {

struct RawSettings {
  /// What counts as nothing of a covering vector at a point where pivots ended, as the dictionary
  /// is scaled. Not measured.
  double gone = 1e-9;
  /// The residual at which sweeps leave the rest to pivots, and the part of the largest unknown
  /// below which one counts as zero then. Not measured.
  double near_enough = 1e-6;
  /// Sweeps without a better residual, after which they make no more progress. Not measured.
  Index patience = 1000;
  /// The first relaxation of large problems: 420 iterations of an obstacle problem of 10,000 rows.
  double over_relaxation = 1.9;
  /// A pair is decided where its z or w is more than this of the largest on its side, in balanced
  /// scales: rounding leaves less. Undecided ones become a problem of their own, so often: each
  /// level is a thousand million times smaller.
  double clearly = 1e-9;
  int deepest = 4;
  /// Of the points where covering vectors failed, how many are looked at: the last ones.
  std::size_t near_points = 2;
  /// The generic covering vectors of the second search: not those of the first.
  Index first_other_cover = 6, other_covers = 3;
  /// Pseudo-random bases to start from: each is factored afresh. Bimatrix games of 12 take 2.
  Index starts(Index n) const { return n <= 100 ? 48 : n <= 400 ? 24 : n <= 1000 ? 8 : 2; }
  Index first_seed = 1000;              ///< of their pseudo-random numbers
  double shares[3] = {0.5, 0.25, 0.75}; ///< of the unknowns in them, one after the other
  /// All complementary cones are tried up to here: the work doubles with each pair.
  Index pairs_enumerated = 10, rows_enumerated = 24;
  /// Of the terms of a sum along a ray: what is less is 0. A ray's entries have nine digits.
  double rounding = 1e-9;
  /// What least squares leave of a column that is not needed, of the largest.
  double crumb = 1e-13;
  /// Balancing ends when no scale changes by more than this part, and after so many passes: each
  /// halves the logarithm of what is off.
  double balanced = 0.05;
  int balancing_passes = 30;
  /// A row's terms may be so much larger than what is given, q and ends of boxes: then a residual
  /// is a thousandth of that. Matrices singular to rounding have answers of 1e19 in which q is
  /// lost.
  double terms_over_given = 1e6;
  /// An unknown is told to be at an end of its box within this part of itself.
  double at_end = 1e-9;
};

constexpr RawSettings raw_settings;

} // namespace lcpush::desktop
