// Complete pivoting: which entry of a matrix is the largest in size.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

template <class S> struct LargestEntry {
  S size;
  Index row = -1, column = -1; ///< -1: no entry is above the bound
};

/// The first entry(i, j) of the largest size above `bound`, column by column.
template <class S, class Entry>
LargestEntry<S> largest_entry(Index rows, Index columns, const S& bound, Entry entry) {
  LargestEntry<S> largest{bound};
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) {
      const S size = Eigen::numext::abs(entry(i, j));
      if (size > largest.size) largest = {size, i, j};
    }
  return largest;
}

/// Exchanges rows for columns, the largest entry first, until none above `bound` is left:
/// entry(row, column) and exchange(row, column) for the numbers in the lists, `count` each. Returns
/// how many of each are left; they come first.
template <class S, class Int, class Entry, class Exchange>
Index exchange_largest(Span<Int> rows, Span<Int> columns, Index count, const S& bound, Entry entry,
                       Exchange exchange) {
  for (; count > 0; --count) {
    const LargestEntry<S> pivot = largest_entry(
        count, count, bound, [&](Index i, Index j) { return S(entry(rows[i], columns[j])); });
    if (pivot.row < 0) break;
    exchange(rows[pivot.row], columns[pivot.column]);
    rows[pivot.row] = rows[count - 1];
    columns[pivot.column] = columns[count - 1];
  }
  return count;
}

} // namespace lcpush
