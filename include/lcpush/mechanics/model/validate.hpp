// Does a scene make sense that no file reader has checked: a table in flash, a C caller's?
#pragma once

#include "lcpush/mechanics/model/even_pressure.hpp"

namespace lcpush {

enum class Mistake {
  none,
  memory_too_small, ///< more than was promised
  not_finite,       ///< a number is NaN or infinite, or too large to go on with
  mass,             ///< mass <= 0, or an inertia that is not symmetric positive definite
  facets,           ///< not even, or outside of 4..256
  direction,        ///< a normal or tangent that is no unit vector, or not orthogonal
  friction,         ///< friction, torsion radius or preload < 0
  index,            ///< a body without points, or an index outside of its array
  actuator,         ///< force or inertia < 0, or nothing that it drives
  unsupported,      ///< a soft contact of several points; even pressure with a shared actuator
                    ///< or a preload; a preload on a body that an actuator drives
  nothing_moves,    ///< break: no pusher has an acceleration
  not_described,    ///< there is no scene yet
  weights,          ///< a weight <= 0, or those of a body do not sum to 1
  round_cones,      ///< of round friction: not one for each point
};

constexpr const char* mistake_text(Mistake mistake) {
  constexpr const char* texts[] = {
      "",
      "the memory is too small for the scene",
      "a number is not finite, or overflows when scaled",
      "the mass is not positive, or the inertia not positive definite",
      "facets must be even, from 4 to 256",
      "a normal is zero, or a tangent lies along it",
      "friction, torsion radius and preload must be >= 0",
      "a body has no points, or an index is outside of its array",
      "an actuator has a negative force or inertia, or drives nothing",
      ("a soft contact has several points, even pressure shares an actuator or a preload, or a "
       "driven body has a preload"),
      "no pusher moves: give one an acceleration",
      "there is no scene: describe one first",
      "weights must be > 0, one for each point",
      "round friction needs a linearized cone for each point"};
  if (mistake < Mistake::none || mistake > Mistake::round_cones) return "";
  return texts[static_cast<int>(mistake)];
}

namespace detail {

/// And not so large that the square of a product of two overflows: 4e9 in float.
template <class S> bool is_finite(const S& x) {
  const S square = x * x, power = square * square;
  return power - power == S(0);
}
template <class V> bool all_finite(const V& v) {
  for (Index i = 0; i < v.size(); ++i)
    if (!is_finite(v[i])) return false;
  return true;
}

/// Sylvester's criterion, relative to the largest entry.
template <class S> bool is_positive_definite(const Matrix3<S>& I) {
  S scale(0);
  for (Index k = 0; k < I.size(); ++k)
    scale = Eigen::numext::maxi(scale, S(Eigen::numext::abs(I.data()[k])));
  if (!(scale > S(0)) || !is_finite(scale)) return false;
  const Matrix3<S> A = I / scale;
  const S slack = ModelSettings<S>::symmetry();
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < i; ++j)
      if (!(Eigen::numext::abs(S(A(i, j) - A(j, i))) <= slack)) return false;
  const Adjugate<S> minors(A);
  return A(0, 0) > slack && minors.rows[2][2] > slack * slack &&
         minors.determinant > slack * slack * slack;
}

template <class S> Mistake mistake_of(const Body<S>& body) {
  const S slack = ModelSettings<S>::unit_length();
  const auto near = [&](const S& x, const S& y) { return Eigen::numext::abs(S(x - y)) <= slack; };
  const bool finite = all_finite(body.normal) && all_finite(body.tangent) &&
                      all_finite(body.acceleration) && is_finite(body.friction) &&
                      is_finite(body.torsion_radius) && is_finite(body.preload);
  if (!finite) return Mistake::not_finite;
  if (!near(body.normal.squaredNorm(), S(1)) || !near(body.tangent.squaredNorm(), S(1)) ||
      !near(body.normal.dot(body.tangent), S(0)))
    return Mistake::direction;
  if (body.friction < S(0) || body.torsion_radius < S(0) || body.preload < S(0))
    return Mistake::friction;
  if (body.torsion_radius > S(0) && body.point_count > 1) return Mistake::unsupported;
  return Mistake::none;
}

template <class S> Mistake mistake_of_point_data(const Scene<S>& scene) {
  if (has_round_friction(scene) && scene.round_cones.size != scene.points.size)
    return Mistake::round_cones;
  if (scene.weights.size == 0) return Mistake::none;
  if (scene.weights.size != scene.points.size) return Mistake::weights;
  for (const Body<S>& body : scene.bodies) {
    S sum(0);
    for (const Index i : points_of(body)) {
      if (!(scene.weights[i] > S(0))) return Mistake::weights;
      sum += scene.weights[i];
    }
    const S slack = ModelSettings<S>::sum_of_weights(body.point_count);
    if (!(Eigen::numext::abs(S(sum - S(1))) <= slack)) return Mistake::weights;
  }
  return Mistake::none;
}

/// A preload is held without an actuator, and pads alone know what it is for.
template <class S> bool has_stray_preload(const Scene<S>& scene) {
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (scene.bodies[b].preload > S(0) && (presses_evenly(scene) || is_driven(scene, b)))
      return true;
  return false;
}

template <class S> Mistake mistake_of_drives(const Scene<S>& scene) {
  for (const Drive<S>& drive : scene.drives) {
    if (drive.body < 0 || drive.body >= scene.bodies.size || drive.actuator < 0 ||
        drive.actuator >= scene.actuators.size)
      return Mistake::index;
    if (!all_finite(drive.twist)) return Mistake::not_finite;
  }
  for (Index a = 0; a < scene.actuators.size; ++a) {
    const Actuator<S>& actuator = scene.actuators[a];
    if (!is_finite(actuator.force) || !is_finite(actuator.inertia)) return Mistake::not_finite;
    bool drives = false;
    for (const Drive<S>& drive : scene.drives)
      drives = drives || (drive.actuator == a && drive.twist.squaredNorm() > S(0));
    if (actuator.force < S(0) || actuator.inertia < S(0) || !drives) return Mistake::actuator;
  }
  return Mistake::none;
}

} // namespace detail

