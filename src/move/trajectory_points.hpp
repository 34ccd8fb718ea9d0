// The laws that a contact point's force obeys by itself.
#pragma once

#include "lcpush/desktop/trajectory.hpp"
#include "move/trajectory_steps.hpp"

namespace lcpush::desktop {

/// What a frame's numbers are measured by.
struct ForceUnits {
  double force = 0;       ///< N, the largest that acts on the object
  double point_force = 0; ///< N, the largest at a contact point
  double speed = 0;       ///< m/s
  double size = 0;        ///< m, of the object
};

/// N, the larger of normal force and friction.
double force_size(const FrameContact& contact);

/// Point i in a step, which is measured by `units`: one of each law that what is said of it lets
/// judge, without the time.
std::vector<WorstForce> judge_point(const SceneFile& file, Index i, const FrameContact& said,
                                    const SeenContact& seen, double h, const ForceUnits& units);

} // namespace lcpush::desktop
