// Arithmetic on magnitudes: arrays of 64-bit limbs, least significant first. The callers see to
// the memory; lengths count limbs, and a length without leading zeros is called normal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace lcpush::desktop::limbs {

using Limb = std::uint64_t;
__extension__ typedef unsigned __int128 Wide; // NOLINT: __extension__ needs a typedef
constexpr int limb_bits = 64;

/// Uninitialised memory for `size` limbs, on the stack if they are few.
class Scratch {
public:
  explicit Scratch(std::size_t size) {
    if (size > on_stack) heap_.reset(new Limb[size]);
  }
  Limb* data() { return heap_ ? heap_.get() : stack_; }

private:
  static constexpr std::size_t on_stack = 160;
  Limb stack_[on_stack];
  std::unique_ptr<Limb[]> heap_;
};

inline int leading_zeros(Limb x) { return __builtin_clzll(x); }  ///< pre: x != 0
inline int trailing_zeros(Limb x) { return __builtin_ctzll(x); } ///< pre: x != 0

inline std::size_t normal(const Limb* a, std::size_t na) {
  while (na > 0 && a[na - 1] == 0) --na;
  return na;
}

/// < 0, 0 or > 0 as a is below, equal to or above b; both lengths normal.
int compare(const Limb* a, std::size_t na, const Limb* b, std::size_t nb);

/// out = a + b with na >= nb, na limbs; returns the carry. `out` may be a or b.
Limb add(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb);

/// out = a - b with a >= b, na limbs. `out` may be a or b.
void subtract(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb);

/// out = a b, na + nb limbs, apart from both. Cost: na nb.
void multiply(Limb* out, const Limb* a, std::size_t na, const Limb* b, std::size_t nb);

/// out = a << bits with 0 <= bits < 64; returns what leaves at the top. `out` may be a.
Limb shift_left(Limb* out, const Limb* a, std::size_t na, int bits);

/// out = a >> bits with 0 <= bits < 64. `out` may be a.
void shift_right(Limb* out, const Limb* a, std::size_t na, int bits);

/// out = a / d (na limbs, may be a); returns the remainder. Pre: d != 0.
Limb divide_by_limb(Limb* out, const Limb* a, std::size_t na, Limb d);

/// quotient = a / b (na - nb + 1 limbs), remainder = a mod b (nb limbs); either may be nullptr, and
/// remainder may be a. Pre: lengths normal, na >= nb >= 1. Cost: nb (na - nb).
void divide(Limb* quotient, Limb* remainder, const Limb* a, std::size_t na, const Limb* b,
            std::size_t nb);

/// out = the greatest common divisor (at most min(na, nb) limbs); returns its normal length. a and
/// b are used up. Pre: lengths normal and >= 1. Cost: quadratic (Lehmer's method).
std::size_t greatest_common_divisor(Limb* out, Limb* a, std::size_t na, Limb* b, std::size_t nb);

} // namespace lcpush::desktop::limbs
