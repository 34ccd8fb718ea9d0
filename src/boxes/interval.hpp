// Intervals of fractions that surely hold a number: one point where it is a fraction itself.
#pragma once

#include "boxes/settings.hpp"
#include "lcpush/desktop/rational.hpp"

#include <algorithm>
#include <utility>

namespace lcpush::desktop {

struct Interval {
  Rational low, high;

  Interval() = default;
  Interval(Rational point) : low(point), high(std::move(point)) {} // NOLINT: implicit on purpose
  Interval(Rational a, Rational b) : low(std::move(a)), high(std::move(b)) {}
  bool is_point() const { return low == high; }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return {a.low - b.high, a.high - b.low};
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (a.is_point() && b.is_point()) return a.low * b.low;
    const Rational ends[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {*std::min_element(ends, ends + 4), *std::max_element(ends, ends + 4)};
  }
};

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// x and what is nearer to it than `by`.
inline Interval about(const Rational& x, const Rational& by) {
  return by.sign() == 0 ? Interval(x) : Interval(x - by, x + by);
}

/// The fraction of 2^bits below, or above, x.
inline Rational on_grid(const Rational& x, bool upwards) {
  const BigInteger unit = BigInteger(1) << box_settings.grid_bits;
  BigInteger quotient, rest;
  BigInteger::divide(x.numerator() * unit, x.denominator(), &quotient, &rest);
  if (rest.sign() > 0 && upwards) quotient = quotient + 1;
  if (rest.sign() < 0 && !upwards) quotient = quotient - 1;
  return {std::move(quotient), unit};
}

/// The same, or a little wider, with short ends.
inline Interval shortened(const Interval& x) {
  if (x.low.bit_length() <= box_settings.short_bits &&
      x.high.bit_length() <= box_settings.short_bits)
    return x;
  return {on_grid(x.low, false), on_grid(x.high, true)};
}

/// Of numbers >= 0; what lies below counts as 0.
inline Interval root(const Interval& x) {
  const auto end = [](const Rational& a, bool upwards) -> Rational {
    if (a.sign() <= 0) return 0;
    if (std::optional<Rational> exact = exact_root(a)) return *exact;
    const BigInteger unit = BigInteger(1) << box_settings.grid_bits;
    const BigInteger whole = root(a.numerator() * unit * unit / a.denominator());
    return {upwards ? whole + 1 : whole, unit};
  };
  return {end(x.low, false), end(x.high, true)};
}

/// Pre: 0 < b.
inline Interval operator/(const Interval& a, const Interval& b) {
  return a * Interval(Rational(1) / b.high, Rational(1) / b.low);
}

} // namespace lcpush::desktop
