#include "draw/markup.hpp"

#include "text/utf8.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace lcpush::desktop {
namespace {

std::string attribute(const char* name, double x, int decimals = 2) {
  return std::string(" ") + name + "=\"" + pixels(x, decimals) + "\"";
}

} // namespace

std::string escaped(const std::string& text) {
  constexpr std::string_view special = "<>&\"'\n", replacement = "\xEF\xBF\xBD";
  constexpr const char* entities[] = {"&lt;", "&gt;", "&amp;", "&quot;", "&#39;", "&#10;"};
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const std::string_view three = std::string_view(text).substr(i, 3);
    if (const std::size_t k = special.find(c); k != std::string_view::npos) {
      result += entities[k];
    } else if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") { // no characters
      result += replacement;
      i += 2;
    } else if ((c >= 0 && c < 0x20 && c != '\t') || c == 0x7F) {
      result += replacement;
    } else {
      result += c;
    }
  }
  return result;
}

std::string percent_encoded(const std::string& text, const char* plain) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') ||
                          std::string_view(plain).find(c) != std::string_view::npos;
    if (is_plain)
      encoded += c;
    else
      (((encoded += '%') += digits[byte >> 4U]) += digits[byte & 15U]);
  }
  return encoded;
}

std::string shortened(const std::string& text, std::size_t most) {
  std::size_t letters = 0, cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (continues_character(text[i])) continue;
    if (letters == most - 2) cut = i;
    ++letters;
  }
  return letters > most ? text.substr(0, cut) + ".." : text;
}

std::string pixels(double x, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, x);
  return text;
}

std::string move_to(const Pixel& at) { return "M" + pixels(at.x()) + " " + pixels(at.y()); }

std::string line_element(const std::string& kind, const Pixel& from, const Pixel& to,
                         int decimals) {
  return "<line class=\"" + kind + "\"" + attribute("x1", from.x(), decimals) +
         attribute("y1", from.y(), decimals) + attribute("x2", to.x(), decimals) +
         attribute("y2", to.y(), decimals) + "/>\n";
}

std::string polygon_element(const std::string& kind, const std::vector<Pixel>& corners) {
  std::string points;
  for (const Pixel& p : corners)
    points += (points.empty() ? "" : " ") + pixels(p.x()) + "," + pixels(p.y());
  return "<polygon class=\"" + kind + "\" points=\"" + points + "\"/>\n";
}

std::string circle_element(const std::string& kind, const Pixel& center, double radius) {
  return "<circle class=\"" + kind + "\"" + attribute("cx", center.x()) +
         attribute("cy", center.y()) + attribute("r", radius) + "/>\n";
}

std::string path_element(const std::string& kind, const std::string& strokes) {
  return "<path class=\"" + kind + "\" d=\"" + strokes + "\"/>\n";
}

std::string text_element(const std::string& kind, const Pixel& at, const std::string& text,
                         const std::string& anchor) {
  return (kind.empty() ? "<text" : "<text class=\"" + kind + "\"") + attribute("x", at.x()) +
         attribute("y", at.y()) + (anchor == "start" ? "" : " text-anchor=\"" + anchor + "\"") +
         ">" + escaped(text) + "</text>\n";
}

std::string arrow_element(const std::string& kind, const Pixel& from, const Pixel& to,
                          double longest_head) {
  const double size = (to - from).norm();
  if (size < 2.5) return "";
  const Pixel along = (to - from) / size, across(-along.y(), along.x());
  const double head = std::min(longest_head, 0.6 * size);
  const Pixel back = to - head * along;
  return "<g class=\"" + kind + "\">" + line_element("shaft", from, back) +
         polygon_element("head", {to, back + 0.42 * head * across, back - 0.42 * head * across}) +
         "</g>\n";
}

std::string shifted(const std::string& elements, const Pixel& by) {
  return "<g transform=\"translate(" + pixels(by.x()) + " " + pixels(by.y()) + ")\">" + elements +
         "</g>\n";
}

std::string svg_element(const Drawing& drawing, const std::string& style) {
  // A title and a description as children name the image; ids would have to differ on a page.
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" viewBox=\"0 " +
         pixels(drawing.top) + " " + pixels(drawing.width) + " " + pixels(drawing.height) +
         "\" role=\"img\">\n<title>" + escaped(drawing.title) + "</title>\n<desc>" +
         escaped(drawing.description) + "</desc>\n" + style + drawing.elements + "</svg>\n";
}

std::string svg_document(const Drawing& drawing) {
  return svg_element(drawing, "<style>\n" + palette(".drawing") + drawing_style() + "</style>\n");
}

} // namespace lcpush::desktop
