// Sweeps as SVG.
#include <algorithm>
#include <cmath>

#include "draw/plot_svg.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/parameter_words.hpp"
#include "sweep/sweep_quantity.hpp"
#include "sweep/sweep_words.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

using Kind = SweepQuantity::Kind;
using Curve = std::vector<std::vector<std::pair<double, double>>>;

const std::vector<SweepQuantity> both_forces = {{Kind::break_force, 0}, {Kind::force, 0}};

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
    const bool known = answer_of(quantity, a).has_force();
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
    const bool known = answer_of(quantity, point.at).has_force();
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
                     parameter_words(variation.parameter) + " from " + number(variation.from) +
                     " to " + number(variation.to) + ".";
  for (const PlotMark& mark : plot.marks) text += " At " + mark.place + ": " + mark.text + ".";
  for (const SweepCurve& curve : curves)
    for (const BistableRange& range : curve.sweep.bistable)
      text += (curve.label.empty() ? " Bistable from " : " " + curve.label + ": bistable from ") +
              number(range.from) + " to " + number(range.to) + ".";
  return text;
}

/// Changes of mode that matter, and the zeros of what is shown.
std::vector<PlotMark> marks_of(const Sweep& sweep, const std::vector<SweepQuantity>& shown) {
  const Variation& variation = sweep.variations[0];
  std::vector<PlotMark> marks;
  const auto events = sweep.segments.empty() ? events_of(sweep, sweep.points, Telling::brief)
                                             : events_of(sweep, sweep.segments, Telling::brief);
  for (const SweepEvent& event : events) {
    const std::string text = event_text(sweep, event);
    if (!marks.empty() && are_one_place(variation, marks.back().x, event.value())) {
      marks.back().text += "; " + text;
      marks.back().strong = marks.back().strong || event.jumps;
    } else {
      marks.push_back({event.value(), event_place(variation, event), text, event.jumps});
    }
  }
  for (const SweepZero& zero : sweep.zeros)
    for (const SweepQuantity& quantity : shown)
      if (quantity.kind == Kind::twist && quantity.component == zero.component &&
          zero.from == zero.to && !zero.jumps)
        marks.push_back(
            {zero.from, with_unit(variation, zero.from), words_of(quantity) + " is zero", false});
  std::stable_sort(marks.begin(), marks.end(),
                   [](const PlotMark& a, const PlotMark& b) { return a.x < b.x; });
  return marks;
}

/// Of the panel's height: curves that are nearer than this over a tenth of the range coincide.
constexpr double near_curves = 0.01, coinciding_part = 0.1;

std::optional<double> height_at(const PlotLine& line, double x) {
  for (const auto& piece : line.pieces)
    for (std::size_t k = 1; k < piece.size(); ++k) {
      const auto& [x0, y0] = piece[k - 1];
      const auto& [x1, y1] = piece[k];
      if (x0 != x1 && (x - x0) * (x - x1) <= 0) return y0 + (x - x0) / (x1 - x0) * (y1 - y0);
    }
  return std::nullopt;
}

/// Would a curve hide a part of another?
bool coincide(const PlotPanel& panel, double from, double to) {
  const auto [low, high] = value_range(panel);
  constexpr int looks = 100;
  for (std::size_t a = 0; a < panel.lines.size(); ++a)
    for (std::size_t b = a + 1; b < panel.lines.size(); ++b) {
      int near = 0;
      for (int k = 0; k <= looks; ++k) {
        const double x = from + (to - from) * k / looks;
        const auto first = height_at(panel.lines[a], x), second = height_at(panel.lines[b], x);
        near += first && second && std::abs(*first - *second) <= near_curves * (high - low) ? 1 : 0;
      }
      if (near > coinciding_part * looks) return true;
    }
  return false;
}

class LinePlot {
public:
  LinePlot(const std::vector<SweepCurve>& curves, const std::vector<SweepQuantity>& shown)
      : curves_(curves), shown_(shown) {}

  Plot plot(const std::string& title) {
    const Sweep& sweep = curves_.front().sweep;
    Plot plot;
    plot.title = title;
    plot.x_label = parameter_label(sweep.variations[0].parameter);
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
      panel.y_label = lone                ? axis_label(mine[0])
                      : is_force(mine[0]) ? "force, N"
                      : mine[0].kind == Kind::twist
                          ? "acceleration, " + unit
                          : "motion at breaking" + (unit.empty() ? "" : ", " + unit);
      for (const SweepCurve& curve : curves_)
        for (const SweepQuantity& quantity : mine) add(panel, quantity, curve, lone);
      panel.nested = coincide(panel, plot.x_from, plot.x_to);
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

} // namespace

std::string sweep_svg(const std::vector<SweepCurve>& given, const std::string& title,
                      const std::vector<SweepQuantity>& shown) {
  std::vector<SweepCurve> curves = given;
  for (SweepCurve& curve : curves) curve.sweep = in_typed_units(std::move(curve.sweep));
  const Sweep& sweep = curves.front().sweep;
  if (sweep.is_map()) return sweep_map_svg(sweep, title, shown);
  return plot_svg(LinePlot(curves, shown.empty() ? both_forces : shown).plot(title));
}

std::string sweep_svg(const Sweep& sweep, const std::string& title) {
  std::vector<SweepQuantity> shown = both_forces;
  if (const auto axis = axis_of_turn(sweep)) shown.push_back({Kind::twist, 3 + *axis});
  return sweep_svg({{"", "", std::nullopt, sweep}}, title, shown);
}

} // namespace lcpush::desktop
