// What line plots and maps are drawn with.
#pragma once

#include <string>

#include "draw/markup.hpp"

namespace lcpush::desktop::plot {

// In the picture's own units.
constexpr double width = 760, left = 96, right = 38;
constexpr double line_height = 26; // of titles and legends, for letters as large as on a phone
constexpr double axis_room = 64;   // below the last panel
constexpr double panel_gap = 34;
constexpr double lone_panel = 340, one_of_many = 220;

struct Axis {
  double low, high, begin, end; ///< values, and where they stand
  double at(double x) const { return begin + (x - low) / (high - low) * (end - begin); }
};

inline std::string coordinate(double x) { return pixels(x, 3); }
inline std::string line_element(const char* kind, double x1, double y1, double x2, double y2) {
  return desktop::line_element(kind, {x1, y1}, {x2, y2}, 3);
}
/// `attributes` begins with a space, or is empty.
std::string text_element(double x, double y, const std::string& text, const char* attributes = "");

/// In lines of at most so many letters, the first one's middle at y; `bottom` grows by their
/// height.
std::string text_lines(double x, double y, const std::string& text, std::size_t letters,
                       double& bottom);

/// Frame, ticks and their numbers; `grid`: lines across; `numbered`: numbers along x too.
std::string axes(const Axis& x, const Axis& y, bool grid, bool numbered);
/// From pale to full along x, with numbers; what it colours stands above it.
std::string colour_bar(const Axis& x, double y);
constexpr double colour_bar_height = 16, colour_bar_room = 46; // with its numbers
/// How full the colour of a share of the way from the least value to the largest is.
double opacity_of(double share);
std::string x_axis_label(const std::string& label, double y);
/// Beside the axis, or in a line above at `top` where it is longer than the axis.
std::string y_axis_label(const std::string& label, const Axis& y, double top);
double y_label_height(const std::string& label, double tall); ///< of that line

/// The whole picture of this height; `body` begins below the title.
std::string picture(const std::string& title, const std::string& description, double height,
                    const std::string& body);
double title_height(const std::string& title);

} // namespace lcpush::desktop::plot
