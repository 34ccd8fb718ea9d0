// The problems of fixtures/textbook; each file's second line says what it shows and its source.
#pragma once

#include <string>

#include "lcpush/desktop/matrix_market.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

inline MatrixX<double> read_matrix(const std::string& path) {
  const desktop::HostMatrix matrix = desktop::read_matrix_market(path);
  return Eigen::Map<const MatrixX<double>>(matrix.values.data(), matrix.rows, matrix.cols);
}

/// fixtures/textbook/NAME.M.mtx and NAME.q.mtx.
inline DenseLcp<double> textbook(const std::string& name) {
  const std::string stem = std::string(LCPUSH_SOURCE_DIR) + "/fixtures/textbook/" + name;
  return {read_matrix(stem + ".M.mtx"), read_matrix(stem + ".q.mtx")};
}

} // namespace lcpush::test
