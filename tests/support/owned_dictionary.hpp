// A dictionary with memory of its own, for the tests of the pivot and the ratio test.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "lcpush/lcp/pivots/dictionary.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

/// A dictionary that owns its memory, filled with table [M d] and right-hand sides.
template <class S> struct OwnedDictionary {
  MatrixX<S> table, values;
  VectorX<S> scratch;
  std::vector<int> basic, nonbasic;
  Dictionary<S> d;

  OwnedDictionary(const MatrixX<S>& full_table, const MatrixX<S>& right_hand_sides)
      : table(full_table), values(right_hand_sides), scratch(table.rows()),
        basic(static_cast<std::size_t>(table.rows())),
        nonbasic(static_cast<std::size_t>(table.cols())) {
    new (&d.table) MatrixMap<S>(table.data(), table.rows(), table.cols());
    new (&d.values) MatrixMap<S>(values.data(), values.rows(), values.cols());
    d.basic = {basic.data(), table.rows()};
    d.nonbasic = {nonbasic.data(), table.cols()};
    d.reset_basis();
  }
  OwnedDictionary(const OwnedDictionary& other) : OwnedDictionary(other.table, other.values) {}
  OwnedDictionary& operator=(const OwnedDictionary&) = delete;
  void exchange(Index r, Index c) {
    d.exchange(r, c, VectorMap<S>(scratch.data(), scratch.size()));
  }
};

} // namespace lcpush::test
