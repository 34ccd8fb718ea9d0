// Sweeps over two parameters as SVG.
#include <limits>

#include "draw/plot_svg.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/parameter_words.hpp"
#include "sweep/sweep_quantity.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

MapPlot map_plot(const Sweep& sweep, const SweepQuantity& quantity, const std::string& title) {
  const Variation &x = sweep.variations[0], &y = sweep.variations[1];
  MapPlot plot;
  plot.title = title;
  plot.x_label = parameter_label(x.parameter);
  plot.y_label = parameter_label(y.parameter);
  plot.value_label = quantity.kind == SweepQuantity::Kind::break_force
                         ? "breaking force by " + sweep.pusher + ", N"
                         : axis_label(quantity);
  plot.x_from = x.from;
  plot.x_to = x.to;
  plot.y_from = y.from;
  plot.y_to = y.to;
  bool any = false;
  for (const SweepPoint& point : sweep.points) {
    if (point.second == sweep.points.front().second) ++plot.columns;
    const SweepAnswer& answer = answer_of(quantity, point.at);
    const bool known = answer.has_force();
    const double value = value_of(quantity, point.at);
    plot.cells.push_back(known ? value : std::numeric_limits<double>::quiet_NaN());
    plot.texts.push_back(number(point.value) + ", " + number(*point.second) + ": " +
                         (known                ? number(value) + " " + quantity.unit()
                          : answer.is_solved() ? "the push breaks nothing"
                                               : std::string(status_text(answer.status))));
    plot.hatched.push_back(point.bistable);
    any = any || point.bistable;
  }
  if (any) plot.hatch_label = "hatched: bistable, another start gives another motion";
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    const auto differs = [&](std::size_t other) {
      return other < sweep.points.size() && sweep.points[other].modes != sweep.points[i].modes;
    };
    plot.border_right.push_back((i + 1) % plot.columns != 0 && differs(i + 1));
    plot.border_above.push_back(differs(i + plot.columns));
  }
  plot.border_label = "lines: beyond, other contacts slip, stick or open";
  plot.description = plot.value_label + " over " + parameter_words(x.parameter) + " and " +
                     parameter_words(y.parameter) + ", a cell a value.";
  return plot;
}

} // namespace

std::string sweep_map_svg(const Sweep& sweep, const std::string& title,
                          const std::vector<SweepQuantity>& shown) {
  if (shown.size() > 1) throw InputError("a map shows one quantity, not several");
  return map_svg(map_plot(sweep, shown.empty() ? SweepQuantity{} : shown.front(), title));
}

} // namespace lcpush::desktop
