#include "plot_svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "report_format.hpp"

namespace lcpush::host {
namespace {

constexpr double width = 760, left = 96, right = 38;
constexpr double line_height = 26; // of titles and legends, for letters as large as on a phone
constexpr double axis_room = 64;   // below the last panel
constexpr double panel_gap = 34;
constexpr double lone_panel = 340, one_of_many = 220;
constexpr std::size_t title_letters = 58; // a line
constexpr std::size_t colours = 6;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    case '&': result += "&amp;"; break;
    case '"': result += "&quot;"; break;
    default: result += c;
    }
  return result;
}

std::string pixels(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", x);
  return text;
}

/// Round numbers, about `count` of them, that cover the range.
std::vector<double> ticks(double low, double high, int count) {
  const double rough = (high - low) / count, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = power * (rough < 1.5 * power   ? 1
                               : rough < 3.5 * power ? 2
                               : rough < 7.5 * power ? 5
                                                     : 10);
  std::vector<double> list;
  const double slack = step * 1e-9;
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k)
    list.push_back(k * step == 0 ? 0 : k * step);
  return list;
}

struct Axis {
  double low, high, begin, end; ///< values, and their pixels
  double at(double x) const { return begin + (x - low) / (high - low) * (end - begin); }
};

/// In lines of so many letters, where there are spaces.
std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines;
}

/// Colours by the reader's setting; larger letters and fewer of them where the picture is narrow.
const char* const style =
    "<style>\n"
    "  svg { font: 13px system-ui, sans-serif; background: #ffffff; color: #1b1f24; }\n"
    "  text { fill: currentColor; }\n"
    "  .frame, .tick { stroke: #8a929c; fill: none; }\n"
    "  .grid { stroke: #e3e6ea; }\n"
    "  .mark { stroke: #8a929c; stroke-dasharray: 4 4; }\n"
    "  .jump { stroke: #b3261e; }\n"
    "  .line { fill: none; stroke-width: 2; }\n"
    "  .c0 { stroke: #0b57a4; } .c1 { stroke: #a8480a; stroke-dasharray: 8 3; }\n"
    "  .c2 { stroke: #386a20; stroke-dasharray: 2 3; } .c3 { stroke: #7b1fa2; stroke-dasharray: "
    "10 3 2 3; }\n"
    "  .c4 { stroke: #00696d; stroke-dasharray: 5 5; } .c5 { stroke: #5d4037; stroke-dasharray: "
    "14 4; }\n"
    "  circle.line { stroke-dasharray: none; }\n"
    "  .cell { fill: #0b57a4; shape-rendering: crispEdges; }\n"
    "  .border, .hatch { stroke: #1b1f24; stroke-width: 2; fill: none; }\n"
    "  .hatch { stroke: #ff8f3f; }\n"
    "  @media (prefers-color-scheme: dark) {\n"
    "    svg { background: #14171b; color: #e6e9ed; }\n"
    "    .grid { stroke: #2c3239; }\n"
    "    .jump { stroke: #ff8a80; }\n"
    "    .c0 { stroke: #7cb8ff; } .c1 { stroke: #ffb27a; } .c2 { stroke: #a5d68c; }\n"
    "    .c3 { stroke: #d9a6f0; } .c4 { stroke: #6fd5d9; } .c5 { stroke: #d7b9a8; }\n"
    "    .cell { fill: #7cb8ff; }\n"
    "    .border { stroke: #e6e9ed; } .hatch { stroke: #d9480f; }\n"
    "  }\n"
    "  @media (max-width: 500px) { svg { font-size: 22px; } .odd { display: none; } }\n"
    "</style>\n";

std::string text_element(double x, double y, const std::string& text, const char* attributes = "") {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\"" + attributes + ">" +
         escaped(text) + "</text>\n";
}

/// Puts `body` (which begins below the title) into a picture of this height.
std::string picture(const std::string& title, const std::string& description, double height,
                    const std::string& body) {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixels(width) +
                     " " + pixels(height) +
                     "\" role=\"img\" aria-labelledby=\"title description\">\n<title "
                     "id=\"title\">" +
                     escaped(title) + "</title>\n<desc id=\"description\">" + escaped(description) +
                     "</desc>\n" + style;
  double y = line_height;
  for (const std::string& line : wrapped(title, title_letters)) {
    text += text_element(12, y, line, " font-weight=\"600\"");
    y += line_height;
  }
  return text + body + "</svg>\n";
}

double title_height(const std::string& title) {
  return line_height * static_cast<double>(wrapped(title, title_letters).size()) + 14;
}

std::string line_element(const char* kind, double x1, double y1, double x2, double y2) {
  return std::string("<line class=\"") + kind + "\" x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) +
         "\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) + "\"/>\n";
}

std::string tick_label(const char* anchor, std::size_t index, double x, double y, double value,
                       double zero) {
  const std::string attributes =
      std::string(" text-anchor=\"") + anchor + "\"" + (index % 2 == 1 ? " class=\"odd\"" : "");
  return text_element(x, y, number(value, zero), attributes.c_str());
}

