#include "cone/motion_cone.hpp"
#include "cone/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lcpush::desktop {
namespace {

double angle_between(const Vector3<double>& a, const Vector3<double>& b) {
  return std::atan2(cross<double>(a, b).norm(), a.dot(b));
}

/// From a twist to the shorter arc of a great circle between two others.
double angle_to_arc(const Vector3<double>& v, const Vector3<double>& a, const Vector3<double>& b) {
  const Vector3<double> n = cross<double>(a, b);
  const double ends = std::min(angle_between(v, a), angle_between(v, b));
  if (!(n.norm() > cone_settings.parallel)) return ends;
  const Vector3<double> foot = v - n * (n.dot(v) / n.squaredNorm());
  const bool is_between = cross<double>(a, foot).dot(n) > 0 && cross<double>(foot, b).dot(n) > 0;
  return is_between ? std::min(ends, angle_between(v, foot)) : ends;
}

} // namespace

MotionCone::MotionCone(const LimitSurface& grip, PusherCone pusher, const Vector3<double>& load)
    : grip_(grip), pusher_(std::move(pusher)), load_(load) {
  for (const ExtremeWrench& edge : pusher_.edges)
    edges_.push_back(grip.crossing(load, edge.wrench));
  const auto add = [&](std::size_t a, std::size_t b) {
    ConeArc arc{{edges_[a].twist.normalized()}};
    trace(pusher_.edges[a].wrench, edges_[a], pusher_.edges[b].wrench, edges_[b], 0, arc);
    arc.twists.push_back(edges_[b].twist.normalized());
    arcs_.push_back(std::move(arc));
  };
  for (const ConeFace& face : pusher_.faces) add(face.from, face.to);
  if (pusher_.faces.empty() && edges_.size() == 2) add(0, 1);
}

// In the plane through the load and two wrenches, the grip's limit is a convex curve, of which each
// crossing gives a point and its tangent. Where two tangents meet, the curve is either met as well,
// and they are neighbours, or it turns in between.
void MotionCone::trace(const Vector3<double>& from, const Crossing& begin,
                       const Vector3<double>& to, const Crossing& end, int depth,
                       ConeArc& arc) const {
  const double finest = grip_.is_round() ? cone_settings.drawn_finely : cone_settings.same_twist;
  if (depth > cone_settings.most_halvings || angle_between(begin.twist, end.twist) < finest) return;
  Eigen::Matrix2d tangents;
  tangents << begin.twist.dot(from), begin.twist.dot(to), end.twist.dot(from), end.twist.dot(to);
  const Eigen::Vector2d limits(begin.force, end.force);
  const Eigen::Vector2d meeting = solved(tangents, limits);
  // It turns by more than half a turn: the tangents meet behind it, or never.
  const bool turns_back =
      begin.twist.dot(end.twist) < 0 && !(meeting.allFinite() && meeting.minCoeff() > 0);
  if (!turns_back && !meeting.allFinite()) return; // parallel: both are the curve's own line
  const double share = turns_back ? end.force / limits.sum() : meeting[1] / meeting.sum();
  if (!(share > cone_settings.share && share < 1 - cone_settings.share)) return;
  const Vector3<double> between = (1 - share) * from + share * to;
  const Crossing middle = grip_.crossing(load_, between);
  if (!turns_back && middle.force >= meeting.sum() * (1 - cone_settings.same_line)) return;
  trace(from, begin, between, middle, depth + 1, arc);
  arc.twists.push_back(middle.twist.normalized());
  trace(between, middle, to, end, depth + 1, arc);
}

MotionCone::Nearest MotionCone::nearest(const Vector3<double>& twist) const {
  Nearest nearest{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t k = 0; k < arcs_.size(); ++k)
    for (std::size_t i = 0; i + 1 < arcs_[k].twists.size(); ++i)
      if (const double angle = angle_to_arc(twist, arcs_[k].twists[i], arcs_[k].twists[i + 1]);
          angle < nearest.angle)
        nearest = {angle, k};
  return nearest;
}

bool MotionCone::contains(const Vector3<double>& twist) const {
  if (nearest(twist).angle < cone_settings.same_twist) return true;
  return pusher_.room(grip_.resistance(beside(twist)) - load_) >= 0;
}

namespace {

/// By bisection, between the grip that just holds the load and one beside which it counts little.
std::optional<double> least_at_place(const LimitSurface& grip, const PusherCone& pusher,
                                     const Vector3<double>& load, const Vector3<double>& twist) {
  const auto sticks = [&](double factor) {
    std::vector<Crossing> edges;
    for (const ExtremeWrench& edge : pusher.edges)
      edges.push_back(grip.crossing(load / factor, edge.wrench));
    return judge_at_place(pusher, edges, twist).sticks;
  };
  const double holding = grip.share_of(load);
  if (holding == 0) return sticks(1) ? std::optional<double>(0) : std::nullopt;
  double slips = holding, factor = holding * (1 + cone_settings.beside_holding);
  while (!sticks(factor)) {
    slips = factor;
    if (factor > cone_settings.grip_most * holding) return std::nullopt;
    factor *= cone_settings.grip_step;
  }
  while (factor - slips > cone_settings.grip_found * factor) {
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

std::optional<GripFactors> between_faces(const PusherCone& pusher,
                                         const Vector3<double>& resistance,
                                         const Vector3<double>& load) {
  GripFactors sticks{0};
  for (const ConeFace& face : pusher.faces) {
    const double by_grip = face.inward.dot(resistance), by_load = face.inward.dot(load);
    if (by_grip > 0)
      sticks.least = std::max(sticks.least, by_load / by_grip);
    else if (by_grip < 0)
      sticks.most = std::min(sticks.most, by_load / by_grip);
    else if (by_load > 0)
      return std::nullopt;
  }
  return sticks.least <= sticks.most && sticks.most > 0 ? std::optional(sticks) : std::nullopt;
}

std::optional<GripFactors> sticking_grips(const LimitSurface& grip, const PusherCone& pusher,
                                          const Vector3<double>& load,
                                          const Vector3<double>& twist) {
  if (!pusher.faces.empty()) return between_faces(pusher, grip.resistance(beside(twist)), load);
  const std::optional<double> least = least_at_place(grip, pusher, load, twist);
  return least ? std::optional(GripFactors{*least}) : std::nullopt;
}

} // namespace lcpush::desktop
