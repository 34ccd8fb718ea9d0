#include "report/grasp_painter.hpp"

#include <algorithm>
#include <cmath>

#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Motions below this part of the fastest contact's are not drawn, as Motion does not name them.
constexpr double negligible = 1e-3;

constexpr double tallest_object = 160; ///< pixels: two views stand beside the isometric one

/// Of a point: its prescribed motion and what its actuators add; without an answer the former.
Vector3<double> point_acceleration(const Scene<double>& scene, const Body<double>& body,
                                   Index point, const PushReport& report) {
  if (report.status != Status::solved)
    return acceleration_at(scene.points[point], body.acceleration);
  return acceleration_at(scene.points[point], report.answer.acceleration) -
         report.answer.contacts[point].acceleration;
}

} // namespace

PictureScales picture_scales(const DrawnScene& drawn, const PushReport& report) {
  PictureScales scales;
  scales.shows_forces = report.status == Status::solved;
  double most_force = 0, most_speed = 0;
  for (const Body<double>& body : drawn.scene.bodies)
    for (const Index i : points_of(body)) {
      most_speed = std::max(most_speed, point_acceleration(drawn.scene, body, i, report).norm());
      if (!scales.shows_forces) continue;
      const ContactAnswer<double>& answer = report.answer.contacts[i];
      most_force =
          std::max({most_force, std::abs(answer.normal_force), answer.friction_force.norm()});
    }
  if (scales.shows_forces) {
    most_force = std::max(most_force, (drawn.file.object.mass * drawn.file.gravity).norm());
    most_speed = std::max(most_speed, report.answer.acceleration.head<3>().norm());
    scales.no_force = report.noise.force;
    scales.still = std::max(negligible * most_speed, report.noise.acceleration);
  }
  scales.newtons = most_force > 0 ? longest_force / round_above(most_force) : 0;
  scales.accelerations = most_speed > 0 ? fastest / most_speed : 0;
  return scales;
}

std::string GraspPainter::arrow(const std::string& kind, const Pixel& from, const Pixel& to) {
  places_.block_line(from, to, look_.weight);
  arrows_.add(from, to);
  return arrow_element(kind, from, to, look_.head);
}

/// Beside the arrows that would cover it: a table's force runs the same way.
std::string GraspPainter::weight() {
  const Vector3<double> force = file_.object.mass * file_.gravity;
  if (!scales_.shows_forces || !(view_.flat(force).norm() > scales_.no_force)) return "";
  const Pixel along = scales_.newtons * view_.flat(force);
  if (along.norm() < look_.least) return "";
  const Pixel from = arrows_.clear_start(center(), center() + along), to = from + along;
  labels_.push_back({{"weight " + brief(force.norm()) + " N"}, to, along.normalized(), to});
  return arrow("force weight", from, to);
}

bool GraspPainter::squeezes(Index b) const {
  const std::vector<JamBody>& jam = report_.jam.bodies;
  return std::any_of(jam.begin(), jam.end(), [b](const JamBody& one) { return one.body == b; });
}

std::string GraspPainter::squeeze(Index b, const std::string& kind) {
  const Pixel flat = view_.flat(scene_.bodies[b].normal), tip = contact(scene_.bodies[b]);
  const bool is_seen = !scales_.shows_forces && squeezes(b) && flat.norm() >= 0.3;
  return is_seen ? arrow(kind, tip - 60 * flat, tip) : "";
}

Vector3<double> GraspPainter::friction_of(const Body<double>& body) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const Index i : points_of(body)) sum += report_.answer.contacts[i].friction_force;
  return sum;
}

Vector3<double> GraspPainter::acceleration_of(const Body<double>& body) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const Index i : points_of(body)) sum += point_acceleration(scene_, body, i, report_);
  return sum / static_cast<double>(body.point_count);
}

void GraspPainter::label_body(const std::vector<std::string>& lines, const Pixel& at,
                              const Pixel& away, const Pixel& target) {
  labels_.push_back({lines, at, away, target});
  if (lines.size() > 1)
    words_.push_back(lines[0] + ": " + listed({lines.begin() + 1, lines.end()}, "and") + ".");
}

Drawing GraspPainter::labelled(const Pixel& corner, double below,
                               const std::string& description) const {
  const std::vector<Frame> words = placed_labels(places_, labels_);
  const Frame used = places_.used(words, corner, below);
  Drawing drawing{view_.name,   view_.title,   description,
                  used.width(), used.height(), label_elements(labels_, words),
                  used.top};
  for (const std::string& sentence : words_) drawing.description += " " + sentence;
  return drawing;
}

std::vector<Drawing> scene_pictures(const DrawnScene& drawn, const PushReport& report) {
  const std::vector<View> views = chosen_views(drawn.file);
  double meters = 1e300;
  for (const View& view : views)
    meters = std::min(meters, fitting_scale(ScenePainter::extent(drawn, report, view),
                                            ScenePainter::width - 2 * ScenePainter::margin,
                                            tallest_object));
  const PictureScales scales = picture_scales(drawn, report);
  std::vector<Drawing> drawings;
  for (const View& view : views)
    drawings.push_back(ScenePainter(drawn, report, view, meters, scales).draw());
  return drawings;
}

Drawing isometric_picture(const DrawnScene& drawn, const PushReport& report) {
  return IsometricPainter(drawn, report).draw();
}

} // namespace lcpush::desktop
