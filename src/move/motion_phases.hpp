// What a run of steps is made of: parts that one word describes, and jumps of the push.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

/// A step of h: what it did is `motion`, in words of the instant.
MotionPhase phase_of(const Motion<double>& motion, const MotionFrame& end, double h);

/// Neighbours of one kind become one; what is over at once, or moves the object by next to nothing
/// of `size`, goes to its neighbour.
std::vector<MotionPhase> merged_phases(std::vector<MotionPhase> phases, double size);

/// Where the push force falls or rises at once though no contact comes or goes: one step of a run
/// looks like any other, so a jump is known by its neighbours.
class ForceJumps {
public:
  /// The next step: from `time` on, `h` seconds, `force` newtons on average.
  void add(double time, double h, double force);
  std::vector<ForceJump> take() { return std::move(found_); }

private:
  struct Step {
    double time = 0, h = 0, force = 0, rate = 0; ///< rate: N/s, of the change to this step
  };
  Step last_[2];
  Index steps_ = 0;
  double largest_ = 0;
  std::vector<ForceJump> found_;
};

} // namespace lcpush::desktop
