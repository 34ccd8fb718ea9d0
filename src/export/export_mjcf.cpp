// MuJoCo's XML.
#include "draw/markup.hpp"
#include "export/rigid_scene.hpp"
#include "export/settings.hpp"
#include "lcpush/desktop/export.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

template <class Vector> std::string attribute(const Vector& v) { return "\"" + spaced(v) + "\""; }

std::string attribute(const std::string& name) { return "\"" + escaped(name) + "\""; }

/// Nothing touches it but what a <pair> names.
std::string geom(const RigidShape& shape, const std::string& indent) {
  using Kind = RigidShape::Kind;
  const Vector3<double> half(shape.size / 2);
  const std::string kind =
      shape.kind == Kind::box ? "box\" size=" + attribute(half)
      : shape.kind == Kind::plane
          ? "plane\" size=" + attribute(Vector3<double>(half[0], half[1], half[0]))
      : shape.kind == Kind::ball
          ? "sphere\" size=" + attribute(Vector3<double>(shape.size).head<1>())
          : "cylinder\" size=" + attribute(Eigen::Vector2d(shape.size[0], half[1]));
  return indent + "<geom name=" + attribute(shape.name) + " type=\"" + kind +
         " pos=" + attribute(shape.center) + " zaxis=" + attribute(shape.axis) + "/>\n";
}

std::string object_text(const RigidScene& scene) {
  const SceneFile& file = scene.file;
  const Matrix3<double>& I = file.object.inertia;
  Vector6<double> inertia;
  inertia << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
  std::string text =
      "    <body name=\"object\" pos=" + attribute(file.object.center_of_mass) + ">\n";
  text += !file.planar ? "      <freejoint name=\"object\"/>\n"
                       : "      <joint name=\"object_x\" type=\"slide\" axis=\"1 0 0\"/>\n"
                         "      <joint name=\"object_y\" type=\"slide\" axis=\"0 1 0\"/>\n"
                         "      <joint name=\"object_turn\" type=\"hinge\" axis=\"0 0 1\"/>\n";
  text += "      <inertial pos=\"0 0 0\" mass=" + attribute(shown(file.object.mass)) +
          " fullinertia=" + attribute(inertia) + "/>\n";
  if (file.shape.kind != ObjectShape::Kind::unknown) text += geom(scene.object, "      ");
  for (const RigidBody& body : scene.bodies)
    for (const RigidShape& shape : body.on_object) text += geom(shape, "      ");
  return text + "    </body>\n";
}

std::string slide_name(const RigidScene& scene, Index b, std::size_t k) {
  const RigidBody& body = scene.bodies[static_cast<std::size_t>(b)];
  return body.name + (k + 1 < body.slides.size() ? "_carrier" : "_slide");
}

std::string body_text(const RigidScene& scene, Index b) {
  const RigidBody& body = scene.bodies[static_cast<std::size_t>(b)];
  std::string text, ends, indent = "    ";
  for (std::size_t k = 0; k < std::max<std::size_t>(body.slides.size(), 1); ++k) {
    const bool is_last = k + 1 >= body.slides.size();
    text += indent + "<body name=" + attribute(body.name + (is_last ? "" : "_carrier")) +
            (k == 0 ? " pos=" + attribute(scene.file.object.center_of_mass) : "") +
            " gravcomp=\"1\">\n";
    ends = indent + "</body>\n" + ends;
    indent += "  ";
    if (body.slides.empty()) break;
    const RigidSlide& slide = body.slides[k];
    text += indent + "<joint name=" + attribute(slide_name(scene, b, k)) +
            " type=\"slide\" axis=" + attribute(slide.axis) + "/>\n" + indent +
            "<inertial pos=\"0 0 0\" mass=" + attribute(shown(slide.mass)) + " diaginertia=" +
            attribute(Vector3<double>(slide.mass * Vector3<double>::Ones() *
                                      scene.file.object.inertia.trace() / scene.file.object.mass)) +
            "/>\n";
  }
  for (const RigidShape& shape : body.shapes) text += geom(shape, indent);
  return text + ends;
}

