// The layers of a view that show forces and motions.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "picture/contact_figures.hpp"
#include "report/scene_painter.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

std::string ScenePainter::forces(const Body<double>& body, Index point) {
  if (!scales_.shows_forces) return "";
  const Pixel tip = place(positions_[static_cast<std::size_t>(point)]);
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
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
    const Pixel at = place(positions_[static_cast<std::size_t>(i)]);
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
  const Pixel center = place(file_.object.center_of_mass);
  std::string text;
  if (scales_.shows_forces) {
    const Vector6<double>& a = report_.answer.acceleration;
    const Pixel flat = view_.flat(a.head<3>());
    const Pixel tip = center + scales_.accelerations * flat;
    std::vector<std::string> lines{"object"}, said;
    if (flat.norm() > scales_.still) {
      text += arrow_element("motion", center, tip);
      places_.block_line(center, tip, 60);
      arrows_.add(center, tip);
      const double whole = a.head<3>().norm();
      lines.push_back(brief(flat.norm()) + " m/s\u00B2" +
                      (flat.norm() < 0.995 * whole ? " of " + brief(whole) : ""));
      said.push_back("accelerates by " + lines.back());
    }
    const double spin = view_.toward.dot(a.tail<3>());
    if (report_.scales.length * std::abs(spin) > scales_.still) {
      places_.block_around(center, 22, 20);
      text += turning_arc(center, spin < 0);
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
    const bool moves = flat.norm() > scales_.still;
    labels_.push_back({lines, moves ? tip : center, Pixel::Zero(), moves ? tip : center});
    words_.push_back("The object " + listed(said, "and") + ".");
  }
  return text + circle_element("center", center, 3);
}

/// Where the axis is when that is off the picture. `pitch`: of a screw, else empty.
std::string ScenePainter::away_mark(const Pixel& center, const std::string& name,
                                    const std::string& pitch) {
  const Pixel middle(width / 2, height_ / 2), along = (center - middle).normalized();
  const auto line = clipped_line(middle, along, width, height_ - 26); // above the scales
  if (!line) return "";
  const Pixel tip = line->second - 5 * along, tail = tip - 26 * along;
  const std::string distance = brief(1000 * report_.motion.axis_point.norm()) + " mm";
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
  const std::string pitch = "pitch " + brief(1000 * motion.pitch) + " mm/rad";
  const Vector3<double> point = file_.object.center_of_mass + motion.axis_point;
  const Pixel at = place(point);
  if (is_along_sight(view_, motion.axis)) {
    const std::string name = is_screw ? "screw axis" : "instantaneous centre";
    const std::string more = is_screw ? ", " + pitch : "";
    if (at.x() < 8 || at.y() < 8 || at.x() > width - 8 || at.y() > height_ - 8)
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
  const auto line = clipped_line(at, view_.flat(motion.axis), width, height_);
  if (!line) return away_mark(at, name, "");
  places_.block_endless_line(line->first, line->second, 200);
  std::vector<std::string> lines{name};
  if (is_screw) lines.push_back(pitch);
  const Pixel near = line->first + 0.85 * (line->second - line->first);
  labels_.push_back({lines, near, Pixel::Zero(), near});
  return line_element("screw", line->first, line->second);
}

std::string ScenePainter::body_motion(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel flat = view_.flat(body.normal), start = place(middle_of(positions_, body));
  const Pixel out = start - 22 * flat;
  const Vector3<double> moves = body_acceleration(scene_, body, report_);
  std::string text;
  if (view_.flat(moves).norm() > scales_.still) {
    const Pixel tip = out + scales_.accelerations * view_.flat(moves);
    places_.block_line(out, tip, 60);
    text = arrow_element("motion thin", out, tip);
  }
  const std::vector<std::string> lines = body_words(b);
  labels_.push_back({lines, start - 46 * flat, Pixel(-flat), start});
  words_.push_back(lines[0] + ": " + listed({lines.begin() + 1, lines.end()}, "and") + ".");
  return text;
}

} // namespace lcpush::desktop
