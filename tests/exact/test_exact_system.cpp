#include "exact/exact_system.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

using Dense = std::vector<std::vector<Rational>>;

std::vector<ExactRow> sparse(const Dense& matrix) {
  std::vector<ExactRow> rows;
  for (const std::vector<Rational>& from : matrix) {
    ExactRow& row = rows.emplace_back();
    for (std::size_t j = 0; j < from.size(); ++j)
      if (from[j].sign() != 0) row.push_back({static_cast<Index>(j), from[j]});
  }
  return rows;
}

std::vector<Rational> product(const Dense& A, const std::vector<Rational>& x) {
  std::vector<Rational> result;
  for (const std::vector<Rational>& row : A) {
    Rational sum = 0;
    for (std::size_t j = 0; j < x.size(); ++j) sum += row[j] * x[j];
    result.push_back(sum);
  }
  return result;
}

} // namespace

TEST_CASE("a system with fractions of many denominators is solved without any error") {
  std::mt19937 random(1);
  const auto fraction = [&] {
    return Rational(static_cast<int>(random() % 2001) - 1000) /
           Rational(static_cast<int>(random() % 999) + 1);
  };
  for (std::size_t n = 1; n <= 12; ++n) {
    Dense A(n, std::vector<Rational>(n));
    std::vector<Rational> x(n);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = fraction();
      for (std::size_t j = 0; j < n; ++j)
        if (random() % 3 > 0 || i == j) A[i][j] = fraction();
      A[i][i] += 3000; // regular
    }
    const auto solution = ExactSystem(sparse(A)).solve(product(A, x));
    REQUIRE(solution);
    CHECK(*solution == x);
  }
}

TEST_CASE("Hilbert's matrix, whose inverse doubles lose, is inverted") {
  constexpr std::size_t n = 20;
  Dense H(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      H[i][j] = Rational(1) / Rational(static_cast<int>(i + j + 1));
  std::vector<Rational> ones(n, Rational(1));
  const auto solution = ExactSystem(sparse(H)).solve(product(H, ones));
  REQUIRE(solution);
  CHECK(*solution == ones);
}

TEST_CASE("a singular matrix is refused, and its largest minor has its rank") {
  const Dense A = {{1, 2, 3}, {2, 4, 6}, {0, 1, 1}};
  const ExactSystem system(sparse(A));
  CHECK(system.is_singular());
  CHECK(!system.solve({1, 1, 1}));
  const ExactMinor minor = largest_minor(sparse(A), 3);
  CHECK(minor.rows == std::vector<std::size_t>{0, 2});
  CHECK(minor.columns == std::vector<std::size_t>{0, 1});
}
