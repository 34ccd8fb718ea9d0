// Sweeps as SVG.
#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/plot_svg.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

using Kind = SweepQuantity::Kind;
using Curve = std::vector<std::vector<std::pair<double, double>>>;

std::string axis_label(const Parameter& parameter) {
  return parameter.path + (parameter.unit.empty() ? "" : " in " + parameter.unit);
}

Status status_of(const SweepQuantity& quantity, const SweepValue& at) {
  const bool breaks = quantity.kind == Kind::break_force || quantity.kind == Kind::break_twist;
  return (breaks ? at.breaking : at.push).status;
}

bool is_force(const SweepQuantity& quantity) {
  return quantity.kind != Kind::twist && quantity.kind != Kind::break_twist;
}

double value_of(const SweepQuantity& quantity, const SweepValue& at) {
  switch (quantity.kind) {
  case Kind::break_force: return at.breaking.normal;
  case Kind::force: return at.push.force.norm();
  case Kind::force_component: return at.push.force[quantity.component];
  case Kind::twist: {
    const double value = at.push.twist[quantity.component];
    return std::abs(value) <= at.push.twist_noise(quantity.component) ? 0 : value;
  }
  case Kind::break_twist: return at.breaking.twist[quantity.component];
  }
  return 0;
}

/// For the legend.
std::string words_of(const SweepQuantity& quantity) {
  return quantity.kind == Kind::break_force ? "breaking force (normal)"
         : quantity.kind == Kind::force     ? "push as prescribed (size)"
                                            : quantity.name();
}

/// Adds a point; after a gap a new piece begins.
void extend(Curve& curve, bool gap, double x, double y) {
  if (gap || curve.empty()) curve.emplace_back();
  curve.back().emplace_back(x, y);
}

Curve curve_of_segments(const SweepQuantity& quantity, const std::vector<SweepSegment>& segments) {
  Curve curve;
  bool gap = true;
  // The length of a force that changes in a straight line is no straight line.
  const int parts = quantity.kind == Kind::force ? 16 : 1;
  for (const SweepSegment& segment : segments) {
    const SweepValue &a = segment.at_from, &b = segment.at_to;
    const bool known = status_of(quantity, a) == Status::solved;
    if (known) {
      extend(curve, gap, segment.from, value_of(quantity, a));
      for (int k = 1; k <= parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        SweepValue between = b;
        between.push.force = a.push.force + share * (b.push.force - a.push.force);
        extend(curve, false, segment.from + share * (segment.to - segment.from),
               value_of(quantity, between));
      }
    }
    gap = !known || segment.change.jumps;
  }
  return curve;
}

Curve curve_of_points(const SweepQuantity& quantity, const std::vector<SweepPoint>& points) {
  Curve curve;
  bool gap = true;
  for (const SweepPoint& point : points) {
    const bool known = status_of(quantity, point.at) == Status::solved;
    if (known) extend(curve, gap, point.value, value_of(quantity, point.at));
    gap = !known || point.change.jumps;
  }
  return curve;
}

/// Of segments nobody knows the first motion at breaking between the ends.
bool from_segments(const SweepQuantity& quantity, const Sweep& sweep) {
  if (sweep.segments.empty()) return false;
  if (quantity.kind != Kind::break_twist) return true;
  if (sweep.points.empty())
    throw InputError(quantity.name() + " is known at points alone: add --steps");
  return false;
}

std::string described(const std::vector<SweepCurve>& curves, const Plot& plot) {
  const Variation& variation = curves.front().sweep.variations[0];
  std::string text = "The force or motion by " + curves.front().sweep.pusher + " over " +
                     variation.parameter.path + " from " + number(variation.from) + " to " +
                     number(variation.to) + ".";
  for (const PlotMark& mark : plot.marks) text += " At " + number(mark.x) + ": " + mark.text + ".";
  for (const SweepCurve& curve : curves)
    for (const BistableRange& range : curve.sweep.bistable)
      text += (curve.label.empty() ? " Bistable from " : " " + curve.label + ": bistable from ") +
              number(range.from) + " to " + number(range.to) + ".";
  return text;
}

