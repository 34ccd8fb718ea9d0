// main.c: a scene as tables of the C interface, and a control loop around them.
#include "export/export_parts.hpp"
#include "lcpush/mechanics/model/even_pressure.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace lcpush::desktop {
namespace {

/// A double of C, to its last bit.
std::string literal(double x) {
  std::string text = printed("%.17g", x + 0.0);
  if (const std::string brief = printed("%.9g", x + 0.0); std::stod(brief) == x) text = brief;
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

template <class List> std::string braced(const List& list) {
  std::string text;
  for (Index i = 0; i < static_cast<Index>(list.size()); ++i)
    text += (i > 0 ? ", " : "") + literal(list[i]);
  return "{" + text + "}";
}

/// A name as a comment.
std::string comment(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '.' && c != '-')
      c = ' ';
  return " /* " + name + " */";
}

/// An array of `count` entries; an empty one has one, which nothing reads.
template <class Entry>
std::string table(const std::string& type, const std::string& name, std::size_t count,
                  Entry entry) {
  std::string text = "static const " + type + " " + name + "[" +
                     std::to_string(std::max<std::size_t>(count, 1)) + "] = {\n";
  for (std::size_t i = 0; i < count; ++i) text += "    " + entry(i) + "\n";
  return text + (count == 0 ? "    {0}" : "") + "};\n";
}

std::string body_text(const SceneFile& file, std::size_t b) {
  const Body<double>& body = file.bodies[b];
  std::string text = std::string("{.role = LCPUSH_") +
                     (body.role == Role::pusher ? "PUSHER" : "FINGER") +
                     ", .normal = " + braced(body.normal) + ", .tangent = " + braced(body.tangent) +
                     ",\n     .friction = " + literal(body.friction);
  if (body.torsion_radius > 0) text += ", .torsion_radius = " + literal(body.torsion_radius);
  if (body.bilateral) text += ", .bilateral = 1";
  if (body.preload > 0) text += ", .preload = " + literal(body.preload);
  text += ", .first_point = " + std::to_string(body.first_point) +
          ", .point_count = " + std::to_string(body.point_count);
  if (!body.acceleration.isZero(0)) text += ",\n     .acceleration = " + braced(body.acceleration);
  return text + "}," + comment(file.body_names[b]);
}

/// What lcpush_size and LCPUSH_BYTES take: bodies, points, facets, actuators, drives, and pulls.
std::array<Index, 6> sizes(const SceneFile& file) {
  const Scene<double> scene = file.view();
  std::array<Index, 6> size = {scene.bodies.size,    scene.points.size, scene.facets,
                               scene.actuators.size, scene.drives.size, 0};
  for (const Body<double>& body : file.bodies) {
    if (body.torsion_radius > 0) size[2] = 5 * scene.facets + 2;
    if (body.bilateral) size[5] += body.point_count;
  }
  if (file.pressure == Pressure::even && has_driven_patch(scene)) {
    const EvenSize even = even_size(scene);
    size[0] += even.bodies;
    size[3] += even.drives;
    size[4] += even.drives;
  }
  return size;
}

std::string tables(const SceneFile& file) {
  const auto text = [](double x) { return literal(x); };
  std::string result = table("LCPUSH(point)", "points", file.points.size(),
                             [&](std::size_t i) { return braced(file.points[i]) + ","; });
  result += table("REAL", "weights", file.weights.size(),
                  [&](std::size_t i) { return text(file.weights[i]) + ","; });
  result += table("LCPUSH(body)", "bodies", file.bodies.size(),
                  [&](std::size_t b) { return body_text(file, b); });
  result += table("LCPUSH(actuator)", "actuators", file.actuators.size(), [&](std::size_t a) {
    return "{" + text(file.actuators[a].force) + ", " + text(file.actuators[a].inertia) + "}," +
           comment(file.actuator_names[a]);
  });
  result += table("LCPUSH(drive)", "drives", file.drives.size(), [&](std::size_t d) {
    const Drive<double>& drive = file.drives[d];
    return "{" + std::to_string(drive.body) + ", " + std::to_string(drive.actuator) + ", " +
           braced(drive.twist) + "},";
  });
  constexpr const char* laws[] = {"LCPUSH_PAD", "LCPUSH_EVEN", "LCPUSH_RIGID"};
  const Eigen::Map<const Eigen::Matrix<double, 9, 1>> inertia(file.object.inertia.data());
  result +=
      "static const LCPUSH(scene) scene = {\n    .object = {.mass = " + text(file.object.mass) +
      ", .inertia = " + braced(inertia) +
      ",\n               .wrench = " + braced(file.object.wrench) +
      "},\n    .gravity = " + braced(file.gravity) +
      ", .facets = " + (file.is_round ? "LCPUSH_ROUND" : std::to_string(file.facets)) +
      ", .pressure = " + laws[static_cast<int>(file.pressure)] +
      (file.planar ? ", .planar = 1" : "") +
      ",\n    .bodies = bodies, .body_count = BODIES, .points = points, .point_count = POINTS,\n"
      "    .actuators = actuators, .actuator_count = ACTUATORS, .drives = drives, .drive_count = " +
      std::to_string(file.drives.size()) + ",\n    .weights = weights};\n";
  return result;
}

} // namespace

std::string c_program(const SceneFile& file) {
  const std::array<Index, 6> size = sizes(file);
  std::string list, bytes;
  for (std::size_t k = 0; k < size.size(); ++k) {
    list += (k > 0 ? ", " : "") + std::to_string(size[k]);
    // A pull is less than a point.
    if (k < 5) bytes += ", " + std::to_string(k == 1 ? size[1] + size[5] : size[k]);
  }
  return (file.title.empty() ? "" : comment(file.title).substr(1) + "\n\n") +
         "/* Written by `lcpush export --format c`. Beside lcpush.o of the device bundle:\n"
         " *   gcc -std=c99 -Iinclude main.c lcpush.o -o push && ./push */\n"
         "#include <lcpush/lcpush.h>\n#if __STDC_HOSTED__\n#include <stdio.h>\n#endif\n\n"
         "#ifdef IN_FLOAT /* for pushes that accelerate by more than a tenth of grip over mass */\n"
         "#define REAL float\n#define LCPUSH(name) lcpushf_##name\n#else\n"
         "#define REAL double\n#define LCPUSH(name) lcpush_##name\n#endif\n\n"
         "enum { BODIES = " +
         std::to_string(file.bodies.size()) + ", POINTS = " + std::to_string(file.points.size()) +
         ", ACTUATORS = " + std::to_string(file.actuators.size()) +
         ", TICKS = 10 };\n"
         "/* At most: bodies, points, facets, actuators, drives, pulls. */\n"
         "static const lcpush_size size = {" +
         list +
         "};\n"
         "static double memory[(LCPUSH_BYTES(REAL" +
         bytes + ") / sizeof(double)) + 1u];\n\n" + tables(file) + control_loop();
}

} // namespace lcpush::desktop