/// Frame, ticks and their numbers; `numbered`: along x too.
std::string axes(const Axis& x, const Axis& y, bool grid, bool numbered) {
  std::string text;
  const double zero_x = 1e-9 * std::abs(x.high - x.low), zero_y = 1e-9 * (y.high - y.low);
  std::size_t index = 0;
  for (const double at : ticks(std::min(x.low, x.high), std::max(x.low, x.high), 8)) {
    if (grid) text += line_element("grid", x.at(at), y.begin, x.at(at), y.end);
    text += line_element("tick", x.at(at), y.begin, x.at(at), y.begin + 5);
    if (numbered) text += tick_label("middle", index++, x.at(at), y.begin + 24, at, zero_x);
  }
  for (const double at : ticks(std::min(y.low, y.high), std::max(y.low, y.high), 6)) {
    if (grid) text += line_element("grid", x.begin, y.at(at), x.end, y.at(at));
    text += line_element("tick", x.begin - 5, y.at(at), x.begin, y.at(at));
    text += tick_label("end", 0, x.begin - 9, y.at(at) + 4, at, std::abs(zero_y));
  }
  return text + "<rect class=\"frame\" x=\"" + pixels(x.begin) + "\" y=\"" + pixels(y.end) +
         "\" width=\"" + pixels(x.end - x.begin) + "\" height=\"" + pixels(y.begin - y.end) +
         "\"/>\n";
}

std::string x_axis_label(const std::string& label, double y) {
  return text_element((left + width - right) / 2, y, label, " text-anchor=\"middle\"");
}
std::string y_axis_label(const std::string& label, const Axis& y) {
  return "<text transform=\"translate(20 " + pixels((y.begin + y.end) / 2) +
         ") rotate(-90)\" text-anchor=\"middle\">" + escaped(label) + "</text>\n";
}

std::string colour(std::size_t line) {
  return "c" + std::string(1, static_cast<char>('0' + line % colours));
}

} // namespace

namespace {

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
        points += (points.empty() ? "" : " ") + pixels(x.at(px)) + "," + pixels(y.at(py));
        if (line.dots)
          dots += "<circle class=\"line " + colour(line.colour) + "\" cx=\"" + pixels(x.at(px)) +
                  "\" cy=\"" + pixels(y.at(py)) + "\" r=\"1.5\"/>\n";
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
  if (a.lines.size() != b.lines.size()) return false;
  for (std::size_t k = 0; k < a.lines.size(); ++k)
    if (a.lines[k].label != b.lines[k].label || a.lines[k].colour != b.lines[k].colour)
      return false;
  return true;
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

namespace {

std::vector<std::string> map_notes(const MapPlot& plot, double low, double high) {
  std::vector<std::string> notes;
  notes.push_back(low <= high ? plot.value_label + ": from " + number(low) + " (pale) to " +
                                    number(high) + " (full)"
                              : plot.value_label + ": nowhere known");
  if (!plot.border_label.empty()) notes.push_back(plot.border_label);
  if (!plot.hatch_label.empty()) notes.push_back(plot.hatch_label);
  return notes;
}

std::string map_legend(const MapPlot& plot, double low, double high) {
  std::string text;
  double y = title_height(plot.title) + 14;
  for (const std::string& note : map_notes(plot, low, high)) {
    text += text_element(12, y, note);
    y += line_height;
  }
  return text;
}
double map_legend_height(const MapPlot& plot) {
  return line_height * static_cast<double>(map_notes(plot, 0, 0).size()) + 10;
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
  const double top = title_height(plot.title) + map_legend_height(plot);
  const Axis x = axis(plot.x_from, plot.x_to, plot.columns, left, width - right);
  const Axis y = axis(plot.y_from, plot.y_to, rows, top + lone_panel, top);
  std::string body = "<defs><pattern id=\"hatch\" width=\"6\" height=\"6\" "
                     "patternUnits=\"userSpaceOnUse\"><path class=\"hatch\" d=\"M0,6 "
                     "L6,0\"/></pattern></defs>\n";
  const double w = (x.end - x.begin) / static_cast<double>(std::max<std::size_t>(plot.columns, 1));
  const double h = (y.begin - y.end) / static_cast<double>(std::max<std::size_t>(rows, 1));
  std::string borders;
  const auto rectangle = [&](const char* paint, double px, double py) {
    return std::string("<rect ") + paint + " x=\"" + pixels(px) + "\" y=\"" + pixels(py) +
           "\" width=\"" + pixels(w) + "\" height=\"" + pixels(h) + "\"";
  };
  for (std::size_t i = 0; i < plot.cells.size(); ++i) {
    const double cell = plot.cells[i];
    const double share = high > low && std::isfinite(cell) ? (cell - low) / (high - low) : 1;
    const double px = x.begin + w * static_cast<double>(i % plot.columns);
    const double py = y.begin - h * static_cast<double>(i / plot.columns + 1);
    body += rectangle("class=\"cell\"", px, py) + " fill-opacity=\"" +
            pixels(std::isfinite(cell) ? 0.06 + 0.94 * share : 0) + "\"><title>" +
            escaped(plot.texts[i]) + "</title></rect>\n";
    if (!plot.hatched.empty() && plot.hatched[i])
      body += rectangle("fill=\"url(#hatch)\"", px, py) + "/>\n";
    if (!plot.border_right.empty() && plot.border_right[i])
      borders += line_element("border", px + w, py, px + w, py + h);
    if (!plot.border_above.empty() && plot.border_above[i])
      borders += line_element("border", px, py, px + w, py);
  }
  body += axes(x, y, false, true) + borders + y_axis_label(plot.y_label, y);
  const double bottom = top + lone_panel + axis_room;
  body += x_axis_label(plot.x_label, bottom - 12) + map_legend(plot, low, high);
  return picture(plot.title, plot.description, bottom, body);
}

} // namespace lcpush::host
