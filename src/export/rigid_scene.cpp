#include "export/rigid_scene.hpp"
#include "export/settings.hpp"
#include "lcpush/desktop/input_error.hpp"

namespace lcpush::desktop {
namespace {

void refuse_unsayable(const SceneFile& file) {
  const auto refuse_if = [](bool is_there, const std::string& what) {
    if (is_there) throw InputError("a rigid-body engine has no " + what);
  };
  refuse_if(file.pressure == Pressure::even, "pressure law (pressure = \"even\")");
  refuse_if(file.hand == Hand::locked, "memory of what locked fingers pressed with");
  refuse_if(!file.object.wrench.isZero(0), "load beside weight (object: wrench)");
  refuse_if(!file.prescribed.empty(), "acceleration of an actuator, only its force");
  refuse_if(static_cast<int>(file.bodies.size()) > ExportSettings().bodies,
            "collision bits for more than 16 bodies");
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Body<double>& body = file.bodies[b];
    const std::string of = " (\"" + file.body_names[b] + "\")";
    refuse_if(body.bilateral, "contact that pulls" + of);
    refuse_if(!body.acceleration.tail<3>().isZero(0), "slide for a body that turns" + of);
    refuse_if(file.strokes[b].is_limited(), "body that comes or goes at a time" + of);
    refuse_if(file.shape.kind == ObjectShape::Kind::unknown && !file.strokes[b].rides_on_object,
              "object without a shape that" + of + " could touch");
  }
  for (const Drive<double>& drive : file.drives)
    refuse_if(!drive.twist.tail<3>().isZero(0), "slide for a finger that its actuator turns (\"" +
                                                    file.body_name(drive.body) + "\")");
}

RigidShape object_shape(const SceneFile& file) {
  const ObjectShape& shape = file.shape;
  const Vector3<double> center = Vector3<double>::Zero();
  if (shape.kind == ObjectShape::Kind::ball)
    return {RigidShape::Kind::ball,
            "shape",
            {shape.size[0] / 2, 0, 0},
            center,
            Vector3<double>::UnitZ()};
  if (shape.kind == ObjectShape::Kind::cylinder)
    return {RigidShape::Kind::cylinder,
            "shape",
            {shape.size[(shape.axis + 1) % 3] / 2, shape.size[shape.axis], 0},
            center,
            Vector3<double>::Unit(shape.axis)};
  return {RigidShape::Kind::box, "shape", shape.size, center, Vector3<double>::UnitZ()};
}

/// A body's points are balls on the body that touch the object's flat faces, or, where the object
/// is round or brings the points, a plate that is a plane if it stands.
void add_shapes(const SceneFile& file, Index b, RigidBody& rigid) {
  const ExportSettings settings;
  const Body<double>& body = file.body(b);
  const bool rides = file.strokes[static_cast<std::size_t>(b)].rides_on_object;
  const double size = object_size(file), radius = settings.ball * size;
  const bool has_plate = rides || file.shape.kind != ObjectShape::Kind::box;
  for (const Index i : points_of(body)) {
    const Vector3<double>& point = file.points[static_cast<std::size_t>(i)];
    const std::string name = rigid.name + "_" + std::to_string(i - body.first_point + 1);
    const auto ball = [&](double side) {
      return RigidShape{RigidShape::Kind::ball,
                        name,
                        {radius, 0, 0},
                        point + side * radius * body.normal,
                        body.normal};
    };
    if (!has_plate) rigid.shapes.push_back(ball(-1));
    if (rides) rigid.on_object.push_back(ball(1));
  }
  if (!has_plate) return;
  const Vector3<double>& at = file.points[static_cast<std::size_t>(body.first_point)];
  const double side = 2 * settings.plate * size;
  if (rigid.slides.empty())
    rigid.shapes = {
        {RigidShape::Kind::plane, rigid.name + "_plane", {side, side, 0}, at, body.normal}};
  else
    rigid.shapes = {{RigidShape::Kind::box,
                     rigid.name + "_plate",
                     {side, side, size},
                     at - size / 2 * body.normal,
                     body.normal}};
}

void add_slides(const SceneFile& file, Index b, RigidBody& rigid) {
  const ExportSettings settings;
  const Vector3<double> motion = file.body(b).acceleration.head<3>();
  const double fast = motion.norm(), heavy = settings.heavy * file.object.mass;
  if (fast > 0) {
    const bool is_velocity = file.strokes[static_cast<std::size_t>(b)].is_velocity;
    rigid.slides.push_back(
        {motion / fast, heavy, is_velocity ? fast : 0, 0, is_velocity ? 0 : fast, true, b, 1});
  }
  for (const Drive<double>& drive : file.drives) {
    if (drive.body != b) continue;
    const Drive<double>* leader = file.drives.data();
    while (leader->actuator != drive.actuator) ++leader;
    const Actuator<double>& actuator = file.actuators[static_cast<std::size_t>(drive.actuator)];
    const double reach = drive.twist.norm(), led = leader->twist.norm();
    rigid.slides.push_back(
        {drive.twist.head<3>() / reach,
         actuator.inertia > 0 ? actuator.inertia : settings.finger * file.object.mass, 0,
         leader->body == b ? actuator.force / reach : 0, 0, false, leader->body, reach / led});
  }
}

} // namespace

RigidScene rigid_scene(const SceneFile& file) {
  refuse_unsayable(file);
  RigidScene scene{file, object_shape(file), {}};
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const Body<double>& body = file.body(b);
    RigidBody rigid{file.body_name(b), {}, {}, {}, body.friction, body.torsion_radius};
    add_slides(file, b, rigid);
    add_shapes(file, b, rigid);
    scene.bodies.push_back(std::move(rigid));
  }
  return scene;
}

} // namespace lcpush::desktop
