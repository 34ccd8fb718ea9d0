// The law of pads [T.7]: how compliant a patch's points are, and around which pressure.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/assemble.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"

namespace lcpush {
namespace detail {

/// Is a body a stop of the hand: a finger that moves with it, and presses by no force of its own?
template <class S> bool is_stop(const Scene<S>& scene, Index body) {
  const Body<S>& stop = scene.bodies[body];
  return stop.role == Role::finger && !is_driven(scene, body) && !(stop.preload > S(0));
}

} // namespace detail

/// [T.7] Pad: round r adds eps_r c_i (lambda_i - lambda_i^(r-1)) to [T.2].
/// With the points' weights w_i, sets c_i: 1 / (m w_i) on a force-controlled patch, be it of one
/// point (how the fingers of a jaw share its force may be open), and on a locked finger; a
/// thousandth of that on another position-controlled body of more than two points, which may share
/// its force in many ways, and on all stops of the hand where they have more than two together; 0
/// otherwise. And lambda^(0): w_i of each patch's own force or preload, 0 where there is none.
template <class S> void pad_preload(const Assembly<S>& assembly, const PressureMemory<S>& memory) {
  const Scene<S>& scene = assembly.scene();
  Index stop_points = 0;
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (detail::is_stop(scene, b)) stop_points += scene.bodies[b].point_count;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<S>& body = scene.bodies[b];
    const Index k = body.point_count;
    S force = body.preload;
    bool driven = false;
    for (const Drive<S>& drive : scene.drives) {
      if (drive.body != b) continue;
      const Index driven_bodies = drive_count(scene, drive.actuator);
      const S along = closing_speed(scene, body, drive);
      driven = true;
      if (along > S(0)) force += scene.actuators[drive.actuator].force / (along * S(driven_bodies));
    }
    const Index sharing = detail::is_stop(scene, b) ? stop_points : k;
    const bool soft = body.preload > S(0) || driven;
    const S softness = soft ? S(1) : sharing > 2 ? S(1) / S(1000) : S(0);
    for (Index i = body.first_point; i < body.first_point + k; ++i) {
      const S weight = weight_of(scene, body, i);
      memory.preload[i] = weight * force / assembly.layout().scales.force;
      memory.compliance[i] = softness / weight;
    }
  }
}

/// Sets eps c_i on the normal rows, around the last round's pressure.
template <class S>
void set_compliance(Assembly<S>& assembly, const PressureMemory<S>& memory, S eps) {
  assembly.push_normals();
  for (Index i = 0; i < assembly.layout().points; ++i) {
    const S c = eps * memory.compliance[i];
    const ConeGroup<S>& cone = assembly.cones()[i];
    assembly.cones()[i].compliance = c;
    assembly.q()[cone.variable] -= c * memory.preload[i];
    if (cone.normals == 2) assembly.q()[cone.variable + 1] += c * memory.preload[i];
  }
}

namespace detail {

/// The pressure becomes the next round's preload. Returns by how much the round's answer violates
/// the literal [T.2]. `changes`: a point presses that did not in the round before, or the other way
/// round; `slides`: a point slips.
template <class S>
S take_pressure(const Assembly<S>& assembly, const PressureMemory<S>& memory, bool& changes,
                bool& slides) {
  S violation(0);
  changes = slides = false;
  for (Index i = 0; i < assembly.layout().points; ++i) {
    const ConeGroup<S>& cone = assembly.layout().cones[i];
    const S lambda = cone.normal_force(memory.z.data), last = memory.preload[i];
    memory.preload[i] = lambda;
    const S change = cone.compliance * (lambda - last);
    violation = Eigen::numext::maxi(violation, S(Eigen::numext::abs(change)));
    if ((lambda > S(0)) != (last > S(0))) changes = true;
    if (cone.generators > 0 && memory.z[cone.slip()] > Tolerances<S>().settled) slides = true;
  }
  return violation;
}

/// The largest normal force of the last answer.
template <class S> S largest_normal(const Assembly<S>& assembly, const PressureMemory<S>& memory) {
  S largest(0);
  for (Index i = 0; i < assembly.layout().points; ++i)
    largest = Eigen::numext::maxi(
        largest, Eigen::numext::abs(assembly.cones()[i].normal_force(memory.z.data)));
  return largest;
}

/// What the scene's forces and prescribed motions ask for.
template <class S> S largest_load(const Assembly<S>& assembly) {
  S largest(1);
  for (const S& x : assembly.q()) largest = Eigen::numext::maxi(largest, S(Eigen::numext::abs(x)));
  return largest;
}

} // namespace detail

} // namespace lcpush
