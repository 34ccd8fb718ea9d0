// The isometric view: bodies as things, what each does to the object, and where the object goes.
#include <cmath>

#include "report/grasp_painter.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double width = 420, height = 340, finger_length = 62;
constexpr double object_width = 235, object_height = 165, longest_arrow = 84, fastest_arrow = 50;

/// In the middle of the picture, as large as there is room.
Sight isometric_sight(const DrawnScene& drawn) {
  const View view = isometric_view(chosen_views(drawn.file)[0]);
  std::vector<Pixel> shown;
  for (const auto& corner : corners_of(drawn.object)) shown.push_back(view.flat(corner));
  for (const auto& position : drawn.positions) shown.push_back(view.flat(position));
  const Frame frame = bounds(shown);
  return centered(view, frame, fitting_scale(frame, object_width, object_height), {width, height});
}

} // namespace

IsometricPainter::IsometricPainter(const DrawnScene& drawn, const PushReport& report)
    : GraspPainter(drawn, report, picture_scales(drawn, report), isometric_sight(drawn),
                   {width, height}, {14, 6, 6}),
      figures_(drawn, sight_, {finger_length, 26, 2}) {
  if (!scales_.shows_forces) return;
  double most = (file_.object.mass * file_.gravity).norm();
  for (const Body<double>& body : scene_.bodies)
    most = std::max({most, std::abs(normal_sum(report_.answer, body)), friction_of(body).norm()});
  scales_.newtons = most > 0 ? longest_arrow / round_above(most) : 0;
  scales_.accelerations *= fastest_arrow / fastest;
}

/// Words do not touch its outline while there is any other place.
std::string IsometricPainter::kept_clear(const Figure& figure) {
  places_.bar_edges(figure.outline);
  return figure.elements;
}

/// The sums of a body's forces, at the middle of its contact.
std::string IsometricPainter::forces(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel at = contact(body);
  places_.block_around(at, 6, 6);
  if (!scales_.shows_forces) return squeeze(b, "force normal bold");
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
  const auto at = [&](double angle) {
    return Pixel(center() + turn_radius * view_.flat(Vector3<double>(std::cos(angle) * u +
                                                                     std::sin(angle) * v)));
  };
  std::vector<Pixel> arc;
  constexpr double end = 4.4, step = 0.1;
  for (double angle = 0; angle <= end; angle += step) arc.push_back(at(angle));
  places_.block_around(center(), turn_radius, 1.5);
  return "<g class=\"motion\">" + polyline_element("arc", arc) +
         arrow_element("tip", at(end - 0.05), at(end + 0.45), 12) + "</g>\n";
}

std::string IsometricPainter::object_motion() {
  std::string text;
  std::string name = object_name(file_);
  name.erase(0, std::string("the ").size());
  std::vector<std::string> lines{name};
  Pixel target = center();
  if (scales_.shows_forces) {
    const Vector6<double>& a = report_.answer.acceleration;
    if (a.head<3>().norm() > scales_.still) {
      target = center() + scales_.accelerations * view_.flat(a.head<3>());
      text += arrow("motion", center(), target);
      lines.push_back(brief(a.head<3>().norm()) + " m/s\u00B2");
    }
    text += turning();
    if (turns(report_.motion))
      lines.push_back("turns " + brief(report_.motion.rotation) + " rad/s\u00B2");
    if (lines.size() == 1) lines.emplace_back("stays");
    words_.push_back("The " + name + ": " + listed({lines.begin() + 1, lines.end()}, "and") + ".");
  }
  labels_.push_back({lines, target, Pixel::Zero(), target});
  return text + circle_element("center", center(), 3.5);
}

/// Beside the body's force, which may go the same way.
std::string IsometricPainter::body_motion(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Vector3<double> moves = acceleration_of(body);
  if (!(moves.norm() > scales_.still)) return "";
  const Pixel back = view_.flat(body.normal), across(-back.y(), back.x());
  const Pixel from = contact(body) - 30 * back + 20 * across;
  return arrow("motion thin", from, from + scales_.accelerations * view_.flat(moves));
}

/// "left", "presses 20 N", "slips".
std::vector<std::string> IsometricPainter::body_words(Index b) const {
  const Body<double>& body = scene_.bodies[b];
  std::vector<std::string> words{shortened(file_.body_name(b), 18)};
  if (!scales_.shows_forces) {
    if (squeezes(b)) words.emplace_back("squeezes");
    return words;
  }
  const double normal = normal_sum(report_.answer, body);
  if (normal > scales_.no_force)
    words.push_back("presses " + brief(normal) + " N");
  else if (normal < -scales_.no_force)
    words.push_back("pulls " + brief(-normal) + " N");
  else
    words.emplace_back("no force");
  words.push_back(modes_text(report_.answer, body));
  return words;
}

/// At the finger itself, or where a plate touches.
void IsometricPainter::label(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const Pixel at = contact(body), back = -view_.flat(body.normal);
  // Of a finger behind the object the far end is seen.
  const double seen = view_.toward.dot(body.normal) > 0 ? 0.95 : 0.6;
  label_body(body_words(b), at + finger_length * back, back,
             figures_.is_table(b) ? at : Pixel(at + seen * finger_length * back));
}

Drawing IsometricPainter::draw() {
  const Pixel corner(92, 92); // of the axes
  places_.bar({0, 0, corner.x(), corner.y()});
  std::string behind, before, arrows;
  for (const Index b : bodies_back_to_front(view_, scene_.bodies)) {
    const Body<double>& body = scene_.bodies[b];
    const std::string kind =
        std::string("thing ") + (body.role == Role::pusher ? "pusher" : "finger");
    (view_.toward.dot(body.normal) > 0 ? behind : before) += kept_clear(figures_.body(b, kind));
  }
  const std::string object = kept_clear(figures_.object());
  const std::string ghost_elements =
      scales_.shows_forces ? kept_clear(figures_.ghost(report_)) : "";
  for (Index b = 0; b < scene_.bodies.size; ++b) arrows += forces(b) + body_motion(b);
  const std::string motion = object_motion();
  arrows += weight() + motion;
  for (Index b = 0; b < scene_.bodies.size; ++b) label(b);
  Drawing drawing = labelled(corner, 8,
                             scales_.shows_forces
                                 ? "The object between the bodies that touch it, the forces on it, "
                                   "and dashed where it goes."
                                 : "The object between the bodies that touch it.");
  drawing.elements = shifted(axes_in_space(view_, {44, 50}, 32), {0, drawing.top}) + behind +
                     object + before + ghost_elements + arrows + drawing.elements;
  return drawing;
}

} // namespace lcpush::desktop
