#include "report/scene_painter.hpp"

#include <algorithm>
#include <cmath>

#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
ScenePainter::ScenePainter(const SceneFile& file, const PushReport& report, const View& view,
                           const PictureScales& scales)
    : file_(file), scene_(file.view()), report_(report), view_(view), scales_(scales),
      positions_(drawn_positions(file)), extent_(extent(file, report, view)),
      height_(std::round(extent_.height() * scales.meters + 2 * margin_above)),
      places_(width, height_) {}

Frame ScenePainter::extent(const SceneFile& file, const PushReport& report, const View& view) {
  std::vector<Pixel> shown;
  for (const auto& corner : box_corners(file.object.center_of_mass, file.shape.size))
    shown.push_back(view.flat(corner));
  for (const auto& position : drawn_positions(file)) shown.push_back(view.flat(position));
  const Frame frame = bounds(shown);
  const Motion<double>& motion = report.motion;
  if (report.status != Status::solved || !turns(motion) || !is_along_sight(view, motion.axis))
    return frame;
  // Its centre too, unless that would make everything else small.
  const Pixel center = view.flat(file.object.center_of_mass + motion.axis_point);
  const double reach = 0.6 * std::max(frame.width(), frame.height());
  if (center.x() > frame.left - reach && center.x() < frame.right + reach &&
      center.y() > frame.top - reach && center.y() < frame.bottom + reach)
    shown.push_back(center);
  return bounds(shown);
}

Pixel ScenePainter::place(const Vector3<double>& position) const {
  const Pixel middle((extent_.left + extent_.right) / 2, (extent_.top + extent_.bottom) / 2);
  return Pixel(width / 2, height_ / 2) + scales_.meters * (view_.flat(position) - middle);
}

std::string ScenePainter::outline() {
  const ObjectShape& shape = file_.shape;
  std::vector<Pixel> corners;
  for (const auto& corner : box_corners(file_.object.center_of_mass, shape.size))
    corners.push_back(place(corner));
  places_.block(bounds(corners), 0.6);
  places_.bar_edges(hull(corners));
  if (shape.kind == ObjectShape::Kind::cylinder && view_.toward[shape.axis] != 0)
    return circle_element("object", place(file_.object.center_of_mass),
                          scales_.meters * std::abs(view_.right.dot(shape.size)) / 2);
  return polygon_element(shape.kind == ObjectShape::Kind::unknown ? "object guessed" : "object",
                         hull(corners));
}

std::string ScenePainter::pad(const Body<double>& body) {
  std::vector<Pixel> around;
  const std::vector<Pixel> rim = pad_rim(view_, body.normal);
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
    const Pixel at = place(positions_[static_cast<std::size_t>(i)]);
    places_.block_around(at, 12, 20);
    for (const Pixel& offset : rim) around.emplace_back(at + offset);
  }
  places_.bar_edges(hull(around));
  return polygon_element(std::string("pad ") + (body.role == Role::pusher ? "pusher" : "finger") +
                             (view_.is_behind(body.normal) ? " behind" : ""),
                         hull(around));
}

std::string ScenePainter::weight() {
  const Vector3<double> force = file_.object.mass * file_.gravity;
  if (!scales_.shows_forces || !(view_.flat(force).norm() > scales_.no_force)) return "";
  const Pixel center = place(file_.object.center_of_mass);
  const Pixel along = scales_.newtons * view_.flat(force);
  const Pixel from = arrows_.clear_start(center, center + along), to = from + along;
  places_.block_line(from, to, 60);
  if ((to - from).norm() >= 2.5)
    labels_.push_back({{"weight " + brief(force.norm()) + " N"}, to, along.normalized(), to});
  return arrow_element("force weight", from, to);
}

