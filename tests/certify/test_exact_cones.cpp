#include "certify/exact_cones.hpp"

#include <doctest/doctest.h>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

using Columns = std::vector<std::vector<Rational>>;

Rational typed(const char* text) { return *Rational::parse(text); }

Rational product(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

} // namespace

TEST_CASE("what no sum of the columns reaches is separated from them exactly") {
  const Columns columns = {{1, 0, typed("0.1")}, {0, 1, typed("0.1")}, {-1, -1, typed("0.1")}};
  const std::vector<Rational> below = {typed("0.3"), typed("0.2"), -1};
  const auto y = separation(columns, below);
  REQUIRE(y);
  CHECK(product(*y, below) > Rational(0));
  for (const std::vector<Rational>& column : columns) CHECK(product(*y, column) <= Rational(0));
  CHECK(!separation(columns, {0, 0, 1}));
  CHECK(!separation({{1, 0}}, {1, 0}));
}

// In doubles these columns cannot reach b; with weights of 1e10 and more they do.
TEST_CASE("doubles that see no way to reach a load prove nothing") {
  CHECK(!separation({{1, 0}, {-1, typed("1e-10")}}, {0, 1}));
  const Rational tiny = typed("1e-12");
  CHECK(!separation({{-1, 0, 0}, {1, tiny, 0}, {0, -1, typed("1e-7")}}, {0, typed("1e-6"), 1}));
}
