#include "cone/least_grip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

/// By bisection, between the grip that just holds the load and one beside which it counts little.
std::optional<double> least_at_place(const LimitSurface& grip, const PusherCone& pusher,
                                     const Vector3<double>& load, const Vector3<double>& twist) {
  constexpr double enough = 1e4, step = 1.25;
  const auto sticks = [&](double factor) {
    std::vector<Crossing> edges;
    for (const ExtremeWrench& edge : pusher.edges)
      edges.push_back(grip.crossing(load / factor, edge.wrench));
    return judge_at_place(pusher, edges, twist).sticks;
  };
  const double holding = grip.share_of(load);
  if (holding == 0) return sticks(1) ? std::optional<double>(0) : std::nullopt;
  double slips = holding, factor = holding * (1 + 1e-9);
  while (!sticks(factor)) {
    slips = factor;
    if (factor > enough * holding) return std::nullopt;
    factor *= step;
  }
  while (factor - slips > 1e-12 * factor) {
    const double middle = (slips + factor) / 2;
    if (!(middle > slips && middle < factor)) break;
    (sticks(middle) ? factor : slips) = middle;
  }
  return factor;
}

} // namespace

PlaceVerdict judge_at_place(const PusherCone& pusher, const std::vector<Crossing>& edges,
                            const Vector3<double>& twist) {
  // The powers of its two extreme forces are the velocity of the place: forces n + mu t, n - mu t.
  const auto velocity = [&](const Vector3<double>& v) {
    const double a = v.dot(pusher.edges[0].wrench), b = v.dot(pusher.edges[1].wrench);
    const double mu = (pusher.edges[0].force - pusher.edges[1].force).norm() / 2;
    return Eigen::Vector2d((a + b) / 2, pusher.edges[0].side * (a - b) / (2 * mu));
  };
  const auto angle = [&](const Vector3<double>& v) {
    const Eigen::Vector2d c = velocity(v);
    return std::atan2(c[1], c[0]); // 0: straight along the normal
  };
  const std::size_t first = pusher.edges[0].side < 0 ? 0 : 1, last = 1 - first;
  const double at = angle(twist);
  const double above = at - angle(edges[first].twist), below = angle(edges[last].twist) - at;
  const bool is_first = std::abs(above) <= std::abs(below);
  return {above >= 0 && below >= 0, std::abs(is_first ? above : below), is_first ? first : last};
}

std::optional<double> least_of_faces(const PusherCone& pusher, const Vector3<double>& resistance,
                                     const Vector3<double>& load) {
  double least = 0, most = std::numeric_limits<double>::infinity();
  for (const ConeFace& face : pusher.faces) {
    const double by_grip = face.inward.dot(resistance), by_load = face.inward.dot(load);
    if (by_grip > 0)
      least = std::max(least, by_load / by_grip);
    else if (by_grip < 0)
      most = std::min(most, by_load / by_grip);
    else if (by_load > 0)
      return std::nullopt;
  }
  return least <= most && most > 0 ? std::optional<double>(least) : std::nullopt;
}

std::optional<double> least_grip(const LimitSurface& grip, const PusherCone& pusher,
                                 const Vector3<double>& load, const Vector3<double>& twist) {
  if (pusher.faces.empty()) return least_at_place(grip, pusher, load, twist);
  return least_of_faces(pusher, grip.resistance(beside(twist)), load);
}

} // namespace lcpush::desktop
