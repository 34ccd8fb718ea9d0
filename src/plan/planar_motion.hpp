// Motions in the plane with one twist, from one pose to another.
#pragma once

#include "cone/limit_surface.hpp"
#include "lcpush/desktop/plan.hpp"

#include <cmath>

namespace lcpush::desktop {

using Planar = Eigen::Vector2d;

inline Planar place_of(const PlanarPose& pose) { return {pose.x, pose.y}; }

inline Planar turned(const Planar& v, double angle) {
  return turned(Vector3<double>(v.x(), v.y(), 0), angle).head<2>();
}
inline PlanarPose pose_at(const Planar& place, double angle) {
  return {place.x(), place.y(), angle};
}

/// A constant twist that takes one pose to another in a unit of time.
class Arc {
public:
  Arc(const PlanarPose& from, const PlanarPose& to) : from_(from), turn_(to.angle - from.angle) {
    const Planar way = place_of(to) - place_of(from);
    // The centre's velocity at the begin; over the way it turns with the object, so that its mean
    // is shorter by the chord of the turn.
    begin_ = turned(way, -turn_ / 2) / chord(turn_ / 2);
  }

  /// That begins with this velocity, in units of its time.
  Arc(const PlanarPose& from, const Planar& velocity, double turn)
      : from_(from), turn_(turn), begin_(velocity) {}

  double turn() const { return turn_; }
  /// The velocity of the centre of mass at a share of the way.
  Planar velocity(double share) const { return turned(begin_, share * turn_); }
  PlanarPose at(double share) const {
    const double half = share * turn_ / 2;
    const Planar way = share * chord(half) * turned(begin_, half);
    return {from_.x + way.x(), from_.y + way.y(), from_.angle + 2 * half};
  }

private:
  /// Of an arc over twice this angle, over its length.
  static double chord(double half) {
    return std::abs(half) < 1e-6 ? 1 - half * half / 6 : std::sin(half) / half;
  }

  PlanarPose from_;
  double turn_;
  Planar begin_;
};

} // namespace lcpush::desktop
