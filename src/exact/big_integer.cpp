#include "lcpush/desktop/big_integer.hpp"

#include "exact/limbs.hpp"
#include "text/whole_number.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lcpush::desktop {
namespace {

using limbs::limb_bits;
using limbs::Wide;

// The largest power of ten in a limb.
constexpr std::size_t limb_digits = 19;
constexpr BigInteger::Limb limb_power = 10'000'000'000'000'000'000U;

} // namespace

/// Room for `count` limbs, whose old contents are lost. Pre: count < 2^31.
BigInteger::Limb* BigInteger::room(std::size_t count) {
  if (count > std::max<std::size_t>(capacity_, 1)) {
    heap_.reset(new Limb[count]);
    capacity_ = static_cast<std::uint32_t>(count);
  }
  return limbs();
}

/// The first `count` limbs are the magnitude.
void BigInteger::finish(std::size_t count, bool is_negative) {
  const auto size = static_cast<std::int32_t>(limbs::normal(limbs(), count));
  size_ = is_negative ? -size : size;
}

template <class Wide> BigInteger BigInteger::of_two_limbs(Wide magnitude, bool is_negative) {
  const auto high = static_cast<Limb>(magnitude >> limb_bits);
  const std::size_t count = high == 0 ? 1 : 2;
  BigInteger result;
  Limb* const out = result.room(count);
  out[0] = static_cast<Limb>(magnitude);
  if (high != 0) out[1] = high;
  result.finish(count, is_negative);
  return result;
}

BigInteger& BigInteger::operator=(const BigInteger& other) {
  if (this == &other) return *this;
  const std::size_t size = other.count();
  std::copy_n(other.limbs(), size, room(size));
  size_ = other.size_;
  return *this;
}

std::size_t BigInteger::bit_length() const {
  const std::size_t size = count();
  if (size == 0) return 0;
  return size * limb_bits - static_cast<std::size_t>(limbs::leading_zeros(limbs()[size - 1]));
}

std::optional<BigInteger> BigInteger::parse(std::string_view text) {
  const bool is_negative = !text.empty() && text.front() == '-';
  if (is_negative) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  BigInteger number;
  while (!text.empty()) {
    // The first part takes what makes the others equally long.
    const std::size_t part =
        text.size() % limb_digits == 0 ? limb_digits : text.size() % limb_digits;
    const std::optional<Limb> digits = whole_number<Limb>(text.substr(0, part));
    if (!digits) return std::nullopt;
    number = number * limb_power + *digits;
    text.remove_prefix(part);
  }
  if (is_negative) number.negate();
  return number;
}

std::string BigInteger::text() const {
  if (size_ == 0) return "0";
  BigInteger rest = *this;
  std::size_t size = count();
  Limb* const data = rest.limbs();
  std::string reversed;
  while (size > 0) {
    Limb part = limbs::divide_by_limb(data, data, size, limb_power);
    size = limbs::normal(data, size);
    for (std::size_t k = 0; k < limb_digits && (size > 0 || part > 0); ++k, part /= 10)
      reversed += static_cast<char>('0' + part % 10);
  }
  if (size_ < 0) reversed += '-';
  return {reversed.rbegin(), reversed.rend()};
}

double BigInteger::value() const {
  const std::size_t length = bit_length();
  if (length > 1024) return size_ < 0 ? -HUGE_VAL : HUGE_VAL;
  const std::size_t dropped = length > limb_bits ? length - limb_bits : 0;
  const BigInteger top = abs(*this) >> dropped;
  Limb bits = top.low();
  // The last bit is far below a double's: there it stands for everything that was dropped.
  if (dropped > 0 && compare(top << dropped, abs(*this)) != 0) bits |= 1U;
  const double size = std::ldexp(static_cast<double>(bits), static_cast<int>(dropped));
  return size_ < 0 ? -size : size;
}

/// a + b, with b's sign as given.
BigInteger BigInteger::sum(const BigInteger& a, const BigInteger& b, bool b_negative) {
  const BigInteger *large = &a, *small = &b;
  bool is_negative = a.size_ < 0;
  const bool same_sign = is_negative == b_negative;
  const bool swap = same_sign ? a.count() < b.count()
                              : limbs::compare(a.limbs(), a.count(), b.limbs(), b.count()) < 0;
  if (swap) {
    std::swap(large, small);
    is_negative = b_negative;
  }
  const std::size_t size = large->count();
  BigInteger result;
  if (!same_sign) {
    limbs::subtract(result.room(size), large->limbs(), size, small->limbs(), small->count());
    result.finish(size, is_negative);
    return result;
  }
  if (size <= 1) return of_two_limbs(Wide{large->low()} + small->low(), is_negative);
  Limb* const out = result.room(size + 1);
  out[size] = limbs::add(out, large->limbs(), size, small->limbs(), small->count());
  result.finish(size + 1, is_negative);
  return result;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b) {
  return BigInteger::sum(a, b, b.size_ < 0);
}
BigInteger operator-(const BigInteger& a, const BigInteger& b) {
  return BigInteger::sum(a, b, b.size_ > 0);
}