/// The first thing that is wrong with a scene, or none. Bodies have to cover the points one after
/// the other, as everything in mechanics/ expects. Cost: O(points + drives actuators).
template <class S> Mistake find_mistake(const Scene<S>& scene) {
  using detail::all_finite;
  if (!all_finite(scene.gravity) || !detail::is_finite(scene.object.mass) ||
      !all_finite(scene.object.wrench))
    return Mistake::not_finite;
  if (!(scene.object.mass > S(0)) || !detail::is_positive_definite(scene.object.inertia))
    return Mistake::mass;
  if (scene.facets < 4 || scene.facets > 256 || scene.facets % 2 != 0) return Mistake::facets;
  for (const Vector3<S>& p : scene.points)
    if (!all_finite(p)) return Mistake::not_finite;
  Index covered = 0;
  for (const Body<S>& body : scene.bodies) {
    const Mistake mistake = detail::mistake_of(body);
    if (mistake != Mistake::none) return mistake;
    if (body.first_point != covered || body.point_count < 1 ||
        body.point_count > scene.points.size - covered)
      return Mistake::index;
    covered += body.point_count;
  }
  if (covered != scene.points.size || covered == 0) return Mistake::index;
  Mistake mistake = detail::mistake_of_drives(scene);
  if (mistake == Mistake::none) mistake = detail::mistake_of_point_data(scene);
  if (mistake != Mistake::none) return mistake;
  const bool shares = presses_evenly(scene) && shares_an_actuator(scene);
  return shares || detail::has_stray_preload(scene) ? Mistake::unsupported : Mistake::none;
}

} // namespace lcpush
