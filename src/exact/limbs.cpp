#include "exact/limbs.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lcpush::desktop::limbs {

int compare(const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  if (na != nb) return na < nb ? -1 : 1;
  for (std::size_t i = na; i-- > 0;)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

Limb add(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  Limb carry = 0;
  for (std::size_t i = 0; i < na; ++i) {
    const Wide sum = Wide{a[i]} + (i < nb ? b[i] : 0) + carry;
    out[i] = static_cast<Limb>(sum);
    carry = static_cast<Limb>(sum >> limb_bits);
  }
  return carry;
}

void subtract(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  Limb borrow = 0;
  for (std::size_t i = 0; i < na; ++i) {
    const Wide difference = Wide{a[i]} - (i < nb ? b[i] : 0) - borrow;
    out[i] = static_cast<Limb>(difference);
    borrow = static_cast<Limb>(difference >> limb_bits) & 1U;
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

/// out -= a b over na + 1 limbs; returns what is borrowed at the top.
Limb subtract_multiple(Limb* out, const Limb* a, std::size_t na, Limb b) {
  Limb borrow = 0;
  for (std::size_t i = 0; i < na; ++i) {
    const Wide product = Wide{a[i]} * b + borrow;
    const auto low = static_cast<Limb>(product);
    borrow = static_cast<Limb>(product >> limb_bits) + (out[i] < low ? 1 : 0);
    out[i] -= low;
  }
  const Limb before = out[na];
  out[na] -= borrow;
  return before < borrow ? 1 : 0;
}

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
    if (subtract_multiple(u + j, v, nb, digit) != 0) { // rare: two in 2^64 for random numbers
      --digit;
      u[j + nb] += add(u + j, u + j, nb, v, nb);
    }
    if (quotient != nullptr) quotient[j] = digit;
  }
  if (remainder != nullptr) shift_right(remainder, u, nb, shift);
}

// The greatest common divisor by Lehmer's method: the leading bits alone decide most quotients of
// Euclid's algorithm, and the long numbers see the product of some twenty steps at once.
namespace {

/// How many Euclidean steps were taken together, and what they make of a and b:
/// a' = |p a - q b|, b' = |s b - r a|.
struct Steps {
  int count = 0;
  Limb p = 1, q = 0, r = 0, s = 1;
};

/// The steps that the leading 62 bits x of a, and y of b at the same place, are enough to decide.
/// Every entry stays below 2^31. [Lehmer 1938, with Collins' test; Knuth 4.5.2 L]
Steps leading_steps(Limb x, Limb y) {
  Steps steps;
  auto& [count, p, q, r, s] = steps;
  for (; y != r; ++count) {
    const Limb quotient = (x + (p - 1)) / (y - r);
    const Limb next_r = q + quotient * s, rest = x - quotient * y;
    if (quotient * y > x || next_r > rest) break;
    x = std::exchange(y, rest);
    const Limb next_s = p + quotient * r;
    p = std::exchange(s, next_s);
    q = std::exchange(r, next_r);
  }
  return steps;
}

/// out = p a - q b over n limbs, known to be neither negative nor longer than n; may be a or b.
void combine(Limb* out, const Limb* a, Limb p, const Limb* b, Limb q, std::size_t n) {
  Limb carry_a = 0, carry_b = 0, borrow = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Wide pa = Wide{a[i]} * p + carry_a, qb = Wide{b[i]} * q + carry_b;
    carry_a = static_cast<Limb>(pa >> limb_bits);
    carry_b = static_cast<Limb>(qb >> limb_bits);
    const Wide difference = Wide{static_cast<Limb>(pa)} - static_cast<Limb>(qb) - borrow;
    out[i] = static_cast<Limb>(difference);
    borrow = static_cast<Limb>(difference >> limb_bits) & 1U;
  }
  assert(carry_a == carry_b + borrow);
}

Limb small_divisor(Limb a, Limb b) {
  while (b != 0) a = std::exchange(b, a % b);
  return a;
}

/// a without its trailing zero bits, in place; returns its length, and how many they were.
std::size_t make_odd(Limb* a, std::size_t na, std::size_t& zeros) {
  std::size_t whole = 0;
  while (a[whole] == 0) ++whole;
  const int bits = trailing_zeros(a[whole]);
  zeros = whole * limb_bits + static_cast<std::size_t>(bits);
  if (zeros > 0) shift_right(a, a + whole, na - whole, bits);
  return normal(a, na - whole);
}

/// The leading 62 bits of a, whose length is n, and those of b at the same place.
std::pair<Limb, Limb> leading_bits(const Limb* a, const Limb* b, std::size_t n) {
  const int shift = leading_zeros(a[n - 1]);
  const auto top = [&](const Limb* x) {
    const Limb high =
        shift == 0 ? x[n - 1] : (x[n - 1] << shift) | (x[n - 2] >> (limb_bits - shift));
    return high >> 2;
  };
  return {top(a), top(b)};
}

} // namespace

std::size_t greatest_common_divisor(Limb* out, Limb* a, std::size_t na, Limb* b, std::size_t nb) {
  // Powers of two are in every denominator that a double gave.
  std::size_t zeros_a = 0, zeros_b = 0;
  na = make_odd(a, na, zeros_a);
  nb = make_odd(b, nb, zeros_b);
  const std::size_t zeros = std::min(zeros_a, zeros_b);
  if (compare(a, na, b, nb) < 0) {
    std::swap(a, b);
    std::swap(na, nb);
  }
  Scratch memory(na);
  Limb* spare = memory.data();
  while (nb > 1) {
    Steps steps;
    if (na <= nb + 1) {
      if (na > nb) b[nb] = 0;
      const auto [x, y] = leading_bits(a, b, na);
      steps = leading_steps(x, y);
    }
    if (steps.count == 0) {
      divide(nullptr, a, a, na, b, nb);
      na = normal(a, nb);
      std::swap(a, b);
      std::swap(na, nb);
      continue;
    }
    if (steps.count % 2 == 0) {
      combine(spare, a, steps.p, b, steps.q, na);
      combine(b, b, steps.s, a, steps.r, na);
    } else {
      combine(spare, b, steps.p, a, steps.q, na);
      combine(b, a, steps.s, b, steps.r, na);
    }
    std::swap(a, spare);
    nb = normal(b, na);
    na = normal(a, na);
  }
  // b is a single limb or zero.
  if (nb == 1) {
    const Limb rest = divide_by_limb(a, a, na, b[0]);
    a[0] = small_divisor(b[0], rest);
    na = 1;
  }
  const std::size_t whole = zeros / limb_bits;
  std::fill_n(out, whole, Limb{0});
  const Limb above = shift_left(out + whole, a, na, static_cast<int>(zeros % limb_bits));
  na += whole;
  if (above != 0) out[na++] = above;
  return na;
}

} // namespace lcpush::desktop::limbs
