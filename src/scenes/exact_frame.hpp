// Contact frames and points in either scalar: rounded in double, exact in fractions where they can
// be.
#pragma once

#include "lcpush/desktop/big_integer.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/types.hpp"

#include <optional>

namespace lcpush::desktop {

inline double as_double(double x) { return x; }
inline double as_double(const Rational& x) { return x.value(); }
template <class S> Vector3<double> as_doubles(const Vector3<S>& v) {
  return {as_double(v[0]), as_double(v[1]), as_double(v[2])};
}

/// The unit vectors of a contact; `..._exact` is false for the exact value of a rounded one.
template <class S> struct ContactFrame {
  Vector3<S> normal;
  Vector3<S> tangent;
  bool normal_exact = true;
  bool tangent_exact = true;
};

/// The frame of a contact with this normal and, if it has a value, the tangent nearest to
/// `direction`. Pre: `normal` is not zero, `direction` not parallel to it.
ContactFrame<double> contact_frame(const Vector3<double>& normal,
                                   const std::optional<Vector3<double>>& direction);
ContactFrame<Rational> contact_frame(const Vector3<Rational>& normal,
                                     const std::optional<Vector3<Rational>>& direction);

/// Points of a disc or ring about `center`; false if they are irrational. Then their coordinates in
/// the contact plane, seen from the center, are the exact values of doubles.
bool sample_round(bool is_disc, const Vector3<double>& center, const ContactFrame<double>& frame,
                  double radius, Span<Vector3<double>> points);
bool sample_round(bool is_disc, const Vector3<Rational>& center,
                  const ContactFrame<Rational>& frame, const Rational& radius,
                  Span<Vector3<Rational>> points);

/// The fraction nearest to `x` among those with denominators up to `most`.
Rational simplest_near(const Rational& x, const BigInteger& most = 1'000'000'000);

} // namespace lcpush::desktop
