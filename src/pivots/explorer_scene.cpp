#include "pivots/explorer_scene.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

void write_object(JsonWriter& json, const SceneFile& file) {
  const bool is_cylinder = file.shape.kind == ObjectShape::Kind::cylinder;
  json.member("title", file.title).member("planar", file.planar);
  json.key("gravity").numbers(file.gravity).member("mass", file.object.mass);
  json.key("center_of_mass").numbers(file.object.center_of_mass);
  json.key("shape").begin_object().member("kind", is_cylinder ? "cylinder" : "box");
  json.key("size").numbers(file.shape.size).member("axis", file.shape.axis).end_object();
  // In SI units: the scales of Layout, all 1.
  const Scene<double> scene = file.view();
  const Scales<double> si{file.object.mass, 1.0, 1.0};
  const Matrix6<double> mobility = laws::newton(scene, si) / file.object.mass;
  json.key("mobility").begin_array();
  for (Index i = 0; i < 6; ++i) json.numbers(Vector6<double>(mobility.row(i)));
  json.end_array();
  Vector6<double> weight = Vector6<double>::Zero();
  weight.head<3>() = file.object.mass * file.gravity;
  json.key("weight").numbers(weight).member("facets", file.facets);
}

void write_bodies(JsonWriter& json, const Push& push) {
  const Scene<double>& scene = push.scene();
  json.key("bodies").begin_array();
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Body<double>& body = scene.bodies[b];
    const Index of_file = push.file().body_of(body.first_point);
    json.begin_object();
    json.member("name", push.file().body_names[static_cast<std::size_t>(of_file)]);
    json.member("role", body.role == Role::finger ? "finger" : "pusher");
    json.key("normal").numbers(body.normal).key("tangent").numbers(body.tangent);
    json.member("friction", body.friction).key("acceleration").numbers(body.acceleration);
    json.key("actuators").begin_array();
    for (const Drive<double>& drive : scene.drives) {
      if (drive.body != b) continue;
      json.begin_object().member("variable", push.layout().closing(drive.actuator));
      json.key("twist").numbers(drive.twist).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

void write_points(JsonWriter& json, const Push& push) {
  const Scene<double>& scene = push.scene();
  const Layout<double>& layout = push.layout();
  json.key("points").begin_array();
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<double>& cone = layout.cones[i];
    const Body<double>& body = scene.bodies[layout.body[i]];
    json.begin_object().member("name", point_name(push.file(), i)).member("body", layout.body[i]);
    json.key("position").numbers(push.file().positions[static_cast<std::size_t>(i)]);
    json.member("normal", layout.normal(i)).key("pull");
    if (cone.normals == 2)
      json.value(layout.normal(i) + 1);
    else
      json.value(nullptr);
    json.key("friction").begin_array();
    for (Index j = 0; j < cone.generators; ++j) json.value(layout.friction(i, j));
    json.end_array().key("slip");
    if (cone.generators > 0)
      json.value(layout.slip(i));
    else
      json.value(nullptr);
    json.key("generators").begin_array();
    for (Index j = 0; j < cone.generators; ++j) {
      const Generator<double> d = generator(body, j, scene.facets);
      json.begin_object().key("force").numbers(d.force).member("torque", d.torque).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array();
}

} // namespace

void write_drawing(JsonWriter& json, const Push& push) {
  json.begin_object();
  write_object(json, push.file());
  write_bodies(json, push);
  write_points(json, push);
  json.end_object();
}

} // namespace lcpush::desktop
