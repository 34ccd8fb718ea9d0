// The scene: an object, the bodies that touch it, and what drives those bodies.
// Plain structs over arrays that the caller owns; a file reader fills them on the desktop, a table
// in flash on a microcontroller. Gripper's frame, SI units, scene axes; positions and twists are
// taken at the object's centre of mass unless a field says otherwise.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

enum class Role {
  finger, ///< part of the hand: force-controlled, or a fixed stop if no actuator drives it
  pusher, ///< part of the environment: moves as prescribed
};

/// How a patch shares its force over its points; docs/theory/theory.md, "Pressure laws".
enum class Pressure {
  pad,   ///< the literal equations, reached from an even preload through a thin elastic pad
  even,  ///< every point is a pad of its own with its even share: see even_pressure.hpp
  rigid, ///< the literal equations, solved once: one answer of a set
};
constexpr Pressure pressures[] = {Pressure::pad, Pressure::even, Pressure::rigid};

/// As scene files and command lines spell it.
constexpr const char* pressure_text(Pressure pressure) {
  return pressure == Pressure::pad ? "pad" : pressure == Pressure::even ? "even" : "rigid";
}

template <class S> struct Object {
  S mass;                    ///< kg, > 0
  Matrix3<S> inertia;        ///< kg m^2, about the centre of mass, symmetric positive definite
  Vector3<S> center_of_mass; ///< m, in the scene's frame; used to print positions only
  /// Applied to the object beside its weight, [N; N m] at the centre of mass.
  Vector6<S> wrench = Vector6<S>::Zero();
  /// N m: the gyroscopic torque of a step [T.13]. It comes of the motion and is no load.
  Vector3<S> turning = Vector3<S>::Zero();
};

/// A rigid body that touches the object at one or more points sharing one normal.
template <class S> struct Body {
  Role role = Role::finger;
  Vector3<S> normal = Vector3<S>::Zero();       ///< unit, from the body into the object
  Vector3<S> tangent = Vector3<S>::Zero();      ///< unit, orthogonal to it: the first generator
  S friction{0};                                ///< Coulomb's mu, >= 0; 0: a frictionless contact
  S torsion_radius{0};                          ///< m; > 0 makes a single point a soft contact
  bool in_plane = false;                        ///< friction is +-tangent alone: lie_in_plane()
  bool bilateral = false;                       ///< holds its normal motion, pulling if it must
  Index first_point = 0;                        ///< index of its first point in Scene::points
  Index point_count = 0;                        ///< >= 1
  Vector6<S> acceleration = Vector6<S>::Zero(); ///< prescribed part of its twist, [m/s^2; rad/s^2]
  S preload{0}; ///< N, >= 0; of a locked finger: what it pressed with before it stood still
};

/// The body's points, as indices into Scene::points.
template <class S> Indices points_of(const Body<S>& body) {
  return {body.first_point, body.point_count};
}

/// A force-controlled degree of freedom of the hand.
template <class S> struct Actuator {
  S force;   ///< tau, N: the force (or generalised force) it holds
  S inertia; ///< m_a, kg, >= 0; 0 is the paper's exact equality
};

/// One column of the hand's Jacobian [P.9]: `actuator` moves `body` with `twist` per unit.
template <class S> struct Drive {
  Index body;
  Index actuator;
  Vector6<S> twist; ///< at the object's centre of mass
};

/// A point's round friction cone, linearized about its last slip [T.16], in the point's friction
/// space: (along the tangent, along n x tangent, torque over the torsion radius).
template <class S> struct LinearizedCone {
  Vector3<S> along{S(1), S(0), S(0)};          ///< unit: generator 0; a hard point has no torque
  Vector3<S> body_motion = Vector3<S>::Zero(); ///< m/s^2: how the body itself moved there
  S inertia{0}; ///< kg, >= 0: what resists a slip across it, mu lambda over the slip [T.16]
  Vector3<S> slip = Vector3<S>::Zero(); ///< m/s^2: the slip that it is linearized about
};

template <class S> struct Scene {
  Object<S> object;
  Vector3<S> gravity; ///< m/s^2
  Index facets;       ///< g, sides of a friction pyramid: even, 4..256
  Pressure pressure;
  bool planar; ///< motion in the x-y plane only; its bodies have been through lie_in_plane()
  Span<const Body<S>> bodies;
  Span<const Vector3<S>> points; ///< m, from the centre of mass, body by body
  Span<const Actuator<S>> actuators;
  Span<const Drive<S>> drives;
  /// Per point: its share of its patch's force under even pressure, > 0, of sum 1 a body; empty:
  /// equal shares. They make a few points carry what the patch's surface carries (patch.hpp).
  Span<const S> weights{};
  /// Per point: the normal acceleration that it may take up before it touches, m/s^2: phi / h^2 of
  /// a time step's gap phi [T.13]; empty: every point touches.
  Span<const S> clearances{};
  /// Per point: its round cone as the present iteration sees it; empty: friction is a pyramid, with
  /// generator 0 along the body's tangent.
  Span<const LinearizedCone<S>> round_cones{};
};

template <class S> bool has_round_friction(const Scene<S>& scene) {
  return scene.round_cones.size > 0;
}
/// Of this body: two generators are all of a cone in the plane, and its points' stay unturned.
template <class S> bool has_round_friction(const Scene<S>& scene, const Body<S>& body) {
  return has_round_friction(scene) && !body.in_plane;
}

template <class S> bool presses_evenly(const Scene<S>& scene) {
  return scene.pressure == Pressure::even;
}

/// Does the object move along the k-th component of a twist? In a plane not out of it.
template <class S> bool moves_along(const Scene<S>& scene, Index k) {
  return !scene.planar || k < 2 || k > 4;
}
/// Row by row, the component of a wrench that has to balance: x, y and the turn in the plane.
template <class S> Index balance_axis(const Scene<S>& scene, Index row) {
  return scene.planar && row == 2 ? 5 : row;
}
/// Of a vector that begins with a wrench or a twist: nothing is left that points out of the plane.
template <class S, class Vector> void stay_in_plane(const Scene<S>& scene, Vector& vector) {
  if (scene.planar) vector.template segment<3>(2).setZero();
}

/// The share of `point`, one of the body's. Pre: the body is of this scene.
template <class S> S weight_of(const Scene<S>& scene, const Body<S>& body, Index point) {
  return scene.weights.size > 0 ? scene.weights[point] : S(1) / S(body.point_count);
}

template <class S> S clearance_of(const Scene<S>& scene, Index point) {
  return scene.clearances.size > 0 ? scene.clearances[point] : S(0);
}

} // namespace lcpush
