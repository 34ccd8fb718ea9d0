// Which columns are independent of those before them? Gram and Schmidt, one column after the other.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

/// The first `count` columns of Q are orthonormal and span the columns that were taken.
template <class S> class IndependentColumns {
public:
  /// Memory for `rows` columns.
  IndependentColumns(Span<S> memory, Index rows) : Q_(memory.data, rows, rows) {}

  Index count() const { return count_; }
  void keep(Index count) { count_ = count; } ///< the first `count` of them
  auto direction(Index k) const { return Q_.col(k); }

  /// Takes a column of which more than the part `dependent` lies outside of what the others span;
  /// twice made orthogonal, for the digits. `parts`, if given, becomes the column as the sum of
  /// parts[k] direction(k), k <= count. Pre: count < Q's columns.
  template <class Column> bool take(const Column& column, const S& dependent, S* parts = nullptr) {
    Q_.col(count_) = column;
    auto rest = Q_.col(count_);
    const S size = rest.norm();
    for (Index k = 0; parts != nullptr && k < count_; ++k) parts[k] = S(0);
    for (int pass = 0; pass < 2; ++pass)
      for (Index k = 0; k < count_; ++k) {
        const S part = Q_.col(k).dot(rest);
        if (parts != nullptr) parts[k] += part;
        rest -= part * Q_.col(k);
      }
    const S left = rest.norm();
    if (!(left > dependent * size)) return false;
    rest /= left;
    if (parts != nullptr) parts[count_] = left;
    ++count_;
    return true;
  }

  /// What of `column` lies outside of what they span.
  void remove_from(VectorMap<S>& column) const {
    for (int pass = 0; pass < 2; ++pass)
      for (Index k = 0; k < count_; ++k) column -= Q_.col(k).dot(column) * Q_.col(k);
  }

private:
  MatrixMap<S> Q_;
  Index count_ = 0;
};

} // namespace lcpush
