#include "draw/plot_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop::plot {
namespace {

constexpr std::size_t title_letters = 58; // a line

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

/// In lines of so many letters, where there are spaces.
std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines(1);
  for (const std::string_view word : split_at(text, ' ')) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters)
      lines.emplace_back();
    lines.back().append(lines.back().empty() ? "" : " ").append(word);
  }
  return lines;
}

// Classes and no ids, so that several plots can stand on one page. Colours by the reader's setting;
// larger letters and fewer of them where the picture is narrow.
const char* const style =
    "<style>\n"
    "  .plot { font: 13px system-ui, sans-serif; background: #ffffff; color: #1b1f24; }\n"
    "  .plot text { fill: currentColor; }\n"
    "  .plot .frame, .plot .tick { stroke: #8a929c; fill: none; }\n"
    "  .plot .grid { stroke: #e3e6ea; }\n"
    "  .plot .mark { stroke: #8a929c; stroke-dasharray: 4 4; }\n"
    "  .plot .jump { stroke: #b3261e; }\n"
    "  .plot .line { fill: none; stroke-width: 2; }\n"
    "  .plot .c0 { stroke: #0b57a4; } .plot .c1 { stroke: #a8480a; stroke-dasharray: 8 3; }\n"
    "  .plot .c2 { stroke: #386a20; stroke-dasharray: 2 3; } .plot .c3 { stroke: #7b1fa2; "
    "stroke-dasharray: "
    "10 3 2 3; }\n"
    "  .plot .c4 { stroke: #00696d; stroke-dasharray: 5 5; } .plot .c5 { stroke: #5d4037; "
    "stroke-dasharray: "
    "14 4; }\n"
    "  .plot circle.line { stroke-dasharray: none; }\n"
    "  .plot .cell { fill: #0b57a4; shape-rendering: crispEdges; }\n"
    "  .plot .border, .plot .hatch { stroke: #1b1f24; stroke-width: 2; fill: none; }\n"
    "  .plot .hatch { stroke: #ff8f3f; }\n"
    "  @media screen and (prefers-color-scheme: dark) {\n"
    "    .plot { background: #14171b; color: #e6e9ed; }\n"
    "    .plot .grid { stroke: #2c3239; }\n"
    "    .plot .jump { stroke: #ff8a80; }\n"
    "    .plot .c0 { stroke: #7cb8ff; } .plot .c1 { stroke: #ffb27a; } .plot .c2 { stroke: "
    "#a5d68c; }\n"
    "    .plot .c3 { stroke: #d9a6f0; } .plot .c4 { stroke: #6fd5d9; } .plot .c5 { stroke: "
    "#d7b9a8; }\n"
    "    .plot .cell { fill: #7cb8ff; }\n"
    "    .plot .border { stroke: #e6e9ed; } .plot .hatch { stroke: #d9480f; }\n"
    "  }\n"
    "  @media (max-width: 500px) { .plot { font-size: 22px; } .plot .odd { display: none; } }\n"
    "</style>\n";

std::string tick_label(const char* anchor, std::size_t index, double x, double y, double value,
                       double zero) {
  const std::string attributes =
      std::string(" text-anchor=\"") + anchor + "\"" + (index % 2 == 1 ? " class=\"odd\"" : "");
  return text_element(x, y, number(value, zero), attributes.c_str());
}

} // namespace

std::string text_element(double x, double y, const std::string& text, const char* attributes) {
  return "<text x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\"" + attributes + ">" +
         escaped(text) + "</text>\n";
}

std::string text_lines(double x, double y, const std::string& text, std::size_t letters,
                       double& bottom) {
  std::string elements;
  for (const std::string& line : wrapped(text, letters)) {
    elements += text_element(x, y + 5, line);
    y += line_height;
    bottom += line_height;
  }
  return elements;
}

std::string picture(const std::string& title, const std::string& description, double height,
                    const std::string& body) {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 " +
                     coordinate(width) + " " + coordinate(height) + "\" role=\"img\">\n<title>" +
                     escaped(title) + "</title>\n<desc>" + escaped(description) + "</desc>\n" +
                     style;
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
  return text + "<rect class=\"frame\" x=\"" + coordinate(x.begin) + "\" y=\"" + coordinate(y.end) +
         "\" width=\"" + coordinate(x.end - x.begin) + "\" height=\"" +
         coordinate(y.begin - y.end) + "\"/>\n";
}

double opacity_of(double share) { return 0.06 + 0.94 * share; }

std::string colour_bar(const Axis& x, double y) {
  constexpr int pieces = 40;
  const double piece = (x.end - x.begin) / pieces, bottom = y + colour_bar_height;
  std::string text = "<g class=\"colours\">\n";
  for (int k = 0; k < pieces; ++k)
    text += "<rect class=\"cell\" x=\"" + coordinate(x.begin + k * piece) + "\" y=\"" +
            coordinate(y) + "\" width=\"" + coordinate(piece) + "\" height=\"" +
            coordinate(colour_bar_height) + "\" fill-opacity=\"" +
            coordinate(opacity_of((k + 0.5) / pieces)) + "\"/>\n";
  text += "<rect class=\"frame\" x=\"" + coordinate(x.begin) + "\" y=\"" + coordinate(y) +
          "\" width=\"" + coordinate(x.end - x.begin) + "\" height=\"" +
          coordinate(colour_bar_height) + "\"/>\n";
  std::size_t index = 0;
  for (const double at : ticks(x.low, x.high, 4)) {
    text += line_element("tick", x.at(at), bottom, x.at(at), bottom + 5);
    text += tick_label("middle", index++, x.at(at), bottom + 22, at, 1e-9 * (x.high - x.low));
  }
  return text + "</g>\n";
}

std::string x_axis_label(const std::string& label, double y) {
  return text_element((left + width - right) / 2, y, label, " text-anchor=\"middle\"");
}
double y_label_height(const std::string& label, double tall) {
  constexpr double letter = 11.5; // as wide as the larger ones on a phone are on average
  return letter * static_cast<double>(label.size()) > tall ? line_height + 4 : 0;
}
std::string y_axis_label(const std::string& label, const Axis& y, double top) {
  if (y_label_height(label, y.begin - y.end) > 0)
    return text_element(12, top + line_height / 2 + 5, label);
  return "<text transform=\"translate(20 " + coordinate((y.begin + y.end) / 2) +
         ") rotate(-90)\" text-anchor=\"middle\">" + escaped(label) + "</text>\n";
}

} // namespace lcpush::desktop::plot
