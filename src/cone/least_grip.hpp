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

/// The least factor s on a grip's resistance R to a motion with which the pusher sticks: the grip's
/// wrench is in proportion to its force, and s R - load lies in the pusher's cone where it is on
/// the inner side of each of its faces. None: with no grip. Pre: the cone has faces.
std::optional<double> least_of_faces(const PusherCone& pusher, const Vector3<double>& resistance,
                                     const Vector3<double>& load);

/// The least factor on all grip forces with which the pusher sticks; none: with no grip.
std::optional<double> least_grip(const LimitSurface& grip, const PusherCone& pusher,
                                 const Vector3<double>& load, const Vector3<double>& twist);

} // namespace lcpush::desktop
