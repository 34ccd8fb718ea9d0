// Does a pusher that moves so stick, by how much, and from which grip force on?
#pragma once

#include "cone/motion_cone.hpp"

namespace lcpush::desktop {

/// Of a pusher that presses at one place: that place's velocity, seen between those of the edges.
struct PlaceVerdict {
  bool sticks;
  double angle; ///< rad, >= 0, to the nearer edge
  std::size_t edge;
};
PlaceVerdict judge_at_place(const PusherCone& pusher, const std::vector<Crossing>& edges,
                            const Vector3<double>& twist);

/// The least factor on all grip forces with which the pusher sticks; none: with no grip.
std::optional<double> least_grip(const LimitSurface& grip, const PusherCone& pusher,
                                 const Vector3<double>& load, const Vector3<double>& twist);

} // namespace lcpush::desktop
