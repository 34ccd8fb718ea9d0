// lcpush: matrices in files and on the command line.
//
// Matrix Market (https://math.nist.gov/MatrixMarket/formats.html), `matrix array|coordinate
// real|integer general`; everything else is refused by name. A vector is an n x 1 matrix.
#pragma once

#include "lcpush/desktop/rational.hpp"
#include "lcpush/types.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lcpush::desktop {

/// Most rows or columns that are read: 20,000 x 20,000 doubles are 3.2 GB.
constexpr Index largest_dimension = 20000;

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

// Numbers come as S = double, the nearest, or as S = Rational: then every decimal is taken as
// typed, so that 0.2 is 1/5.

/// Every entry is finite, none is missing, none comes twice. Throws InputError otherwise, and
/// allocates nothing for a size that the file is too short for.
template <class S = double> MatrixOf<S> read_matrix_market(const std::string& path);

/// The same for a text; `file_name` only names it in messages.
HostMatrix parse_matrix_market(const std::string& text, const std::string& file_name);

/// Rows by `;`, numbers by blanks or commas: "2 1; 1 2", fractions among them: "1/3". `option`
/// names the text in messages.
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
