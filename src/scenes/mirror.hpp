// Planes through the centre of mass in which a scene is its own mirror image.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <vector>

namespace lcpush::desktop {

/// A twist or an acceleration [linear; angular] seen in the mirror across axis 0, 1 or 2.
Vector6<double> mirrored_twist(const Vector6<double>& twist, Index axis);

/// The axes (0, 1, 2 for x, y, z) across which bodies, drives, motions, inertia and weight are
/// their own image. Friction pyramids are taken for cones. Cost: O(points^2) of equal bodies.
std::vector<Index> mirror_axes(const SceneFile& file);

/// Is a scene that is not said to be planar plane by its own symmetry: its image across z, with no
/// normal between z and the plane?
bool is_plane(const SceneFile& file);

} // namespace lcpush::desktop
