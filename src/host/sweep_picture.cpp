// Sweeps as SVG.
#include <limits>

#include "lcpush/host/sweep.hpp"
#include "plot_svg.hpp"
#include "report_format.hpp"

namespace lcpush::host {
namespace {

using Curve = std::vector<std::vector<std::pair<double, double>>>;

std::string axis_label(const Parameter& parameter) {
  return parameter.path + (parameter.unit.empty() ? "" : " in " + parameter.unit);
}

/// Adds a point; after a gap a new piece begins.
void extend(Curve& curve, bool gap, double x, double y) {
  if (gap || curve.empty()) curve.emplace_back();
  curve.back().emplace_back(x, y);
}

void add_segments(const std::vector<SweepSegment>& segments, Curve& breaking, Curve& push) {
  bool break_gap = true, push_gap = true;
  for (const SweepSegment& segment : segments) {
    const SweepValue &a = segment.at_from, &b = segment.at_to;
    if (a.breaking == Status::solved) {
      extend(breaking, break_gap, segment.from, a.break_force);
      extend(breaking, false, segment.to, b.break_force);
    }
    break_gap = a.breaking != Status::solved || segment.jumps;
    if (a.push == Status::solved) {
      extend(push, push_gap, segment.from, a.force.norm());
      // The length of a force that changes in a straight line is no straight line.
      constexpr int parts = 16;
      for (int k = 1; k <= parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        extend(push, false, segment.from + share * (segment.to - segment.from),
               (a.force + share * (b.force - a.force)).norm());
      }
    }
    push_gap = a.push != Status::solved || segment.jumps;
  }
}

void add_points(const std::vector<SweepPoint>& points, Curve& breaking, Curve& push) {
  bool break_gap = true, push_gap = true;
  for (const SweepPoint& point : points) {
    const bool jumps = point.change.find("jumps") != std::string::npos;
    if (point.at.breaking == Status::solved)
      extend(breaking, break_gap, point.value, point.at.break_force);
    if (point.at.push == Status::solved) extend(push, push_gap, point.value, point.at.force.norm());
    break_gap = point.at.breaking != Status::solved || jumps;
    push_gap = point.at.push != Status::solved || jumps;
  }
}

std::string described(const Sweep& sweep, const std::vector<PlotMark>& marks) {
  const Variation& variation = sweep.variations[0];
  std::string text = "The force by " + sweep.pusher + " over " + variation.parameter.path +
                     " from " + number(variation.from) + " to " + number(variation.to) + ".";
  for (const PlotMark& mark : marks) text += " At " + number(mark.x) + ": " + mark.text + ".";
  for (const BistableRange& range : sweep.bistable)
    text += " Bistable from " + number(range.from) + " to " + number(range.to) + ".";
  return text;
}

std::string line_plot(const Sweep& sweep, const std::string& title) {
  const Variation& variation = sweep.variations[0];
  Plot plot;
  plot.title = title;
  plot.x_label = axis_label(variation.parameter);
  plot.y_label = "force by " + sweep.pusher + " in N";
  plot.x_from = variation.from;
  plot.x_to = variation.to;
  PlotLine breaking{"breaking force (normal)", {}}, push{"push as prescribed (size)", {}};
  PlotLine back{"the way back", {}};
  if (!sweep.segments.empty()) {
    add_segments(sweep.segments, breaking.pieces, push.pieces);
    Curve ignored;
    add_segments(sweep.back, ignored, back.pieces);
    for (const SweepSegment& segment : sweep.segments)
      if (!segment.change.empty())
        plot.marks.push_back({segment.to, segment.change, segment.jumps});
  } else {
    add_points(sweep.points, breaking.pieces, push.pieces);
    Curve ignored;
    add_points(sweep.points_back, ignored, back.pieces);
    for (const SweepPoint& point : sweep.points)
      if (!point.change.empty())
        plot.marks.push_back(
            {point.value, point.change, point.change.find("jumps") != std::string::npos});
    push.dots = breaking.dots = sweep.points.size() <= 200;
  }
  plot.lines = {breaking, push};
  if (!back.pieces.empty()) plot.lines.push_back(back);
  plot.description = described(sweep, plot.marks);
  return plot_svg(plot);
}

std::string map_plot(const Sweep& sweep, const std::string& title) {
  const Variation &x = sweep.variations[0], &y = sweep.variations[1];
  MapPlot plot;
  plot.title = title;
  plot.x_label = axis_label(x.parameter);
  plot.y_label = axis_label(y.parameter);
  plot.value_label = "breaking force by " + sweep.pusher + " in N";
  plot.x_from = x.from;
  plot.x_to = x.to;
  plot.y_from = y.from;
  plot.y_to = y.to;
  for (const SweepPoint& point : sweep.points) {
    if (point.second == sweep.points.front().second) ++plot.columns;
    const bool known = point.at.breaking == Status::solved;
    plot.cells.push_back(known ? point.at.break_force : std::numeric_limits<double>::quiet_NaN());
    plot.texts.push_back(number(point.value) + ", " + number(*point.second) + ": " +
                         (known ? number(point.at.break_force) + " N"
                                : std::string(status_text(point.at.breaking))));
  }
  plot.description = "The breaking force by " + sweep.pusher + " over " + x.parameter.path +
                     " and " + y.parameter.path + ", a cell a value.";
  return map_svg(plot);
}

} // namespace

std::string sweep_svg(const Sweep& sweep, const std::string& title) {
  return sweep.is_map() ? map_plot(sweep, title) : line_plot(sweep, title);
}

} // namespace lcpush::host
