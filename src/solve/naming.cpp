#include "lcpush/desktop/naming.hpp"

#include <cmath>

#include "solve/word_settings.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// To three digits, without the sign of a zero.
std::string rounded(double x) {
  return shown(std::round(x * word_settings.places) / word_settings.places + 0.0);
}

} // namespace

std::string point_name(const SceneFile& file, Index point) {
  const Index b = file.body_of(point);
  return file.body_name(b) + "." + std::to_string(point - file.body(b).first_point + 1);
}

std::string components_text(const Vector3<double>& direction) {
  return "(" + rounded(direction[0]) + ", " + rounded(direction[1]) + ", " + rounded(direction[2]) +
         ")";
}

std::string direction_text(const Vector3<double>& direction) {
  for (Index axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0})
      if ((direction - sign * Vector3<double>::Unit(axis)).norm() < 0.5 / word_settings.places)
        return std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
  return components_text(direction);
}

std::string friction_law_text(const SceneFile& file) {
  if (file.is_round) return "round friction";
  if (file.has_cones()) return std::to_string(file.facets) + " facets";
  const bool has_friction = std::any_of(file.bodies.begin(), file.bodies.end(),
                                        [](const Body<double>& body) { return body.friction > 0; });
  return has_friction ? "friction along the plane" : "no friction";
}

std::string generator_text(const Generator<double>& generator, double torsion_radius) {
  const double slide = generator.force.norm();
  std::string text;
  if (slide > 0) text = " along " + direction_text(generator.force / slide);
  if (generator.torque == 0) return text;
  if (slide > 0) text += " times " + rounded(slide) + " and";
  return text + " twisting by " + rounded(generator.torque / torsion_radius);
}

} // namespace lcpush::desktop
