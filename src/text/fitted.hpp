// Tables that fit, with as many digits as that allows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "text/format.hpp"
#include "text/wrap.hpp"

namespace lcpush::desktop {

/// In so many significant digits, large numbers with zeros behind them instead of an exponent; what
/// is no more than `zero` is 0.
inline std::string in_digits(double x, int digits, double zero = 0) {
  constexpr int longest = 6;
  if (std::abs(x) <= zero) x = 0;
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  const double rounded = std::strtod(text, nullptr);
  if (std::abs(rounded) >= std::pow(10, digits) && std::abs(rounded) < std::pow(10, longest))
    std::snprintf(text, sizeof text, "%.0f", rounded);
  return text;
}

/// As wide as table_text makes it.
inline std::size_t table_width(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c >= widths.size()) widths.push_back(0);
      widths[c] = std::max(widths[c], row[c].size());
    }
  std::size_t sum = 0;
  for (const std::size_t width : widths) sum += 2 + width;
  return sum;
}

/// The first table of make(digits, is_long) that fits: with fewer digits, down to three, then in
/// shorter words.
template <class Make> std::string fitted_table(int most_digits, Make make) {
  for (const bool is_long : {true, false})
    for (int digits = most_digits; digits >= 3; --digits) {
      const auto rows = make(digits, is_long);
      if (table_width(rows) <= usual_width) return table_text(rows);
    }
  return table_text(make(3, false));
}

} // namespace lcpush::desktop
