// One contact point: its tangent, wrench columns, friction generators, the acceleration it sees.
#pragma once

#include <cmath>
#include <type_traits>

#include "lcpush/mechanics/model/scene.hpp"

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
/// differ between machines. Each term is less than a third of the one before, so that after one
/// that changes nothing no other does.
template <class S> constexpr S sine_series(const S& x, S term, int k) {
  S sum = term;
  for (; k < 26; k += 2) {
    term = -term * x * x / S(k * (k + 1));
    const S next = sum + term;
    if (next == sum) break;
    sum = next;
  }
  return sum;
}
template <class S> constexpr S circle_angle(Index j, Index g) {
  return S(6.283185307179586476925286766559L) * S(j) / S(g);
}
/// cos(2 pi j / g) in the first quarter.
template <class S> constexpr S quarter_cosine(Index j, Index g) {
  if (4 * j == g) return S(0);
  if (8 * j <= g) return sine_series(circle_angle<S>(j, g), S(1), 1);
  const S x = circle_angle<S>(g - 4 * j, 4 * g);
  return sine_series(x, x, 2);
}
/// The same numbers for multiples of a 64th of the circle, computed by the compiler: in the working
/// precision, so that the bits are those of the series. Used for powers of two g alone: there
/// reducing j / g rounds nothing.
template <class S> struct CosineTable {
  static constexpr Index steps = 64;
  S quarter[steps / 4 + 1];
  constexpr CosineTable() : quarter{} {
    for (Index k = 0; k <= steps / 4; ++k) quarter[k] = quarter_cosine<S>(k, steps);
  }
};
template <class S> inline constexpr CosineTable<S> cosine_table{};
} // namespace detail

/// cos(2 pi j / g) for g even, through the circle's symmetries: multiples of 90 degrees are exactly
/// 0 and +-1, opposite directions exact negatives, mirrored ones the same bits.
template <class S> S circle_cosine(Index j, Index g) {
  j = ((j % g) + g) % g;
  if (2 * j > g) j = g - j;
  if (4 * j > g) return -circle_cosine<S>(g / 2 - j, g);
  if constexpr (std::is_floating_point_v<S>) {
    constexpr Index steps = detail::CosineTable<S>::steps;
    const bool is_power = (g & (g - 1)) == 0;
    if (is_power && j * steps % g == 0) return detail::cosine_table<S>.quarter[j * steps / g];
  }
  return detail::quarter_cosine<S>(j, g);
}

/// sin(2 pi j / g), in the same way.
template <class S> S circle_sine(Index j, Index g) { return circle_cosine<S>(4 * j - g, 4 * g); }

/// The unit vector along the projection of `direction` onto the plane orthogonal to `normal`.
/// Preconditions: `normal` is a unit vector, `direction` is not parallel to it.
template <class S> Vector3<S> tangent_along(const Vector3<S>& normal, const Vector3<S>& direction) {
  return (direction - normal * normal.dot(direction)).normalized();
}

/// The axis (0, 1 or 2 for x, y or z) least aligned with `normal`, the first of them on a tie. A
/// tie is up to 1e-9 (a float's rounding: 1e-6), so that a normal which is a rounding error off an
/// axis does not turn the friction pyramid. Precondition: `normal` is a unit vector.
template <class S> Index least_aligned_axis(const Vector3<S>& normal) {
  using Eigen::numext::abs;
  const S tie = S(1) / S(std::is_same_v<S, float> ? 1000000 : 1000000000);
  Index axis = 0;
  for (Index i = 1; i < 3; ++i)
    if (abs(normal[i]) < abs(normal[axis]) - tie) axis = i;
  return axis;
}

/// The tangent of a contact that names none: along the projection of the axis least aligned with
/// `normal`. Precondition: `normal` is a unit vector.
template <class S> Vector3<S> default_tangent(const Vector3<S>& normal) {
  return tangent_along<S>(normal, Vector3<S>::Unit(least_aligned_axis(normal)));
}

/// A unit of friction: a force in the contact plane, at a soft point a torque about the normal too.
template <class S> struct Generator {
  Vector3<S> force; ///< 1
  S torque;         ///< m, along the normal
};

/// Generators of a soft point: five angles between force and torque for each of the g directions,
/// and the pure torques.
constexpr Index soft_generators(Index g) { return 5 * g + 2; }

/// Friction generator k of a body with g facets. The first g are the forces
/// d_j = cos(2 pi j / g) t + sin(2 pi j / g) o, o = n x t. A soft point of torsion radius r goes on
/// with [cos(psi) d_j ; r sin(psi)] for psi = 30, -30, 60, -60 degrees and ends with [0 ; +-r].
template <class S> Generator<S> generator(const Body<S>& body, Index k, Index g) {
  const Index angle = k / g;
  const S r = body.torsion_radius;
  if (angle == 5) return {Vector3<S>::Zero(), k == 5 * g ? r : S(-r)};
  const Vector3<S> d = circle_cosine<S>(k, g) * body.tangent +
                       circle_sine<S>(k, g) * cross(body.normal, body.tangent);
  if (angle == 0) return {d, S(0)};
  const S half = S(1) / S(2), cos_30 = circle_cosine<S>(1, 12);
  const S cosine[] = {cos_30, cos_30, half, half};
  const S sine[] = {half, S(-half), cos_30, S(-cos_30)};
  return {cosine[angle - 1] * d, sine[angle - 1] * r};
}

/// Friction generators of one point of this body: none without friction.
template <class S> Index generator_count(const Scene<S>& scene, const Body<S>& body) {
  if (!(body.friction > S(0))) return 0;
  return body.torsion_radius > S(0) ? soft_generators(scene.facets) : scene.facets;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template double circle_cosine<double>(Index, Index);
extern template Generator<double> generator<double>(const Body<double>&, Index, Index);
#endif

} // namespace lcpush
