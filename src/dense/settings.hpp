// The numbers of small dense systems and linear programs. They are parts of numbers near 1.
#pragma once

#include <algorithm>
#include <limits>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct DenseSettings {
  static constexpr double digits_left = 1e-8; ///< of a squared norm: half of its digits are gone
  /// Rows that stay in a processor's cache while those above pass by: 3,000 numbers each are 400
  /// kB; and rows above that are subtracted in one pass: half the time of one by one.
  static constexpr Index rows_at_once = 16, rows_together = 4, vector_step = 8;
  static constexpr double diagonal =
      0.1; ///< of a row's largest: is the pivot, and bands stay bands
  /// Of the largest pivot: below it a diagonal entry is rounding's alone.
  static constexpr double rounding(Index rows, Index columns) {
    return std::numeric_limits<double>::epsilon() * static_cast<double>(std::min(rows, columns));
  }
};

/// Of the tableau of a linear program whose rows and columns are near 1.
struct SimplexSettings {
  static constexpr double pivot = 1e-9;  ///< a smaller entry is what eliminating has left of a zero
  static constexpr double price = 1e-10; ///< a reduced cost below it gains nothing
  static constexpr double tie = 1e-12;   ///< of the ratio test: the largest pivot leaves
  static constexpr double agrees = 1e-10;  ///< left of an equation or a sign: it holds
  static constexpr double balances = 2e-9; ///< of a point as a whole, in sums and signs: numbers in
                                           ///< ten digits leave so much
  static constexpr double contradicts = 1e-8; ///< it does not; in between nothing is claimed
  static constexpr double proof = 1e-8;       ///< of a reduced cost that is computed afresh
  /// More pivots than these go in circles; the programs of fixtures take 3 a row.
  static constexpr Index pivots = 400, pivots_a_row = 40;
};

} // namespace lcpush::desktop
