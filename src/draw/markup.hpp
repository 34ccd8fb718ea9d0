// The few elements of SVG that pictures are made of.
#pragma once

#include <string>
#include <vector>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// A place on a drawing, y down.
using Pixel = Eigen::Vector2d;

struct Frame {
  double left, top, right, bottom;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// Fit for the text and the attributes of XML and HTML. What XML cannot hold becomes U+FFFD.
std::string escaped(const std::string& text);

/// As an address carries it: letters, digits and the characters of `plain` stay.
std::string percent_encoded(const std::string& text, const char* plain);

/// At most so many letters, the last two dots if some are left out. Precondition: UTF-8.
std::string shortened(const std::string& text, std::size_t most);

/// A length on the drawing.
std::string pixels(double x, int decimals = 2);
/// A stroke of a path that draws nothing: "M1.00 2.00".
std::string move_to(const Pixel& at);

std::string line_element(const std::string& kind, const Pixel& from, const Pixel& to,
                         int decimals = 2);
std::string polygon_element(const std::string& kind, const std::vector<Pixel>& corners);
std::string circle_element(const std::string& kind, const Pixel& center, double radius);
/// A path of one stroke after the other.
std::string path_element(const std::string& kind, const std::string& strokes);
/// `anchor`: "start", "middle" or "end" of the text stands at the place.
std::string text_element(const std::string& kind, const Pixel& at, const std::string& text,
                         const std::string& anchor = "start");
/// A stroke with a head of its own, so that no colour is needed to see its end; nothing if it is
/// shorter than 2.5.
std::string arrow_element(const std::string& kind, const Pixel& from, const Pixel& to,
                          double longest_head = 9);

/// Elements, moved.
std::string shifted(const std::string& elements, const Pixel& by);

/// A picture before it is written as SVG.
struct Drawing {
  std::string name, title, description;
  double width = 420, height = 300;
  std::string elements;
  double top = 0; ///< where its upper edge lies
};

/// An element for a page that has palette(":root") and drawing_style() once; or with its own
/// `style`, an element too.
std::string svg_element(const Drawing& drawing, const std::string& style = "");
/// A document of its own.
std::string svg_document(const Drawing& drawing);

/// The colours as CSS variables of `selector`, in light and in dark.
std::string palette(const std::string& selector);
std::string drawing_style();
/// What pages that draw by themselves begin their scripts with: script/, embedded.
std::string drawing_script();

} // namespace lcpush::desktop
