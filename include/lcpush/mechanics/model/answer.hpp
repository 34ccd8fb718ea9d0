// The answer in SI units, scene axes: what every contact, body and actuator does.
#pragma once

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush {

enum class Mode { stick, slide, separate };

constexpr const char* mode_text(Mode mode) {
  return mode == Mode::stick ? "stick" : mode == Mode::slide ? "slide" : "separate";
}

template <class S> struct ContactAnswer {
  Index body = 0;
  S normal_force{0}; ///< N, lambda; negative where a bilateral body pulls
  Vector3<S> friction_force = Vector3<S>::Zero(); ///< N, on the object
  S torsion{0};              ///< N m, friction moment about the normal, soft points only
  S spin{0};                 ///< rad/s^2 about the normal, of the object relative to its body
  S closing_acceleration{0}; ///< m/s^2 along the normal, what actuators add to its body's motion
  S slip{0};                 ///< m/s^2, xi
  Vector3<S> acceleration = Vector3<S>::Zero(); ///< m/s^2, object's point relative to its body
  Mode mode = Mode::stick;
};

template <class S> struct Answer {
  Vector6<S> acceleration = Vector6<S>::Zero(); ///< of the object, [m/s^2; rad/s^2]
  Span<ContactAnswer<S>> contacts;              ///< in the scene's order
  Span<S> friction; ///< N, beta, generator_count a point, in the same order
  Span<S> closing;  ///< s of each actuator, per second^2
};

/// A contact's friction in its point's friction space (LinearizedCone), N.
template <class S> Vector3<S> friction_of(const Body<S>& body, const ContactAnswer<S>& contact) {
  const Vector3<S>& f = contact.friction_force;
  const S r = body.torsion_radius;
  return {f.dot(body.tangent), f.dot(cross(body.normal, body.tangent)),
          r > S(0) ? S(contact.torsion / r) : S(0)};
}

/// The wrench of one body on the object, [N; N m about the centre of mass].
template <class S>
Vector6<S> body_wrench(const Scene<S>& scene, const Answer<S>& answer, const Body<S>& body) {
  Vector6<S> total = Vector6<S>::Zero();
  for (const Index i : points_of(body)) {
    const ContactAnswer<S>& contact = answer.contacts[i];
    total += wrench_column<S>(scene.points[i],
                              contact.normal_force * body.normal + contact.friction_force);
    total.template tail<3>() += contact.torsion * body.normal;
  }
  return total;
}

/// The twist of a body, prescribed and driven, at the object's centre of mass.
template <class S>
Vector6<S> body_twist(const Scene<S>& scene, const Answer<S>& answer, Index body, S sigma) {
  Vector6<S> twist = sigma * scene.bodies[body].acceleration;
  for (const Drive<S>& drive : scene.drives)
    if (drive.body == body) twist += answer.closing[drive.actuator] * drive.twist;
  return twist;
}

/// Mean of W(n)' J over a body's points: how fast a unit of the actuator closes it.
template <class S>
S closing_speed(const Scene<S>& scene, const Body<S>& body, const Drive<S>& drive) {
  S sum(0);
  for (const Index i : points_of(body))
    sum += acceleration_at(scene.points[i], drive.twist).dot(body.normal);
  return sum / S(body.point_count);
}

/// m/s^2: the fastest point of the driven body per unit of the actuator.
template <class S> S drive_reach(const Scene<S>& scene, const Drive<S>& drive) {
  S reach(0);
  for (const Index i : points_of(scene.bodies[drive.body]))
    reach = Eigen::numext::maxi(reach, S(acceleration_at(scene.points[i], drive.twist).norm()));
  return reach;
}

/// How many bodies it drives; one body by two drives counts twice.
template <class S> Index drive_count(const Scene<S>& scene, Index actuator) {
  Index count = 0;
  for (const Drive<S>& drive : scene.drives) count += drive.actuator == actuator ? 1 : 0;
  return count;
}

template <class S> bool is_driven(const Scene<S>& scene, Index body) {
  for (const Drive<S>& drive : scene.drives)
    if (drive.body == body) return true;
  return false;
}

/// How fast its actuators close a body, m/s^2 along its normal (mean over its points).
template <class S> S mean_closing(const Answer<S>& answer, const Body<S>& body) {
  S sum(0);
  for (const Index i : points_of(body)) sum += answer.contacts[i].closing_acceleration;
  return sum / S(body.point_count);
}

/// The sum of a body's normal forces, N.
template <class S> S normal_sum(const Answer<S>& answer, const Body<S>& body) {
  S sum(0);
  for (const Index i : points_of(body)) sum += answer.contacts[i].normal_force;
  return sum;
}

} // namespace lcpush
