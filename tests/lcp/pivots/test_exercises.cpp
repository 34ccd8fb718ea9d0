// What docs/teach/lemke_by_hand.md and docs/teach/exercises.md claim and no transcript there shows,
// in fractions.
#include <doctest/doctest.h>

#include "support/by_hand.hpp"

using namespace lcpush;
using namespace lcpush::test::by_hand;

TEST_CASE("the worked examples: Kostreva's matrix has positive principal minors") {
  const Numbers& m = textbook("kostreva_1").M.values; // by columns
  const auto at = [&](std::size_t i, std::size_t j) { return m[3 * j + i]; };
  const auto minor = [&](std::size_t i, std::size_t j) {
    return at(i, i) * at(j, j) - at(i, j) * at(j, i);
  };
  for (std::size_t i = 0; i < 3; ++i) CHECK(at(i, i) == Rational(1));
  CHECK(minor(0, 1) == Rational(1));
  CHECK(minor(0, 2) == Rational(1));
  CHECK(minor(1, 2) == Rational(1));
  const Rational determinant = at(0, 0) * minor(1, 2) -
                               at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
                               at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  CHECK(determinant == Rational(9));
}

TEST_CASE("exercise 4: two of three solutions by two covers, the third by none") {
  const ExactProblem problem = typed("1 2; 2 1", "-3 -3");
  for (const char* z : {"3 0", "0 3", "1 1"}) CHECK(solves(problem, numbers(z)));
  check_solved(problem, pivoted(problem, {"1 2"}), "3 0");
  check_solved(problem, pivoted(problem, {"2 1"}), "0 3");
  for (int d = 1; d <= 30; ++d) {
    const PivotTrace trace = pivoted(problem, {std::to_string(d) + " 10"});
    check_solved(problem, trace, d < 10 ? "3 0" : "0 3");
  }
}

TEST_CASE("exercise 4: Murty 2.11 ends in a ray from d2 / d1 = 8/3 on") {
  const ExactProblem problem = textbook("murty_2_11");
  for (const char* cover : {"1 1", "8 21", "300 799"})
    check_solved(problem, pivoted(problem, {cover}), "27 91/4");
  check_ray(problem, pivoted(problem, {"5 16"}), "1 0", "3/10", "5 16");
  check_ray(problem, pivoted(problem, {"3 8"}), "1 0", "1/2", "3 8");
}

TEST_CASE("exercise 5: covers that keep Kostreva's example from cycling under the first row") {
  const ExactProblem problem = textbook("kostreva_1");
  CHECK(pivoted(problem, by_first_row).cycle.has_value());
  const PivotTrace untied = pivoted(problem, {"3 2 1", TieRule::first_row, true});
  check_solved(problem, untied, "1/3 1/3 1/3");
  CHECK(untied.pivots.size() == 4);
  CHECK(ties_of(untied) == 0);
  const PivotTrace tied = pivoted(problem, {"1 2 3", TieRule::first_row, true});
  check_solved(problem, tied, "1/3 1/3 1/3");
  CHECK(tied.pivots.size() == 6);
  CHECK(ties_of(tied) == 1);
  CHECK(tied.pivots[2].ties.size() == 2);
  std::size_t standing = 0;
  for (std::size_t k = 1; k < tied.pivots.size(); ++k)
    if (value_text(tied.pivots[k].z0) == value_text(tied.pivots[k - 1].z0)) ++standing;
  CHECK(standing == 2);
}

TEST_CASE("exercise 6: on a rougher table the coin needs 10 mu + 1 N and never jams") {
  struct Push {
    std::string mu, force;
  };
  for (const Push& push :
       {Push{"0.1", "2"}, Push{"0.5", "6"}, Push{"0.75", "17/2"}, Push{"5", "51"}}) {
    CAPTURE(push.mu);
    const ExactProblem problem =
        scene("scenes/coin.toml", "friction = 0.5", "friction = " + push.mu);
    const PivotTrace trace = pivoted(problem);
    REQUIRE(trace.status == Status::solved);
    CHECK(trace.z[4].fraction == push.force);
  }
}

TEST_CASE("exercise 6: from above P = (5/3 + 10 mu) / (3/5 - 4/5 mu), and a jam from mu = 3/4 on") {
  for (const char* mu : {"0.1", "0.5", "0.7", "0.74"}) {
    CAPTURE(mu);
    const ExactProblem problem =
        scene("scenes/coin_from_above.toml", "friction = 0.5", std::string("friction = ") + mu);
    const PivotTrace trace = pivoted(problem);
    const Rational m = *Rational::parse(mu);
    const Rational P = (*Rational::parse("5/3") + Rational(10) * m) /
                       (*Rational::parse("3/5") - *Rational::parse("4/5") * m);
    const Rational N = Rational(10) + *Rational::parse("4/5") * P;
    check_solved(problem, trace, N.text() + " 0 " + (m * N).text() + " 5/3 " + P.text());
  }
  for (const char* mu : {"0.75", "0.8", "2"}) {
    CAPTURE(mu);
    CHECK(pivoted(scene("scenes/coin_from_above.toml", "friction = 0.5",
                        std::string("friction = ") + mu))
              .status == Status::ray);
  }
  const ExactProblem jammed = scene("rays/coin_jammed.toml");
  check_ray(jammed, pivoted(jammed), "4/5 0 3/5 0 1", "0");
}

TEST_CASE("exercise 7: the block sticks up to 5 N, as z0 leaves before the friction is used up") {
  for (int f = 1; f <= 8; ++f) {
    CAPTURE(f);
    const ExactProblem problem = typed("1 1; -1 0", "-" + std::to_string(f) + " 5");
    const PivotTrace trace = pivoted(problem);
    CHECK(path_of(trace) == (f <= 5 ? "z0 w1, z1 z0" : "z0 w1, z1 w2, z2 z0"));
    check_solved(problem, trace, f <= 5 ? std::to_string(f) + " 0" : "5 " + std::to_string(f - 5));
    CHECK(ties_of(trace) == (f == 5 ? 1 : 0));
  }
}

TEST_CASE("exercise 9: a number in place of S must be 1 or more, the letter always is") {
  const auto with = [](const std::string& S) {
    return typed("1 -1 -1; -1 1 0; 1 0 0", S + " -1 -5");
  };
  check_solved(with("3"), pivoted(with("3")), "5 6 2");
  check_solved(with("1"), pivoted(with("1")), "5 6 0");
  CHECK(ties_of(pivoted(with("1"))) == 1);
  check_ray(with("1/2"), pivoted(with("1/2")), "1 1 0", "0");
  CHECK(proves_infeasible(with("1/2"), numbers("1 1 0")));
  CHECK_FALSE(proves_infeasible(with("1"), numbers("1 1 0")));

  ExactProblem harder = scene("scenes/squeeze.toml", "grip_force = 5", "grip_force = 7");
  harder.q.values[1] = Rational(-2); // w2: the thumb's acceleration, 2 m/s^2
  check_solved(harder, pivoted(harder), "7 9 -2");
}
