// The fixtures/scenes files, pushed: what their tests ask about.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

#include "lcpush/desktop/push.hpp"

namespace lcpush::test {

inline std::string scene_text(const std::string& name, const std::string& folder = "scenes") {
  std::ifstream stream(LCPUSH_SOURCE_DIR "/fixtures/" + folder + "/" + name);
  std::stringstream text;
  text << stream.rdbuf();
  REQUIRE(!text.str().empty());
  return text.str();
}

/// A scene file of a test's own scene.
template <class OwnScene> desktop::SceneFile file_of(const OwnScene& scene) {
  desktop::SceneFile file;
  file.object = scene.base.object;
  file.gravity = scene.base.gravity;
  file.facets = scene.base.facets;
  file.pressure = scene.base.pressure;
  file.planar = scene.base.planar;
  file.bodies = scene.bodies;
  file.points = file.positions = scene.points;
  file.actuators = scene.actuators;
  file.drives = scene.drives;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    file.body_names.push_back("body" + std::to_string(b));
  for (std::size_t a = 0; a < scene.actuators.size(); ++a)
    file.actuator_names.push_back("drive" + std::to_string(a));
  return file;
}

/// What the text is about, where it says nothing: pyramids.
inline std::string in_pyramids(const std::string& text) {
  return text.find("facets") == std::string::npos ? "facets = 8\n" + text : text;
}

/// A table of a scene file, its keys between semicolons; without a header those of the top.
inline std::string table(const std::string& header, std::string keys) {
  for (std::size_t at = 0; (at = keys.find("; ", at)) != std::string::npos;)
    keys.replace(at, 2, "\n");
  return (header.empty() ? "" : header + "\n") + keys + "\n";
}
inline std::string finger(const std::string& name, const std::string& shape,
                          const std::string& keys) {
  return table("[[finger]]", "name = \"" + name + "\"; shape = \"" + shape + "\"; " + keys);
}
inline std::string pusher(const std::string& name, const std::string& shape,
                          const std::string& keys) {
  return table("[[pusher]]", "name = \"" + name + "\"; shape = \"" + shape + "\"; " + keys);
}
/// theory 8: a cylinder that a sheet rolls, or slides under: both are answers.
inline std::string bistable_push(const std::string& object, double radius, const std::string& grip,
                                 const std::string& sheet) {
  const std::string r = std::to_string(radius);
  return table("", "gravity = [0, -9.81, 0]; planar = true") +
         table("[gripper]", "jaws = \"parallel\"") +
         table("[object]", object + "; axis = \"z\"; cylinder_radius = " + r) +
         finger("left", "point", grip + "; normal = [1, 0, 0]; center = [-" + r + ", 0, 0]") +
         finger("right", "point", grip + "; normal = [-1, 0, 0]; center = [" + r + ", 0, 0]") +
         pusher("sheet", "point", sheet + "; normal = [0, 1, 0]; center = [0, -" + r + ", 0]");
}

inline std::string with(std::string text, const std::string& old, const std::string& replacement) {
  std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  for (; at != std::string::npos; at = text.find(old, at + replacement.size()))
    text.replace(at, old.size(), replacement);
  return text;
}

/// What a test asks about a push.
struct Pushed {
  desktop::SceneFile file;
  desktop::Push push;
  desktop::PushReport report;

  explicit Pushed(const std::string& text)
      : file(desktop::parse_scene(text, "test.toml")), push(file), report(push.solve({})) {
    REQUIRE(report.status == Status::solved);
    REQUIRE(report.residuals.max() <= 1e-9);
  }

  double normal_of(const std::string& body) const {
    double sum = 0;
    for (Index i = 0; i < report.answer.contacts.size; ++i)
      if (file.body_names[static_cast<std::size_t>(report.answer.contacts[i].body)] == body)
        sum += report.answer.contacts[i].normal_force;
    return sum;
  }
  Mode mode_of(const std::string& point) const {
    for (Index i = 0; i < report.answer.contacts.size; ++i)
      if (desktop::point_name(file, i) == point) return report.answer.contacts[i].mode;
    FAIL("no point " << point);
    return Mode::stick;
  }
  double linear(int k) const { return report.answer.acceleration[k]; }
  double angular(int k) const { return report.answer.acceleration[3 + k]; }
};

inline double break_force(const std::string& text) {
  const desktop::SceneFile file = desktop::parse_scene(text, "test.toml");
  desktop::Push push(file);
  const desktop::BreakReport report =
      push.find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
  REQUIRE(report.status == Status::solved);
  return report.breaking.break_force;
}

} // namespace lcpush::test
