// A run as a picture that stands still: two pairs among their complementary cones, others by z0.
#include "draw/cone_plane.hpp"
#include "draw/markup.hpp"
#include "draw/plot_svg.hpp"
#include "lcpush/desktop/pivots.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace lcpush::desktop {
namespace {

constexpr double side = ConeView::side;
const char* const style = ".drawing .run { color: var(--friction); }\n"
                          ".drawing .run .shaft { stroke: var(--friction); stroke-width: 2.6; "
                          "stroke-dasharray: 5 4; }\n";

/// The cones, and q + z0 d after each pivot.
struct ConePlane {
  ConeColumns cones{{{1, 0}, {0, 1}}, {}};
  std::vector<Plane> points;
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
  plane.cones.columns.emplace_back(-column(0));
  plane.cones.columns.emplace_back(-column(1));
  for (Index k = 0; k < 4; ++k) plane.cones.names.push_back(trace.name(k));
  plane.d = column(2);
  plane.q = {start.values[0].finite.value, start.values[1].finite.value};
  for (const TracedPivot& pivot : trace.pivots) {
    plane.lifted = std::max(plane.lifted, 1.45 * pivot.z0.finite.value);
    plane.points.push_back(plane.at(pivot.z0.finite.value));
  }
  return plane;
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
  const ConeView view({plane.q, plane.at(plane.lifted)});
  Drawing drawing;
  drawing.width = drawing.height = side;
  drawing.title = "The complementary cones of two pairs, and the run through them";
  drawing.description = "The plane of q. Each cone belongs to one choice of w or z in both pairs. "
                        "The point q + z0 d comes along d;";
  for (std::size_t k = 0; k < trace.pivots.size(); ++k)
    drawing.description += " pivot " + std::to_string(k) +
                           ": z0 = " + number_of(trace.pivots[k].z0.finite) + ", " +
                           trace.name(trace.pivots[k].leaving) + " leaves;";
  drawing.elements = cone_elements(plane.cones, view) + run_elements(trace, plane, view);
  return svg_element(drawing, "<style>\n" + palette(".drawing") + drawing_style() + cone_style() +
                                  style + "</style>\n");
}

/// z0 after each pivot.
std::string path_svg(const PivotTrace& trace) {
  PlotLine line;
  line.dots = true;
  line.label = trace.status == Status::solved ? "solved"
               : trace.ray                    ? "not solved: a ray"
                                              : "not solved: " + trace.reason;
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
  if (trace.ray && !line.pieces.back().empty()) { // one more step of whatever grows without end
    const auto [x, z0] = line.pieces.back().back();
    PlotLine ray;
    ray.label = "along the ray";
    ray.colour = 1;
    ray.pieces = {{{x, z0}, {x + 1, z0 + trace.ray->v0.value}}};
    plot.x_to = std::max(plot.x_to, x + 1);
    plot.panels.back().lines.push_back(ray);
  }
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
