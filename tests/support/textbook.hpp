// The problems of fixtures/textbook; each file's second line says what it shows and its source.
#pragma once

#include <string>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"
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

inline DenseLcp<desktop::Rational> in_fractions(const DenseLcp<double>& lcp) {
  return {lcp.M.cast<desktop::Rational>(), lcp.q.cast<desktop::Rational>()};
}

/// As the books run it: their cover, no scaling.
template <class S> LemkeOptions<S> book_options(const VectorX<S>& cover, TieRule rule) {
  LemkeOptions<S> options;
  options.cover = cover.data();
  options.equilibrate = false;
  options.tie_rule = rule;
  options.max_pivots = 5000;
  return options;
}

} // namespace lcpush::test
