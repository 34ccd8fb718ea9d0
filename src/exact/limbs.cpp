#include "exact/limbs.hpp"

#include <algorithm>

namespace lcpush::desktop::limbs {

int compare(const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  if (na != nb) return na < nb ? -1 : 1;
  for (std::size_t i = na; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

Limb add(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  Limb carry = 0;
  for (std::size_t i = 0; i < nb; ++i) {
    const Wide sum = Wide{a[i]} + b[i] + carry;
    out[i] = static_cast<Limb>(sum);
    carry = static_cast<Limb>(sum >> limb_bits);
  }
  for (std::size_t i = nb; i < na; ++i) {
    const Limb sum = a[i] + carry;
    carry = sum < carry ? 1 : 0;
    out[i] = sum;
  }
  return carry;
}

void subtract(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  Limb borrow = 0;
  for (std::size_t i = 0; i < nb; ++i) {
    const Wide difference = Wide{a[i]} - b[i] - borrow;
    out[i] = static_cast<Limb>(difference);
    borrow = static_cast<Limb>(difference >> limb_bits) & 1U;
  }
  for (std::size_t i = nb; i < na; ++i) {
    const Limb x = a[i];
    out[i] = x - borrow;
    borrow = x < borrow ? 1 : 0;
  }
}

void multiply(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  std::fill_n(out, na, Limb{0});
  for (std::size_t j = 0; j < nb; ++j) {
    Limb carry = 0;
    for (std::size_t i = 0; i < na; ++i) {
      const Wide sum = Wide{a[i]} * b[j] + out[i + j] + carry;
      out[i + j] = static_cast<Limb>(sum);
      carry = static_cast<Limb>(sum >> limb_bits);
    }
    out[na + j] = carry;
  }
}

Limb shift_left(Limb* out, const Limb* a, std::size_t na, int bits) {
  if (bits == 0) {
    if (out != a) std::copy_n(a, na, out);
    return 0;
  }
  Limb above = 0;
  for (std::size_t i = na; i-- > 0;) {
    const Limb x = a[i];
    if (i + 1 == na) above = x >> (limb_bits - bits);
    out[i] = (x << bits) | (i > 0 ? a[i - 1] >> (limb_bits - bits) : 0);
  }
  return above;
}

void shift_right(Limb* out, const Limb* a, std::size_t na, int bits) {
  if (bits == 0) {
    if (out != a) std::copy_n(a, na, out);
    return;
  }
  for (std::size_t i = 0; i < na; ++i)
    out[i] = (a[i] >> bits) | (i + 1 < na ? a[i + 1] << (limb_bits - bits) : 0);
}

Limb divide_by_limb(Limb* out, const Limb* a, std::size_t na, Limb d) {
  Limb rest = 0;
  for (std::size_t i = na; i-- > 0;) {
    const Wide both = (Wide{rest} << limb_bits) | a[i];
    out[i] = static_cast<Limb>(both / d);
    rest = static_cast<Limb>(both % d);
  }
  return rest;
}

namespace {

/// One digit of the quotient, at most one too large, from the leading limbs: u is the rest's three,
/// v the divisor's two with the highest bit set. [Knuth, The Art of Computer Programming, 4.3.1 D3]
Limb estimated_digit(const Limb u[3], const Limb v[2]) {
  constexpr Limb largest = ~Limb{0};
  const Wide top = (Wide{u[2]} << limb_bits) | u[1];
  Limb digit = u[2] >= v[1] ? largest : static_cast<Limb>(top / v[1]);
  Wide rest = top - Wide{digit} * v[1];
  while ((rest >> limb_bits) == 0 && Wide{digit} * v[0] > ((rest << limb_bits) | u[0])) {
    --digit;
    rest += v[1];
  }
  return digit;
}

/// u -= digit v over nb + 1 limbs of u; true if that went below zero.
bool subtract_multiple(Limb* u, const Limb* v, std::size_t nb, Limb digit) {
  Limb carry = 0, borrow = 0;
  for (std::size_t i = 0; i < nb; ++i) {
    const Wide product = Wide{digit} * v[i] + carry;
    carry = static_cast<Limb>(product >> limb_bits);
    const Wide difference = Wide{u[i]} - static_cast<Limb>(product) - borrow;
    u[i] = static_cast<Limb>(difference);
    borrow = static_cast<Limb>(difference >> limb_bits) & 1U;
  }
  const Wide difference = Wide{u[nb]} - carry - borrow;
  u[nb] = static_cast<Limb>(difference);
  return (difference >> limb_bits) != 0;
}

} // namespace

void divide(Limb* quotient, Limb* remainder, const Limb* a, std::size_t na, const Limb* b,
            std::size_t nb) {
  const int shift = leading_zeros(b[nb - 1]);
  Scratch memory(na + 1 + nb);
  Limb* const u = memory.data();
  if (nb == 1) {
    const Limb rest = divide_by_limb(quotient != nullptr ? quotient : u, a, na, b[0]);
    if (remainder != nullptr) remainder[0] = rest;
    return;
  }
  Limb* const v = u + na + 1;
  u[na] = shift_left(u, a, na, shift);
  shift_left(v, b, nb, shift);
  for (std::size_t j = na - nb + 1; j-- > 0;) {
    Limb digit = estimated_digit(u + j + nb - 2, v + nb - 2);
    if (subtract_multiple(u + j, v, nb, digit)) { // rare: two in 2^64 for random numbers
      --digit;
      u[j + nb] += add(u + j, u + j, nb, v, nb);
    }
    if (quotient != nullptr) quotient[j] = digit;
  }
  if (remainder != nullptr) shift_right(remainder, u, nb, shift);
}

} // namespace lcpush::desktop::limbs
