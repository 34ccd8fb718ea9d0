#include "cone/motion_cone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr double same_twist = 1e-9, drawn_finely = 1e-2; // rad
constexpr int most_halvings = 64;

double angle_between(const Vector3<double>& a, const Vector3<double>& b) {
  return std::atan2(cross<double>(a, b).norm(), a.dot(b));
}

/// From a twist to the shorter arc of a great circle between two others.
double angle_to_arc(const Vector3<double>& v, const Vector3<double>& a, const Vector3<double>& b) {
  const Vector3<double> n = cross<double>(a, b);
  const double ends = std::min(angle_between(v, a), angle_between(v, b));
  if (!(n.norm() > 1e-14)) return ends;
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
  const double finest = grip_.is_round() ? drawn_finely : same_twist;
  if (depth > most_halvings || angle_between(begin.twist, end.twist) < finest) return;
  Eigen::Matrix2d tangents;
  tangents << begin.twist.dot(from), begin.twist.dot(to), end.twist.dot(from), end.twist.dot(to);
  const Eigen::Vector2d limits(begin.force, end.force);
  const Eigen::Vector2d meeting = solved(tangents, limits);
  if (!meeting.allFinite()) return; // parallel: both are the curve's own line
  const double share = meeting[1] / meeting.sum();
  if (!(share > 1e-12 && share < 1 - 1e-12)) return;
  const Vector3<double> between = (1 - share) * from + share * to;
  const Crossing middle = grip_.crossing(load_, between);
  if (middle.force >= meeting.sum() * (1 - 1e-10)) return;
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
  if (nearest(twist).angle < same_twist) return true;
  return pusher_.room(grip_.resistance(beside(twist)) - load_) >= 0;
}

} // namespace lcpush::desktop
