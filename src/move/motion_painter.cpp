#include "move/motion_painter.hpp"

#include "move/move_words.hpp"
#include "move/settings.hpp"
#include "picture/contact_figures.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

/// A point of the object that was at `at`, scene's frame.
Vector3<double> carried_by(const SceneFile& file, const Pose<double>& pose,
                           const Vector3<double>& at) {
  const Vector3<double>& center = file.object.center_of_mass;
  return center + pose.at(at - center);
}

/// Where its body has it: points that ride on the object hang over their body's plane.
Vector3<double> on_body(const SceneFile& file, const MotionFrame& frame, Index b, Index i) {
  const PointState& point = frame.contacts[static_cast<std::size_t>(i)];
  const bool rides = file.strokes[static_cast<std::size_t>(b)].rides_on_object;
  return point.position - (rides ? point.gap.value_or(0) : 0) * point.normal;
}

View clearest_view(const SceneFile& file, const MotionReport& report) {
  const std::vector<View> views = axis_views(file.gravity);
  const auto seen = [&](const View& view) {
    double most = 0;
    for (const MotionFrame& frame : report.frames) {
      const Vector3<double> turn = frame.turn;
      most = std::max(most, view.flat(frame.pose.position).norm() +
                                object_size(file) / 2 * std::abs(turn.dot(view.toward)));
    }
    return most;
  };
  // The first, unless another shows clearly more.
  View best = views[0];
  for (const View& view : views)
    if (seen(view) > 1.05 * seen(best)) best = view;
  return best;
}

/// All that the motion shows fits in.
Sight motion_sight(const SceneFile& file, const MotionReport& report, const Prism& object) {
  constexpr double margin = 84, width = MotionPainter::width, height = MotionPainter::height;
  const View view = clearest_view(file, report);
  std::vector<Pixel> shown;
  for (const MotionFrame& frame : report.frames) {
    for (const auto& corner : corners_of(object))
      shown.push_back(view.flat(carried_by(file, frame.pose, corner)));
    for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b)
      for (const Index i : points_of(file.body(b)))
        if (frame.contacts[static_cast<std::size_t>(i)].touch != Touch::away)
          shown.push_back(view.flat(on_body(file, frame, b, i)));
  }
  const Frame extent = bounds(shown);
  return centered(view, extent, fitting_scale(extent, width - 2 * margin, height - 2 * margin),
                  {width, height});
}

/// Of one body's in the picture; 0 where all press across it, but for rounding. The first step,
/// which sets everything going at once, does not count.
double largest_force(const MotionReport& report, const View& view) {
  double most = 0, pressed = 0;
  for (std::size_t k = 1; k < report.frames.size(); ++k) {
    if (k == 1 && report.frames.size() >= 3) continue;
    pressed = std::max(pressed, hardest(report.frames[k].bodies));
    for (const BodyForce& body : report.frames[k].bodies)
      most = std::max(most, view.flat(body.force).norm());
  }
  return most > MoveSettings::exact * pressed ? most : 0;
}

} // namespace

std::vector<std::size_t> spread_out(std::size_t count, std::size_t most) {
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < std::min(count, most); ++k)
    list.push_back(count <= most ? k : k * (count - 1) / (most - 1));
  return list;
}

MotionPainter::MotionPainter(const SceneFile& file, const MotionReport& report)
    : file_(file), report_(report), object_(object_prism(file)),
      sight_(motion_sight(file, report, object_)) {
  const double most = largest_force(report, view_);
  newtons_ = most > 0 ? longest_force / round_above(most) : 0;
}

std::vector<Pixel> MotionPainter::outline(const MotionFrame& frame) const {
  std::vector<Pixel> corners;
  for (const auto& corner : corners_of(object_))
    corners.push_back(place(carried_by(file_, frame.pose, corner)));
  return hull(corners);
}

/// Its pad, its points by what they do, and its force on the object in the plane; its name joins
/// `names`.
std::string MotionPainter::body(const MotionFrame& frame, Index b,
                                std::vector<PlacedName>& names) const {
  const Body<double>& body = file_.body(b);
  std::vector<Pixel> around;
  std::string marks;
  Vector3<double> middle = Vector3<double>::Zero(), normal = Vector3<double>::Zero();
  Index touching = 0;
  for (const Index i : points_of(body)) {
    const PointState& point = frame.contacts[static_cast<std::size_t>(i)];
    if (point.touch == Touch::away) continue;
    const Pixel at = place(point.position), pad = place(on_body(file_, frame, b, i));
    for (const Pixel& offset : pad_rim(view_, point.normal)) around.emplace_back(pad + offset);
    normal = point.normal;
    marks += mode_mark(point.touch == Touch::sticks  ? Mode::stick
                       : point.touch == Touch::slips ? Mode::slide
                                                     : Mode::separate,
                       at);
    if (!is_touching(point.touch)) continue;
    middle += point.position;
    ++touching;
  }
  if (around.empty()) return "";
  std::string text =
      polygon_element(std::string("pad ") + (body.role == Role::pusher ? "pusher" : "finger") +
                          (view_.is_behind(normal) ? " behind" : ""),
                      hull(around));
  const Frame pad = bounds(around);
  const Pixel back = -view_.flat(normal);
  names.push_back({{(pad.left + pad.right) / 2 + 14 * back.x(),
                    back.y() > 0.5 ? pad.bottom + 16 : pad.top - 6 + 6 * std::abs(back.x())},
                   shortened(file_.body_name(b), 18),
                   back.x() > 0.5    ? "start"
                   : back.x() < -0.5 ? "end"
                                     : "middle",
                   back.y() > 0.5 ? 1.0 : -1.0});
  if (touching > 0) {
    const BodyForce& sum = frame.bodies[static_cast<std::size_t>(b)];
    const Pixel at = place(middle / static_cast<double>(touching));
    const Pixel press = newtons_ * sum.normal_force * view_.flat(normal);
    const Pixel drag = newtons_ * view_.flat(sum.force - sum.normal_force * normal);
    text += arrow_element("force normal", at - press, at) +
            arrow_element("force friction", at, at + drag);
  }
  return text + marks;
}

