// One contact point: its tangent, wrench columns, friction generators, the acceleration it sees.
#pragma once

#include <cmath>
#include <type_traits>

#include "lcpush/mechanics/model/scene.hpp"
#include "lcpush/mechanics/model/settings.hpp"

namespace lcpush {

template <class S> Vector3<S> cross(const Vector3<S>& a, const Vector3<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// An inverse by Cramer's rule: row k of the adjugate over the determinant.
template <class S> struct Adjugate {
  Vector3<S> rows[3];
  S determinant;

  explicit Adjugate(const Matrix3<S>& matrix) {
    const Vector3<S> x = matrix.col(0), y = matrix.col(1), z = matrix.col(2);
    rows[0] = cross(y, z);
    rows[1] = cross(z, x);
    rows[2] = cross(x, y);
    determinant = x.dot(rows[0]);
  }
};

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
/// The same numbers for multiples of a 16th of the circle, computed by the compiler: in the working
/// precision, so that the bits are those of the series. Used for powers of two g alone: there
/// reducing j / g rounds nothing.
template <class S> struct CosineTable {
  static constexpr Index steps = 16;
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

/// The axis (0, 1 or 2 for x, y or z) least aligned with `normal`, the first of them on a tie.
/// Precondition: `normal` is a unit vector.
template <class S> Index least_aligned_axis(const Vector3<S>& normal) {
  using Eigen::numext::abs;
  const S tie = ModelSettings<S>::equal_components();
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

/// In a planar scene a body whose normal lies in the plane has friction along n x z alone, forth
/// and back: an interval in place of the cone. A torque about the normal would leave the plane.
template <class S> void lie_in_plane(Body<S>& body, bool is_planar = true) {
  const Vector3<S>& n = body.normal;
  body.in_plane = is_planar && Eigen::numext::abs(n[2]) <= ModelSettings<S>::equal_components();
  if (!body.in_plane) return;
  body.tangent = {n[1], S(0) - n[0], S(0)}; // from 0: no zero with a sign
  body.torsion_radius = S(0);
}

/// A unit of friction: a force in the contact plane, at a soft point a torque about the normal too.
template <class S> struct Generator {
  Vector3<S> force; ///< 1
  S torque;         ///< m, along the normal
};

/// Generators of a soft point: five angles between force and torque for each of the g directions,
/// and the pure torques.
constexpr Index soft_generators(Index g) { return 5 * g + 2; }

/// Generator k of a point with g facets in its friction space (LinearizedCone). The first g are
/// (cos(2 pi k / g), sin(2 pi k / g), 0). A soft point goes on with
/// (cos(psi) cos(2 pi j / g), cos(psi) sin(2 pi j / g), sin(psi)) for psi = 30, -30, 60, -60
/// degrees and ends with (0, 0, +-1).
template <class S> Vector3<S> generator_direction(Index k, Index g) {
  const Index angle = k / g;
  if (angle == 5) return {S(0), S(0), S(k == 5 * g ? 1 : -1)};
  const S x = circle_cosine<S>(k, g), y = circle_sine<S>(k, g);
  if (angle == 0) return {x, y, S(0)};
  const S half = S(1) / S(2), cos_30 = circle_cosine<S>(1, 12);
  const S cosine[] = {cos_30, cos_30, half, half};
  const S sine[] = {half, S(-half), cos_30, S(-cos_30)};
  return {cosine[angle - 1] * x, cosine[angle - 1] * y, sine[angle - 1]};
}

/// A direction of a body's friction space as a force and a torque.
template <class S> Generator<S> generator_along(const Body<S>& body, const Vector3<S>& u) {
  return {u[0] * body.tangent + u[1] * cross(body.normal, body.tangent),
          u[2] * body.torsion_radius};
}

/// A motion at a point of a body in its friction space: m/s^2, and rad/s^2 about the normal.
template <class S>
Vector3<S> in_friction_space(const Body<S>& body, const Vector3<S>& acceleration, const S& spin) {
  return {acceleration.dot(body.tangent), acceleration.dot(cross(body.normal, body.tangent)),
          S(body.torsion_radius * spin)};
}

/// How the object slips over point p of a body, in the same space; `relative` is its twist beside
/// the body's.
template <class S>
Vector3<S> slip_of(const Body<S>& body, const Vector3<S>& p, const Vector6<S>& relative) {
  return in_friction_space(body, acceleration_at(p, relative),
                           S(relative.template tail<3>().dot(body.normal)));
}

/// Generators of a hard point of this body in a scene of g facets.
template <class S> Index facets_of(const Body<S>& body, Index g) { return body.in_plane ? 2 : g; }

/// Friction generator k of a body with g facets: d_j = cos(2 pi j / g) t + sin(2 pi j / g) o,
/// o = n x t, and at a soft point the others of generator_direction.
template <class S> Generator<S> generator(const Body<S>& body, Index k, Index g) {
  return generator_along(body, generator_direction<S>(k, facets_of(body, g)));
}

/// The directions across a linearized cone: two unit vectors at a soft point, at a hard one the
/// first alone (the other is the torque that it has not).
template <class S> struct Across { Vector3<S> first, second; };
template <class S> Across<S> across(const LinearizedCone<S>& cone, bool is_soft) {
  const Vector3<S>& m = cone.along;
  if (!is_soft) return {{S(-m[1]), m[0], S(0)}, {S(0), S(0), S(1)}};
  // Any right-handed frame will do; this one needs no square root (Duff et al., JCGT 6, 2017).
  const S sign = m[0] < S(0) ? S(-1) : S(1), a = S(-1) / (sign + m[0]), b = m[1] * m[2] * a;
  return {{S(-sign * m[1]), S(1) + sign * m[1] * m[1] * a, sign * b},
          {S(-m[2]), b, sign + m[2] * m[2] * a}};
}

/// Friction generator k of a point of this body: turned to the linearized cone of round friction.
template <class S>
Generator<S> generator(const Scene<S>& scene, const Body<S>& body, Index point, Index k) {
  const Vector3<S> u = generator_direction<S>(k, facets_of(body, scene.facets));
  if (!has_round_friction(scene)) return generator_along(body, u);
  const LinearizedCone<S>& cone = scene.round_cones[point];
  const Across<S> side = across(cone, body.torsion_radius > S(0));
  return generator_along<S>(body, u[0] * cone.along + u[1] * side.first + u[2] * side.second);
}

/// Friction generators of one point of this body: none without friction.
template <class S> Index generator_count(const Scene<S>& scene, const Body<S>& body) {
  if (!(body.friction > S(0))) return 0;
  const Index g = facets_of(body, scene.facets);
  return body.torsion_radius > S(0) ? soft_generators(g) : g;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template double circle_cosine<double>(Index, Index);
extern template Generator<double> generator<double>(const Body<double>&, Index, Index);
#endif

} // namespace lcpush
