// The compact dictionary: n basic variables written in terms of n + 1 nonbasic ones,
//
//     x_basic = values + table x_nonbasic,
//
// over the 2n + 1 variables w_0..w_{n-1}, z_0..z_{n-1}, z0. Only the n x (n+1) table and the
// right-hand sides are stored; basic columns are unit vectors and need no memory.
#pragma once

#include "lcpush/lcp/loops.hpp"
#include "lcpush/lcp/memory.hpp"

namespace lcpush {

/// Numbers of variables: w_i is i, z_i is n + i, the artificial variable z0 is 2n.
constexpr Index slack(Index i) { return i; }
constexpr Index unknown(Index i, Index n) { return n + i; }
constexpr Index artificial(Index n) { return 2 * n; }
constexpr Index complement(Index variable, Index n) {
  return variable < n ? variable + n : variable - n;
}

/// Right-hand sides whose values a factorisation is asked for: from `first` on those before `exact`
/// to rounding, those before `end` as they come.
struct Wanted {
  Index first, exact, end;
};

/// `Int` numbers variables, rows and columns.
template <class S, class Int = int> class Dictionary {
public:
  MatrixMap<S> table{nullptr, 0, 0};  ///< n x (n + 1), or the columns that its owner needs
  MatrixMap<S> values{nullptr, 0, 0}; ///< n x rhs_count, one column a right-hand side
  Span<Int> basic;                    ///< n: the variable of each row
  Span<Int> nonbasic;                 ///< n + 1: the variable of each column

  void carve(Index n, Index columns, Index rhs_count, Block<S>& scalars, Block<Int>& integers) {
    scalars.seat(table, n, columns);
    scalars.seat(values, n, rhs_count);
    basic = integers.take(n);
    nonbasic = integers.take(columns);
  }

  Index size() const { return table.rows(); }

  /// The basis of all w: rows w_i, columns z_i and z0.
  void reset_basis() {
    const Index n = size();
    for (Index i = 0; i < n; ++i) {
      basic[i] = static_cast<Int>(slack(i));
      nonbasic[i] = static_cast<Int>(unknown(i, n));
    }
    nonbasic[n] = static_cast<Int>(artificial(n));
  }

  Index row_of(Index variable) const { return find(basic, variable); }
  Index column_of(Index variable) const { return find(nonbasic, variable); }

  /// The pivot: the variable of column c becomes basic in row r, the one of row r nonbasic.
  /// `entering` is scratch for n Scalars. Cost: n (n + 1) multiply-adds, less for zeros in row r.
  void exchange(Index r, Index c, VectorMap<S> entering) {
    entering = table.col(c);
    const S pivot = entering[r];
    // Dividing by the pivot, not multiplying with its reciprocal: 1/pivot may overflow.
    auto eliminate = [&](auto given) {
      S* const column = given.data();
      if (column[r] == S(0)) return;
      const S solved = -column[r] / pivot;
      detail::add_scaled(column, entering.data(), solved, size());
      column[r] = solved;
    };
    for (Index j = 0; j < table.cols(); ++j)
      if (j != c) eliminate(table.col(j));
    for (Index k = 0; k < values.cols(); ++k) eliminate(values.col(k));
    table.col(c) = entering / pivot;
    table(r, c) = S(1) / pivot;
    Eigen::numext::swap(basic[r], nonbasic[c]);
  }

private:
  static Index find(const Span<Int>& variables, Index variable) {
    for (Index i = 0; i < variables.size; ++i)
      if (variables[i] == variable) return i;
    return -1;
  }
};

} // namespace lcpush
