// Matrices in Matrix Market files (real or integer; general, symmetric or skew-symmetric; array or
// coordinate) and typed in place. Anything else is refused by name. A vector is an n x 1 matrix.
#pragma once

#include "lcpush/desktop/rational.hpp"
#include "lcpush/types.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// Most rows or columns of a matrix that is stored whole: 20,000 x 20,000 doubles are 3.2 GB.
constexpr Index largest_dimension = 20000;
/// The same where only the entries that are not zero are stored.
constexpr Index largest_sparse_dimension = 1000000;

template <class S> struct MatrixOf {
  Index rows = 0;
  Index cols = 0;
  std::vector<S> values; ///< column-major, rows x cols

  const S& operator()(Index i, Index j) const {
    return values[static_cast<std::size_t>(j * rows + i)];
  }
};
using HostMatrix = MatrixOf<double>;
using ExactMatrix = MatrixOf<Rational>;

struct SparseEntry {
  int column;
  double value;
};

/// A matrix row by row, without its zeros; the columns of a row ascend.
struct SparseRows {
  Index cols = 0;
  std::vector<SparseEntry> entries;
  std::vector<std::size_t> begins{0}; ///< rows + 1: where the entries of a row begin

  Index rows() const { return static_cast<Index>(begins.size()) - 1; }
  Span<const SparseEntry> row(Index i) const {
    const std::size_t begin = begins[static_cast<std::size_t>(i)];
    const std::size_t end = begins[static_cast<std::size_t>(i) + 1];
    return {entries.data() + begin, static_cast<Index>(end - begin)};
  }
  /// 0 where there is none. Cost: a pass over the row.
  double operator()(Index i, Index j) const {
    for (const SparseEntry& entry : row(i))
      if (entry.column == j) return entry.value;
    return 0;
  }
  /// Building: entries of the row that is open, then its end.
  void add(Index column, double value) { entries.push_back({static_cast<int>(column), value}); }
  void end_row() { begins.push_back(entries.size()); }
  /// A whole row, without its zeros.
  template <class Row> void add_row(const Row& row) {
    for (Index j = 0; j < row.size(); ++j)
      if (row[j] != 0) add(j, row[j]);
    end_row();
  }
};

SparseRows rows_of(const HostMatrix& matrix);

// Numbers come as S = double, the nearest, or as S = Rational: then every decimal is taken as
// typed, so that 0.2 is 1/5.

/// May entries be inf and -inf, as in a list of bounds?
enum class Entries { finite, bounds };

/// Every entry is finite, none is missing, none comes twice; "-" is standard input. Throws
/// InputError otherwise, and allocates nothing for a size that the file is too short for.
template <class S = double>
MatrixOf<S> read_matrix_market(const std::string& path, Entries kind = Entries::finite);

/// The same, without its zeros.
SparseRows read_sparse_matrix(const std::string& path);

/// The same for a text; `file_name` only names it in messages.
HostMatrix parse_matrix_market(const std::string& text, const std::string& file_name);
SparseRows parse_sparse_matrix(const std::string& text, const std::string& file_name);

/// MATLAB's "[2 1; 1 2]" and Python's "[[2, 1], [1, 2]]" as "2 1; 1 2"; other texts as they are.
std::string without_brackets(std::string_view text);

/// Rows by `;`, numbers by blanks or commas: "2 1; 1 2", fractions among them: "1/3"; brackets
/// around them may stand. `option` names the text in messages.
template <class S = double>
MatrixOf<S> parse_inline_matrix(std::string_view text, const std::string& option);

/// One row or one column, "-5 -6" or "-5; -6", as an n x 1 matrix.
template <class S = double>
MatrixOf<S> parse_inline_vector(std::string_view text, const std::string& option);

enum class MatrixMarketFormat {
  array,      ///< every entry
  coordinate, ///< the entries that are not zero
};

/// The text that reads back as the same doubles. `comment` is one line, or empty for none.
std::string write_matrix_market(const HostMatrix& matrix, MatrixMarketFormat format,
                                const std::string& comment);

} // namespace lcpush::desktop
