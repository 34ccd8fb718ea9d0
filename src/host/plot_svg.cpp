#include "plot_svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "report_format.hpp"

namespace lcpush::host {
namespace {

constexpr double width = 760, height = 460;
constexpr double left = 84, right = 24, top = 52, bottom = 64;
constexpr std::size_t colours = 3;

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
  std::snprintf(text, sizeof text, "%.2f", x);
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

std::string head(const std::string& title, const std::string& description) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixels(width) + " " +
         pixels(height) +
         "\" role=\"img\" aria-labelledby=\"title description\">\n<title id=\"title\">" +
         escaped(title) + "</title>\n<desc id=\"description\">" + escaped(description) +
         "</desc>\n"
         "<style>\n"
         "  svg { font: 13px system-ui, sans-serif; background: #ffffff; color: #1b1f24; }\n"
         "  text { fill: currentColor; }\n"
         "  .frame, .tick { stroke: #8a929c; fill: none; }\n"
         "  .grid { stroke: #e3e6ea; }\n"
         "  .mark { stroke: #8a929c; stroke-dasharray: 4 4; }\n"
         "  .jump { stroke: #b3261e; }\n"
         "  .line { fill: none; stroke-width: 2; }\n"
         "  .c0 { stroke: #0b57a4; } .c1 { stroke: #a8480a; stroke-dasharray: 8 3; }\n"
         "  .c2 { stroke: #386a20; stroke-dasharray: 2 3; }\n"
         "  .cell { fill: #0b57a4; }\n"
         "  @media (prefers-color-scheme: dark) {\n"
         "    svg { background: #14171b; color: #e6e9ed; }\n"
         "    .grid { stroke: #2c3239; }\n"
         "    .jump { stroke: #ff8a80; }\n"
         "    .c0 { stroke: #7cb8ff; } .c1 { stroke: #ffb27a; } .c2 { stroke: #a5d68c; }\n"
         "    .cell { fill: #7cb8ff; }\n"
         "  }\n"
         "</style>\n"
         "<text x=\"" +
         pixels(left) + "\" y=\"24\" font-weight=\"600\">" + escaped(title) + "</text>\n";
}

std::string line_element(const char* kind, double x1, double y1, double x2, double y2) {
  return std::string("<line class=\"") + kind + "\" x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) +
         "\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) + "\"/>\n";
}

std::string axes(const Axis& x, const Axis& y, const std::string& x_label,
                 const std::string& y_label, bool grid) {
  std::string text;
  const double zero_x = 1e-9 * std::abs(x.high - x.low), zero_y = 1e-9 * (y.high - y.low);
  for (const double at : ticks(std::min(x.low, x.high), std::max(x.low, x.high), 8)) {
    if (grid) text += line_element("grid", x.at(at), y.begin, x.at(at), y.end);
    text += line_element("tick", x.at(at), y.begin, x.at(at), y.begin + 5);
    text += "<text x=\"" + pixels(x.at(at)) + "\" y=\"" + pixels(y.begin + 20) +
            "\" text-anchor=\"middle\">" + number(at, zero_x) + "</text>\n";
  }
  for (const double at : ticks(std::min(y.low, y.high), std::max(y.low, y.high), 6)) {
    if (grid) text += line_element("grid", x.begin, y.at(at), x.end, y.at(at));
    text += line_element("tick", x.begin - 5, y.at(at), x.begin, y.at(at));
    text += "<text x=\"" + pixels(x.begin - 9) + "\" y=\"" + pixels(y.at(at) + 4) +
            "\" text-anchor=\"end\">" + number(at, std::abs(zero_y)) + "</text>\n";
  }
  text += "<rect class=\"frame\" x=\"" + pixels(x.begin) + "\" y=\"" + pixels(y.end) +
          "\" width=\"" + pixels(x.end - x.begin) + "\" height=\"" + pixels(y.begin - y.end) +
          "\"/>\n";
  text += "<text x=\"" + pixels((x.begin + x.end) / 2) + "\" y=\"" + pixels(height - 16) +
          "\" text-anchor=\"middle\">" + escaped(x_label) + "</text>\n";
  return text + "<text transform=\"translate(20 " + pixels((y.begin + y.end) / 2) +
         ") rotate(-90)\" text-anchor=\"middle\">" + escaped(y_label) + "</text>\n";
}

std::string colour(std::size_t line) {
  return "c" + std::string(1, static_cast<char>('0' + line % colours));
}

} // namespace

