// Is the answer the only one? A proof where there is one, else a search under covering vectors.
#pragma once

#include "lcpush/mechanics/solve/breaking.hpp"

namespace lcpush {

enum class Uniqueness {
  yes,              ///< proved: see motion_is_determined
  none_other_found, ///< other covering vectors led to the same answer, which is no proof
  no,               ///< another answer was found
  not_tested,
};

/// Is the body without friction, or its normal force known whatever the answer: a single point with
/// an actuator of its own, without inertia, along its normal (and, if it is soft, without turning
/// about it)?
template <class S> bool has_known_friction(const Scene<S>& scene, Index b) {
  const Body<S>& body = scene.bodies[b];
  if (!(body.friction > S(0))) return true;
  if (body.point_count > 1) return false;
  Index drives = 0;
  bool known = false;
  for (const Drive<S>& drive : scene.drives) {
    if (drive.body != b) continue;
    ++drives;
    const Vector3<S> motion = acceleration_at(scene.points[body.first_point], drive.twist);
    const S along = motion.dot(body.normal);
    const S across = (motion - along * body.normal).norm();
    // A soft point's friction torque must not load the actuator either.
    const S turns =
        body.torsion_radius * Eigen::numext::abs(drive.twist.template tail<3>().dot(body.normal));
    known = drive_count(scene, drive.actuator) == 1 && along > S(0) &&
            across + turns <= S(16) * Eigen::NumTraits<S>::epsilon() * along &&
            !(scene.actuators[drive.actuator].inertia > S(0));
  }
  return drives == 1 && known;
}

/// The first body with friction under an unknown normal force, or -1.
template <class S> Index undetermined_body(const Scene<S>& scene) {
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (!has_known_friction(scene, b)) return b;
  return -1;
}

/// [T.9] The object's acceleration is unique if every contact with friction has a known normal
/// force: the friction problem is then convex (docs/theory/theory.md, "Uniqueness").
template <class S> bool motion_is_determined(const Scene<S>& scene) {
  return undetermined_body(scene) < 0;
}

/// Object's acceleration and one body's wrench, for comparing answers.
template <class S> struct Outcome {
  Vector6<S> acceleration;
  Vector6<S> wrench;
};

/// Equal to `tolerance` of the motion, or of the push (m/s^2) if that is larger?
template <class S>
bool same_motion(const Outcome<S>& a, const Outcome<S>& b, const Scales<S>& scales, S push,
                 S tolerance) {
  const S motion = motion_size(a.acceleration, scales);
  const S size = Eigen::numext::maxi(motion, S(push / scales.acceleration));
  const S left = Tolerances<S>().residual; // by checked answers, of what rests
  return motion_size<S>(a.acceleration - b.acceleration, scales) <= tolerance * size + left;
}

template <class S>
bool same_wrench(const Outcome<S>& a, const Outcome<S>& b, const Scales<S>& scales, S tolerance) {
  const Vector6<S> off = a.wrench - b.wrench;
  const S size = Eigen::numext::maxi(scales.force, S(a.wrench.template head<3>().norm()));
  return off.template head<3>().norm() <= tolerance * size &&
         off.template tail<3>().norm() <= tolerance * size * scales.length;
}

} // namespace lcpush
