// Line plots and maps as SVG that any browser shows, in light and in dark, and that screen readers
// can read out.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace lcpush::desktop {

struct PlotLine {
  std::string label;
  /// Pieces that are drawn without a stroke in between, each a list of (x, y).
  std::vector<std::vector<std::pair<double, double>>> pieces;
  bool dots = false;      ///< a mark at every point
  std::size_t colour = 0; ///< lines of one colour belong together
};

/// One quantity's axes; panels stand above each other over the same x.
struct PlotPanel {
  std::string y_label;
  std::vector<PlotLine> lines;
  bool nested = false; ///< lines coincide somewhere: earlier ones are drawn wider
};

/// The least and the largest value of a panel's lines, zero included.
std::pair<double, double> value_range(const PlotPanel& panel);

/// A vertical stroke with a number, which a list below the plot explains.
struct PlotMark {
  double x;
  std::string place; ///< "6.52 N"
  std::string text;  ///< what happens there
  bool strong = false;
};

struct Plot {
  std::string title, description, x_label;
  double x_from = 0, x_to = 1;
  std::vector<PlotPanel> panels;
  std::vector<PlotMark> marks; ///< numbered in this order
};

std::string plot_svg(const Plot& plot);

/// Where the first panel's axes begin and end, from the top, in parts of the plot's width.
std::pair<double, double> first_axes(const Plot& plot);

/// A map: cells of equal size, row by row from below; a cell that is not finite stays empty.
struct MapPlot {
  std::string title, description, x_label, y_label, value_label;
  double x_from = 0, x_to = 1, y_from = 0, y_to = 1;
  std::size_t columns = 0;
  std::vector<double> cells;
  std::vector<std::string> texts;               ///< shown when pointed at
  std::vector<bool> hatched;                    ///< cells that are hatched; empty: none
  std::string hatch_label;                      ///< what that means
  std::vector<bool> border_right, border_above; ///< of each cell; empty: none
  std::string border_label;                     ///< what a border means
};

std::string map_svg(const MapPlot& plot);

/// A plot that stands in its document's own style, which would reach the whole page otherwise.
/// `words`: for those who do not see it.
std::string plot_image(const std::string& svg, const std::string& words);

} // namespace lcpush::desktop
