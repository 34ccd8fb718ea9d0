// Do a motion's forces obey the laws of its steps? From the scene and the frames alone.
#pragma once

#include "lcpush/desktop/trajectory.hpp"

namespace lcpush::desktop {

/// None: no frame says anything of forces. Cost: O(frames points).
std::optional<ForceReport> judge_forces(const SceneFile& file,
                                        const std::vector<TrajectoryFrame>& frames);

} // namespace lcpush::desktop
