#include "text/format.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace lcpush::desktop {
namespace {

constexpr std::size_t margin = 2; // before each column

std::vector<std::size_t> column_widths(const TableRows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c >= widths.size()) widths.push_back(0);
      widths[c] = std::max(widths[c], text_columns(row[c]));
    }
  return widths;
}

/// The first column and those from `begin` to `end`.
std::string block_text(const TableRows& rows, const std::vector<std::size_t>& widths,
                       std::size_t left, std::size_t begin, std::size_t end) {
  std::string text;
  for (const auto& row : rows) {
    std::string line = std::string(margin, ' ') + row[0];
    line.append(widths[0] - text_columns(row[0]), ' ');
    for (std::size_t c = begin; c < std::min(end, row.size()); ++c) {
      const std::string padding(widths[c] - text_columns(row[c]), ' ');
      line += std::string(margin, ' ') + (c < left ? row[c] + padding : padding + row[c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

} // namespace

std::string in_digits(double x, int digits, double zero) {
  constexpr double too_long = 1e6;
  if (std::abs(x) <= zero) x = 0;
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  const double rounded = std::strtod(text, nullptr), size = std::abs(rounded);
  return size >= std::pow(10, digits) && size < too_long ? printed("%.0f", rounded) : text;
}

std::string brief_within(double x, bool up, double zero) {
  constexpr double rounding = 1e-6; // of the last digit: what six digits leave of a clean number
  if (!(std::abs(x) > zero) || !std::isfinite(x)) return brief(x, zero);
  const double digit = std::pow(10, std::floor(std::log10(std::abs(x))) - 2), count = x / digit;
  return brief((up ? std::ceil(count - rounding) : std::floor(count + rounding)) * digit);
}

std::pair<std::string, std::string> told_apart(double a, double b, double zero) {
  int digits = 3;
  while (digits < std::numeric_limits<double>::max_digits10 &&
         in_digits(a, digits, zero) == in_digits(b, digits, zero))
    ++digits;
  return {in_digits(a, digits, zero), in_digits(b, digits, zero)};
}

std::size_t table_width(const TableRows& rows) {
  std::size_t sum = 0;
  for (const std::size_t width : column_widths(rows)) sum += margin + width;
  return sum;
}

std::string table_text(const TableRows& rows, std::size_t left, std::size_t width) {
  const std::vector<std::size_t> widths = column_widths(rows);
  if (widths.empty()) return "";
  std::string text;
  std::size_t begin = 1;
  do {
    std::size_t end = begin, used = margin + widths[0];
    while (end < widths.size() && (end == begin || used + margin + widths[end] <= width))
      used += margin + widths[end++];
    text += (text.empty() ? "" : "\n") + block_text(rows, widths, left, begin, end);
    begin = end;
  } while (begin < widths.size());
  return text;
}

} // namespace lcpush::desktop
