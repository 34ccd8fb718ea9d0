// SDFormat 1.9, as Gazebo reads it: models, friction and speeds; it has no forces of actuators.
#include "draw/markup.hpp"
#include "export/rigid_scene.hpp"
#include "export/settings.hpp"
#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

std::string tag(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}

std::string named(const std::string& kind, const std::string& name, const std::string& inside) {
  return "<" + kind + " name=\"" + escaped(name) + "\">" + inside + "</" + kind + ">\n";
}

/// A place, and the turn of z onto the axis.
std::string pose(const Vector3<double>& at,
                 const Vector3<double>& axis = Vector3<double>::UnitZ()) {
  Vector6<double> six;
  six << at, 0, std::atan2(std::hypot(axis[0], axis[1]), axis[2]), std::atan2(axis[1], axis[0]);
  return tag("pose", spaced(six));
}

std::string geometry(const RigidShape& shape) {
  using Kind = RigidShape::Kind;
  const std::string radius = tag("radius", shown(shape.size[0]));
  switch (shape.kind) {
  case Kind::box: return tag("box", tag("size", spaced(shape.size)));
  case Kind::ball: return tag("sphere", radius);
  case Kind::cylinder: return tag("cylinder", radius + tag("length", shown(shape.size[1])));
  case Kind::plane: break;
  }
  return tag("plane", "<normal>0 0 1</normal>" +
                          tag("size", spaced(Eigen::Vector2d(shape.size[0], shape.size[1]))));
}

/// The two friction coefficients meet as their minimum: the object's is left to the body's.
std::string collision(const RigidShape& shape, unsigned bits, const RigidBody* body) {
  std::string friction;
  if (body != nullptr) {
    const std::string mu = shown(body->friction);
    friction = tag("ode", tag("mu", mu) + tag("mu2", mu));
    // A patch of radius a with Hertz's pressure has the torsion 3 pi / 16 a mu N.
    constexpr double hertz = 3 * 3.14159265358979323846 / 16;
    if (body->torsion_radius > 0)
      friction += tag("torsional", tag("coefficient", mu) + tag("use_patch_radius", "true") +
                                       tag("patch_radius", shown(body->torsion_radius / hertz)));
  } else {
    const std::string large = shown(ExportSettings().object_friction);
    friction = tag("ode", tag("mu", large) + tag("mu2", large));
  }
  return "      " +
         named("collision", shape.name,
               pose(shape.center, shape.axis) + tag("geometry", geometry(shape)) +
                   tag("surface", tag("contact", tag("collide_bitmask", std::to_string(bits))) +
                                      tag("friction", friction)));
}

void refuse_forces(const RigidScene& scene) {
  if (scene.file.planar) throw InputError("SDF has no planar motion: use --format mjcf");
  for (const RigidBody& body : scene.bodies)
    for (const RigidSlide& slide : body.slides)
      if (slide.velocity == 0)
        throw InputError("SDF has no force of a body, only a plugin's (\"" + body.name +
                         "\"): use --format mjcf");
}

std::string object_model(const RigidScene& scene) {
  const SceneFile& file = scene.file;
  std::string inertia, collisions;
  for (const auto& [i, j] : {std::pair(0, 0), {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}})
    inertia += tag(std::string("i") + "xyz"[i] + "xyz"[j], shown(file.object.inertia(i, j)));
  unsigned shared = 0, bit = 1;
  for (const RigidBody& body : scene.bodies) {
    for (const RigidShape& shape : body.on_object) collisions += collision(shape, bit, nullptr);
    if (body.on_object.empty()) shared |= bit;
    bit *= 2;
  }
  if (shared != 0) collisions += collision(scene.object, shared, nullptr);
  const std::string link =
      tag("inertial", tag("mass", shown(file.object.mass)) + tag("inertia", inertia)) + "\n";
  return "    " + named("model", "object",
                        pose(file.object.center_of_mass) + "\n     " +
                            named("link", "link", link + collisions));
}

std::string body_model(const RigidScene& scene, const RigidBody& body, unsigned bit) {
  std::string link, more;
  if (body.slides.empty()) {
    more = "<static>true</static>";
  } else {
    link = "<gravity>false</gravity>" + tag("inertial", tag("mass", shown(body.slides[0].mass))) +
           "\n";
    more = "\n     <joint name=\"slide\" type=\"prismatic\">" + tag("parent", "world") +
           tag("child", "link") + tag("axis", tag("xyz", spaced(body.slides[0].axis))) + "</joint>";
  }
  for (const RigidShape& shape : body.shapes) link += collision(shape, bit, &body);
  return "    " + named("model", body.name,
                        pose(scene.file.object.center_of_mass) + more + "\n     " +
                            named("link", "link", link));
}

/// A link's speed at the start.
std::string speed(const std::string& model, const Vector6<double>& twist) {
  return "      " + named("model", model, named("link", "link", tag("velocity", spaced(twist))));
}

} // namespace

std::string sdf_text(const SceneFile& file) {
  const RigidScene scene = rigid_scene(file);
  refuse_forces(scene);
  std::string models = object_model(scene), speeds = speed("object", file.start);
  unsigned bit = 1;
  for (const RigidBody& body : scene.bodies) {
    models += body_model(scene, body, bit);
    bit *= 2;
    if (body.slides.empty()) continue;
    Vector6<double> twist = Vector6<double>::Zero();
    twist.head<3>() = body.slides[0].velocity * body.slides[0].axis;
    speeds += speed(body.name, twist);
  }
  return "<sdf version=\"1.9\">\n  <world name=\"scene\">\n    " +
         tag("gravity", spaced(file.gravity)) + "\n" + models +
         "    <state world_name=\"scene\">\n" + speeds + "    </state>\n  </world>\n</sdf>\n";
}

} // namespace lcpush::desktop
