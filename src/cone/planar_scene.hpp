// A scene as one of the plane: is it one, and what pulls at the object there?
#pragma once

#include "cone/limit_surface.hpp"

namespace lcpush::desktop {

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