std::string plot_svg(const Plot& plot) {
  double low = 0, high = 0;
  for (const PlotLine& line : plot.lines)
    for (const auto& piece : line.pieces)
      for (const auto& [x, y] : piece) {
        low = std::min(low, y);
        high = std::max(high, y);
      }
  if (!(high > low)) high = low + 1;
  const double room = 0.05 * (high - low);
  if (low < 0) low -= room;
  high += room;
  const Axis x{plot.x_from, plot.x_to, left, width - right};
  const Axis y{low, high, height - bottom, top};
  std::string text = head(plot.title, plot.description);
  text += axes(x, y, plot.x_label, plot.y_label, true);
  for (const PlotMark& mark : plot.marks)
    text += std::string("<g><title>") + escaped(mark.text) + "</title>" +
            line_element(mark.strong ? "mark jump" : "mark", x.at(mark.x), y.begin, x.at(mark.x),
                         y.end) +
            "</g>\n";
  for (std::size_t k = 0; k < plot.lines.size(); ++k) {
    for (const auto& piece : plot.lines[k].pieces) {
      std::string points, dots;
      for (const auto& [px, py] : piece) {
        points += (points.empty() ? "" : " ") + pixels(x.at(px)) + "," + pixels(y.at(py));
        if (plot.lines[k].dots)
          dots += "<circle class=\"line " + colour(k) + "\" cx=\"" + pixels(x.at(px)) + "\" cy=\"" +
                  pixels(y.at(py)) + "\" r=\"2\"/>\n";
      }
      text += "<polyline class=\"line " + colour(k) + "\" points=\"" + points + "\"/>\n" + dots;
    }
    const double at = left + 12 + 230 * static_cast<double>(k);
    text += line_element(("line " + colour(k)).c_str(), at, top - 12, at + 26, top - 12);
    text += "<text x=\"" + pixels(at + 33) + "\" y=\"" + pixels(top - 8) + "\">" +
            escaped(plot.lines[k].label) + "</text>\n";
  }
  return text + "</svg>\n";
}

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
  const Axis x = axis(plot.x_from, plot.x_to, plot.columns, left, width - right);
  const Axis y = axis(plot.y_from, plot.y_to, rows, height - bottom, top);
  std::string text = head(plot.title, plot.description);
  const double w = (x.end - x.begin) / static_cast<double>(std::max<std::size_t>(plot.columns, 1));
  const double h = (y.begin - y.end) / static_cast<double>(std::max<std::size_t>(rows, 1));
  for (std::size_t i = 0; i < plot.cells.size(); ++i) {
    const double cell = plot.cells[i];
    const double share = high > low && std::isfinite(cell) ? (cell - low) / (high - low) : 1;
    const double px = x.begin + w * static_cast<double>(i % plot.columns);
    const double py = y.begin - h * static_cast<double>(i / plot.columns + 1);
    text += "<rect class=\"cell\" x=\"" + pixels(px) + "\" y=\"" + pixels(py) + "\" width=\"" +
            pixels(w) + "\" height=\"" + pixels(h) + "\" fill-opacity=\"" +
            pixels(std::isfinite(cell) ? 0.06 + 0.94 * share : 0) + "\"><title>" +
            escaped(plot.texts[i]) + "</title></rect>\n";
  }
  text += axes(x, y, plot.x_label, plot.y_label, false);
  if (low <= high)
    text += "<text x=\"" + pixels(left) + "\" y=\"" + pixels(top - 9) + "\">" +
            escaped(plot.value_label) + ": from " + number(low) + " (pale) to " + number(high) +
            " (full)</text>\n";
  return text + "</svg>\n";
}

} // namespace lcpush::host
