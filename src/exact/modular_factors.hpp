// A sparse matrix modulo 2^61 - 1, factored.
#pragma once

#include "exact/modular.hpp"
#include "lcpush/types.hpp"

#include <vector>

namespace lcpush::desktop {

/// A = L U by rows and columns in the order that keeps both sparse: the next pivot is in the
/// shortest row that is left, and there in the column of the fewest rows (Markowitz).
class ModularFactors {
public:
  struct Entry {
    Index at; // a column, or of a step of elimination the row
    modular::Limb value;
  };
  using Row = std::vector<Entry>;

  /// `rows` is n x n, none of its entries zero.
  explicit ModularFactors(std::vector<Row> rows);

  bool is_singular() const { return is_singular_; }
  /// b becomes x with A x = b. Pre: not singular.
  void solve(std::vector<modular::Limb>& b) const;

private:
  struct Step {
    std::size_t row, column;
    modular::Limb inverse; // of the pivot
    Row eliminates;        // how often this row was taken from which rows
  };
  std::vector<Row> rows_; // when they became pivots, without these
  std::vector<Step> steps_;
  bool is_singular_ = false;
};

} // namespace lcpush::desktop
