// Numbers, vectors and tables for the text reports.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "lcpush/types.hpp"
#include "text/wrap.hpp"

namespace lcpush::desktop {

/// `x` as printf writes it.
inline std::string printed(const char* format, double x) {
  const int length = std::snprintf(nullptr, 0, format, x);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::snprintf(text.data(), text.size() + 1, format, x);
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

/// In so many significant digits, whole numbers below a million without an exponent; what is no
/// more than `zero` is 0.
std::string in_digits(double x, int digits, double zero = 0);

/// In three digits.
inline std::string brief(double x, double zero = 0) { return in_digits(x, 3, zero); }
/// In three digits, none below `x` (`up`) or none above it but for rounding: a bound stays true.
std::string brief_within(double x, bool up, double zero = 0);
/// Two numbers that differ, in as many digits as show it, three or more.
std::pair<std::string, std::string> told_apart(double a, double b, double zero = 0);

constexpr double millimetres_a_metre = 1000;
constexpr double degrees_a_radian = 180 / 3.14159265358979323846;
/// "30 mm".
inline std::string millimetres(double metres) {
  return brief(millimetres_a_metre * metres) + " mm";
}

/// A residual, without the digits that only say how rounding went.
inline std::string residual_text(double residual) {
  return residual < 1e-12 ? "below 1e-12" : printed("%.1e", residual);
}

inline std::string vector_text(const Vector3<double>& v, double zero = 0) {
  return "(" + number(v[0], zero) + ", " + number(v[1], zero) + ", " + number(v[2], zero) + ")";
}

using TableRows = std::vector<std::vector<std::string>>;

/// Columns as wide as their widest cell; the first `left` are flushed left, the others right.
/// Columns beyond `width` go on below, behind the first one again.
std::string table_text(const TableRows& rows, std::size_t left = 1,
                       std::size_t width = usual_width);

/// As wide as table_text makes it, on one line.
std::size_t table_width(const TableRows& rows);

/// The first table of make(digits, is_long) that fits: with fewer digits, down to three, then in
/// shorter words.
template <class Make> std::string fitted_table(int most_digits, Make make) {
  for (const bool is_long : {true, false})
    for (int digits = most_digits; digits >= 3; --digits) {
      const TableRows rows = make(digits, is_long);
      if (table_width(rows) <= usual_width) return table_text(rows);
    }
  return table_text(make(3, false));
}

} // namespace lcpush::desktop
