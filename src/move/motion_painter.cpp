#include "move/motion_painter.hpp"

#include "draw/marks.hpp"
#include "move/move_words.hpp"
#include "scenes/drawn_object.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr double margin = 84, bar_room = 70;

/// A point of the object that was at `at`, scene's frame.
Vector3<double> carried_by(const SceneFile& file, const Pose<double>& pose,
                           const Vector3<double>& at) {
  const Vector3<double>& center = file.object.center_of_mass;
  return center + pose.at(at - center);
}

std::vector<View> axis_views(const SceneFile& file) {
  const Vector3<double> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), g = file.gravity.cwiseAbs();
  if (g.z() > std::max(g.x(), g.y()))
    return {
        {"front", "x and z", x, z, -y}, {"top", "x and y", x, y, z}, {"side", "y and z", y, z, x}};
  return {
      {"front", "x and y", x, y, z}, {"top", "x and z", x, -z, y}, {"side", "z and y", -z, y, x}};
}

View clearest_view(const SceneFile& file, const MotionReport& report) {
  const std::vector<View> views = axis_views(file);
  const auto seen = [&](const View& view) {
    double most = 0;
    for (const MotionFrame& frame : report.frames) {
      const Vector3<double> turn = rotation_vector(frame.pose.rotation);
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

bool touches(const PointState& point) {
  return point.touch == Touch::sticks || point.touch == Touch::slips;
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
      view_(clearest_view(file, report)) {
  std::vector<Pixel> shown;
  for (const MotionFrame& frame : report.frames) {
    for (const auto& corner : corners_of(object_))
      shown.push_back(view_.flat(carried_by(file, frame.pose, corner)));
    for (const PointState& point : frame.contacts)
      if (point.touch != Touch::away) shown.push_back(view_.flat(point.position));
  }
  extent_ = bounds(shown);
  meters_ = std::min((width - 2 * margin) / std::max(extent_.width(), 1e-9),
                     (height - 2 * margin) / std::max(extent_.height(), 1e-9));
  const double most = largest_force();
  newtons_ = most > 0 ? longest_force / round_above(most) : 0;
}

/// Of one body's; the first step, which sets everything going at once, does not count.
double MotionPainter::largest_force() const {
  double most = 0;
  for (std::size_t k = 1; k < report_.frames.size(); ++k)
    for (const BodyForce& body : report_.frames[k].bodies)
      if (k > 1 || report_.frames.size() < 3) most = std::max(most, view_.flat(body.force).norm());
  return most;
}

Pixel MotionPainter::place(const Vector3<double>& at) const {
  const Pixel middle((extent_.left + extent_.right) / 2, (extent_.top + extent_.bottom) / 2);
  return Pixel(width / 2, height / 2) + meters_ * (view_.flat(at) - middle);
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
    const Pixel at = place(point.position);
    for (const Pixel& offset : pad_rim(view_, point.normal)) around.emplace_back(at + offset);
    normal = point.normal;
    const bool sticks = point.touch == Touch::sticks;
    marks += mark_element(sticks                        ? Mark::square
                          : point.touch == Touch::slips ? Mark::triangle
                                                        : Mark::ring,
                          sticks                        ? "stick"
                          : point.touch == Touch::slips ? "slide"
                                                        : "separate",
                          at);
    if (!touches(point)) continue;
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

std::string MotionPainter::way() const {
  std::string strokes;
  for (const MotionFrame& frame : report_.frames) {
    const Pixel at = place(file_.object.center_of_mass + frame.pose.position);
    strokes += strokes.empty() ? move_to(at) : "L" + move_to(at).substr(1);
  }
  return path_element("turning", strokes);
}

std::string MotionPainter::surroundings() const {
  const double length = round_below(bar_room / meters_), y = height - 14;
  const auto bar = [y](double left, double long_by) {
    return path_element("scale", move_to({left, y}) + "v6h" + pixels(long_by) + "v-6");
  };
  std::string text =
      axes_elements(view_) + bar(12, length * meters_) +
      text_element("quiet", {18 + length * meters_, y + 7}, number(1000 * length) + " mm");
  if (newtons_ == 0) return text;
  const double force = round_below(longest_force / newtons_), size = force * newtons_;
  return text + bar(width - 12 - size, size) +
         text_element("quiet", {width - 18 - size, y + 7}, number(force) + " N", "end");
}

} // namespace lcpush::desktop
