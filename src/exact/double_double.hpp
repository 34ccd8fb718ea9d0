// Numbers of twice a double's digits: the sum of two doubles that do not overlap (T. J. Dekker, A
// floating-point technique for extending the available precision, Numer. Math. 18, 1971). A scalar
// for the core where rounding to 1e-16 hides what tells two fractions apart.
#pragma once

#include <cmath>

#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush::desktop {

class DoubleDouble {
public:
  DoubleDouble() = default;
  template <class N, std::enable_if_t<std::is_arithmetic_v<N>, int> = 0>
  DoubleDouble(N value) : high_(static_cast<double>(value)) {} // NOLINT: implicit on purpose
  /// The nearest one, about; infinite beyond the range of doubles.
  explicit DoubleDouble(const Rational& value) : high_(value.value()) {
    if (std::isfinite(high_)) low_ = (value - Rational(high_)).value();
  }

  double value() const { return high_; }

  DoubleDouble operator-() const { return {-high_, -low_}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = sum(a.high_, b.high_), low = sum(a.low_, b.low_);
    const DoubleDouble nearly = ordered_sum(high.high_, high.low_ + low.high_);
    return ordered_sum(nearly.high_, nearly.low_ + low.low_);
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = product(a.high_, b.high_);
    return ordered_sum(high.high_, high.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
  }
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high_ / b.high_;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high_ / b.high_;
    const DoubleDouble left = rest - b * DoubleDouble(second);
    return ordered_sum(first, second) + DoubleDouble(left.high_ / b.high_);
  }
  DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }
  DoubleDouble& operator-=(const DoubleDouble& b) { return *this = *this - b; }
  DoubleDouble& operator*=(const DoubleDouble& b) { return *this = *this * b; }
  DoubleDouble& operator/=(const DoubleDouble& b) { return *this = *this / b; }

  friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ == b.high_ && a.low_ == b.low_;
  }
  friend bool operator!=(const DoubleDouble& a, const DoubleDouble& b) { return !(a == b); }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
  friend bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ <= b.low_);
  }
  friend bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }
  friend DoubleDouble abs(const DoubleDouble& a) { return a.high_ < 0 ? -a : a; }

private:
  double high_ = 0, low_ = 0;

  DoubleDouble(double high, double low) : high_(high), low_(low) {}

  /// a + b without any error; the ordered one for |a| >= |b|.
  static DoubleDouble sum(double a, double b) {
    const double high = a + b, of_b = high - a;
    return {high, (a - (high - of_b)) + (b - of_b)};
  }
  static DoubleDouble ordered_sum(double a, double b) {
    const double high = a + b;
    return {high, b - (high - a)};
  }
  /// a b without any error, as long as it neither overflows nor underflows.
  static DoubleDouble product(double a, double b) {
    const double high = a * b;
    const DoubleDouble x = halves(a), y = halves(b);
    return {high,
            ((x.high_ * y.high_ - high) + x.high_ * y.low_ + x.low_ * y.high_) + x.low_ * y.low_};
  }
  /// a as the sum of two numbers of 26 bits.
  static DoubleDouble halves(double a) {
    constexpr double split = 0x1p27 + 1;
    const double scaled = split * a, high = scaled - (scaled - a);
    return {high, a - high};
  }
};

} // namespace lcpush::desktop

/// As those of double are, in multiples of 2^-104.
template <> struct lcpush::Tolerances<lcpush::desktop::DoubleDouble> {
  desktop::DoubleDouble pivot = 0x1p-82, tie = 0x1p-89, residual = 0x1p-82, settled = 0x1p-88,
                        noise = 0x1p-16, finish = 0.0, independent = 0x1p-16;
};

template <>
struct Eigen::NumTraits<lcpush::desktop::DoubleDouble>
    : Eigen::GenericNumTraits<lcpush::desktop::DoubleDouble> {
  using Real = lcpush::desktop::DoubleDouble;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 25
  };
  static Real epsilon() { return 0x1p-104; }
  static Real dummy_precision() { return 0x1p-90; }
  static int digits10() { return 31; }
};
