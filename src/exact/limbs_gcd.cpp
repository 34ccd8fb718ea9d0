// The greatest common divisor by Lehmer's method: the leading bits alone decide most quotients of
// Euclid's algorithm, and the long numbers see the product of some twenty steps at once.
#include "exact/limbs.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace lcpush::desktop::limbs {
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
