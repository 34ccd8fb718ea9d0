// Exact fractions for the tests, small enough for textbook problems. Overflow is not detected:
// use integers below a hundred and at most four unknowns.
#pragma once

#include <ostream>

#include <Eigen/Core>

namespace lcpush::test {

class Rational {
public:
  Rational(int value = 0) : numerator_(value), denominator_(1) {} // NOLINT: implicit on purpose

  friend Rational operator+(const Rational& a, const Rational& b) {
    return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
            a.denominator_ * b.denominator_};
  }
  friend Rational operator-(const Rational& a, const Rational& b) { return a + -b; }
  friend Rational operator*(const Rational& a, const Rational& b) {
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  friend Rational operator/(const Rational& a, const Rational& b) {
    return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
  }
  Rational operator-() const { return {-numerator_, denominator_}; }
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }

  friend bool operator==(const Rational& a, const Rational& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }
  friend bool operator<(const Rational& a, const Rational& b) {
    return a.numerator_ * b.denominator_ < b.numerator_ * a.denominator_;
  }
  friend bool operator!=(const Rational& a, const Rational& b) { return !(a == b); }
  friend bool operator>(const Rational& a, const Rational& b) { return b < a; }
  friend bool operator<=(const Rational& a, const Rational& b) { return !(b < a); }
  friend bool operator>=(const Rational& a, const Rational& b) { return !(a < b); }
  friend std::ostream& operator<<(std::ostream& out, const Rational& a) {
    return out << static_cast<long long>(a.numerator_) << '/'
               << static_cast<long long>(a.denominator_);
  }
  friend Rational abs(const Rational& a) { return a < Rational(0) ? -a : a; }

private:
  __extension__ typedef __int128 Wide; // NOLINT: __extension__ needs a typedef

  Rational(Wide numerator, Wide denominator) : numerator_(numerator), denominator_(denominator) {
    Wide a = numerator < 0 ? -numerator : numerator,
         b = denominator < 0 ? -denominator : denominator;
    while (b != 0) {
      const Wide rest = a % b;
      a = b;
      b = rest;
    }
    if (denominator < 0) a = -a;
    numerator_ /= a;
    denominator_ /= a;
  }

  Wide numerator_, denominator_;
};

} // namespace lcpush::test

template <> struct Eigen::NumTraits<lcpush::test::Rational> {
  using Real = lcpush::test::Rational;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 20,
    MulCost = 20
  };
  static Real epsilon() { return 0; }
  static Real dummy_precision() { return 0; }
  static int digits10() { return 0; }
};
