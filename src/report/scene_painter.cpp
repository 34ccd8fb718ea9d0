#include "report/scene_painter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Where a label's leader begins: the place of its frame that is next to `at`.
Pixel leader_end(const Frame& frame, const Pixel& at) {
  return {std::clamp(at.x(), frame.left, frame.right), std::clamp(at.y(), frame.top, frame.bottom)};
}

} // namespace

ScenePainter::ScenePainter(const SceneFile& file, const PushReport& report, const View& view,
                           const PictureScales& scales)
    : file_(file), scene_(file.view()), report_(report), view_(view), scales_(scales),
      extent_(extent(file, report, view)),
      height_(std::round(extent_.height() * scales.meters + 2 * margin_above)),
      places_(width, height_) {}

Frame ScenePainter::extent(const SceneFile& file, const PushReport& report, const View& view) {
  std::vector<Pixel> shown;
  for (const auto& corner : box_corners(file.object.center_of_mass, file.shape.size))
    shown.push_back(view.flat(corner));
  for (const auto& position : file.positions) shown.push_back(view.flat(position));
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

Vector3<double> ScenePainter::body_middle(const Body<double>& body) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
    sum += file_.positions[static_cast<std::size_t>(i)];
  return sum / static_cast<double>(body.point_count);
}

Vector3<double> ScenePainter::point_acceleration(const Scene<double>& scene,
                                                 const Body<double>& body, Index point,
                                                 const PushReport& report) {
  if (report.status != Status::solved)
    return acceleration_at(scene.points[point], body.acceleration);
  return acceleration_at(scene.points[point], report.answer.acceleration) -
         report.answer.contacts[point].acceleration;
}

/// Of the middle of its points.
Vector3<double> ScenePainter::body_acceleration(const Body<double>& body) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
    sum += point_acceleration(scene_, body, i, report_);
  return sum / static_cast<double>(body.point_count);
}

std::string ScenePainter::outline() {
  const ObjectShape& shape = file_.shape;
  std::vector<Pixel> corners;
  for (const auto& corner : box_corners(file_.object.center_of_mass, shape.size))
    corners.push_back(place(corner));
  places_.block(bounds(corners), 0.6);
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
    const Pixel at = place(file_.positions[static_cast<std::size_t>(i)]);
    places_.block_around(at, 12, 1.5);
    for (const Pixel& offset : rim) around.emplace_back(at + offset);
  }
  return polygon_element(std::string("pad ") + (body.role == Role::pusher ? "pusher" : "finger") +
                             (view_.is_behind(body.normal) ? " behind" : ""),
                         hull(around));
}

std::string ScenePainter::weight() {
  const Vector3<double> force = file_.object.mass * file_.gravity;
  if (!scales_.shows_forces || !(view_.flat(force).norm() > scales_.no_force)) return "";
  const Pixel from = place(file_.object.center_of_mass);
  const Pixel to = from + scales_.newtons * view_.flat(force);
  places_.block_line(from, to, 2);
  if ((to - from).norm() >= 2.5)
    labels_.push_back({{"weight " + rough_number(force.norm()) + " N"}, to, Pixel::Zero(), to});
  return arrow_element("force weight", from, to);
}

/// Without an answer: an arrow for each body of a jam, of no particular length.
std::string ScenePainter::squeezes() {
  std::string text;
  for (const JamBody& squeezing : report_.jam.bodies) {
    const Body<double>& body = scene_.bodies[squeezing.body];
    const Pixel flat = view_.flat(body.normal);
    if (flat.norm() < 0.3) continue;
    const Pixel tip = place(body_middle(body)), tail = tip - 60 * flat;
    places_.block_line(tail, tip, 2);
    text += arrow_element("force normal", tail, tip);
  }
  return text;
}

