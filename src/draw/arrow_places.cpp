#include "draw/arrow_places.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double step_aside = 7, widest_head = 11; // pixels
constexpr double crossing = 0.3;                   // the least sine of the angle
constexpr int most_steps = 3;                      // farther off it would be another arrow

} // namespace

bool ArrowPlaces::lies_on_one(const Pixel& from, const Pixel& to) const {
  const double length = (to - from).norm();
  const Pixel along = (to - from) / length, across(-along.y(), along.x());
  const auto lies_on = [&](const std::pair<Pixel, Pixel>& other) {
    const Pixel whole = other.second - other.first;
    if (!(whole.norm() > 0) || std::abs(across.dot(whole)) > crossing * whole.norm()) return false;
    const double a = along.dot(other.first - from), b = along.dot(other.second - from);
    if (std::min(a, b) > length || std::max(a, b) < 0) return false;
    const double aside = std::min(std::abs(across.dot(other.first - from)),
                                  std::abs(across.dot(other.second - from)));
    return aside < widest_head;
  };
  return std::any_of(drawn_.begin(), drawn_.end(), lies_on);
}

Pixel ArrowPlaces::clear_start(const Pixel& from, const Pixel& to) const {
  const Pixel along = to - from;
  if (!(along.norm() > 0)) return from;
  const Pixel across = Pixel(-along.y(), along.x()).normalized();
  for (int k = 0; k <= most_steps; ++k)
    for (const double side : {1.0, -1.0}) {
      const Pixel start = from + side * k * step_aside * across;
      if (!lies_on_one(start, start + along)) return start;
    }
  return from;
}

} // namespace lcpush::desktop
