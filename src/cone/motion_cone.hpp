// The motion cone: the planar twists that an object takes from a pusher that sticks to it [T.18].
#pragma once

#include "cone/pusher_cone.hpp"

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

} // namespace lcpush::desktop