BigInteger operator*(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  if (a.size_ == 0 || b.size_ == 0) return result;
  const std::size_t na = a.count(), nb = b.count();
  const bool is_negative = (a.size_ < 0) != (b.size_ < 0);
  if (na == 1 && nb == 1)
    return BigInteger::of_two_limbs(Wide{a.limbs()[0]} * b.limbs()[0], is_negative);
  limbs::multiply(result.room(na + nb), a.limbs(), na, b.limbs(), nb);
  result.finish(na + nb, is_negative);
  return result;
}

void BigInteger::divide(const BigInteger& a, const BigInteger& b, BigInteger* quotient,
                        BigInteger* remainder) {
  assert(b.size_ != 0);
  const std::size_t na = a.count(), nb = b.count();
  BigInteger whole, rest;
  if (limbs::compare(a.limbs(), na, b.limbs(), nb) < 0) {
    rest = a;
  } else {
    const std::size_t digits = na - nb + 1;
    limbs::divide(quotient != nullptr ? whole.room(digits) : nullptr,
                  remainder != nullptr ? rest.room(nb) : nullptr, a.limbs(), na, b.limbs(), nb);
    if (quotient != nullptr) whole.finish(digits, (a.size_ < 0) != (b.size_ < 0));
    if (remainder != nullptr) rest.finish(nb, a.size_ < 0);
  }
  if (quotient != nullptr) *quotient = std::move(whole);
  if (remainder != nullptr) *remainder = std::move(rest);
}

BigInteger::Limb BigInteger::modulo(Limb modulus) const {
  Wide rest = 0;
  for (std::size_t i = count(); i-- > 0;) rest = ((rest << limb_bits) | limbs()[i]) % modulus;
  const auto remainder = static_cast<Limb>(rest);
  return size_ < 0 && remainder != 0 ? modulus - remainder : remainder;
}

BigInteger operator/(const BigInteger& a, const BigInteger& b) {
  BigInteger quotient;
  BigInteger::divide(a, b, &quotient, nullptr);
  return quotient;
}

BigInteger operator%(const BigInteger& a, const BigInteger& b) {
  BigInteger remainder;
  BigInteger::divide(a, b, nullptr, &remainder);
  return remainder;
}

BigInteger operator<<(const BigInteger& a, std::size_t bits) {
  BigInteger result;
  if (a.size_ == 0) return result;
  const std::size_t whole = bits / limb_bits, size = a.count();
  if (bits + a.bit_length() <= limb_bits) {
    result.room(1)[0] = a.limbs()[0] << bits;
    result.finish(1, a.size_ < 0);
    return result;
  }
  BigInteger::Limb* const out = result.room(size + whole + 1);
  std::fill_n(out, whole, BigInteger::Limb{0});
  out[size + whole] =
      limbs::shift_left(out + whole, a.limbs(), size, static_cast<int>(bits % limb_bits));
  result.finish(size + whole + 1, a.size_ < 0);
  return result;
}

BigInteger operator>>(const BigInteger& a, std::size_t bits) {
  BigInteger result;
  const std::size_t whole = bits / limb_bits, size = a.count();
  if (whole >= size) return result;
  limbs::shift_right(result.room(size - whole), a.limbs() + whole, size - whole,
                     static_cast<int>(bits % limb_bits));
  result.finish(size - whole, a.size_ < 0);
  return result;
}

BigInteger gcd(const BigInteger& a, const BigInteger& b) {
  const std::size_t na = a.count(), nb = b.count();
  if (na == 0) return abs(b);
  if (nb == 0) return abs(a);
  BigInteger result;
  if ((na == 1 && a.limbs()[0] == 1) || (nb == 1 && b.limbs()[0] == 1)) return BigInteger(1);
  const std::size_t room = std::max(na, nb);
  limbs::Scratch memory(3 * room);
  BigInteger::Limb *const x = memory.data(), *const y = x + room, *const divisor = y + room;
  std::copy_n(a.limbs(), na, x);
  std::copy_n(b.limbs(), nb, y);
  const std::size_t size = limbs::greatest_common_divisor(divisor, x, na, y, nb);
  std::copy_n(divisor, size, result.room(size));
  result.finish(size, false);
  return result;
}

BigInteger root(const BigInteger& a) {
  assert(a.size_ >= 0);
  if (a.size_ == 0) return a;
  // Newton from above falls until it is there.
  BigInteger x = BigInteger(1) << ((a.bit_length() + 1) / 2);
  for (;;) {
    BigInteger next = (x + a / x) >> 1U;
    if (next >= x) return x;
    x = std::move(next);
  }
}

int BigInteger::compare(const BigInteger& a, const BigInteger& b) {
  if (a.sign() != b.sign()) return a.sign() < b.sign() ? -1 : 1;
  const int sizes = limbs::compare(a.limbs(), a.count(), b.limbs(), b.count());
  return a.size_ < 0 ? -sizes : sizes;
}

} // namespace lcpush::desktop
