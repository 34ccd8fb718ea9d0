// Floating-point numbers of 256 bits, 77 decimal digits: a scalar for the core where even 32 digits
// hide a tie. About fifteen times the cost of a DoubleDouble.
#pragma once

#include <cmath>

#include "exact/limbs.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/tolerances.hpp"

namespace lcpush::desktop {

/// sign mantissa 2^exponent, the mantissa's highest bit set; zero has sign 0. Results are cut off.
class WideFloat {
public:
  WideFloat() = default;
  /// Pre: a double holds it.
  template <class N, std::enable_if_t<std::is_arithmetic_v<N>, int> = 0>
  WideFloat(N value) { // NOLINT: implicit on purpose
    int exponent = 0;
    const double part = std::frexp(static_cast<double>(value), &exponent);
    if (part == 0) return;
    sign_ = part < 0 ? -1 : 1;
    exponent_ = exponent - bits_;
    mantissa_[limbs_ - 1] = static_cast<limbs::Limb>(std::abs(part) * 0x1p64);
  }
  explicit WideFloat(const Rational& value);

  double value() const;

  WideFloat operator-() const {
    WideFloat result = *this;
    result.sign_ = -sign_;
    return result;
  }
  friend WideFloat operator+(const WideFloat& a, const WideFloat& b);
  friend WideFloat operator-(const WideFloat& a, const WideFloat& b) { return a + -b; }
  friend WideFloat operator*(const WideFloat& a, const WideFloat& b);
  /// Pre: b != 0.
  friend WideFloat operator/(const WideFloat& a, const WideFloat& b);
  WideFloat& operator+=(const WideFloat& b) { return *this = *this + b; }
  WideFloat& operator-=(const WideFloat& b) { return *this = *this - b; }
  WideFloat& operator*=(const WideFloat& b) { return *this = *this * b; }
  WideFloat& operator/=(const WideFloat& b) { return *this = *this / b; }

  static int compare(const WideFloat& a, const WideFloat& b);
  friend bool operator==(const WideFloat& a, const WideFloat& b) { return compare(a, b) == 0; }
  friend bool operator!=(const WideFloat& a, const WideFloat& b) { return compare(a, b) != 0; }
  friend bool operator<(const WideFloat& a, const WideFloat& b) { return compare(a, b) < 0; }
  friend bool operator>(const WideFloat& a, const WideFloat& b) { return compare(a, b) > 0; }
  friend bool operator<=(const WideFloat& a, const WideFloat& b) { return compare(a, b) <= 0; }
  friend bool operator>=(const WideFloat& a, const WideFloat& b) { return compare(a, b) >= 0; }
  friend WideFloat abs(const WideFloat& a) { return a.sign_ < 0 ? -a : a; }

private:
  static constexpr std::size_t limbs_ = 4;
  static constexpr int bits_ = static_cast<int>(limbs_) * limbs::limb_bits;
  int sign_ = 0, exponent_ = 0;
  limbs::Limb mantissa_[limbs_] = {};

  void normalise();
  void shift_down(int bits);
};

} // namespace lcpush::desktop

/// Far below what products of scenes' rounded directions differ by, far above rounding.
template <> struct lcpush::Tolerances<lcpush::desktop::WideFloat> {
  desktop::WideFloat pivot = 0x1p-200, tie = 0x1p-216, residual = 0x1p-200, settled = 0x1p-208,
                     noise = 0x1p-16, finish = 0.0, independent = 0x1p-16;
};

template <>
struct Eigen::NumTraits<lcpush::desktop::WideFloat>
    : Eigen::GenericNumTraits<lcpush::desktop::WideFloat> {
  using Real = lcpush::desktop::WideFloat;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 5,
    AddCost = 100,
    MulCost = 100
  };
  static Real epsilon() { return 0x1p-254; }
  static Real dummy_precision() { return 0x1p-220; }
  static int digits10() { return 76; }
};
