// The law of a step in time: which push takes the object's velocity from now to a time h later.
#pragma once

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush {

/// What a step of time h starts from. Twists are at the object's present centre of mass.
template <class S> struct StepStart {
  S h;                           ///< s
  Vector6<S> velocity;           ///< v(t), of the object
  Span<const Vector6<S>> bodies; ///< V_b(t + h), the prescribed part, a body
  Span<const S> closing_speeds;  ///< sdot_a(t), an actuator
  Span<const S> gaps;            ///< phi_i >= 0, a point, m; empty: every point touches
};

/// Arrays of the push that the step is, the caller's; as long as the scene's.
template <class S> struct StepPush {
  Span<Body<S>> bodies;
  Span<Actuator<S>> actuators;
  Span<S> clearances; ///< as long as StepStart::gaps
};

namespace laws {

/// [T.13] Motion: a step is the push of T.1 to T.6 in which every body accelerates with
///   A_b = (V_b(t + h) - v(t)) / h,   normal rows + phi_i / h^2,   w + (0; - omega x I omega),
///   tau_a + m_a sdot_a / h.
/// Then h a is the change of the object's velocity, h r_i the relative velocity at the step's end,
/// h s_a the closing speed then, and h lambda_i an impulse. Returns `scene`, which has the present
/// points, normals and inertia, as that push, over the arrays of `push`.
template <class S>
Scene<S> time_step(const Scene<S>& scene, const StepStart<S>& start, const StepPush<S>& push) {
  Scene<S> step = scene;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    push.bodies[b] = scene.bodies[b];
    push.bodies[b].acceleration = (start.bodies[b] - start.velocity) / start.h;
  }
  for (Index a = 0; a < scene.actuators.size; ++a) {
    const Actuator<S>& actuator = scene.actuators[a];
    push.actuators[a] = actuator;
    push.actuators[a].force += actuator.inertia * start.closing_speeds[a] / start.h;
  }
  for (Index i = 0; i < start.gaps.size; ++i)
    push.clearances[i] = start.gaps[i] / start.h / start.h;
  const Vector3<S> omega = start.velocity.template tail<3>();
  const Vector3<S> spin = scene.object.inertia.lazyProduct(omega);
  step.object.turning = -cross(omega, spin);
  step.bodies = {push.bodies.data, scene.bodies.size};
  step.actuators = {push.actuators.data, scene.actuators.size};
  step.clearances = {push.clearances.data, start.gaps.size};
  return step;
}

} // namespace laws
} // namespace lcpush
