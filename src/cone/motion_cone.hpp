// The motion cone: the planar twists that an object takes from a pusher that sticks to it [T.18].
#pragma once

#include "cone/pusher_cone.hpp"

#include <limits>
#include <optional>

namespace lcpush::desktop {

/// The boundary of the cone between two extreme wrenches of the pusher, both included.
struct ConeArc {
  std::vector<Vector3<double>> twists; ///< unit; neighbours span a flat part of the boundary
};

class MotionCone {
public:
  /// `load`: the weight and what else pulls at the object. Pre: the grip holds it.
  MotionCone(const LimitSurface& grip, PusherCone pusher, const Vector3<double>& load);

  /// For each extreme wrench, where the object goes and with how many N of normal force.
  const std::vector<Crossing>& edges() const { return edges_; }
  /// One a face of the pusher's cone; of a flat one a single arc.
  const std::vector<ConeArc>& arcs() const { return arcs_; }
  const PusherCone& pusher() const { return pusher_; }

  struct Nearest {
    double angle; ///< rad, > 0
    std::size_t arc;
  };
  /// Of the boundary, as seen from a twist.
  Nearest nearest(const Vector3<double>& twist) const;
  /// Does a pusher that moves so stick? A twist on the boundary does.
  bool contains(const Vector3<double>& twist) const;

private:
  const LimitSurface& grip_;
  PusherCone pusher_;
  Vector3<double> load_;
  std::vector<Crossing> edges_;
  std::vector<ConeArc> arcs_;

  void trace(const Vector3<double>& from, const Crossing& begin, const Vector3<double>& to,
             const Crossing& end, int depth, ConeArc& arc) const;
};

/// Of a pusher that presses at one place: that place's velocity, seen between those of the edges.
struct PlaceVerdict {
  bool sticks;
  double angle; ///< rad, >= 0, to the nearer edge
  std::size_t edge;
};
PlaceVerdict judge_at_place(const PusherCone& pusher, const std::vector<Crossing>& edges,
                            const Vector3<double>& twist);

/// From which factor on all grip forces to which one a pusher sticks.
struct GripFactors {
  double least, most = std::numeric_limits<double>::infinity();
};

/// The factors s on a grip's resistance R to a motion with which the pusher sticks: the grip's
/// wrench is in proportion to its force, and s R - load lies in the pusher's cone where it is on
/// the inner side of each of its faces. None: with no grip. Pre: the cone has faces.
std::optional<GripFactors> between_faces(const PusherCone& pusher,
                                         const Vector3<double>& resistance,
                                         const Vector3<double>& load);

/// The factors on all grip forces with which the pusher sticks; none: with no grip.
std::optional<GripFactors> sticking_grips(const LimitSurface& grip, const PusherCone& pusher,
                                          const Vector3<double>& load,
                                          const Vector3<double>& twist);

} // namespace lcpush::desktop
