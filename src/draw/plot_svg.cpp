// Line plots: panels above each other over one x.
#include "draw/plot_svg.hpp"

#include <algorithm>

#include "draw/plot_parts.hpp"

namespace lcpush::desktop {
namespace {

using namespace plot;

constexpr std::size_t colours = 6;

std::string colour(std::size_t line) {
  return "c" + std::string(1, static_cast<char>('0' + line % colours));
}

/// The values of a panel, and zero.
Axis y_axis(const PlotPanel& panel, double begin, double end) {
  double low = 0, high = 0;
  for (const PlotLine& line : panel.lines)
    for (const auto& piece : line.pieces)
      for (const auto& [x, y] : piece) {
        low = std::min(low, y);
        high = std::max(high, y);
      }
  if (!(high > low)) high = low + 1;
  const double room = 0.05 * (high - low);
  return {low < 0 ? low - room : low, high > 0 ? high + room : high, begin, end};
}

std::string curves(const PlotPanel& panel, const Axis& x, const Axis& y) {
  std::string text;
  for (const PlotLine& line : panel.lines)
    for (const auto& piece : line.pieces) {
      std::string points, dots;
      for (const auto& [px, py] : piece) {
        points += (points.empty() ? "" : " ") + coordinate(x.at(px)) + "," + coordinate(y.at(py));
        if (line.dots)
          dots += "<circle class=\"line " + colour(line.colour) + "\" cx=\"" +
                  coordinate(x.at(px)) + "\" cy=\"" + coordinate(y.at(py)) + "\" r=\"1.5\"/>\n";
      }
      text += "<polyline class=\"line " + colour(line.colour) + "\" points=\"" + points + "\"/>\n" +
              dots;
    }
  return text;
}

/// Two entries a row, from y on.
std::string legend(const PlotPanel& panel, double y) {
  std::string text;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const double at = 12 + (k % 2 == 1 ? (width - 24) / 2 : 0);
    const double row = y + line_height * static_cast<double>(k / 2) + line_height / 2;
    text += line_element(("line " + colour(panel.lines[k].colour)).c_str(), at, row, at + 26, row);
    text += text_element(at + 33, row + 5, panel.lines[k].label);
  }
  return text;
}
double legend_height(const PlotPanel& panel) {
  return line_height * static_cast<double>((panel.lines.size() + 1) / 2) + 4;
}

bool same_legend(const PlotPanel& a, const PlotPanel& b) {
  return std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                    [](const PlotLine& one, const PlotLine& other) {
                      return one.label == other.label && one.colour == other.colour;
                    });
}

} // namespace

std::string plot_svg(const Plot& plot) {
  const Axis x{plot.x_from, plot.x_to, left, width - right};
  const double tall = plot.panels.size() > 1 ? one_of_many : lone_panel;
  std::string body;
  double top = title_height(plot.title);
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const PlotPanel& panel = plot.panels[p];
    const bool last = p + 1 == plot.panels.size();
    if (p == 0 || !same_legend(panel, plot.panels[p - 1])) {
      body += legend(panel, top);
      top += legend_height(panel);
    }
    const Axis y = y_axis(panel, top + tall, top);
    body += axes(x, y, true, last) + y_axis_label(panel.y_label, y);
    for (const PlotMark& mark : plot.marks)
      body += std::string("<g><title>") + escaped(mark.text) + "</title>" +
              line_element(mark.strong ? "mark jump" : "mark", x.at(mark.x), y.begin, x.at(mark.x),
                           y.end) +
              "</g>\n";
    body += curves(panel, x, y);
    top += tall + (last ? axis_room : panel_gap);
  }
  return picture(plot.title, plot.description, top, body + x_axis_label(plot.x_label, top - 12));
}

} // namespace lcpush::desktop
