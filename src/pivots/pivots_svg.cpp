// A run as a picture that stands still: two pairs among their complementary cones, others by z0.
#include "draw/markup.hpp"
#include "draw/plot_svg.hpp"
#include "lcpush/desktop/pivots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace lcpush::desktop {
namespace {

using Plane = Eigen::Vector2d;

constexpr double side = 480, edge = 46; // of the picture, and about what is drawn
const char* const style = ".drawing .sector { fill: var(--soft); fill-opacity: 0.08; }\n"
                          ".drawing .zw { fill: var(--move); fill-opacity: 0.17; }\n"
                          ".drawing .wz { fill: var(--cone); fill-opacity: 0.2; }\n"
                          ".drawing .zz { fill: var(--normal); fill-opacity: 0.17; }\n"
                          ".drawing .border { stroke: var(--ink); stroke-width: 1.6; }\n"
                          ".drawing .run { color: var(--friction); }\n"
                          ".drawing .run .shaft, .drawing .way { stroke: var(--friction); "
                          "stroke-width: 2.6; fill: none; }\n"
                          ".drawing .run .shaft { stroke-dasharray: 5 4; }\n"
                          ".drawing .dot { fill: var(--friction); stroke: var(--raised); }\n";

/// The plane of q: the columns of w1, w2, z1, z2, and q + z0 d after each pivot.
struct ConePlane {
  std::vector<Plane> columns{{1, 0}, {0, 1}}, points;
  Plane q, d;
  double lifted = 0; ///< z0 where the run is drawn to come from

  Plane at(double z0) const { return q + z0 * d; }
};

bool has_two_pairs(const PivotTrace& trace) {
  return trace.size == 2 && trace.free_count == 0 && trace.runs.size() == 1 &&
         !trace.is_as_solved && !trace.pivots.empty();
}

ConePlane cone_plane(const PivotTrace& trace) {
  const Tableau& start = trace.runs.front().start;
  const auto column = [&](std::size_t j) {
    return Plane(start.entry(0, j).value, start.entry(1, j).value);
  };
  ConePlane plane;
  plane.columns.emplace_back(-column(0));
  plane.columns.emplace_back(-column(1));
  plane.d = column(2);
  plane.q = {start.values[0].finite.value, start.values[1].finite.value};
  for (const TracedPivot& pivot : trace.pivots) {
    plane.lifted = std::max(plane.lifted, 1.45 * pivot.z0.finite.value);
    plane.points.push_back(plane.at(pivot.z0.finite.value));
  }
  return plane;
}

/// From the plane of q to pixels: all points of the run in sight, and the origin.
struct ConeView {
  Plane middle;
  double unit;

  explicit ConeView(const ConePlane& plane) {
    Plane low = Plane::Zero(), high = Plane::Zero();
    for (const Plane& p : {plane.q, plane.at(plane.lifted)}) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    middle = (low + high) / 2;
    unit = (side - 2 * edge) / (high - low).maxCoeff();
  }
  Pixel operator()(const Plane& p) const {
    return {side / 2 + unit * (p.x() - middle.x()), side / 2 - unit * (p.y() - middle.y())};
  }
  /// Where a ray from the origin leaves the picture, less a `margin`.
  Pixel end_of(const Plane& ray, double margin) const {
    const Pixel from = (*this)(Plane::Zero()), along(ray.x(), -ray.y());
    double reach = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k)
      if (along[k] != 0)
        reach = std::min(reach, ((along[k] > 0 ? side - margin : margin) - from[k]) / along[k]);
    return from + reach * along;
  }
};

/// The cone of two columns, its name where its middle leaves the picture.
std::string sector(const ConePlane& plane, const ConeView& view, std::size_t a, std::size_t b,
                   const PivotTrace& trace) {
  const Plane one = plane.columns[a].normalized(), other = plane.columns[b].normalized();
  const Plane between = one + other;
  if (!(between.norm() > 1e-9) || !(one.norm() * other.norm() > 0)) return {}; // it has no inside
  const double far = 4 * side / view.unit;
  const char* const kind = a > 1   ? b > 1 ? "sector zz" : "sector zw"
                           : b > 1 ? "sector wz"
                                   : "sector";
  const Pixel end = view.end_of(between, 0), origin = view(Plane::Zero());
  const Pixel name = (origin + 0.7 * (end - origin)).cwiseMax(edge).cwiseMin(side - edge);
  return polygon_element(
             kind, {origin, view(far * one), view(far * between.normalized()), view(far * other)}) +
         text_element("label strong", name,
                      trace.name(static_cast<Index>(a)) + " and " +
                          trace.name(static_cast<Index>(b)),
                      "middle");
}

std::string number_of(const TraceNumber& x) { return value_text({{}, x}); }

