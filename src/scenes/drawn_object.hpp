// What every picture of a scene draws: the object as a prism, and its contacts on that.
#pragma once

#include "draw/prism.hpp"
#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// The object; its box where the scene gives an inertia alone.
Prism object_prism(const SceneFile& file);
/// Is it a circle in a view along an axis?
bool is_round_in(const View& view, const ObjectShape& shape);
/// Where contact points are drawn: one that is taken at the object's centre stands on its surface,
/// so that its body is seen beside the object.
std::vector<Vector3<double>> drawn_positions(const SceneFile& file);

} // namespace lcpush::desktop
