// How large the terms of the referee's rows are. A row fails by what is left of it against the sum
// of its own terms, so that a large force elsewhere hides nothing small.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush {
namespace detail {

/// |p x u| at most, component by component.
template <class S> Vector3<S> cross_size(const Vector3<S>& p, const Vector3<S>& u) {
  const Vector3<S> a = p.cwiseAbs(), b = u.cwiseAbs();
  return {a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]};
}

/// The sum of |terms| of body_wrench, axis by axis.
template <class S>
Vector6<S> wrench_size(const Scene<S>& scene, const Answer<S>& answer, const Body<S>& body) {
  using Eigen::numext::abs;
  Vector6<S> total = Vector6<S>::Zero();
  const Vector3<S> n = body.normal.cwiseAbs();
  for (const Index i : points_of(body)) {
    const ContactAnswer<S>& contact = answer.contacts[i];
    const Vector3<S> force = abs(contact.normal_force) * n + contact.friction_force.cwiseAbs();
    total.template head<3>() += force;
    total.template tail<3>() += cross_size(scene.points[i], force) + abs(contact.torsion) * n;
  }
  return total;
}

/// The sum of |terms| of body_twist.
template <class S>
Vector6<S> twist_size(const Scene<S>& scene, const Answer<S>& answer, Index body, S sigma) {
  using Eigen::numext::abs;
  Vector6<S> size = abs(sigma) * scene.bodies[body].acceleration.cwiseAbs();
  for (const Drive<S>& drive : scene.drives)
    if (drive.body == body) size += abs(answer.closing[drive.actuator]) * drive.twist.cwiseAbs();
  return size;
}

/// The same at a point.
template <class S> Vector3<S> size_at(const Vector3<S>& p, const Vector6<S>& twist) {
  return twist.template head<3>() + cross_size<S>(twist.template tail<3>(), p);
}

/// F / m; in a step in time, which begins with velocities, those of bodies beside the object too.
template <class S> S fastest_of(const Scene<S>& scene, const Scales<S>& scales) {
  const bool is_step = scene.clearances.size > 0;
  return is_step ? fastest_body(scene, scales.length, scales.acceleration) : scales.acceleration;
}

template <class S> struct TermSizes {
  Vector6<S> wrench;       ///< [T.1] axis by axis: N, N m
  Vector6<S> acceleration; ///< what forces of that size make of the object: m/s^2, rad/s^2
  S load{0};               ///< N: the object's weight and the wrench on it, which are given

  /// |I^-1| |moment|.
  static Vector3<S> turning_size(const Matrix3<S>& inertia, const Vector3<S>& moment) {
    const Adjugate<S> inverse(inertia);
    Vector3<S> size;
    for (Index k = 0; k < 3; ++k)
      size[k] = inverse.rows[k].cwiseAbs().dot(moment) / Eigen::numext::abs(inverse.determinant);
    return size;
  }

  TermSizes(const Scene<S>& scene, const Scales<S>& scales, const Answer<S>& answer) {
    const Object<S>& object = scene.object;
    const Vector3<S> weight = object.mass * scene.gravity;
    wrench = object.wrench.cwiseAbs();
    load = weight.norm() + object.wrench.template head<3>().norm() +
           object.wrench.template tail<3>().norm() / scales.length;
    wrench.template head<3>() += weight.cwiseAbs();
    wrench.template tail<3>() += object.turning.cwiseAbs();
    for (const Body<S>& body : scene.bodies) wrench += wrench_size(scene, answer, body);
    const Vector6<S> a = answer.acceleration.cwiseAbs();
    acceleration = a;
    acceleration.template head<3>() += wrench.template head<3>() / object.mass;
    const Vector3<S> moment = wrench.template tail<3>();
    if (scene.planar)
      acceleration[5] += moment[2] / object.inertia(2, 2);
    else
      acceleration.template tail<3>() += turning_size(object.inertia, moment);
    wrench.template head<3>() += object.mass * a.template head<3>();
    const Matrix3<S> inertia = object.inertia.cwiseAbs();
    wrench.template tail<3>() += inertia.lazyProduct(a.template tail<3>());
  }
};

/// F, or what rounding makes of a reaction so large that F is lost in it: near a wedge reactions
/// grow without bound.
template <class S>
Scales<S> scales_of_reactions(const Scene<S>& scene, Scales<S> scales, const Answer<S>& answer) {
  for (Index i = 0; i < scene.points.size; ++i) {
    const S rounding = Tolerances<S>().noise * Eigen::numext::abs(answer.contacts[i].normal_force);
    if (rounding > scales.force) scales.force = rounding;
  }
  scales.acceleration =
      Eigen::numext::maxi(scales.acceleration, S(scales.force / scene.object.mass));
  return scales;
}

/// What a row is measured in: its own terms and what rounding leaves of the scene's size, never
/// more than that size. `given`, where it is not 0, is a load of the row that must not be lost:
/// then rounding may take a hundred thousandth of it (in float as much as a residual).
template <class S> S row_unit_of(const S& own, const S& common, const S& given = S(0)) {
  using Eigen::numext::mini;
  const Tolerances<S> tolerances;
  S noise = tolerances.noise * common;
  if (given > S(0)) {
    const S part = ModelSettings<S>::part_of_load();
    const S most = tolerances.residual < part ? S(part / tolerances.residual) : S(1);
    noise = mini(noise, S(most * given));
  }
  return mini(common, S(own + noise));
}

} // namespace detail
#ifdef LCPUSH_EXTERN_TEMPLATES
extern template struct detail::TermSizes<double>;
#endif

} // namespace lcpush
