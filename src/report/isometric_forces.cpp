// Forces, motions and words of the isometric view.
#include <cmath>

#include "report/isometric_painter.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr double least_arrow = 6; // pixels that can be told from a dot

} // namespace

std::string IsometricPainter::arrow(const std::string& kind, const Pixel& from, const Pixel& to) {
  places_.block_line(from, to, 6);
  arrows_.add(from, to);
  return arrow_element(kind, from, to, 14);
}

/// The sums of a body's forces, at the middle of its contact.
std::string IsometricPainter::forces(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel at = place(middle_of(positions_, body));
  places_.block_around(at, 6, 6);
  if (!scales_.shows_forces) {
    for (const JamBody& squeezing : report_.jam.bodies)
      if (squeezing.body == b)
        return arrow("force normal bold", at - 60 * view_.flat(body.normal), at);
    return "";
  }
  const double normal = normal_sum(report_.answer, body);
  return arrow("force normal bold", at - scales_.newtons * normal * view_.flat(body.normal), at) +
         arrow("force friction bold", at, at + scales_.newtons * view_.flat(friction_of(body))) +
         circle_element("mark", at, 2.4);
}

/// Three quarters of a circle about the axis, around the centre of mass.
std::string IsometricPainter::turning() {
  const Motion<double>& motion = report_.motion;
  if (!turns(motion)) return "";
  const Vector3<double> around =
      motion.axis.cwiseAbs().x() < 0.9 ? Vector3<double>(1, 0, 0) : Vector3<double>(0, 1, 0);
  constexpr double turn_radius = 30; // pixels
  const Vector3<double> u = cross<double>(motion.axis, around).normalized();
  const Vector3<double> v = cross<double>(motion.axis, u);
  const Pixel center = place(file_.object.center_of_mass);
  const auto at = [&](double angle) {
    return Pixel(center + turn_radius * view_.flat(Vector3<double>(std::cos(angle) * u +
                                                                   std::sin(angle) * v)));
  };
  std::string strokes = move_to(at(0));
  constexpr double end = 4.4, step = 0.1;
  for (double angle = step; angle <= end; angle += step)
    strokes += "L" + move_to(at(angle)).substr(1);
  places_.block_around(center, turn_radius, 1.5);
  return "<g class=\"motion\">" + path_element("arc", strokes) +
         arrow_element("tip", at(end - 0.05), at(end + 0.45), 12) + "</g>\n";
}

std::string IsometricPainter::object_motion() {
  const Pixel center = place(file_.object.center_of_mass);
  std::string text;
  std::string name = object_name(file_);
  name.erase(0, std::string("the ").size());
  std::vector<std::string> lines{name};
  Pixel target = center;
  if (scales_.shows_forces) {
    const Vector6<double>& a = report_.answer.acceleration;
    if (a.head<3>().norm() > scales_.still) {
      target = center + scales_.accelerations * view_.flat(a.head<3>());
      text += arrow("motion", center, target);
      lines.push_back(brief(a.head<3>().norm()) + " m/s\u00B2");
    }
    text += turning();
    if (turns(report_.motion))
      lines.push_back("turns " + brief(report_.motion.rotation) + " rad/s\u00B2");
    if (lines.size() == 1) lines.emplace_back("stays");
    words_.push_back("The " + name + ": " + listed({lines.begin() + 1, lines.end()}, "and") + ".");
  }
  labels_.push_back({lines, target, Pixel::Zero(), target});
  return text + circle_element("center", center, 3.5);
}

/// Beside the arrows that would cover it: a table's force runs the same way.
std::string IsometricPainter::weight() {
  const Vector3<double> force = file_.object.mass * file_.gravity;
  if (!scales_.shows_forces || !(force.norm() > scales_.no_force)) return "";
  const Pixel center = place(file_.object.center_of_mass);
  const Pixel along = scales_.newtons * view_.flat(force);
  if (along.norm() < least_arrow) return "";
  const Pixel from = arrows_.clear_start(center, center + along);
  labels_.push_back(
      {{"weight " + brief(force.norm()) + " N"}, from + along, along.normalized(), from + along});
  return arrow("force weight", from, from + along);
}

/// Beside the body's force, which may go the same way.
std::string IsometricPainter::body_motion(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Vector3<double> moves = body_acceleration(scene_, body, report_);
  if (!(moves.norm() > scales_.still)) return "";
  const Pixel back = view_.flat(body.normal), across(-back.y(), back.x());
  const Pixel from = place(middle_of(positions_, body)) - 30 * back + 20 * across;
  return arrow("motion thin", from, from + scales_.accelerations * view_.flat(moves));
}

/// "left", "presses 20 N", "slips".
std::vector<std::string> IsometricPainter::body_words(Index b) const {
  const Body<double>& body = scene_.bodies[b];
  std::vector<std::string> words{shortened(file_.body_name(b), 18)};
  if (!scales_.shows_forces) {
    for (const JamBody& squeezing : report_.jam.bodies)
      if (squeezing.body == b) words.emplace_back("squeezes");
    return words;
  }
  const double normal = normal_sum(report_.answer, body);
  if (normal > scales_.no_force)
    words.push_back("presses " + brief(normal) + " N");
  else if (normal < -scales_.no_force)
    words.push_back("pulls " + brief(-normal) + " N");
  else
    words.emplace_back("no force");
  words.push_back(modes_of(body, report_));
  return words;
}

/// At the finger itself, or where a plate touches.
void IsometricPainter::label_body(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel contact = place(middle_of(positions_, body)), back = -view_.flat(body.normal);
  // Of a finger behind the object the far end is seen.
  const double seen = view_.toward.dot(body.normal) > 0 ? 0.95 : 0.6;
  const std::vector<std::string> lines = body_words(b);
  labels_.push_back({lines, contact + finger_length * back, back,
                     figures_.is_rod(b) ? Pixel(contact + seen * finger_length * back) : contact});
  if (lines.size() > 1)
    words_.push_back(lines[0] + ": " + listed({lines.begin() + 1, lines.end()}, "and") + ".");
}

} // namespace lcpush::desktop
