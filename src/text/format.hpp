// Numbers, vectors and tables for the text reports.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// `x` as printf writes it.
inline std::string printed(const char* format, double x) {
  char text[60];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// "1 pivot", "2 pivots".
inline std::string counted(Index count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Six significant digits; what rounding left of a zero (below `zero`) is shown as 0.
inline std::string number(double x, double zero = 0) {
  return printed("%.6g", std::abs(x) <= zero ? 0 : x);
}

/// A residual, without the digits that only say how rounding went.
inline std::string residual_text(double residual) {
  return residual < 1e-12 ? "below 1e-12" : printed("%.1e", residual);
}

inline std::string vector_text(const Vector3<double>& v, double zero = 0) {
  return "(" + number(v[0], zero) + ", " + number(v[1], zero) + ", " + number(v[2], zero) + ")";
}

/// Columns as wide as their widest cell; the first `left` are flushed left, the others right.
inline std::string table_text(const std::vector<std::vector<std::string>>& rows,
                              std::size_t left = 1) {
  std::vector<std::size_t> width;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c >= width.size()) width.push_back(0);
      width[c] = std::max(width[c], row[c].size());
    }
  std::string text;
  for (const auto& row : rows) {
    text += "  ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string padding(width[c] - row[c].size(), ' ');
      text += (c > 0 ? "  " : "") + (c < left ? row[c] + padding : padding + row[c]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

} // namespace lcpush::desktop
