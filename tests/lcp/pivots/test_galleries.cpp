// What docs/teach/galleries.md claims: rays, and ideas switched off one at a
// time.
#include <doctest/doctest.h>

#include "support/by_hand.hpp"

using namespace lcpush;
using namespace lcpush::test::by_hand;

TEST_CASE("gallery of rays: those that prove it, by adding the ray's rows") {
  for (const auto& [book, v] :
       {std::pair("infeasible_psd", "1 1"), std::pair("infeasible_lp", "0 0 1 1"),
        std::pair("unbounded_lp", "1 0 0")}) {
    const std::string name = book;
    CAPTURE(name);
    const ExactProblem problem = textbook(book);
    check_ray(problem, pivoted(problem), v, "0");
    CHECK(proves_infeasible(problem, numbers(v)));
  }
  const ExactProblem runaway = scene("rays/runaway.toml");
  check_ray(runaway, pivoted(runaway), "0 0 1", "0");
  CHECK(proves_infeasible(runaway, numbers("0 0 1")));
}

TEST_CASE("gallery of rays: those that prove nothing") {
  const ExactProblem feasible = textbook("copositive_ray");
  check_ray(feasible, pivoted(feasible), "1 0", "0");
  CHECK(feasible.q.values[0] + product(feasible, 0, numbers("0 1")) == Rational(0));
  CHECK(feasible.q.values[1] + product(feasible, 1, numbers("0 1")) == Rational(1));

  const ExactProblem solvable = textbook("solvable_ray");
  const PivotTrace missed = pivoted(solvable);
  check_ray(solvable, missed, "0 1 0", "1");
  CHECK(solves(solvable, numbers("3/2 0 0")));
  std::string z0_values;
  for (const TracedPivot& pivot : missed.pivots) z0_values += value_text(pivot.z0) + " ";
  CHECK(z0_values == "4 4 1 25/7 1 ");

  const ExactProblem game = textbook("rock_paper_scissors");
  check_ray(game, pivoted(game), "0 0 0 0 0 1", "0");
  check_ray(game, pivoted(game, {"1 2 3 4 5 6"}), "1 0 0 0 0 0", "0", "1 2 3 4 5 6");
  CHECK(solves(game, numbers("1/6 1/6 1/6 1/6 1/6 1/6")));
}

TEST_CASE("ideas switched off: no lexicographic rule, and Kostreva's examples cycle") {
  for (const auto& [book, length] : {std::pair("kostreva_1", 6), std::pair("kostreva_2", 4)}) {
    const PivotTrace trace = pivoted(textbook(book), by_first_row);
    REQUIRE(trace.cycle);
    CHECK(trace.cycle->first == 1);
    CHECK(trace.cycle->length == static_cast<std::size_t>(length));
    CHECK_FALSE(pivoted(textbook(book)).cycle);
  }
}

TEST_CASE("ideas switched off: no dissipation, and what should slide has no answer") {
  const ExactProblem with = typed("1 1; -1 0", "-6 5"), without = typed("1 0; -1 0", "-6 5");
  check_solved(with, pivoted(with), "5 1");
  check_ray(without, pivoted(without), "0 1", "0");
  CHECK(proves_infeasible(without, numbers("1 1")));

  ExactProblem coin = scene("scenes/coin.toml");
  check_solved(coin, pivoted(coin), "10 0 5 1 6");
  for (std::size_t i = 0; i < 5; ++i) coin.M.values[5 * 3 + i] = Rational(0);
  check_ray(coin, pivoted(coin), "0 0 0 1 0", "0");
  CHECK(proves_infeasible(coin, numbers("0 0 1 0 1")));
}

TEST_CASE("ideas switched off: a box instead of the cone holds with 6 N where 5 N is all") {
  const std::string box = "1 0 1 0; 0 1 0 1; -1 0 0 0; 0 -1 0 0";
  const std::string cone = "1 0 3/5 1; 0 1 4/5 1; 3/5 4/5 1 1; -1 -1 -1 0";
  const auto square = [](const Rational& x, const Rational& y) { return x * x + y * y; };

  const ExactProblem held = typed(box, "-18/5 -24/5 5 5"), slides = typed(cone, "-18/5 -24/5 -6 5");
  check_solved(held, pivoted(held), "18/5 24/5 0 0");
  CHECK(square(*Rational::parse("18/5"), *Rational::parse("24/5")) == Rational(36));
  check_solved(slides, pivoted(slides), "0 0 5 1");

  const ExactProblem off = typed(box, "-6 -8 5 5"), along = typed(cone, "-6 -8 -10 5");
  check_solved(off, pivoted(off), "5 5 1 3");
  CHECK(square(Rational(5), Rational(5)) == Rational(2 * 5 * 5)); // sqrt(2) times 5 N
  CHECK(Rational(1) * Rational(8) != Rational(3) * Rational(6));  // (1, 3) is not along (6, 8)
  check_solved(along, pivoted(along), "0 0 5 5");
}

TEST_CASE("ideas switched off: without z0's preference a solution is passed, a ray reported") {
  for (const auto& [book, z, v] :
       {std::tuple("cps_4_4_16", "0 1", "1 1"), std::tuple("artificial_tie", "1 1 0", "0 1 0")}) {
    const std::string name = book;
    CAPTURE(name);
    const ExactProblem problem = textbook(book);
    check_solved(problem, pivoted(problem), z);
    const PivotTrace trace = pivoted(problem, z0_last);
    check_ray(problem, trace, v, "0");
    CHECK(value_text(trace.pivots.back().z0) == "0"); // it was solved before the ray
    CHECK_FALSE(proves_infeasible(problem, numbers(v)));
  }
}
