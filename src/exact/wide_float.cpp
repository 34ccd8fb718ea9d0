#include "exact/wide_float.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

using limbs::Limb;

WideFloat::WideFloat(const Rational& value) : sign_(value.sign()) {
  if (sign_ == 0) return;
  const BigInteger& below = value.denominator();
  const std::size_t room = static_cast<std::size_t>(bits_) + below.bit_length() + 1;
  const std::size_t length = value.numerator().bit_length();
  const std::size_t shift = room > length ? room - length : 0;
  const BigInteger quotient = (value.numerator() << shift) / below;
  const std::size_t bits = quotient.bit_length(); // more than a mantissa's
  const auto extra = bits - static_cast<std::size_t>(bits_);
  const BigInteger top = quotient >> extra;
  std::copy_n(top.magnitude(), std::min(top.limb_count(), limbs_), mantissa_);
  exponent_ = static_cast<int>(extra) - static_cast<int>(shift);
}

double WideFloat::value() const {
  double sum = 0;
  for (std::size_t k = limbs_; k-- > 0;) sum = sum * 0x1p64 + static_cast<double>(mantissa_[k]);
  return sign_ * std::ldexp(sum, exponent_);
}

/// The mantissa's highest bit is set again, or the number is zero.
void WideFloat::normalise() {
  std::size_t zeros = 0;
  while (zeros < limbs_ && mantissa_[limbs_ - 1 - zeros] == 0) ++zeros;
  if (zeros == limbs_) {
    sign_ = 0;
    return;
  }
  if (zeros > 0) {
    for (std::size_t k = limbs_; k-- > zeros;) mantissa_[k] = mantissa_[k - zeros];
    std::fill_n(mantissa_, zeros, Limb{0});
  }
  const int bits = limbs::leading_zeros(mantissa_[limbs_ - 1]);
  if (bits > 0) (void)limbs::shift_left(mantissa_, mantissa_, limbs_, bits);
  exponent_ -= bits + static_cast<int>(zeros) * limbs::limb_bits;
}

/// The mantissa loses its lowest bits. Pre: 0 <= bits < bits_.
void WideFloat::shift_down(int bits) {
  const auto whole = static_cast<std::size_t>(bits / limbs::limb_bits);
  for (std::size_t k = 0; k < limbs_; ++k)
    mantissa_[k] = k + whole < limbs_ ? mantissa_[k + whole] : 0;
  limbs::shift_right(mantissa_, mantissa_, limbs_, bits % limbs::limb_bits);
  exponent_ += bits;
}

WideFloat operator+(const WideFloat& a, const WideFloat& b) {
  if (b.sign_ == 0) return a;
  if (a.sign_ == 0) return b;
  if (a.exponent_ < b.exponent_) return b + a;
  if (a.exponent_ - b.exponent_ >= WideFloat::bits_) return a;
  constexpr std::size_t n = WideFloat::limbs_;
  WideFloat larger = a, smaller = b;
  smaller.shift_down(a.exponent_ - b.exponent_);
  if (a.sign_ == b.sign_) {
    const Limb carry = limbs::add(larger.mantissa_, larger.mantissa_, n, smaller.mantissa_, n);
    if (carry == 0) return larger;
    larger.shift_down(1);
    larger.mantissa_[n - 1] |= Limb{1} << 63U;
    return larger;
  }
  if (std::lexicographical_compare(std::rbegin(larger.mantissa_), std::rend(larger.mantissa_),
                                   std::rbegin(smaller.mantissa_), std::rend(smaller.mantissa_)))
    std::swap(larger, smaller);
  limbs::subtract(larger.mantissa_, larger.mantissa_, n, smaller.mantissa_, n);
  larger.normalise();
  return larger;
}

WideFloat operator*(const WideFloat& a, const WideFloat& b) {
  constexpr std::size_t n = WideFloat::limbs_;
  WideFloat result;
  if (a.sign_ == 0 || b.sign_ == 0) return result;
  Limb product[2 * n];
  limbs::multiply(product, a.mantissa_, n, b.mantissa_, n);
  result.sign_ = a.sign_ * b.sign_;
  result.exponent_ = a.exponent_ + b.exponent_ + WideFloat::bits_;
  if ((product[2 * n - 1] >> 63U) == 0) {
    (void)limbs::shift_left(product, product, 2 * n, 1);
    --result.exponent_;
  }
  std::copy_n(product + n, n, result.mantissa_);
  return result;
}

/// By Newton's method: every step doubles the digits of the reciprocal.
WideFloat operator/(const WideFloat& a, const WideFloat& b) {
  WideFloat unit = b; // 1 <= |unit| < 2
  unit.exponent_ = 1 - WideFloat::bits_;
  WideFloat reciprocal = 1 / unit.value();
  for (int step = 0; step < 3; ++step) reciprocal *= WideFloat(2) - unit * reciprocal;
  reciprocal.exponent_ -= b.exponent_ - unit.exponent_;
  return a * reciprocal;
}

int WideFloat::compare(const WideFloat& a, const WideFloat& b) {
  if (a.sign_ != b.sign_) return a.sign_ < b.sign_ ? -1 : 1;
  if (a.sign_ == 0) return 0;
  if (a.exponent_ != b.exponent_) return (a.exponent_ < b.exponent_) == (a.sign_ > 0) ? -1 : 1;
  return a.sign_ * limbs::compare(a.mantissa_, limbs_, b.mantissa_, limbs_);
}

} // namespace lcpush::desktop
