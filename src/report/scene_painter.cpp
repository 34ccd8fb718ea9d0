#include <algorithm>
#include <cmath>

#include "picture/contact_figures.hpp"
#include "report/grasp_painter.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// The picture is as high as what it shows.
Pixel size_of(const Frame& extent, double meters) {
  return {ScenePainter::width,
          std::round(extent.height() * meters + 2 * ScenePainter::margin_above)};
}

} // namespace

ScenePainter::ScenePainter(const DrawnScene& drawn, const PushReport& report, const View& view,
                           double meters, const PictureScales& scales)
    : GraspPainter(drawn, report, scales,
                   centered(view, extent(drawn, report, view), meters,
                            size_of(extent(drawn, report, view), meters)),
                   size_of(extent(drawn, report, view), meters), {9, 2.5, 60}) {}

Frame ScenePainter::extent(const DrawnScene& drawn, const PushReport& report, const View& view) {
  std::vector<Pixel> shown;
  for (const auto& corner : box_corners(drawn.center(), drawn.file.shape.size))
    shown.push_back(view.flat(corner));
  for (const auto& position : drawn.positions) shown.push_back(view.flat(position));
  const Frame frame = bounds(shown);
  const Motion<double>& motion = report.motion;
  if (report.status != Status::solved || !turns(motion) || !is_along_sight(view, motion.axis))
    return frame;
  // Its centre too, unless that would make everything else small.
  const Pixel center = view.flat(drawn.center() + motion.axis_point);
  const double reach = 0.6 * std::max(frame.width(), frame.height());
  if (center.x() > frame.left - reach && center.x() < frame.right + reach &&
      center.y() > frame.top - reach && center.y() < frame.bottom + reach)
    shown.push_back(center);
  return bounds(shown);
}

std::string ScenePainter::outline() {
  const ObjectShape& shape = file_.shape;
  std::vector<Pixel> corners;
  for (const auto& corner : box_corners(drawn_.center(), shape.size))
    corners.push_back(place(corner));
  places_.block(bounds(corners), 0.6);
  places_.bar_edges(hull(corners));
  if (is_round_in(view_, shape))
    return circle_element("object", center(),
                          sight_.meters * std::abs(view_.right.dot(shape.size)) / 2);
  return polygon_element(shape.kind == ObjectShape::Kind::unknown ? "object guessed" : "object",
                         hull(corners));
}

std::string ScenePainter::pad(const Body<double>& body) {
  std::vector<Pixel> around;
  const std::vector<Pixel> rim = pad_rim(view_, body.normal);
  for (const Index i : points_of(body)) {
    const Pixel at = place(drawn_.position(i));
    places_.block_around(at, 12, 20);
    for (const Pixel& offset : rim) around.emplace_back(at + offset);
  }
  places_.bar_edges(hull(around));
  return polygon_element(std::string("pad ") + (body.role == Role::pusher ? "pusher" : "finger") +
                             (view_.is_behind(body.normal) ? " behind" : ""),
                         hull(around));
}

std::string ScenePainter::forces(const Body<double>& body, Index point) {
  if (!scales_.shows_forces) return "";
  const Pixel tip = place(drawn_.position(point));
  const ContactFigure figure = contact_figure(file_, view_, body, report_.answer.contacts[point],
                                              tip, scales_.newtons, scales_.no_force);
  places_.block_around(tip, 10, 2);
  for (const Pixel& corner : figure.cone) places_.block_line(tip, corner, 30);
  for (const auto& [tail, head] : figure.shafts) {
    places_.block_line(tail, head, 60);
    arrows_.add(tail, head);
  }
  return figure.elements;
}

