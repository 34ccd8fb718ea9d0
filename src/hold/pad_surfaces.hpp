// The pads of a hand as surfaces: so many points that those of a few are no longer seen.
#pragma once

#include <vector>

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// The hand with more points in each line, ring, disc and rectangle, weighted as patch.hpp has it:
/// what friction they bear together is the surface's to a thousandth.
SceneFile with_surfaces(const SceneFile& hand);

/// Of a hand with other points of the same bodies: those beside which one touches.
std::vector<bool> touching_beside(const SceneFile& hand, const std::vector<bool>& touching,
                                  const SceneFile& other);

} // namespace lcpush::desktop