/// Dots at the pivots; what several of them share is told once.
std::string run_elements(const PivotTrace& trace, const ConePlane& plane, const ConeView& view) {
  std::string text = arrow_element("run", view(plane.at(plane.lifted)), view(plane.points.front()));
  for (std::size_t k = 1; k < plane.points.size(); ++k)
    text += line_element("way", view(plane.points[k - 1]), view(plane.points[k]));
  std::map<double, std::string> told;
  for (std::size_t k = 0; k < trace.pivots.size(); ++k) {
    std::string& words = told[trace.pivots[k].z0.finite.value];
    words += (words.empty() ? "pivot " : ", ") + std::to_string(k);
  }
  if (told.count(0) == 0) told[0] = "";
  for (const auto& [z0, pivots] : told) {
    const Pixel at = view(plane.at(z0));
    const bool is_right = at.x() > side - 150;
    std::string words = pivots;
    for (const TracedPivot& pivot : trace.pivots)
      if (pivot.z0.finite.value == z0 && words == pivots)
        words += ": z0 = " + number_of(pivot.z0.finite);
    if (z0 == 0) words = "q" + std::string(words.empty() ? "" : ", ") + words;
    text += circle_element("dot", at, 5) +
            text_element("label", at + Pixel(is_right ? -11 : 11, is_right ? -8 : 18), words,
                         is_right ? "end" : "start");
  }
  return text;
}

std::string cones_svg(const PivotTrace& trace) {
  const ConePlane plane = cone_plane(trace);
  const ConeView view(plane);
  Drawing drawing;
  drawing.width = drawing.height = side;
  drawing.title = "The complementary cones of two pairs, and the run through them";
  drawing.description = "The plane of q. Each cone belongs to one choice of w or z in both pairs. "
                        "The point q + z0 d comes along d;";
  for (std::size_t k = 0; k < trace.pivots.size(); ++k)
    drawing.description += " pivot " + std::to_string(k) +
                           ": z0 = " + number_of(trace.pivots[k].z0.finite) + ", " +
                           trace.name(trace.pivots[k].leaving) + " leaves;";
  std::string names;
  for (const auto& [a, b] :
       std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {2, 1}, {0, 3}, {2, 3}}) {
    const std::string both = sector(plane, view, a, b, trace);
    const std::size_t cut = both.find("<text");
    drawing.elements += both.substr(0, cut);
    if (cut != std::string::npos) names += both.substr(cut);
  }
  for (std::size_t k = 0; k < plane.columns.size(); ++k) {
    if (!(plane.columns[k].norm() > 0)) continue;
    drawing.elements +=
        line_element("border", view(Plane::Zero()), view.end_of(plane.columns[k], 30));
    names += text_element("label", view.end_of(plane.columns[k], 16) + Pixel(0, 5),
                          trace.name(static_cast<Index>(k)), "middle");
  }
  drawing.elements += names + run_elements(trace, plane, view);
  return svg_element(drawing,
                     "<style>\n" + palette(".drawing") + drawing_style() + style + "</style>\n");
}

/// z0 after each pivot.
std::string path_svg(const PivotTrace& trace) {
  PlotLine line;
  line.dots = true;
  line.label = trace.status == Status::solved ? "solved" : "not solved: " + trace.reason;
  line.pieces.emplace_back();
  Plot plot;
  plot.title = "The artificial variable z0";
  plot.description = "z0 after each pivot. When it reaches 0, the problem is solved.";
  plot.x_label = "after pivot";
  plot.x_to = std::max(1.0, static_cast<double>(trace.pivots.size()) - 1);
  for (std::size_t k = 0; k < trace.pivots.size(); ++k) {
    const TracedPivot& pivot = trace.pivots[k];
    const auto x = static_cast<double>(k);
    if (pivot.z0.has_S() || !std::isfinite(pivot.z0.finite.value))
      line.pieces.emplace_back(); // no place on the axis
    else
      line.pieces.back().emplace_back(x, pivot.z0.finite.value);
  }
  plot.panels.push_back({"z0", {line}});
  return plot_svg(plot);
}

} // namespace

std::string pivots_svg(const PivotTrace& trace) {
  if (!has_two_pairs(trace)) return path_svg(trace);
  const Tableau& start = trace.runs.front().start;
  const bool is_finite =
      std::all_of(start.values.begin(), start.values.end(),
                  [](const TraceValue& v) { return std::isfinite(v.finite.value); }) &&
      std::all_of(start.entries.begin(), start.entries.end(),
                  [](const TraceNumber& x) { return std::isfinite(x.value); });
  return is_finite ? cones_svg(trace) : path_svg(trace);
}

} // namespace lcpush::desktop
