// Whole numbers modulo the prime 2^61 - 1, whose remainders need no division.
#pragma once

#include "exact/limbs.hpp"

namespace lcpush::desktop::modular {

using limbs::Limb, limbs::Wide;

constexpr int bits = 61;
constexpr Limb prime = (Limb{1} << bits) - 1;

inline Limb remainder(Limb a) {
  a = (a & prime) + (a >> bits);
  return a >= prime ? a - prime : a;
}
inline Limb times(Limb a, Limb b) {
  const Wide product = Wide{a} * b;
  return remainder(static_cast<Limb>(product & prime) + static_cast<Limb>(product >> bits));
}
inline Limb minus(Limb a, Limb b) { return a >= b ? a - b : a + prime - b; }

/// Fermat's little theorem.
inline Limb inverse_of(Limb a) {
  Limb result = 1;
  for (Limb exponent = prime - 2; exponent > 0; exponent >>= 1U, a = times(a, a))
    if ((exponent & 1U) != 0) result = times(result, a);
  return result;
}

} // namespace lcpush::desktop::modular
