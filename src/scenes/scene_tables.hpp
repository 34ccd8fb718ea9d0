// What the builder reads of a table: [object], where a [[finger]] or [[pusher]] touches it, and the
// hand that moves the fingers.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "scenes/table_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// A contact patch in the scene's frame.
template <class S> struct Patch {
  Vector3<S> normal;  ///< unit, into the object
  Vector3<S> tangent; ///< unit, orthogonal to the normal
  std::vector<Vector3<S>> positions;
  std::vector<S> weights;           ///< of the positions, of sum 1
  std::vector<std::string> inexact; ///< as SceneOf has it
  double overhang = 0; ///< m: so far a line or a rectangle reaches beyond the box' face
  PatchShape shape = PatchShape::points;
};

/// An object's box, whose edges lie along the axes.
template <class S> struct ObjectBox { Vector3<S> middle, half; };

/// Reads and samples the patch: one point or more, no two coincident, all in one contact plane.
/// S is double or Rational. Where a line or a rectangle reaches more than
/// `cut_beyond` (m) beyond the face of `box` that it lies on, only what lies over it is sampled.
template <class S>
Patch<S> read_patch(const TableReader& table, const ObjectBox<S>* box, double cut_beyond);

/// Mass, inertia about the centre of mass, and the centre of mass; what it looks like to `shape`.
/// S is double or Rational.
template <class S> Object<S> read_object(const TableReader& table, ObjectShape& shape);

/// The keys that say how a pusher moves, linear and angular: as velocities or as accelerations.
struct MotionKeys {
  std::string linear, angular;
  bool is_velocity;
};
/// Refuses a [[pusher]] that mixes the two, or says nothing.
MotionKeys motion_keys(const TableReader& table);

/// Of a [[finger]] or [[pusher]].
Stroke read_stroke(const TableReader& table);

/// Of a [[face]]; `inside`: a point of the object, which is convex.
ObjectFace read_face(const TableReader& table, const Vector3<double>& inside);

/// What a file says about its hand.
struct HandTables {
  std::optional<TableReader> gripper;
  std::vector<TableReader> fingers;
  int actuator_line = 0; ///< of the first [[actuator]]; 0: there is none
};

/// What `jaws` may be.
std::vector<std::string> jaws_names();

/// Chooses the scene's hand and drives its fingers, the first bodies of the scene, along their
/// normals. [[actuator]]s are read by the builder. `unsaid`: the hand of a file that names none, if
/// it is known.
template <class S>
void drive_hand(const HandTables& tables, std::optional<Hand> unsaid, SceneOf<S>& scene);

/// Returns the new actuator's index.
template <class S>
Index add_actuator(SceneOf<S>& scene, const std::string& name, const S& force, const S& inertia) {
  scene.actuator_names.push_back(name);
  scene.actuators.push_back({force, inertia});
  return static_cast<Index>(scene.actuators.size()) - 1;
}

template <class S> void drive_along_normal(SceneOf<S>& scene, Index body, Index actuator) {
  Vector6<S> twist;
  twist << scene.body(body).normal, Vector3<S>::Zero();
  scene.drives.push_back({body, actuator, twist});
}

} // namespace lcpush::desktop
