// One contact point: wrench columns, friction generators, the acceleration it sees.
#pragma once

#include "lcpush/mechanics/scene.hpp"

namespace lcpush {

template <class S> Vector3<S> cross(const Vector3<S>& a, const Vector3<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// W(u) = [u ; p x u]: the wrench at the centre of mass of a unit force along u at p.
template <class S> Vector6<S> wrench_column(const Vector3<S>& p, const Vector3<S>& u) {
  Vector6<S> column;
  column << u, cross(p, u);
  return column;
}

/// The acceleration at p of a body that starts from rest with this twist.
template <class S> Vector3<S> acceleration_at(const Vector3<S>& p, const Vector6<S>& twist) {
  const Vector3<S> linear = twist.template head<3>(), angular = twist.template tail<3>();
  return linear + cross(angular, p);
}

namespace detail {
/// Taylor's series, exact to rounding for 0 <= x <= pi/4. Own code, because the bits of a libm
/// differ between machines.
template <class S> S sine_series(const S& x, S term, int k) {
  S sum = term;
  for (; k < 26; k += 2) {
    term = -term * x * x / S(k * (k + 1));
    sum += term;
  }
  return sum;
}
template <class S> S first_octant_sine(Index j, Index g) {
  const S x = S(6.283185307179586476925286766559L) * S(j) / S(g);
  return sine_series(x, x, 2);
}
template <class S> S first_octant_cosine(Index j, Index g) {
  const S x = S(6.283185307179586476925286766559L) * S(j) / S(g);
  return sine_series(x, S(1), 1);
}
} // namespace detail

/// cos(2 pi j / g) for g even, through the circle's symmetries: multiples of 90 degrees are exactly
/// 0 and +-1, opposite directions exact negatives, mirrored ones the same bits.
template <class S> S circle_cosine(Index j, Index g) {
  j = ((j % g) + g) % g;
  if (2 * j > g) j = g - j;
  if (4 * j > g) return -circle_cosine<S>(g / 2 - j, g);
  if (4 * j == g) return S(0);
  if (8 * j <= g) return detail::first_octant_cosine<S>(j, g);
  return detail::first_octant_sine<S>(g - 4 * j, 4 * g);
}

/// sin(2 pi j / g), in the same way.
template <class S> S circle_sine(Index j, Index g) { return circle_cosine<S>(4 * j - g, 4 * g); }

/// The friction generator d_j = cos(2 pi j / g) t + sin(2 pi j / g) o of a body, o = n x t.
template <class S> Vector3<S> generator(const Body<S>& body, Index j, Index g) {
  return circle_cosine<S>(j, g) * body.tangent +
         circle_sine<S>(j, g) * cross(body.normal, body.tangent);
}

/// Friction generators of one point of this body: none without friction.
template <class S> Index generator_count(const Scene<S>& scene, const Body<S>& body) {
  return body.friction > S(0) ? scene.facets : 0;
}

} // namespace lcpush
