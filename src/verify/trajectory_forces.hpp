// Do a motion's forces obey the laws of its steps? From the scene and the frames alone.
#pragma once

#include "lcpush/desktop/trajectory.hpp"
#include "verify/trajectory_steps.hpp"

namespace lcpush::desktop {

/// None: no frame says anything of forces. Cost: O(frames points).
std::optional<ForceReport> judge_forces(const SceneFile& file,
                                        const std::vector<TrajectoryFrame>& frames);

/// What a frame's numbers are measured by.
struct ForceUnits {
  double force = 0;       ///< N, the largest that acts on the object
  double point_force = 0; ///< N, the largest at a contact point
  double speed = 0;       ///< m/s
  double size = 0;        ///< m, of the object
};

/// N, the larger of normal force and friction.
double force_size(const FrameContact& contact);

/// The laws that point i's force obeys by itself in a step, measured by `units`: one of each law
/// that what is said of it lets judge, without the time.
std::vector<WorstForce> judge_point(const SceneFile& file, Index i, const FrameContact& said,
                                    const SeenContact& seen, double h, const ForceUnits& units);

} // namespace lcpush::desktop
