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
    const auto solution = exact_solutions(sparse(A), {product(A, x)});
    REQUIRE(solution);
    CHECK(solution->front() == x);
  }
}

TEST_CASE("a sparse system, its digits long and of both signs, is solved without any error") {
  std::mt19937 random(2);
  const auto decimal = [&] { // 16 digits and a sign, as a coordinate is typed
    return Rational(static_cast<long long>(random()) * 2097152 - (1LL << 52U)) /
           Rational(1'000'000'000'000'000LL);
  };
  for (std::size_t n = 20; n <= 80; n += 20) {
    std::vector<ExactRow> rows(n);
    std::vector<Rational> b(n);
    for (std::size_t i = 0; i < n; ++i) {
      b[i] = decimal();
      for (int k = 0; k < 5; ++k) // a column may be named twice: then the sum counts
        rows[i].push_back({static_cast<Index>(random() % n), decimal()});
      rows[i].push_back({static_cast<Index>((i + 7) % n), 3});
      rows[i].push_back({static_cast<Index>((i + 7) % n), decimal()});
    }
    const auto x = exact_solutions(rows, {b});
    REQUIRE(x);
    for (std::size_t i = 0; i < n; ++i) {
      Rational sum = 0;
      for (const ExactEntry& entry : rows[i])
        sum += entry.value * x->front()[static_cast<std::size_t>(entry.column)];
      CHECK(sum == b[i]);
    }
    // A row twice: no inverse. The last one is a sum of two others.
    rows.back() = rows[0];
    rows.back().insert(rows.back().end(), rows[1].begin(), rows[1].end());
    CHECK(!exact_solutions(rows, {b}));
  }
}

TEST_CASE("Hilbert's matrix, whose inverse doubles lose, is inverted") {
  constexpr std::size_t n = 20;
  Dense H(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      H[i][j] = Rational(1) / Rational(static_cast<int>(i + j + 1));
  std::vector<Rational> ones(n, Rational(1));
  const auto solution =
      exact_solutions(sparse(H), {product(H, ones), product(H, product(H, ones))});
  REQUIRE(solution);
  CHECK(solution->front() == ones);
  CHECK(solution->back() == product(H, ones));
}

TEST_CASE("a singular matrix is refused, and its independent columns are as many as its rank") {
  const Dense A = {{1, 2, 3}, {2, 4, 6}, {0, 1, 1}};
  CHECK(!exact_solutions(sparse(A), {{1, 1, 1}}));
  CHECK(independent_columns(sparse(A), 3) == std::vector<std::size_t>{0, 1});
}
