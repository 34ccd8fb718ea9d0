// The worked examples of docs/teach/lemke_by_hand.md and the answers of docs/teach/exercises.md, in
// fractions.
#include <doctest/doctest.h>

#include "support/by_hand.hpp"

using namespace lcpush;
using namespace lcpush::test::by_hand;

TEST_CASE("the worked examples: the coin's matrices are its scene's, in SI units") {
  const ExactProblem of_scene = scene("scenes/coin.toml"), of_book = textbook("coin");
  CHECK(of_scene.M.values == of_book.M.values);
  CHECK(of_scene.q.values == of_book.q.values);
  CHECK(of_scene.free_count == 0);
  const ExactProblem two = textbook("two_by_two"), by_hand = typed("2 1; 1 2", "-5 -6");
  CHECK(two.M.values == by_hand.M.values);
  CHECK(two.q.values == by_hand.q.values);
}

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

TEST_CASE("the worked examples: the box and the finger, with S") {
  const ExactProblem problem = scene("scenes/squeeze.toml");
  const PivotTrace trace = pivoted(problem);
  CHECK(path_of(trace) == "z0 w3, z3 w1, z1 w2, z2 z0");
  check_solved(problem, trace, "5 6 -1");
  REQUIRE(trace.last);
  CHECK(value_text(trace.last->values[0]) == "S - 1");
}

TEST_CASE("exercise 1: one pivot, then z0 leaves and w1 = 1/3 stays") {
  const ExactProblem problem = typed("4 1; 2 3", "-2 -7");
  const PivotTrace trace = pivoted(problem);
  CHECK(path_of(trace) == "z0 w2, z2 z0");
  REQUIRE(trace.pivots[1].before);
  CHECK(rows_of(trace, *trace.pivots[1].before) ==
        "w1 = 5 + 2 z1 + -2 z2 + 1 w2; z0 = 7 + -2 z1 + -3 z2 + 1 w2");
  check_solved(problem, trace, "0 7/3");
  CHECK(trace.w[0].fraction == "1/3");
}

TEST_CASE("exercise 2: w2 leaves at 5, z3 has grown to 7/2") {
  const PivotTrace trace = pivoted(textbook("cps_4_4_7"));
  REQUIRE(trace.pivots.size() == 5);
  const TracedPivot& pivot = trace.pivots[3];
  REQUIRE(pivot.before);
  CHECK(rows_of(trace, *pivot.before) ==
        "z0 = 1 + 1 w3 + -1 z2 + 1 z1 + 0 w1; w2 = 5 + 2 w3 + -3 z2 + 4 z1 + -1 w1; "
        "z3 = 1 + -1/2 w3 + 1 z2 + -1/2 z1 + 1/2 w1");
  CHECK(name(trace, pivot.entering) + " " + name(trace, pivot.leaving) == "w1 w2");
  CHECK_FALSE(pivot.ratios[0]);
  CHECK_FALSE(pivot.ratios[2]);
  REQUIRE(pivot.ratios[1]);
  CHECK(value_text(*pivot.ratios[1]) == "5");
  REQUIRE(trace.pivots[4].before);
  CHECK(value_text(trace.pivots[4].before->values[2]) == "7/2");
}

TEST_CASE("exercise 3: rays of one unknown, with v0 = 0 and v0 = 1, neither feasible") {
  for (const auto& [M, v0] : {std::pair("0", "0"), std::pair("-1", "1")}) {
    const std::string matrix = M;
    CAPTURE(matrix);
    const ExactProblem problem = typed(M, "-1");
    const PivotTrace trace = pivoted(problem);
    CHECK(path_of(trace) == "z0 w1");
    check_ray(problem, trace, "1", v0);
    CHECK(proves_infeasible(problem, numbers("1")));
  }
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

TEST_CASE("exercise 8: 2^n pivots in the order of the Gray code, or two under another cover") {
  const ExactProblem problem = typed("1 0 0; 2 1 0; 2 2 1", "-8 -12 -14");
  const PivotTrace slow = pivoted(problem), fast = pivoted(problem, {"1 10 10"});
  CHECK(path_of(slow) == "z0 w3, z3 w2, z2 z3, w3 w1, z1 w3, z3 z2, w2 z3, w3 z0");
  check_solved(problem, slow, "8 0 0");
  CHECK(path_of(fast) == "z0 w1, z1 z0");
  check_solved(problem, fast, "8 0 0");
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

TEST_CASE("exercise 10: z = (0, 3) makes w1 = -2, as w1 reached zero before z0") {
  const ExactProblem problem = textbook("two_by_two");
  const Numbers wrong = numbers("0 3");
  CHECK(problem.q.values[0] + product(problem, 0, wrong) == Rational(-2));
  CHECK_FALSE(solves(problem, wrong));
  const PivotTrace trace = pivoted(problem);
  const TracedPivot& pivot = trace.pivots[1];
  CHECK(name(trace, pivot.leaving) == "w1");
  CHECK(value_text(*pivot.ratios[0]) == "1");
  CHECK(value_text(*pivot.ratios[1]) == "3");
  check_solved(problem, trace, "4/3 7/3");
}
