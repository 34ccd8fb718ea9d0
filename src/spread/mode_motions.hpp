// How the object and the actuators may move while each contact keeps its mode: by geometry alone,
// forces left aside. The scene's motions form a cone over (motion, push).
#pragma once

#include "spread/spread_problem.hpp"

namespace lcpush::desktop {

struct ModeMotions {
  bool possible = true; ///< false: with a push the equations contradict each other
  bool distinct = true; ///< false: an equation or sign makes one of the modes another one
  Eigen::MatrixXd span; ///< x = span y; y: some of x's own entries, the push last
  /// Of the modes: signs y >= 0, each of length 1, without those that always hold.
  Eigen::MatrixXd signs;
  std::vector<bool> strict; ///< a sign that is 0 in another mode only: a gap, a slip, a direction
};

/// `own`: only to ask has_own_motion, so that a contradiction ends the work.
ModeMotions motions_of(const LiteralProblem& problem, const FaceModes& modes, bool own = false);

/// Is there a motion with this push with which no strict sign is 0? Then no other modes have it.
bool has_own_motion(const ModeMotions& motions, double& work);

} // namespace lcpush::desktop
