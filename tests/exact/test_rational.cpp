// Exact fractions and the whole numbers under them. tests/exact/rational_fuzz.py has many more
// numbers; here are those whose answer a person can see, and the corners.
#include "lcpush/desktop/exact_pivots.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"
#include "support/dense_lcp.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace lcpush;
using desktop::BigInteger;
using desktop::Rational;

namespace {

Rational fraction(int a, int b) { return Rational(a) / Rational(b); }
Rational typed(const std::string& text) {
  const std::optional<Rational> number = Rational::parse(text);
  CAPTURE(text);
  REQUIRE(number);
  return *number;
}
BigInteger power_of_two(std::size_t exponent) { return BigInteger(1) << exponent; }

} // namespace

TEST_CASE("decimals are taken as typed, and fractions of whole numbers") {
  CHECK(typed("0.2") == fraction(1, 5));
  CHECK(typed("-1.5e-3") == fraction(-3, 2000));
  CHECK(typed("+2") == 2);
  CHECK(typed(".5") == fraction(1, 2));
  CHECK(typed("5.") == 5);
  CHECK(typed("2E+2") == 200);
  CHECK(typed("-0") == 0);
  CHECK(typed("-6/21") == fraction(-2, 7));
  CHECK(typed("0.1").value() == 0.1);
  for (const char* text : {"",        ".",
                           "-",       "+-1",
                           "--1",     "1e",
                           "e5",      "1e+-5",
                           "1 ",      " 1",
                           "1/0",     "1/",
                           "/3",      "1/-3",
                           "0.5/3",   "1e5/3",
                           "inf",     "nan",
                           "0x1",     "1e1001",
                           "1e-1001", "1e99999999999",
                           "1..2",    "1.2.3",
                           "1,5"}) {
    CAPTURE(text);
    CHECK_FALSE(Rational::parse(text));
  }
  CHECK(Rational::parse("1e1000"));
  CHECK_FALSE(Rational::parse(std::string(10001, '1')));
}

TEST_CASE("a double's exact value comes back as the same double") {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  for (const double x : {0.1, -1.0 / 3, 1e300, -1e-300, tiny, 3 * tiny, huge, -huge, 0x1p-1022, 0.0,
                         6755399441055744.5})
    CHECK(Rational(x).value() == x);
  CHECK(Rational(0.1) != typed("0.1"));
  CHECK(Rational(0.375F) == fraction(3, 8));
  CHECK(Rational(-0.375) == fraction(-3, 8));
}

TEST_CASE("value() is the nearest double: ties to even, subnormal, vanishing and overflowing") {
  const Rational tiny(std::numeric_limits<double>::denorm_min());
  CHECK((tiny / 2).value() == 0);
  CHECK((tiny / 2 + tiny / typed("1e30")).value() == tiny.value());
  CHECK((tiny * fraction(3, 2)).value() == 2 * tiny.value());
  CHECK((tiny * fraction(5, 2)).value() == 2 * tiny.value());
  CHECK((tiny / typed("1e1000")).value() == 0);
  const Rational one_and_half_ulp = Rational(1) + Rational(0x1p-53);
  CHECK(one_and_half_ulp.value() == 1);
  CHECK((one_and_half_ulp + Rational(1) / typed("1e200")).value() == 1 + 0x1p-52);
  CHECK((Rational(1) + Rational(3) * Rational(0x1p-53)).value() == 1 + 0x1p-51);
  const Rational limit(power_of_two(1024), 1);
  CHECK(std::isinf((-limit).value()));
  CHECK((limit - Rational(power_of_two(970), 1)).value() == HUGE_VAL); // a tie, to even
  CHECK((limit - Rational(power_of_two(970), 1) - 1).value() == std::numeric_limits<double>::max());
  const Rational long_third(power_of_two(5000), BigInteger(3) * power_of_two(5000) - 1);
  CHECK(long_third.value() == 1.0 / 3);
}

TEST_CASE("square roots are exact where they are fractions") {
  CHECK(sqrt(fraction(9, 16)) == fraction(3, 4));
  CHECK(sqrt(Rational(0)) == 0);
  const Rational large = typed("123456789012345678901234567890/7");
  CHECK(sqrt(large * large) == large);
  CHECK(sqrt(Rational(2)) == Rational(std::sqrt(2.0)));
  CHECK_FALSE(desktop::exact_root(fraction(4, 3)));
}

TEST_CASE("Lemke in fractions: w and z are exactly complementary on random problems") {
  test::Random random(7);
  for (int round = 0; round < 10; ++round) {
    const Index n = 8;
    const Eigen::MatrixXd A = test::random_matrix(random, n, n);
    const Eigen::MatrixXd rounded = A * A.transpose();
    test::MatrixX<Rational> M = rounded.cast<Rational>();
    test::VectorX<Rational> q = Eigen::VectorXd(test::random_matrix(random, n, 1)).cast<Rational>();
    std::vector<Rational> scalars(static_cast<std::size_t>(lemke_scalars(n)));
    std::vector<int> integers(static_cast<std::size_t>(lemke_integers(n)));
    Problem<Rational> problem;
    problem.size = problem.free_begin = n;
    problem.matrix = M.data();
    problem.q = q.data();
    LemkeOptions<Rational> options;
    options.equilibrate = round % 2 == 1;
    options.tie_rule = TieRule::lexicographic;
    Lemke<Rational> lemke({scalars.data(), lemke_scalars(n)}, {integers.data(), lemke_integers(n)});
    REQUIRE(lemke.init(problem, options) == Status::running);
    REQUIRE(lemke.solve() == Status::solved);
    const Eigen::Map<const test::VectorX<Rational>> z(lemke.z(), n);
    const test::VectorX<Rational> w = M * z + q;
    for (Index i = 0; i < n; ++i) {
      CHECK(z[i] >= 0);
      CHECK(w[i] >= 0);
      CHECK(z[i] * w[i] == 0);
    }
    CHECK(lemke.residual().residual == 0);
  }
}