std::string ScenePainter::marks(const Body<double>& body) {
  std::string text;
  for (const Index i : points_of(body)) {
    const Pixel at = place(drawn_.position(i));
    std::string said = point_name(file_, i), mark = circle_element("mark", at, 3);
    if (scales_.shows_forces) {
      const ContactAnswer<double>& answer = report_.answer.contacts[i];
      said += std::string(" ") + mode_verb(answer.mode) + ", normal force " +
              number(answer.normal_force, scales_.no_force) + " N, friction " +
              number(answer.friction_force.norm(), scales_.no_force) + " N";
      mark = mode_mark(answer.mode, at);
    }
    text += "<g><title>" + escaped(said) + "</title>" + mark + "</g>\n";
  }
  return text;
}

std::string ScenePainter::object_motion() {
  std::string text;
  if (scales_.shows_forces) {
    const Vector6<double>& a = report_.answer.acceleration;
    const Pixel flat = view_.flat(a.head<3>());
    const bool moves = flat.norm() > scales_.still;
    const Pixel tip = moves ? Pixel(center() + scales_.accelerations * flat) : center();
    std::vector<std::string> lines{"object"}, said;
    if (moves) {
      text += arrow("motion", center(), tip);
      const double whole = a.head<3>().norm();
      lines.push_back(brief(flat.norm()) + " m/s\u00B2" +
                      (flat.norm() < 0.995 * whole ? " of " + brief(whole) : ""));
      said.push_back("accelerates by " + lines.back());
    }
    const double spin = view_.toward.dot(a.tail<3>());
    if (report_.scales.length * std::abs(spin) > scales_.still) {
      places_.block_around(center(), 22, 20);
      text += turning_arc(center(), spin < 0);
      lines.push_back("turns " + brief(std::abs(spin)) + " rad/s\u00B2");
      said.push_back(lines.back());
    }
    if (report_.motion.kind == MotionKind::rest)
      lines.emplace_back("stays");
    else if (lines.size() == 1)
      lines.emplace_back(!(a.head<3>().norm() > scales_.still) ? "turns"
                         : view_.toward.dot(a.head<3>()) > 0   ? "comes nearer"
                                                               : "moves away");
    if (said.empty()) said.push_back(lines.back());
    labels_.push_back({lines, tip, Pixel::Zero(), tip});
    words_.push_back("The object " + listed(said, "and") + ".");
  }
  return text + circle_element("center", center(), 3);
}

/// Where the axis is when that is off the picture. `pitch`: of a screw, else empty.
std::string ScenePainter::away_mark(const Pixel& center, const std::string& name,
                                    const std::string& pitch) {
  const Pixel middle = size_ / 2, along = (center - middle).normalized();
  const auto line = clipped_line({0, 0, width, size_.y() - 26}, middle, along); // above the scales
  if (!line) return "";
  const Pixel tip = line->second - 5 * along, tail = tip - 26 * along;
  const std::string distance = millimetres(report_.motion.axis_point.norm());
  words_.push_back("Off the picture: " + name + pitch + ", " + distance +
                   " from the centre of mass.");
  places_.block_line(tail, tip, 3);
  labels_.push_back({{name, distance + " away"}, tail, Pixel(-along), tail});
  return arrow_element("motion thin", tail, tip);
}

