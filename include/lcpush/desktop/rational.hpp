// Exact fractions: a scalar for the whole core (solver, assembly) where no rounding is wanted.
//
// Every + - * / costs divisors of ever longer numbers; it is for problems of some dozens of
// unknowns, and for teaching. Exact scalars need no tolerances (Tolerances<Rational> is all zeros)
// and no equilibration; the lexicographic tie rule then never cycles. Pivots are several times
// faster with exact_pivots.hpp.
#pragma once

#include "lcpush/desktop/big_integer.hpp"
#include "lcpush/types.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace lcpush::desktop {

/// A fraction, its denominator positive; in lowest terms, but for `unreduced` ones. Moving is cheap
/// and never throws.
class Rational : Arithmetic<Rational> {
public:
  Rational() = default;
  template <class I, std::enable_if_t<std::is_integral_v<I>, int> = 0>
  Rational(I value) : numerator_(value) {} // NOLINT: implicit on purpose
  /// The exact value, every bit of it. Pre: finite.
  explicit Rational(float value) : Rational(static_cast<double>(value)) {}
  explicit Rational(double value);
  /// numerator / denominator, reduced. Pre: denominator != 0.
  Rational(BigInteger numerator, BigInteger denominator);
  // Compiled once: matrices of fractions are full of them.
  Rational(const Rational&);
  Rational(Rational&&) noexcept;
  Rational& operator=(const Rational&);
  Rational& operator=(Rational&&) noexcept;
  ~Rational();

  /// Numbers that share a denominator keep it. Pre: denominator > 0, and numerator not zero.
  static Rational unreduced(BigInteger numerator, BigInteger denominator);

  /// The number as it is typed: a decimal ("0.2" is 1/5, "-1.5e-3", "+2", ".5") or a fraction of
  /// two whole numbers ("-2/7"). nullopt for anything else, for a denominator of zero, and for what
  /// would take too long: exponents beyond +-1000, more than 10,000 characters.
  static std::optional<Rational> parse(std::string_view text);
  /// "-2/7", or "3" for whole numbers. Cost: quadratic in the digits.
  std::string text() const;
  /// The nearest double, ties to even; infinite beyond its range, whatever the parts' lengths.
  double value() const;

  const BigInteger& numerator() const { return numerator_; }
  const BigInteger& denominator() const { return denominator_; }
  int sign() const { return numerator_.sign(); }
  bool is_whole() const { return denominator_.is_one(); }
  /// Bits of the longer of numerator and denominator.
  std::size_t bit_length() const;

  void negate() { numerator_.negate(); }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }

  friend Rational operator+(const Rational& a, const Rational& b) { return sum(a, b, false); }
  friend Rational operator-(const Rational& a, const Rational& b) { return sum(a, b, true); }
  friend Rational operator*(const Rational& a, const Rational& b) {
    return product(a.numerator_, a.denominator_, b.numerator_, b.denominator_);
  }
  /// Pre: b != 0.
  friend Rational operator/(const Rational& a, const Rational& b);

  /// Exact where the root is a fraction, else the exact value of the double nearest to the root of
  /// a.value(). Pre: a >= 0, a.value() finite if the root is no fraction.
  friend Rational sqrt(const Rational& a);

  /// < 0, 0 or > 0 as a is below, equal to or above b.
  static int compare(const Rational& a, const Rational& b);
  friend bool operator==(const Rational& a, const Rational& b) { return compare(a, b) == 0; }

private:
  BigInteger numerator_;
  BigInteger denominator_ = 1;

  static Rational sum(const Rational& a, const Rational& b, bool subtract);
  static Rational product(const BigInteger& a, const BigInteger& b, const BigInteger& c,
                          const BigInteger& d);
};

/// The square root if it is a fraction itself. Pre: a >= 0.
std::optional<Rational> exact_root(const Rational& a);

} // namespace lcpush::desktop

template <> struct Eigen::NumTraits<lcpush::desktop::Rational> {
  using Real = lcpush::desktop::Rational;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 10,
    AddCost = 200,
    MulCost = 200
  };
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};
