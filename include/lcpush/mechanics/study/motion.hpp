// An acceleration from rest in words a person uses: slide, pivot, roll, and about which axis.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"

namespace lcpush {

enum class MotionKind {
  rest,  ///< does not move in the grip
  slide, ///< translates
  pivot, ///< turns about an axis through the grip
  roll,  ///< turns, carried by a surface that moves along itself and does not slip
  turn,  ///< translates and turns
};

/// The screw of an acceleration [a; alpha] from rest: alpha about an axis, pitch along it.
template <class S> struct Motion {
  MotionKind kind = MotionKind::rest;
  Vector3<S> direction = Vector3<S>::Zero();  ///< unit, of a translation; zero if it turns
  S translation{0};                           ///< m/s^2, |a| of the centre of mass
  Vector3<S> axis = Vector3<S>::Zero();       ///< unit, of the rotation; zero if it does not turn
  Vector3<S> axis_point = Vector3<S>::Zero(); ///< m from the centre of mass, nearest to it
  S rotation{0};                              ///< rad/s^2
  S pitch{0}; ///< m per rad; 0: pure rotation, axis_point is the instantaneous centre
};

namespace detail {

/// Does the axis pass through the fingertips? A patch counts with its radius; about a single one,
/// which grips nothing, it pivots on its normal only.
template <class S> bool axis_through_grip(const Scene<S>& scene, const Answer<S>& answer, S size) {
  Vector3<S> grip = Vector3<S>::Zero();
  Vector3<S> normal;
  Index fingers = 0;
  S radius(0);
  for (const Body<S>& body : scene.bodies) {
    if (body.role != Role::finger) continue;
    Vector3<S> center = Vector3<S>::Zero();
    const Vector3<S>* const first = &scene.points[body.first_point];
    for (Index k = 0; k < body.point_count; ++k) center += first[k] / S(body.point_count);
    for (Index k = 0; k < body.point_count; ++k)
      radius = Eigen::numext::maxi(radius, S((first[k] - center).norm()));
    grip += center;
    normal = body.normal;
    ++fingers;
  }
  if (fingers == 0) return false;
  const Vector3<S> alpha = answer.acceleration.template tail<3>();
  const S along = alpha.dot(normal);
  if (fingers == 1 && along * along < alpha.squaredNorm() / S(2)) return false;
  grip /= S(fingers);
  const S reach = radius * answer.acceleration.template tail<3>().norm() + size / S(100);
  return acceleration_at<S>(grip, answer.acceleration).norm() <= reach;
}

/// Does the object turn over, not with, a pusher that moves along its surface, as a sheet does?
template <class S> bool carried_by_a_surface(const Scene<S>& scene, const Answer<S>& answer) {
  const Vector3<S> alpha = answer.acceleration.template tail<3>();
  bool carried = false;
  for (Index i = 0; i < answer.contacts.size; ++i) {
    const ContactAnswer<S>& contact = answer.contacts[i];
    const Body<S>& body = scene.bodies[contact.body];
    if (body.role != Role::pusher || !(contact.normal_force > S(0))) continue;
    // With what an actuator closes as well.
    const Vector3<S> surface =
        acceleration_at(scene.points[i], answer.acceleration) - contact.acceleration;
    const S along_normal = surface.dot(body.normal);
    const S across = (surface - along_normal * body.normal).norm();
    if (contact.mode != Mode::stick || !(across > Eigen::numext::abs(along_normal))) return false;
    if (alpha.dot(body.normal) * alpha.dot(body.normal) > alpha.squaredNorm() / S(2)) return false;
    carried = true;
  }
  return carried;
}

/// m/s^2, of the object's points of contact, in the hand's frame or against their bodies.
template <class S> S fastest_contact(const Scene<S>& scene, const Answer<S>& answer) {
  S fastest(0);
  for (Index i = 0; i < answer.contacts.size; ++i)
    fastest = Eigen::numext::maxi(
        S(Eigen::numext::maxi(S(answer.contacts[i].acceleration.norm()),
                              S(acceleration_at(scene.points[i], answer.acceleration).norm()))),
        fastest);
  return fastest;
}

} // namespace detail

/// A motion below a thousandth of the fastest contact's is negligible: neither a slow turn nor the
/// noise of a tiny push makes a screw. `push` (m/s^2) is the fastest prescribed one, or 0; without
/// a push nothing moves below 1e-6 of `acceleration_unit` (m/s^2).
template <class S>
Motion<S> describe_motion(const Scene<S>& scene, const Answer<S>& answer, S length,
                          S acceleration_unit, S push) {
  const S part = S(1) / S(1000);
  const Vector3<S> a = answer.acceleration.template head<3>();
  const Vector3<S> alpha = answer.acceleration.template tail<3>();
  Motion<S> motion;
  motion.translation = a.norm();
  motion.rotation = alpha.norm();
  const S size = motion.translation + length * motion.rotation;
  const S fastest = Eigen::numext::maxi(
      push, Eigen::numext::maxi(detail::fastest_contact(scene, answer), S(size / S(2))));
  if (!(size > part * fastest) || (!(push > S(0)) && !(size > part * part * acceleration_unit)))
    return motion;
  if (!(length * motion.rotation > part * fastest)) {
    motion.kind = MotionKind::slide;
    motion.direction = a / motion.translation;
    return motion;
  }
  motion.axis = alpha / motion.rotation;
  motion.axis_point = cross(alpha, a) / (motion.rotation * motion.rotation);
  motion.pitch = a.dot(alpha) / (motion.rotation * motion.rotation);
  if (!(Eigen::numext::abs(motion.pitch) * motion.rotation > part * fastest)) motion.pitch = S(0);

  motion.kind = MotionKind::turn;
  if (detail::axis_through_grip(scene, answer, size)) motion.kind = MotionKind::pivot;
  if (detail::carried_by_a_surface(scene, answer)) motion.kind = MotionKind::roll;
  return motion;
}

} // namespace lcpush
