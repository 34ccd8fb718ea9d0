// The planar wrenches that a pusher can exert without slipping, and a scene as one of the plane: is
// it one, and what pulls at the object there?
#pragma once

#include "cone/limit_surface.hpp"

namespace lcpush::desktop {

/// An extreme wrench of a pusher: one of its points alone presses, at the limit of its friction.
struct ExtremeWrench {
  Index point;            ///< of the scene
  double side;            ///< 1 or -1: friction along z x n, or against it
  Vector3<double> wrench; ///< planar; its normal force is 1 N
  Vector3<double> force;  ///< the same in space, N
};

/// What is about to happen between two neighbouring extreme wrenches.
struct ConeFace {
  std::size_t from, to;   ///< of PusherCone::edges
  Vector3<double> inward; ///< a wrench inside has a product >= 0 with it
  bool is_slip;           ///< else one point alone presses, and the object turns off the others
};

/// The cone of all sums of its points' forces within their friction cones.
struct PusherCone {
  std::vector<ExtremeWrench> edges; ///< around the cone
  std::vector<ConeFace> faces;      ///< none if the cone is flat: it presses at one place
  Vector3<double> along;            ///< z x n

  /// Is the wrench one that the pusher can exert? Least product with a face, over its size; 0: a
  /// flat cone has no inside.
  double room(const Vector3<double>& wrench) const;
};

/// Pre: the pusher's normal lies in the plane, and it has friction.
PusherCone pusher_cone(const SceneFile& file, Index pusher, double length);

/// Throws InputError where motions in the plane change what the fingers press with, or the pusher
/// has no cone.
void refuse_no_cone(const SceneFile& file, Index pusher);
/// Throws InputError where the fingers resist no turning.
void refuse_single_place(const SceneFile& file, const LimitSurface& grip);

/// The weight and what else pulls at the object, a planar wrench.
Vector3<double> planar_load(const SceneFile& file, double length);
/// m, from the centre of mass to the farthest contact point in the plane.
double planar_reach(const SceneFile& file);

} // namespace lcpush::desktop
