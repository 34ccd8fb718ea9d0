#include "exact/double_double.hpp"
#include "exact/wide_float.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace lcpush::desktop;

namespace {

/// A fraction of two whole numbers of up to 120 bits, of any size and sign.
Rational any_fraction(std::mt19937_64& pick) {
  const auto whole = [&] { return BigInteger(pick()) * BigInteger(pick()) + BigInteger(1); };
  const Rational size(BigInteger(1) << pick() % 60, BigInteger(1) << pick() % 60);
  const Rational value = Rational(whole(), whole()) * size;
  return pick() % 2 == 0 ? value : -value;
}

/// What a number lacks, in parts of `size`.
template <class S> double error(const S& number, const Rational& exact, const Rational& size) {
  return std::abs((number - S(exact)).value()) / std::abs(size.value());
}

template <class S> double largest_error() {
  std::mt19937_64 pick(1);
  double largest = 0;
  for (int k = 0; k < 3000; ++k) {
    const Rational a = any_fraction(pick), b = any_fraction(pick);
    const S x(a), y(b);
    // b off by about 2^-70: what is left of the difference is known to as many bits fewer.
    const Rational near = a + a * b / Rational(BigInteger(1) << 130U, 1);
    for (const double e :
         {error(x + y, a + b, abs(a) + abs(b)), error(x - y, a - b, abs(a) + abs(b)),
          error(x * y, a * b, a * b), error(x / y, a / b, a / b), error(x - S(near), a - near, a)})
      largest = std::max(largest, e);
    CHECK((x < y) == (a < b));
    CHECK(abs(x).value() == std::abs(x.value()));
    CHECK(std::abs(x.value() - a.value()) <= 0x1p-52 * std::abs(a.value()));
  }
  return largest;
}

} // namespace

TEST_CASE("long floats compute as fractions do, up to their last bits") {
  CHECK(largest_error<DoubleDouble>() < 0x1p-100);
  CHECK(largest_error<WideFloat>() < 0x1p-250);
}

TEST_CASE("long floats know zero and whole numbers") {
  const auto check = [](auto one) {
    using S = decltype(one);
    CHECK(one - one == S(0));
    CHECK(S(0) + one == one);
    CHECK(S(0) * one == S(0));
    CHECK(-S(0) == S(0));
    CHECK(S(3) / S(4) == S(0.75));
    CHECK(S(-7) < S(0));
    CHECK(S(-7) < S(-6));
    CHECK(S(1) - S(0x1p-60) < one);
    CHECK((S(1) - S(0x1p-60)) + S(0x1p-60) == one);
    CHECK(S(lcpush::desktop::Rational(0)) == S(0));
    CHECK(S(-12.5).value() == -12.5);
  };
  check(DoubleDouble(1));
  check(WideFloat(1));
}
