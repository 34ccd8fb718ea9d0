// What the views of a scene share: scales, places, and which views they are.
#include <algorithm>
#include <cmath>

#include "report/scene_painter.hpp"
#include "solve/sentence.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Motions below this part of the fastest contact's are not drawn, as Motion does not name them.
constexpr double negligible = 1e-3;

constexpr double tallest_object = 160; ///< pixels: two views stand beside the isometric one

/// "slip" of "slips".
std::string plural_of(const std::string& verb) { return verb.substr(0, verb.size() - 1); }

} // namespace

Vector3<double> point_acceleration(const Scene<double>& scene, const Body<double>& body,
                                   Index point, const PushReport& report) {
  if (report.status != Status::solved)
    return acceleration_at(scene.points[point], body.acceleration);
  return acceleration_at(scene.points[point], report.answer.acceleration) -
         report.answer.contacts[point].acceleration;
}

Vector3<double> body_acceleration(const Scene<double>& scene, const Body<double>& body,
                                  const PushReport& report) {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const Index i : points_of(body)) sum += point_acceleration(scene, body, i, report);
  return sum / static_cast<double>(body.point_count);
}

std::string modes_of(const Body<double>& body, const PushReport& report) {
  Index counts[3] = {0, 0, 0};
  for (const Index i : points_of(body)) ++counts[static_cast<int>(report.answer.contacts[i].mode)];
  std::vector<std::string> modes;
  for (const Mode mode : {Mode::stick, Mode::slide, Mode::separate}) {
    const Index count = counts[static_cast<int>(mode)];
    if (count == body.point_count) return mode_verb(mode);
    if (count == 1) modes.push_back(std::string("1 ") + mode_verb(mode));
    if (count > 1) modes.push_back(std::to_string(count) + " " + plural_of(mode_verb(mode)));
  }
  return listed(modes, "and");
}

std::vector<View> chosen_views(const SceneFile& file) {
  const Vector3<double> pull = file.gravity.cwiseAbs();
  if (pull.z() > std::max(pull.x(), pull.y())) {
    const double up = file.gravity.z() < 0 ? 1 : -1;
    const Vector3<double> x(1, 0, 0), y(0, up, 0), z(0, 0, up);
    return {{"front", "Front view, x and z", x, z, -y},
            {"top", "View from above, x and y", x, y, z}};
  }
  return views_with_y_up(file.shape.size, file.bodies);
}

PictureScales picture_scales(const SceneFile& file, const PushReport& report) {
  const Scene<double> scene = file.view();
  PictureScales scales;
  scales.shows_forces = report.status == Status::solved;
  double most_force = 0, most_speed = 0;
  for (const Body<double>& body : scene.bodies)
    for (const Index i : points_of(body)) {
      most_speed = std::max(most_speed, point_acceleration(scene, body, i, report).norm());
      if (!scales.shows_forces) continue;
      const ContactAnswer<double>& answer = report.answer.contacts[i];
      most_force =
          std::max({most_force, std::abs(answer.normal_force), answer.friction_force.norm()});
    }
  if (scales.shows_forces) {
    most_force = std::max(most_force, (file.object.mass * file.gravity).norm());
    most_speed = std::max(most_speed, report.answer.acceleration.head<3>().norm());
    scales.no_force = report.noise.force;
    scales.still = std::max(negligible * most_speed, report.noise.acceleration);
  }
  scales.newtons = most_force > 0 ? longest_force / round_above(most_force) : 0;
  scales.accelerations = most_speed > 0 ? fastest / most_speed : 0;
  return scales;
}

std::vector<Drawing> scene_pictures(const SceneFile& file, const PushReport& report) {
  const std::vector<View> views = chosen_views(file);
  PictureScales scales = picture_scales(file, report);
  scales.meters = 1e300;
  for (const View& view : views) {
    const Frame frame = ScenePainter::extent(file, report, view);
    const double room = ScenePainter::width - 2 * ScenePainter::margin;
    scales.meters = std::min({scales.meters, room / std::max(frame.width(), 1e-9),
                              tallest_object / std::max(frame.height(), 1e-9)});
  }
  std::vector<Drawing> drawings;
  for (const View& view : views)
    drawings.push_back(ScenePainter(file, report, view, scales).draw());
  return drawings;
}

} // namespace lcpush::desktop
