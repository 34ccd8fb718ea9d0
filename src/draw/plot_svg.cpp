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
  auto [low, high] = value_range(panel);
  if (!(high > low)) high = low + 1;
  const double room = 0.05 * (high - low);
  return {low < 0 ? low - room : low, high > 0 ? high + room : high, begin, end};
}

/// " stroke-width=..": the earlier of nested lines are wider, so that none is hidden.
std::string width_attribute(const PlotPanel& panel, std::size_t line) {
  const std::size_t above = panel.lines.size() - 1 - line;
  if (!panel.nested || above == 0) return "";
  constexpr double widest = 6; // more than the last one
  const double step = std::min(3.0, widest / static_cast<double>(panel.lines.size() - 1));
  return " style=\"stroke-width: " + coordinate(2 + step * static_cast<double>(above)) + "\"";
}

std::string curves(const PlotPanel& panel, const Axis& x, const Axis& y) {
  std::string text;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const PlotLine& line = panel.lines[k];
    for (const auto& piece : line.pieces) {
      std::string points, dots;
      for (const auto& [px, py] : piece) {
        points += (points.empty() ? "" : " ") + coordinate(x.at(px)) + "," + coordinate(y.at(py));
        if (line.dots)
          dots += "<circle class=\"line " + colour(line.colour) + "\" cx=\"" +
                  coordinate(x.at(px)) + "\" cy=\"" + coordinate(y.at(py)) + "\" r=\"1.5\"/>\n";
      }
      text += "<polyline class=\"line " + colour(line.colour) + "\"" + width_attribute(panel, k) +
              " points=\"" + points + "\"/>\n" + dots;
    }
  }
  return text;
}

/// Rows that the entries take, and the note below them.
double rows_of_legend(const PlotPanel& panel) {
  return static_cast<double>((panel.lines.size() + 1) / 2 + (panel.nested ? 1 : 0));
}
double legend_height(const PlotPanel& panel) { return line_height * rows_of_legend(panel) + 4; }

/// Two entries a row, from y on.
std::string legend(const PlotPanel& panel, double y) {
  std::string text;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const double at = 12 + (k % 2 == 1 ? (width - 24) / 2 : 0);
    const double row = y + line_height * static_cast<double>(k / 2) + line_height / 2;
    text += "<polyline class=\"line " + colour(panel.lines[k].colour) + "\"" +
            width_attribute(panel, k) + " points=\"" + coordinate(at) + "," + coordinate(row) +
            " " + coordinate(at + 26) + "," + coordinate(row) + "\"/>\n";
    text += text_element(at + 33, row + 5, panel.lines[k].label);
  }
  if (panel.nested)
    text += text_element(12, y + line_height * rows_of_legend(panel) - line_height / 2 + 5,
                         "Where curves coincide, the earlier is the wider one.");
  return text;
}
bool same_legend(const PlotPanel& a, const PlotPanel& b) {
  return a.nested == b.nested &&
         std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                    [](const PlotLine& one, const PlotLine& other) {
                      return one.label == other.label && one.colour == other.colour;
                    });
}

constexpr double number_room = 20; // above the first panel, for the marks' numbers
constexpr double nearest = 24;     // numbers of marks that are nearer than this stand as one text
constexpr std::size_t list_letters = 62; // a line

/// The marks' numbers above the first panel, in the order of x: "1, 2" over two that are near.
std::string mark_numbers(const Plot& plot, const Axis& x, double y) {
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t k = 0; k < plot.marks.size(); ++k)
    places.emplace_back(x.at(plot.marks[k].x), k + 1);
  std::sort(places.begin(), places.end());
  std::string text;
  for (std::size_t k = 0; k < places.size();) {
    const double at = places[k].first;
    double end = at + nearest;
    std::string numbers;
    for (; k < places.size() && places[k].first < end; ++k) {
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(places[k].second);
      end = at + nearest * static_cast<double>(1 + numbers.size() / 3);
    }
    text += text_element(at, y, numbers, " text-anchor=\"middle\" class=\"number\"");
  }
  return text;
}

std::string mark_strokes(const Plot& plot, const Axis& x, const Axis& y) {
  std::string text;
  for (const PlotMark& mark : plot.marks)
    text += std::string("<g><title>") + escaped(mark.place + ": " + mark.text) + "</title>" +
            line_element(mark.strong ? "mark jump" : "mark", x.at(mark.x), y.begin, x.at(mark.x),
                         y.end) +
            "</g>\n";
  return text;
}

double height_of_panels(const Plot& plot) {
  return plot.panels.size() > 1 ? one_of_many : lone_panel;
}

} // namespace

std::pair<double, double> value_range(const PlotPanel& panel) {
  double low = 0, high = 0;
  for (const PlotLine& line : panel.lines)
    for (const auto& piece : line.pieces)
      for (const auto& [x, y] : piece) {
        low = std::min(low, y);
        high = std::max(high, y);
      }
  return {low, high};
}

std::pair<double, double> first_axes(const Plot& plot) {
  const double top = title_height(plot.title) + legend_height(plot.panels.front()) +
                     y_label_height(plot.panels.front().y_label, height_of_panels(plot)) +
                     (plot.marks.empty() ? 0 : number_room);
  return {top / width, (top + height_of_panels(plot)) / width};
}

std::string plot_svg(const Plot& plot) {
  const Axis x{plot.x_from, plot.x_to, left, width - right};
  const double tall = height_of_panels(plot);
  std::string body;
  double top = title_height(plot.title);
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const PlotPanel& panel = plot.panels[p];
    const bool last = p + 1 == plot.panels.size();
    if (p == 0 || !same_legend(panel, plot.panels[p - 1])) {
      body += legend(panel, top);
      top += legend_height(panel);
    }
    const double label_top = top;
    top += y_label_height(panel.y_label, tall);
    if (p == 0 && !plot.marks.empty()) {
      body += mark_numbers(plot, x, top + number_room - 6);
      top += number_room;
    }
    const Axis y = y_axis(panel, top + tall, top);
    body += axes(x, y, true, last) + y_axis_label(panel.y_label, y, label_top);
    body += mark_strokes(plot, x, y);
    body += curves(panel, x, y);
    top += tall + (last ? axis_room : panel_gap);
  }
  body += x_axis_label(plot.x_label, top - 12);
  for (std::size_t k = 0; k < plot.marks.size(); ++k) {
    const PlotMark& mark = plot.marks[k];
    body +=
        text_lines(12, top + line_height / 2,
                   std::to_string(k + 1) + ": " + mark.place + ": " + mark.text, list_letters, top);
  }
  return picture(plot.title, plot.description, top + (plot.marks.empty() ? 0 : 8), body);
}

std::string plot_image(const std::string& svg, const std::string& words) {
  return "<img class=\"plot\" alt=\"" + escaped(words) + "\" src=\"data:image/svg+xml," +
         percent_encoded(svg, "-_.~:/;=,()") + "\"/>\n";
}

} // namespace lcpush::desktop