/// Changes of mode, and the zeros of what is shown.
std::vector<PlotMark> marks_of(const Sweep& sweep, const std::vector<SweepQuantity>& shown) {
  std::vector<PlotMark> marks;
  for (const SweepSegment& segment : sweep.segments)
    if (!segment.change.is_empty())
      marks.push_back({segment.to, change_text(sweep, segment), segment.change.jumps});
  for (const SweepPoint& point : sweep.points)
    if (sweep.segments.empty() && !point.change.is_empty())
      marks.push_back({point.value, change_text(sweep, point), point.change.jumps});
  for (const SweepZero& zero : sweep.zeros)
    for (const SweepQuantity& quantity : shown)
      if (quantity.kind == Kind::twist && quantity.component == zero.component &&
          zero.from == zero.to && !zero.jumps)
        marks.push_back({zero.from, quantity.name() + " is zero", false});
  return marks;
}

class LinePlot {
public:
  LinePlot(const std::vector<SweepCurve>& curves, const std::vector<SweepQuantity>& shown)
      : curves_(curves), shown_(shown) {}

  Plot plot(const std::string& title) {
    const Sweep& sweep = curves_.front().sweep;
    Plot plot;
    plot.title = title;
    plot.x_label = axis_label(sweep.variations[0].parameter);
    plot.x_from = sweep.variations[0].from;
    plot.x_to = sweep.variations[0].to;
    // A panel a unit, in the order in which they are asked for.
    std::vector<std::string> units;
    for (const SweepQuantity& quantity : shown_)
      if (std::find(units.begin(), units.end(), quantity.unit()) == units.end())
        units.push_back(quantity.unit());
    for (const std::string& unit : units) {
      PlotPanel panel;
      std::vector<SweepQuantity> mine;
      for (const SweepQuantity& quantity : shown_)
        if (quantity.unit() == unit) mine.push_back(quantity);
      // Of several the legend has the names.
      const bool lone = mine.size() == 1;
      const std::string what = lone ? mine[0].name() : is_force(mine[0]) ? "force" : "";
      panel.y_label = what + (what.empty() || unit.empty() ? "" : " in ") + unit;
      for (const SweepCurve& curve : curves_)
        for (const SweepQuantity& quantity : mine) add(panel, quantity, curve, lone);
      plot.panels.push_back(std::move(panel));
    }
    if (curves_.size() == 1) plot.marks = marks_of(sweep, shown_);
    plot.description = described(curves_, plot);
    return plot;
  }

private:
  const std::vector<SweepCurve>& curves_;
  std::vector<SweepQuantity> shown_;

  void add(PlotPanel& panel, const SweepQuantity& what, const SweepCurve& curve, bool lone) const {
    const Sweep& sweep = curve.sweep;
    const std::string& label = curve.label;
    const bool segments = from_segments(what, sweep);
    PlotLine line;
    line.label = label.empty() ? words_of(what) : lone ? label : label + ": " + words_of(what);
    line.pieces =
        segments ? curve_of_segments(what, sweep.segments) : curve_of_points(what, sweep.points);
    line.dots = !segments && sweep.points.size() <= 200 && curves_.size() == 1;
    line.colour = panel.lines.size();
    panel.lines.push_back(line);
    const bool has_back = segments ? !sweep.back.empty() : !sweep.points_back.empty();
    if (!has_back || (what.kind == Kind::break_force && !lone)) return;
    // Among several curves only where the object moves in another way.
    const bool moves = std::any_of(sweep.bistable.begin(), sweep.bistable.end(),
                                   [](const BistableRange& range) { return range.motion; });
    if (curves_.size() > 1 && !moves) return;
    line.pieces =
        segments ? curve_of_segments(what, sweep.back) : curve_of_points(what, sweep.points_back);
    line.label = label.empty() ? "the way back" : label + ", back";
    line.colour = panel.lines.size();
    panel.lines.push_back(line);
  }
};

