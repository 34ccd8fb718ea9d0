// What both reports on sets of answers say: ranges, and whose laws.
#pragma once

#include <array>
#include <cctype>
#include <cmath>
#include <string>

#include "lcpush/desktop/spread.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {

inline std::string end_text(double x, int digits, double zero, bool is_long) {
  if (std::isfinite(x)) return in_digits(x, digits, zero);
  if (!is_long) return x > 0 ? "inf" : "-inf";
  return x > 0 ? "no bound" : "no bound below";
}

/// "20.02", or "8.05 .. 10" if the ends differ by more than `same`.
inline std::string interval_text(const Interval& interval, double same, int digits,
                                 bool is_long = true) {
  if (is_single(interval, same)) return in_digits((interval.low + interval.high) / 2, digits, same);
  return end_text(interval.low, digits, same, is_long) + " .. " +
         end_text(interval.high, digits, same, is_long);
}

/// Infinite ends become null.
inline std::array<double, 2> ends_of(const Interval& interval) {
  return {interval.low, interval.high};
}

/// What is enumerated in place of a round cone, or nothing.
inline std::string pyramid_text(const SceneFile& file) {
  if (!file.is_round) return "";
  return "friction is by pyramids of " + std::to_string(file.facets) + " facets, not round";
}

/// With a capital, and a full stop.
inline std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".\n";
}

} // namespace lcpush::desktop