/// "left", "normal 20 N", "friction 10 N", "4 slide".
std::vector<std::string> ScenePainter::body_words(Index b) const {
  const Body<double>& body = scene_.bodies[b];
  std::vector<std::string> words{shortened(file_.body_name(b), 24)};
  if (!scales_.shows_forces) {
    for (const JamBody& squeezing : report_.jam.bodies)
      if (squeezing.body == b) words.emplace_back("squeezes");
    if (body_acceleration(body).norm() > 0)
      words.push_back("moves at " + rough_number(body_acceleration(body).norm()) + " m/s\u00B2");
    return words;
  }
  Vector3<double> friction = Vector3<double>::Zero();
  Index counts[3] = {0, 0, 0};
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
    friction += report_.answer.contacts[i].friction_force;
    ++counts[static_cast<int>(report_.answer.contacts[i].mode)];
  }
  const double normal = normal_sum(report_.answer, body);
  if (std::abs(normal) > scales_.no_force) words.push_back("normal " + rough_number(normal) + " N");
  if (friction.norm() > scales_.no_force)
    words.push_back("friction " + rough_number(friction.norm()) + " N");
  if (words.size() == 1) words.emplace_back("no force");
  std::vector<std::string> modes;
  for (const Mode mode : {Mode::stick, Mode::slide, Mode::separate}) {
    const Index count = counts[static_cast<int>(mode)];
    if (count == 0) continue;
    if (body.point_count == 1)
      modes.push_back(mode_verb(mode));
    else
      modes.push_back((count == body.point_count ? "all " : "") + std::to_string(count) + " " +
                      mode_text(mode));
  }
  words.push_back(listed(modes, "and"));
  return words;
}

std::vector<Frame> ScenePainter::place_labels(const std::vector<std::size_t>& order,
                                              double& cost) const {
  LabelPlaces places = places_;
  std::vector<Frame> frames(labels_.size());
  for (const std::size_t k : order) {
    const Label& label = labels_[k];
    frames[k] = places.place(label.lines, label.at, label.away);
    places.block_line(leader_end(frames[k], label.at), label.target, 1);
  }
  cost = places.cost();
  return frames;
}

/// In the order that gives them the best places, of those that let each be the first.
std::string ScenePainter::placed_labels() const {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < labels_.size(); ++k) order.push_back(k);
  std::vector<Frame> frames;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < labels_.size(); ++turn) {
    double cost = 0;
    const std::vector<Frame> tried = place_labels(order, cost);
    if (cost < least) frames = tried;
    least = std::min(least, cost);
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
  std::string text;
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    const Label& label = labels_[k];
    const Pixel near = leader_end(frames[k], label.at);
    if ((near - label.target).norm() > 26) text += line_element("leader", near, label.target);
  }
  for (std::size_t k = 0; k < labels_.size(); ++k)
    for (std::size_t line = 0; line < labels_[k].lines.size(); ++line)
      text += text_element(line == 0 ? "label strong" : "label",
                           {frames[k].left + 2, frames[k].top + (static_cast<double>(line) + 0.8) *
                                                                    LabelPlaces::line_height},
                           labels_[k].lines[line]);
  return text;
}

std::string ScenePainter::scale_bars() {
  const auto bar = [](double left, double y, double length) {
    return path_element("scale", move_to({left, y}) + "v6h" + pixels(length) + "v-6");
  };
  const double y = height_ - 14;
  const double length = round_below(70 / scales_.meters);
  places_.block({0, height_ - 24, 190, height_}, 30);
  std::string text =
      bar(12, y, length * scales_.meters) +
      text_element("quiet", {18 + length * scales_.meters, y + 7}, number(1000 * length) + " mm");
  if (!scales_.shows_forces || scales_.newtons == 0) return text;
  const double force = round_below(longest_force / scales_.newtons);
  const double size = force * scales_.newtons;
  places_.block({width - 180, height_ - 24, width, height_}, 30);
  return text + bar(width - 12 - size, y, size) +
         text_element("quiet", {width - 18 - size, y + 7}, number(force) + " N", "end");
}

Drawing ScenePainter::draw() {
  Drawing drawing{view_.name, view_.title, "", width, height_, ""};
  std::string bodies, contacts, modes, motions;
  places_.block({0, 0, 58, 54}, 30);
  const std::string frame = axes_elements(view_) + scale_bars() + outline();
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Body<double>& body = scene_.bodies[b];
    bodies += pad(body);
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      contacts += forces(body, i);
    modes += marks(body);
  }
  // One after the other: each leaves labels and words behind.
  contacts += weight();
  contacts += squeezes();
  motions += object_motion();
  motions += turning_axis();
  for (Index b = 0; b < scene_.bodies.size; ++b) motions += body_motion(b);
  drawing.elements = frame + bodies + contacts + modes + motions;
  drawing.elements += placed_labels();
  drawing.description = scales_.shows_forces
                            ? "The object, the bodies that touch it, forces and motions."
                            : "The object and the bodies that touch it. No answer was found, so no "
                              "forces are drawn.";
  for (const std::string& sentence : words_) drawing.description += " " + sentence;
  return drawing;
}

} // namespace lcpush::desktop
