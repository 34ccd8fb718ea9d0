// Matrices as Matrix Market text.
#include "lcpush/desktop/matrix_market.hpp"

#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

SparseRows rows_of(const HostMatrix& matrix) {
  SparseRows rows;
  rows.cols = matrix.cols;
  for (Index i = 0; i < matrix.rows; ++i) {
    for (Index j = 0; j < matrix.cols; ++j)
      if (matrix(i, j) != 0) rows.add(j, matrix(i, j));
    rows.end_row();
  }
  return rows;
}

std::string write_matrix_market(const HostMatrix& matrix, MatrixMarketFormat format,
                                const std::string& comment) {
  const bool is_array = format == MatrixMarketFormat::array;
  const auto is_written = [is_array](double value) {
    return is_array || value != 0 || std::signbit(value);
  };
  std::string text = "%%MatrixMarket matrix ";
  text += is_array ? "array real general\n" : "coordinate real general\n";
  if (!comment.empty()) text += "% " + comment + "\n";
  text += std::to_string(matrix.rows) + " " + std::to_string(matrix.cols);
  if (!is_array)
    text +=
        " " + std::to_string(std::count_if(matrix.values.begin(), matrix.values.end(), is_written));
  text += '\n';
  for (Index j = 0; j < matrix.cols; ++j)
    for (Index i = 0; i < matrix.rows; ++i) {
      if (!is_written(matrix(i, j))) continue;
      if (!is_array) text += std::to_string(i + 1) + " " + std::to_string(j + 1) + " ";
      text += shown(matrix(i, j)) + "\n";
    }
  return text;
}

} // namespace lcpush::desktop
