// The compact dictionary and its only operation, the exchange.
#include <doctest/doctest.h>

#include "lcpush/desktop/exact_pivots.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "support/dense_lcp.hpp"
#include "support/owned_dictionary.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Rational;

namespace {

OwnedDictionary<double> random_dictionary(Random& random, Index n, Index levels) {
  return {random_matrix(random, n, n + 1), random_matrix(random, n, levels)};
}

/// The largest entry of a column, so that no test divides by a tiny pivot.
Index safe_row(const Dictionary<double>& d, Index column) {
  Index row = 0;
  d.table.col(column).cwiseAbs().maxCoeff(&row);
  return row;
}

/// Values of all 2n + 1 variables when the nonbasic ones are given.
VectorX<double> all_variables(const Dictionary<double>& d, const VectorX<double>& nonbasic,
                              Index level) {
  VectorX<double> x(2 * d.size() + 1);
  const VectorX<double> basic = d.values.col(level) + d.table * nonbasic;
  for (Index c = 0; c < d.nonbasic.size; ++c) x[d.nonbasic[c]] = nonbasic[c];
  for (Index i = 0; i < d.size(); ++i) x[d.basic[i]] = basic[i];
  return x;
}

} // namespace

TEST_CASE("the start basis is all w, its nonbasic variables z and z0") {
  Random random(1);
  const auto start = random_dictionary(random, 4, 1);
  for (Index i = 0; i < 4; ++i) {
    CHECK(start.d.row_of(slack(i)) == i);
    CHECK(start.d.column_of(unknown(i, 4)) == i);
    CHECK(start.d.row_of(unknown(i, 4)) == -1);
    CHECK(complement(slack(i), 4) == unknown(i, 4));
    CHECK(complement(unknown(i, 4), 4) == slack(i));
  }
  CHECK(start.d.column_of(artificial(4)) == 4);
}

TEST_CASE("an exchange at the same place undoes an exchange, exactly in fractions") {
  MatrixX<Rational> table(3, 4), values(3, 2);
  table << 3, -2, 1, 5, 7, 4, -6, 1, -1, 2, 9, 2;
  values << 1, -4, 0, 8, -5, 3;
  for (Index r = 0; r < 3; ++r)
    for (Index c = 0; c < 4; ++c) {
      OwnedDictionary<Rational> dictionary(table, values);
      dictionary.exchange(r, c);
      CHECK(dictionary.table != table);
      CHECK(dictionary.d.basic[r] == (c < 3 ? unknown(c, 3) : artificial(3)));
      CHECK(dictionary.d.nonbasic[c] == slack(r));
      dictionary.exchange(r, c);
      CHECK(dictionary.table == table);
      CHECK(dictionary.values == values);
      CHECK(dictionary.d.basic[r] == slack(r));
    }
}

TEST_CASE("after random pivots every variable still obeys w = q + M z + d z0, at every level") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 9), levels = 3;
    auto dictionary = random_dictionary(random, n, levels);
    const MatrixX<double> table = dictionary.table, values = dictionary.values;
    for (int k = 0; k < 12; ++k) {
      const Index c = random.integer(0, n);
      dictionary.exchange(safe_row(dictionary.d, c), c);
    }
    for (Index level = 0; level < levels; ++level) {
      const VectorX<double> nonbasic = random_vector(random, n + 1);
      const VectorX<double> x = all_variables(dictionary.d, nonbasic, level);
      const VectorX<double> w = values.col(level) + table * x.tail(n + 1);
      CHECK((w - x.head(n)).cwiseAbs().maxCoeff() <= 1e-12 * x.cwiseAbs().maxCoeff() * double(n));
    }
  }
}

TEST_CASE("a pivot whose reciprocal overflows is divided by, not multiplied with") {
  MatrixX<double> table(1, 2), values(1, 1);
  table << 1e-310, 1e-310;
  values << 3e-310;
  OwnedDictionary<double> dictionary(table, values);
  dictionary.exchange(0, 0);
  CHECK(dictionary.table(0, 1) == -1);
  CHECK(dictionary.values(0, 0) == doctest::Approx(-3));
}
