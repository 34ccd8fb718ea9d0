// A scene as a rigid-body engine has it: masses, shapes, slides and forces; what MJCF and SDF say.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "text/wording.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// As XML lists numbers.
template <class Vector> std::string spaced(const Vector& v) {
  std::string text;
  for (Index i = 0; i < v.size(); ++i) text += (i > 0 ? " " : "") + shown(v[i] + 0.0);
  return text;
}

/// A shape. Its axis is the outward normal of a plane and of a plate, and the axis of a cylinder.
struct RigidShape {
  enum class Kind { box, cylinder, ball, plane } kind;
  std::string name;
  Vector3<double>
      size; ///< m: a box's and a plane's edges; a cylinder's radius and length; a ball's radius
  Vector3<double> center; ///< m, from the object's centre of mass
  Vector3<double> axis;
};

/// A body's motion along a line, in the order from the world to its shapes.
struct RigidSlide {
  Vector3<double> axis;
  double mass;
  double velocity;     ///< m/s at the start
  double force;        ///< N along the axis
  double acceleration; ///< m/s^2
  bool is_prescribed;  ///< it goes so whatever presses on it
  Index leader;        ///< the body that it moves with by one actuator, or itself
  double ratio;        ///< way over the leader's
};

struct RigidBody {
  std::string name;
  std::vector<RigidSlide> slides; ///< none: it stands
  std::vector<RigidShape> shapes;
  std::vector<RigidShape> on_object; ///< what the object touches it with; none: its own shape
  double friction, torsion_radius;   ///< m
};

struct RigidScene {
  const SceneFile& file;
  RigidShape object;
  std::vector<RigidBody> bodies;
};

/// Throws InputError on what no rigid-body engine has, in one sentence. `file` outlives the result.
RigidScene rigid_scene(const SceneFile& file);

} // namespace lcpush::desktop