MapPlot map_plot(const Sweep& sweep, const SweepQuantity& quantity, const std::string& title) {
  const Variation &x = sweep.variations[0], &y = sweep.variations[1];
  MapPlot plot;
  plot.title = title;
  plot.x_label = axis_label(x.parameter);
  plot.y_label = axis_label(y.parameter);
  plot.value_label =
      (quantity.kind == Kind::break_force ? "breaking force by " + sweep.pusher : quantity.name()) +
      (quantity.unit().empty() ? "" : " in " + quantity.unit());
  plot.x_from = x.from;
  plot.x_to = x.to;
  plot.y_from = y.from;
  plot.y_to = y.to;
  bool any = false;
  for (const SweepPoint& point : sweep.points) {
    if (point.second == sweep.points.front().second) ++plot.columns;
    const Status status = status_of(quantity, point.at);
    const bool known = status == Status::solved;
    const double value = value_of(quantity, point.at);
    plot.cells.push_back(known ? value : std::numeric_limits<double>::quiet_NaN());
    plot.texts.push_back(
        number(point.value) + ", " + number(*point.second) + ": " +
        (known ? number(value) + " " + quantity.unit() : std::string(status_text(status))));
    plot.hatched.push_back(point.bistable);
    any = any || point.bistable;
  }
  if (any) plot.hatch_label = "hatched: bistable, solved from nothing the object moves otherwise";
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const auto differs = [&](std::size_t other) {
      return other < sweep.points.size() && sweep.points[other].modes != sweep.points[i].modes;
    };
    plot.border_right.push_back((i + 1) % plot.columns != 0 && differs(i + 1));
    plot.border_above.push_back(differs(i + plot.columns));
  }
  plot.border_label = "lines: contacts slide, stick or separate otherwise beyond";
  plot.description = plot.value_label + " over " + x.parameter.path + " and " + y.parameter.path +
                     ", a cell a value.";
  return plot;
}

} // namespace

std::string SweepQuantity::name() const {
  constexpr const char* names[] = {"break_force", "force", "force", "twist", "break_twist"};
  const bool is_whole = kind == Kind::break_force || kind == Kind::force;
  return names[static_cast<int>(kind)] + (is_whole ? "" : "[" + std::to_string(component) + "]");
}

std::string SweepQuantity::unit() const {
  if (is_force(*this)) return "N";
  if (kind == Kind::twist) return component < 3 ? "m/s^2" : "rad/s^2";
  return component < 3 ? "" : "rad/m";
}

SweepQuantity sweep_quantity(const std::string& name) {
  std::vector<SweepQuantity> all = {{Kind::break_force, 0}, {Kind::force, 0}};
  for (Index k = 0; k < 3; ++k) all.push_back({Kind::force_component, k});
  for (Index k = 0; k < 6; ++k) all.push_back({Kind::twist, k});
  for (Index k = 0; k < 6; ++k) all.push_back({Kind::break_twist, k});
  std::vector<std::string> names;
  for (const SweepQuantity& quantity : all) {
    names.push_back(quantity.name());
    if (quantity.name() == name) return quantity;
  }
  throw InputError("nothing to show is called " + quoted(name) + suggestion(name, names) +
                   "; there are break_force, force, force[0] to force[2], twist[0] to twist[5] and "
                   "break_twist[0] to break_twist[5]");
}

std::string sweep_svg(const std::vector<SweepCurve>& curves, const std::string& title,
                      const std::vector<SweepQuantity>& shown) {
  const Sweep& sweep = curves.front().sweep;
  if (sweep.is_map()) {
    if (shown.size() > 1) throw InputError("a map shows one quantity, not several");
    return map_svg(map_plot(sweep, shown.empty() ? SweepQuantity{} : shown.front(), title));
  }
  const std::vector<SweepQuantity> both = {{Kind::break_force, 0}, {Kind::force, 0}};
  return plot_svg(LinePlot(curves, shown.empty() ? both : shown).plot(title));
}

} // namespace lcpush::desktop
