// Lemke's method on the problems of fixtures/textbook: how it ends. Which pivots it takes is in
// test_lemke_paths.cpp. The books' covers are ones unless they say otherwise.
#include <doctest/doctest.h>

#include "lcpush/desktop/rational.hpp"
#include "support/textbook.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Rational;

namespace {

constexpr double tolerance = 1e-12;

/// Solves under the book's cover and under generic ones; both must end in `expected`.
void check_solution(const std::string& name, const VectorX<double>& expected) {
  const DenseLcp<double> lcp = textbook(name);
  const VectorX<double> ones = VectorX<double>::Ones(lcp.size());
  for (const bool as_printed : {true, false}) {
    CAPTURE(as_printed);
    LemkeRun<double> run(lcp.size());
    const LemkeOptions<double> options =
        as_printed ? book_options(ones, TieRule::lexicographic) : LemkeOptions<double>{};
    REQUIRE(run.solve(lcp, options) == Status::solved);
    CHECK((run.z() - expected).cwiseAbs().maxCoeff() <= tolerance * expected.maxCoeff());
    CHECK(solution_error(lcp, run.z()) <= tolerance);
  }
}

void check_ray(const std::string& name, const VectorX<double>& cover) {
  const DenseLcp<double> lcp = textbook(name);
  for (const TieRule rule : {TieRule::generic, TieRule::lexicographic}) {
    LemkeRun<double> run(lcp.size());
    REQUIRE(run.solve(lcp, book_options(cover, rule)) == Status::ray);
    CHECK(ray_error(lcp.M, cover, run.ray(), run.lemke.ray_artificial()) <= tolerance);
  }
}

template <int n> VectorX<double> vector(const double (&values)[n]) {
  return Eigen::Map<const VectorX<double>>(values, n);
}

} // namespace

// Cottle, Pang, Stone 1992, Example 4.4.7.
TEST_CASE("Cottle-Pang-Stone 4.4.7 is solved at (0, 1, 3)") {
  check_solution("cps_4_4_7", vector({0, 1, 3}));
}

// Murty 1988, Example 2.8: a quadratic program's conditions. Cottle, Pang, Stone 1992, Example
// 4.4.16. Floudas et al. 1999, problem 10.2.2. Where several z solve, any will do.
TEST_CASE("Murty 2.8, Cottle-Pang-Stone 4.4.16, Floudas 10.2.2 and degenerate ones are solved") {
  for (const char* name :
       {"murty_2_8", "cps_4_4_16", "floudas_10_2_2", "degenerate_psd", "artificial_tie"}) {
    CAPTURE(std::string(name));
    const DenseLcp<double> lcp = textbook(name);
    const VectorX<double> ones = VectorX<double>::Ones(lcp.size());
    for (const TieRule rule : {TieRule::generic, TieRule::lexicographic}) {
      LemkeRun<double> run(lcp.size());
      REQUIRE(run.solve(lcp, book_options(ones, rule)) == Status::solved);
      CHECK(solution_error(lcp, run.z()) <= tolerance);
    }
    LemkeRun<double> by_default(lcp.size());
    REQUIRE(by_default.solve(lcp) == Status::solved);
    CHECK(solution_error(lcp, by_default.z()) <= tolerance);
  }
}

// Floudas et al. 1999, problem 10.2.9, its parameter l at 1: z = (l + 16, l + 16, 46 - 2 l,
// 1286 - 9 l) / 13.
TEST_CASE("Floudas 10.2.9 is solved at (17, 17, 44, 1277) / 13") {
  check_solution("floudas_10_2_9", vector({17.0 / 13, 17.0 / 13, 44.0 / 13, 1277.0 / 13}));
}

TEST_CASE("the exponential families' fixtures are solved at their one solution") {
  check_solution("murty_6_4", vector({16, 0, 0, 0}));
  check_solution("murty_6_4_ones", vector({1, 0, 0, 0}));
  check_solution("fathi_4", vector({768, 0, 0, 0}));
  check_solution("fathi_4_ones", vector({1, 0, 0, 0}));
}

// Murty 1988, Example 2.9.
TEST_CASE("Murty 2.9 ends in a secondary ray with a certificate") {
  check_ray("murty_2_9", vector({1, 1, 1}));
}

// Murty 1988, Example 2.11.
TEST_CASE("Murty 2.11: the cover decides between a ray and a solution") {
  check_ray("murty_2_11", vector({5, 16}));
  const DenseLcp<double> lcp = textbook("murty_2_11");
  const VectorX<double> ones = VectorX<double>::Ones(2);
  LemkeRun<double> run(2);
  REQUIRE(run.solve(lcp, book_options(ones, TieRule::generic)) == Status::solved);
  CHECK(solution_error(lcp, run.z()) <= tolerance);
}

// Kostreva 1979, example 1: a P-matrix, so exactly one solution.
TEST_CASE("Kostreva 1 is solved at (1/3, 1/3, 1/3)") {
  check_solution("kostreva_1", VectorX<double>::Constant(3, 1.0 / 3));
}

TEST_CASE("Kostreva's examples cycle in exact fractions when the first tied row leaves, and under "
          "no other rule") {
  const VectorX<Rational> ones = VectorX<Rational>::Constant(3, Rational(1));
  for (const char* name : {"kostreva_1", "kostreva_2"}) {
    CAPTURE(name);
    const DenseLcp<Rational> lcp = in_fractions(textbook(name));
    LemkeOptions<Rational> options = book_options(ones, TieRule::first_row);
    options.max_pivots = 40;
    LemkeRun<Rational> cycling(3);
    CHECK(cycling.solve(lcp, options) == Status::pivot_limit);
    CHECK(cycling.lemke.pivots() == 40);
    for (const TieRule rule : {TieRule::lexicographic, TieRule::generic}) {
      options.tie_rule = rule;
      LemkeRun<Rational> run(3);
      const Status status = run.solve(lcp, options);
      CHECK(status == (std::string(name) == "kostreva_1" ? Status::solved : Status::ray));
      CHECK(run.lemke.pivots() < 12);
    }
  }
}

// Floudas et al. 1999, problem 10.2.4.
TEST_CASE("a bimatrix game ends in an honest ray under every positive cover") {
  const DenseLcp<double> lcp = textbook("floudas_10_2_4");
  LemkeRun<double> run(4);
  REQUIRE(run.solve(lcp) == Status::ray);
  CHECK(run.lemke.covers_tried() == LemkeOptions<double>{}.covers);
  const VectorX<double> ones = VectorX<double>::Ones(4);
  LemkeRun<double> own(4);
  REQUIRE(own.solve(lcp, book_options(ones, TieRule::generic)) == Status::ray);
  CHECK(own.lemke.covers_tried() == 1);
  CHECK(ray_error(lcp.M, ones, own.ray(), own.lemke.ray_artificial()) <= tolerance);
}
