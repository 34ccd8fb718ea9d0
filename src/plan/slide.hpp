// Where a push ends in which the object may slip over the pusher: `move` says it.
#pragma once

#include "plan/roadmap.hpp"

namespace lcpush::desktop {

/// `body` is the scene's that pushes. None: the motion ends before its time.
std::optional<PlanarPose> slid(const SceneFile& file, Index body, const PlanarPose& from,
                               const Slip& slip);

} // namespace lcpush::desktop