std::string MotionPainter::moment(const MotionFrame& frame) const {
  std::string behind, before;
  std::vector<PlacedName> names;
  for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b)
    (view_.is_behind(file_.body(b).normal) ? behind : before) += body(frame, b, names);
  const bool guessed = file_.shape.kind == ObjectShape::Kind::unknown;
  const Vector3<double>& center = file_.object.center_of_mass;
  // A mark that turns with it, where a cylinder's outline would not show it.
  const double reach = 0.3 * file_.shape.size.minCoeff();
  const Vector3<double> right = frame.pose.turned(view_.right);
  const Vector3<double> at = center + frame.pose.position;
  return behind + polygon_element(guessed ? "object guessed" : "object", outline(frame)) +
         line_element("tick", place(at), place(at + reach * right)) +
         circle_element("center", place(at), 3.4) + before + apart(names);
}

/// Fingers that face each other along the view have one place: names stand in lines then.
std::string MotionPainter::apart(std::vector<PlacedName> names) {
  // As large as they are on a phone, where player_style has larger letters.
  constexpr double letter = 12, line = 23;
  const auto extent = [](const PlacedName& name) {
    const double wide = letter * static_cast<double>(name.text.size());
    const std::string anchor = name.anchor;
    const double left = name.at.x() - (anchor == "start" ? 0 : anchor == "end" ? wide : wide / 2);
    return std::pair(left, left + wide);
  };
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto [left, right] = extent(names[k]);
    for (std::size_t other = 0; other < k;) {
      const auto [from, to] = extent(names[other]);
      const bool is_free =
          right < from || to < left || std::abs(names[k].at.y() - names[other].at.y()) > line - 1;
      if (!is_free) names[k].at.y() += line * names[k].outward;
      other = is_free ? other + 1 : 0;
    }
    text += text_element("label quiet", names[k].at, names[k].text, names[k].anchor);
  }
  return text;
}

std::string MotionPainter::ghosts(const std::vector<std::size_t>& frames) const {
  std::string text;
  for (const std::size_t k : frames) text += polygon_element("ghost", outline(report_.frames[k]));
  return text;
}

std::string MotionPainter::path() const {
  std::vector<Pixel> places;
  for (const MotionFrame& frame : report_.frames)
    places.push_back(place(file_.object.center_of_mass + frame.pose.position));
  return polyline_element("turning", places);
}

std::string MotionPainter::surroundings() const {
  return axes_elements(view_) + scale_bars(width, height, sight_.meters, newtons_);
}

namespace {

constexpr std::size_t animated_moments = 41;        // ten a second, as the eye needs
constexpr double between_moments = 0.1, rest = 1.5; // s; the end stays so long

/// Each moment is seen in its share of the time, the last one to the end. Where nothing moves, for
/// whatever reason, the last is seen.
std::string animation_style(double time) {
  const auto seen = [&](const char* name, double seconds) {
    return std::string("@keyframes ") + name + " { 0% { visibility: visible; } " +
           printed("%.3f", 100 * seconds / time) + "%, 100% { visibility: hidden; } }\n";
  };
  return "<style>\n.moment { visibility: hidden; animation: moment " + printed("%.1f", time) +
         "s infinite step-end; }\n.moment.last { visibility: visible; animation-name: last; }\n" +
         seen("moment", between_moments) + seen("last", rest) +
         "@media print, (prefers-reduced-motion: reduce) { .moment { animation: none; } }\n"
         "</style>\n";
}

} // namespace

std::string move_animation(const SceneFile& file, const MotionReport& report) {
  const MotionPainter painter(file, report);
  const std::vector<std::size_t> shown = spread_out(report.frames.size(), animated_moments);
  const double time = between_moments * static_cast<double>(shown.size() - 1) + rest;
  std::string moments = animation_style(time);
  for (std::size_t k = 0; k < shown.size(); ++k) // delays < 0: all have begun
    moments += std::string("<g class=\"moment") + (k + 1 == shown.size() ? " last" : "") +
               "\" style=\"animation-delay: " +
               printed("%.1f", between_moments * static_cast<double>(k) - time) + "s\">\n" +
               painter.moment(report.frames[shown[k]]) + "</g>\n";
  return svg_document({"move", file.title.empty() ? "Where the object goes" : file.title,
                       move_sentence(file, report) + " Seen in " + painter.axes() + ", moving.",
                       MotionPainter::width, MotionPainter::height,
                       painter.surroundings() + painter.path() + moments});
}

std::string move_svg(const SceneFile& file, const MotionReport& report) {
  constexpr std::size_t most_ghosts = 6;
  const MotionPainter painter(file, report);
  std::vector<std::size_t> ghosts = spread_out(report.frames.size(), most_ghosts + 1);
  ghosts.pop_back(); // the object itself stands there
  return svg_document(
      {"move", file.title.empty() ? "Where the object goes" : file.title,
       move_sentence(file, report) + " Seen in " + painter.axes() +
           "; dashed, the object on its way; the line is that of its centre of mass.",
       MotionPainter::width, MotionPainter::height,
       painter.surroundings() + painter.ghosts(ghosts) + painter.moment(report.frames.back()) +
           painter.path()});
}

} // namespace lcpush::desktop