/// The instantaneous centre, or the axis as a line; of a screw with its pitch.
std::string ScenePainter::turning_axis() {
  const Motion<double>& motion = report_.motion;
  if (!scales_.shows_forces || !turns(motion)) return "";
  const bool is_screw = has_pitch(motion, report_.scales.length);
  const std::string pitch = "pitch " + millimetres(motion.pitch) + "/rad";
  const Vector3<double> point = drawn_.center() + motion.axis_point;
  const Pixel at = place(point);
  if (is_along_sight(view_, motion.axis)) {
    const std::string name = is_screw ? "screw axis" : "instantaneous centre";
    const std::string more = is_screw ? ", " + pitch : "";
    if (at.x() < 8 || at.y() < 8 || at.x() > size_.x() - 8 || at.y() > size_.y() - 8)
      return away_mark(at, name, more);
    places_.block_around(at, 8, 3);
    // In two lines, which find a place more easily.
    std::vector<std::string> lines{"instantaneous", "centre"};
    if (is_screw) lines = {name, pitch};
    labels_.push_back({lines, at, Pixel::Zero(), at, is_screw ? 1U : 2U});
    words_.push_back("It turns about the " + name + more + " at " +
                     vector_text(point, report_.noise.length) + " m.");
    return turning_center(at);
  }
  const std::string name = is_screw ? "screw axis" : "axis of turning";
  words_.push_back("Its " + name + (is_screw ? " has " + pitch + "." : " lies in the picture."));
  const auto line = clipped_line({0, 0, width, size_.y()}, at, view_.flat(motion.axis));
  if (!line) return away_mark(at, name, "");
  places_.block_endless_line(line->first, line->second, 200);
  std::vector<std::string> lines{name};
  if (is_screw) lines.push_back(pitch);
  const Pixel near = line->first + 0.85 * (line->second - line->first);
  labels_.push_back({lines, near, Pixel::Zero(), near});
  return line_element("screw", line->first, line->second);
}

/// "left", "normal 20 N", "friction 10 N", "slips".
std::vector<std::string> ScenePainter::body_words(Index b) const {
  const Body<double>& body = scene_.bodies[b];
  std::vector<std::string> words{shortened(file_.body_name(b), 18)};
  if (!scales_.shows_forces) {
    if (squeezes(b)) words.emplace_back("squeezes");
    const double moves = acceleration_of(body).norm();
    if (moves > 0) words.push_back("moves at " + brief(moves) + " m/s\u00B2");
    return words;
  }
  const double normal = normal_sum(report_.answer, body), friction = friction_of(body).norm();
  if (std::abs(normal) > scales_.no_force) words.push_back("normal " + brief(normal) + " N");
  if (friction > scales_.no_force) words.push_back("friction " + brief(friction) + " N");
  if (words.size() == 1) words.emplace_back("no force");
  words.push_back(modes_text(report_.answer, body));
  return words;
}

std::string ScenePainter::body_motion(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel flat = view_.flat(body.normal), out = contact(body) - 22 * flat;
  const Pixel moves = view_.flat(acceleration_of(body));
  const bool is_still = !(moves.norm() > scales_.still);
  label_body(body_words(b), contact(body) - 46 * flat, -flat, contact(body));
  return is_still ? "" : arrow("motion thin", out, out + scales_.accelerations * moves);
}

Drawing ScenePainter::draw() {
  std::string bodies, contacts, modes, motions;
  const Pixel corner(58, 54); // of the axes' names
  constexpr double scale_height = 24;
  places_.bar({0, 0, corner.x(), corner.y()});
  places_.bar({0, size_.y() - scale_height, width, size_.y()});
  const std::string object = outline();
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Body<double>& body = scene_.bodies[b];
    bodies += pad(body);
    for (const Index i : points_of(body)) contacts += forces(body, i);
    modes += marks(body);
  }
  // One after the other: each leaves labels, words and arrows behind.
  for (Index b = 0; b < scene_.bodies.size; ++b) contacts += squeeze(b, "force normal");
  motions += object_motion();
  contacts += weight();
  motions += turning_axis();
  for (Index b = 0; b < scene_.bodies.size; ++b) motions += body_motion(b);
  Drawing drawing = labelled(corner, scale_height + 6,
                             scales_.shows_forces
                                 ? "The object, the bodies that touch it, forces and motions."
                                 : "The object and the bodies that touch it. No answer was found, "
                                   "so no forces are drawn.");
  drawing.elements =
      shifted(axes_elements(view_), {0, drawing.top}) +
      scale_bars(width, drawing.top + drawing.height, sight_.meters, scales_.newtons) + object +
      bodies + contacts + modes + motions + drawing.elements;
  return drawing;
}

} // namespace lcpush::desktop
