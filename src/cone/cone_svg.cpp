// The motion cone drawn: in space, and as velocities of the pusher where it presses.
#include "cone/cone_words.hpp"
#include "cone/limit_surface.hpp"
#include "draw/view.hpp"
#include "scenes/drawn_object.hpp"
#include "text/format.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double panel = 380, height = 400, cone_radius = 130, fan_radius = 62;

/// (v_x, v_y, omega L) as seen from above and aside, y down.
Pixel seen(const Vector3<double>& twist) {
  return {0.87 * twist[0] - 0.5 * twist[1], -0.87 * twist[2] + 0.25 * twist[0] + 0.43 * twist[1]};
}

class ConePainter {
public:
  ConePainter(const SceneFile& file, const ConeReport& report) : file_(file), report_(report) {}

  std::string in_space() const {
    const Pixel middle = center();
    const auto place = [&](const Vector3<double>& v) -> Pixel {
      return middle + cone_radius * seen(v.normalized());
    };
    std::string axes, cone, edges;
    const std::string names[] = {"vx", "vy", "turn"};
    for (Index axis = 0; axis < 3; ++axis) {
      const Vector3<double> tip = Vector3<double>::Unit(axis);
      axes +=
          arrow_element("axis", middle - 0.5 * (place(tip) - middle),
                        middle + 1.15 * (place(tip) - middle)) +
          text_element("quiet label", middle + 1.28 * (place(tip) - middle), names[axis], "middle");
    }
    for (const ConeReport::Side& side : report_.sides) {
      std::vector<Pixel> fan{middle};
      for (const Vector6<double>& twist : side.twists) fan.push_back(place(planar(twist)));
      cone += polygon_element("cone", fan);
    }
    for (std::size_t k = 0; k < report_.edges.size(); ++k) {
      const Pixel tip = place(planar(report_.edges[k].twist));
      edges += line_element("leader", middle, tip) +
               text_element("strong label", tip + 12 * (tip - middle).normalized(),
                            std::to_string(k + 1), "middle");
    }
    if (report_.verdict)
      edges += arrow_element("motion", middle, place(planar(report_.verdict->twist)));
    return text_element("strong", {14, 54}, "The cone: directions of twists") + axes + cone + edges;
  }

  /// The object from above, and at each pressing point between which velocities it sticks.
  std::string where_it_presses() const {
    std::string elements = text_element("strong", {14, 54}, "Velocities where it presses");
    const std::vector<Pixel> outline = flat_outline();
    std::vector<Pixel> all = outline;
    for (const Vector3<double>& p : file_.positions) all.push_back({p.x(), -p.y()});
    const Frame extent = bounds(all);
    const double scale = fitting_scale(extent, panel - 170, height - 210);
    const Pixel middle((extent.left + extent.right) / 2, (extent.top + extent.bottom) / 2);
    const auto place = [&](const Pixel& p) -> Pixel { return center() + scale * (p - middle); };
    std::vector<Pixel> corners;
    for (const Pixel& p : outline) corners.push_back(place(p));
    elements += polygon_element("object", corners);
    for (std::size_t i = 0; i < file_.positions.size(); ++i) {
      const Body<double>& body = file_.body(file_.body_of(static_cast<Index>(i)));
      const Pixel at = place({file_.positions[i].x(), -file_.positions[i].y()});
      if (body.role == Role::finger) elements += circle_element("mark", at, 2.5);
    }
    for (const Index point : pressing_points()) {
      const Vector3<double>& p = file_.positions[static_cast<std::size_t>(point)];
      elements += fan(point, place({p.x(), -p.y()}));
    }
    return elements;
  }

private:
  const SceneFile& file_;
  const ConeReport& report_;

  /// Of a panel, below its title.
  static Pixel center() { return {panel / 2, height / 2 + 16}; }

  Vector3<double> planar(const Vector6<double>& twist) const {
    return planar_twist(twist, report_.length);
  }
  Pixel velocity(Index point, const Vector6<double>& twist) const {
    const Vector3<double> v = acceleration_at(file_.points[static_cast<std::size_t>(point)], twist);
    return {v.x(), -v.y()};
  }

  std::vector<Pixel> flat_outline() const {
    std::vector<Pixel> corners;
    for (const Vector3<double>& corner : corners_of(object_prism(file_)))
      corners.push_back({corner.x(), -corner.y()});
    return hull(corners);
  }

  std::vector<Index> pressing_points() const {
    std::vector<Index> points;
    for (const ConeReport::Edge& edge : report_.edges)
      if (std::find(points.begin(), points.end(), edge.point) == points.end())
        points.push_back(edge.point);
    return points;
  }

  /// All velocities of one point along the boundary, as a fan around its normal.
  std::string fan(Index point, const Pixel& at) const {
    const Vector3<double>& n = file_.body(report_.pusher).normal;
    const Pixel normal(n.x(), -n.y());
    double low = 4, high = -4;
    for (const ConeReport::Side& side : report_.sides)
      for (const Vector6<double>& twist : side.twists) {
        const Pixel v = velocity(point, twist);
        const double angle = std::atan2(normal.x() * v.y() - normal.y() * v.x(), normal.dot(v));
        low = std::min(low, angle);
        high = std::max(high, angle);
      }
    const auto rim = [&](double angle) -> Pixel {
      const double c = std::cos(angle), s = std::sin(angle);
      return at +
             fan_radius * Pixel(c * normal.x() - s * normal.y(), s * normal.x() + c * normal.y());
    };
    std::vector<Pixel> corners{at};
    constexpr int strokes = 24;
    for (int k = 0; k <= strokes; ++k) corners.push_back(rim(low + (high - low) * k / strokes));
    std::string elements = polygon_element("cone", corners) + circle_element("mark", at, 4);
    if (report_.verdict) {
      const Pixel v = velocity(point, report_.verdict->twist);
      if (v.norm() > 0)
        elements += arrow_element("motion", at, at + 1.15 * fan_radius * v.normalized());
    }
    return elements;
  }
};

} // namespace

std::string cone_svg(const SceneFile& file, const ConeReport& report) {
  const char* const legend = "Shaded: sticks. Arrow: the push that is judged.";
  Drawing drawing{"cone",
                  file.title.empty() ? "Motion cone" : file.title,
                  cone_sentence(file, report) +
                      " Left: the twists that stick, as directions of (vx, vy, turn times " +
                      millimetres(report.length) +
                      "), edges numbered. Right: between which velocities each end of " +
                      file.body_name(report.pusher) + " sticks.",
                  2 * panel,
                  height,
                  ""};
  const ConePainter painter(file, report);
  drawing.elements = text_element("strong", {14, 24}, shortened(drawing.title, 90));
  if (report.status == Status::solved)
    drawing.elements += painter.in_space() + shifted(painter.where_it_presses(), {panel, 0}) +
                        text_element("quiet", {14, height - 12}, legend);
  return svg_document(drawing);
}

} // namespace lcpush::desktop