/// Without an answer: an arrow for each body of a jam, of no particular length.
std::string ScenePainter::squeezes() {
  std::string text;
  for (const JamBody& squeezing : report_.jam.bodies) {
    const Body<double>& body = scene_.bodies[squeezing.body];
    const Pixel flat = view_.flat(body.normal);
    if (flat.norm() < 0.3) continue;
    const Pixel tip = place(middle_of(positions_, body)), tail = tip - 60 * flat;
    places_.block_line(tail, tip, 60);
    text += arrow_element("force normal", tail, tip);
  }
  return text;
}

/// "left", "normal 20 N", "friction 10 N", "slips".
std::vector<std::string> ScenePainter::body_words(Index b) const {
  const Body<double>& body = scene_.bodies[b];
  std::vector<std::string> words{shortened(file_.body_name(b), 18)};
  if (!scales_.shows_forces) {
    for (const JamBody& squeezing : report_.jam.bodies)
      if (squeezing.body == b) words.emplace_back("squeezes");
    const double moves = body_acceleration(scene_, body, report_).norm();
    if (moves > 0) words.push_back("moves at " + brief(moves) + " m/s\u00B2");
    return words;
  }
  Vector3<double> friction = Vector3<double>::Zero();
  for (const Index i : points_of(body)) friction += report_.answer.contacts[i].friction_force;
  const double normal = normal_sum(report_.answer, body);
  if (std::abs(normal) > scales_.no_force) words.push_back("normal " + brief(normal) + " N");
  if (friction.norm() > scales_.no_force)
    words.push_back("friction " + brief(friction.norm()) + " N");
  if (words.size() == 1) words.emplace_back("no force");
  words.push_back(modes_of(body, report_));
  return words;
}

std::string ScenePainter::scale_bars(double bottom) {
  const auto bar = [](double left, double y, double length) {
    return path_element("scale", move_to({left, y}) + "v6h" + pixels(length) + "v-6");
  };
  const double y = bottom - 14;
  const double length = round_below(70 / scales_.meters);
  std::string text =
      bar(12, y, length * scales_.meters) +
      text_element("quiet", {18 + length * scales_.meters, y + 7}, number(1000 * length) + " mm");
  if (!scales_.shows_forces || scales_.newtons == 0) return text;
  const double force = round_below(longest_force / scales_.newtons);
  const double size = force * scales_.newtons;
  return text + bar(width - 12 - size, y, size) +
         text_element("quiet", {width - 18 - size, y + 7}, number(force) + " N", "end");
}

Drawing ScenePainter::draw() {
  Drawing drawing{view_.name, view_.title, "", width, height_, ""};
  std::string bodies, contacts, modes, motions;
  const Pixel corner(58, 54); // of the axes' names
  constexpr double scale_height = 24;
  places_.bar({0, 0, corner.x(), corner.y()});
  places_.bar({0, height_ - scale_height, width, height_});
  const std::string object = outline();
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Body<double>& body = scene_.bodies[b];
    bodies += pad(body);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      contacts += forces(body, i);
    modes += marks(body);
  }
  // One after the other: each leaves labels, words and arrows behind.
  contacts += squeezes();
  motions += object_motion();
  contacts += weight();
  motions += turning_axis();
  for (Index b = 0; b < scene_.bodies.size; ++b) motions += body_motion(b);
  const std::vector<Frame> words = placed_labels(places_, labels_);
  const Frame used = places_.used(words, corner, scale_height + 6);
  drawing.top = used.top;
  drawing.height = used.height();
  drawing.elements = shifted(axes_elements(view_), {0, used.top}) + scale_bars(used.bottom) +
                     object + bodies + contacts + modes + motions + label_elements(labels_, words);
  drawing.description = scales_.shows_forces
                            ? "The object, the bodies that touch it, forces and motions."
                            : "The object and the bodies that touch it. No answer was found, so no "
                              "forces are drawn.";
  for (const std::string& sentence : words_) drawing.description += " " + sentence;
  return drawing;
}

} // namespace lcpush::desktop