/// A force that speeds the mass up by itself, and a servo of the speed, whose reference is its
/// activation: it grows by the control, the acceleration.
std::string servo(const std::string& joint, const RigidSlide& slide) {
  const double gain = ExportSettings().servo * slide.mass;
  return "    <general name=" + attribute(joint) + " joint=" + attribute(joint) +
         " dyntype=\"integrator\" biastype=\"affine\" gainprm=" + attribute(shown(gain)) +
         " biasprm=" + attribute(Vector3<double>(slide.mass * slide.acceleration, 0, -gain)) +
         "/>\n";
}

std::string pairs(const RigidScene& scene) {
  std::string text;
  for (const RigidBody& body : scene.bodies) {
    const double mu = body.friction;
    Eigen::Matrix<double, 5, 1> friction;
    friction << mu, mu, mu * body.torsion_radius, 0, 0;
    const std::string condim = mu == 0 ? "1" : body.torsion_radius > 0 ? "4" : "3";
    const std::vector<RigidShape> own = {scene.object};
    for (const RigidShape& shape : body.shapes)
      for (const RigidShape& touches : body.on_object.empty() ? own : body.on_object)
        text += "    <pair geom1=" + attribute(touches.name) + " geom2=" + attribute(shape.name) +
                " condim=\"" + condim + "\" friction=" + attribute(friction) + "/>\n";
  }
  return text;
}

} // namespace

std::string mjcf_text(const SceneFile& file) {
  const RigidScene scene = rigid_scene(file);
  std::string bodies, motors, servos, equalities, forces, accelerations, references, speeds;
  const Vector6<double>& start = file.start;
  const std::vector<double> object_speeds =
      file.planar ? std::vector<double>{start[0], start[1], start[5]}
                  : std::vector<double>(start.data(), start.data() + start.size());
  for (const double speed : object_speeds) speeds += (speeds.empty() ? "" : " ") + shown(speed);
  for (Index b = 0; b < static_cast<Index>(scene.bodies.size()); ++b) {
    bodies += body_text(scene, b);
    const std::vector<RigidSlide>& slides = scene.bodies[static_cast<std::size_t>(b)].slides;
    for (std::size_t k = 0; k < slides.size(); ++k) {
      const std::string joint = slide_name(scene, b, k);
      speeds += " " + shown(slides[k].velocity);
      if (slides[k].force != 0) {
        motors += "    <motor name=" + attribute(joint) + " joint=" + attribute(joint) + "/>\n";
        forces += " " + shown(slides[k].force);
      } else if (slides[k].is_prescribed) {
        servos += servo(joint, slides[k]);
        accelerations += " " + shown(slides[k].acceleration);
        references += " " + shown(slides[k].velocity);
      }
      if (slides[k].leader == b) continue;
      const std::size_t last =
          scene.bodies[static_cast<std::size_t>(slides[k].leader)].slides.size() - 1;
      equalities += "    <joint joint1=" + attribute(joint) +
                    " joint2=" + attribute(slide_name(scene, slides[k].leader, last)) +
                    " polycoef=\"0 " + shown(slides[k].ratio) + " 0 0 0\"/>\n";
    }
  }
  const auto section = [](const std::string& name, const std::string& text) {
    return text.empty() ? "" : "  <" + name + ">\n" + text + "  </" + name + ">\n";
  };
  const auto values = [](const std::string& name, const std::string& list) {
    return list.empty() ? "" : " " + name + "=" + attribute(list.substr(1));
  };
  std::string sensors;
  for (const char* sensor : {"framepos", "framequat", "framelinvel", "frameangvel"})
    sensors += "    <" + std::string(sensor) + " objtype=\"body\" objname=\"object\"/>\n";
  return "<mujoco model=" + attribute(file.title.empty() ? "scene" : file.title) +
         ">\n  <option gravity=" + attribute(file.gravity) + " cone=\"elliptic\"/>\n" +
         "  <statistic meaninertia=" + attribute(shown(file.object.mass)) + "/>\n" +
         "  <default><geom contype=\"0\" conaffinity=\"0\"/></default>\n" +
         section("worldbody", object_text(scene) + bodies) + section("contact", pairs(scene)) +
         section("equality", equalities) + section("actuator", motors + servos) +
         section("sensor", sensors) +
         section("keyframe", "    <key name=\"start\" qvel=\"" + speeds + "\"" +
                                 values("ctrl", forces + accelerations) +
                                 values("act", references) + "/>\n") +
         "</mujoco>\n";
}

} // namespace lcpush::desktop
