// What a ratio test says: the row that blocks, how many tie with it, and what decided.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

/// What decides between rows that block at the same point.
enum class TieRule {
  generic,       ///< fixed generic right-hand sides, then the largest pivot (floating point)
  lexicographic, ///< the rows of the basis inverse (exact arithmetic; never cycles)
  first_row,     ///< the first tied row: for showing that this can cycle
};

/// Why the chosen row and no other.
enum class TieBreak { none, right_hand_side, artificial, tie_column, lexicographic, size, order };

struct Blocking {
  Index row = -1; ///< -1: nothing blocks
  Index tied = 0; ///< rows that block at the same point, itself included
  TieBreak decided_by = TieBreak::none;
};

} // namespace lcpush
