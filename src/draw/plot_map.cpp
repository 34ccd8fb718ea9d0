// Maps: cells over two values.
#include <algorithm>
#include <cmath>
#include <limits>

#include "draw/plot_parts.hpp"
#include "draw/plot_svg.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

using namespace plot;

/// Parallel strokes from below on the left to above on the right.
std::string hatch(double x, double y, double w, double h) {
  const double strokes[][4] = {{0, 0.5, 0.5, 0}, {0, 1, 1, 0}, {0.5, 1, 1, 0.5}};
  std::string text;
  for (const auto& [x1, y1, x2, y2] : strokes)
    text += line_element("hatch", x + x1 * w, y + y1 * h, x + x2 * w, y + y2 * h);
  return text;
}

std::vector<std::string> map_notes(const MapPlot& plot, double low, double high) {
  std::vector<std::string> notes;
  notes.push_back(low <= high ? plot.value_label + ": from " + printed("%.3g", low) +
                                    " (pale) to " + printed("%.3g", high) + " (full)"
                              : plot.value_label + ": nowhere known");
  if (!plot.border_label.empty()) notes.push_back(plot.border_label);
  if (!plot.hatch_label.empty()) notes.push_back(plot.hatch_label);
  return notes;
}

} // namespace

std::string map_svg(const MapPlot& plot) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double cell : plot.cells) {
    if (!std::isfinite(cell)) continue;
    low = std::min(low, cell);
    high = std::max(high, cell);
  }
  const std::size_t rows = plot.columns > 0 ? plot.cells.size() / plot.columns : 0;
  // The values stand in the middles of the cells.
  const auto axis = [](double from, double to, std::size_t count, double begin, double end) {
    const double half = count > 1 ? (to - from) / (2 * static_cast<double>(count - 1)) : 0.5;
    return Axis{from - half, to + half, begin, end};
  };
  const std::vector<std::string> notes = map_notes(plot, low, high);
  double note_at = title_height(plot.title) + 14;
  const double bar_room = high > low ? colour_bar_room : 0;
  const double label_top = note_at - 4 + bar_room + line_height * static_cast<double>(notes.size());
  const double top = label_top + y_label_height(plot.y_label, lone_panel);
  const Axis x = axis(plot.x_from, plot.x_to, plot.columns, left, width - right);
  const Axis y = axis(plot.y_from, plot.y_to, rows, top + lone_panel, top);
  std::string body;
  if (high > low) body += colour_bar({low, high, 24, 424}, note_at + 9);
  const double w = (x.end - x.begin) / static_cast<double>(std::max<std::size_t>(plot.columns, 1));
  const double h = (y.begin - y.end) / static_cast<double>(std::max<std::size_t>(rows, 1));
  std::string borders;
  for (std::size_t i = 0; i < plot.cells.size(); ++i) {
    const double cell = plot.cells[i];
    const double share = high > low && std::isfinite(cell) ? (cell - low) / (high - low) : 1;
    const double px = x.begin + w * static_cast<double>(i % plot.columns);
    const double py = y.begin - h * static_cast<double>(i / plot.columns + 1);
    body += "<rect class=\"cell\" x=\"" + coordinate(px) + "\" y=\"" + coordinate(py) +
            "\" width=\"" + coordinate(w) + "\" height=\"" + coordinate(h) + "\" fill-opacity=\"" +
            coordinate(std::isfinite(cell) ? opacity_of(share) : 0) + "\"><title>" +
            escaped(plot.texts[i]) + "</title></rect>\n";
    if (!plot.hatched.empty() && plot.hatched[i]) body += hatch(px, py, w, h);
    if (!plot.border_right.empty() && plot.border_right[i])
      borders += line_element("border", px + w, py, px + w, py + h);
    if (!plot.border_above.empty() && plot.border_above[i])
      borders += line_element("border", px, py, px + w, py);
  }
  body += axes(x, y, false, true) + borders + y_axis_label(plot.y_label, y, label_top);
  const double bottom = top + lone_panel + axis_room;
  body += x_axis_label(plot.x_label, bottom - 12);
  for (const std::string& note : notes) {
    body += text_element(12, note_at, note);
    note_at += line_height + (&note == notes.data() ? bar_room : 0);
  }
  return picture(plot.title, plot.description, bottom, body);
}

} // namespace lcpush::desktop
