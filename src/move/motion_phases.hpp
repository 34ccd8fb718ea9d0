// What a run of steps is made of: parts that one word describes, and jumps of the push.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

/// What a step did that goes on as the last one, or as `begin` and `end` differ.
MotionPhase phase_of(MotionKind kind, const MotionFrame& end);
MotionPhase phase_of(MotionKind kind, const MotionFrame& begin, const MotionFrame& end);

/// A run's phases from those of its steps: neighbours of one kind become one; what is over at once,
/// or moves the object by next to nothing of `size`, goes to its neighbour.
class Phases {
public:
  explicit Phases(double size) : size_(size) {}
  void add(const MotionPhase& step);
  std::vector<MotionPhase> take();

private:
  double size_;
  std::vector<MotionPhase> phases_;
};

/// Where the push force falls or rises at once though no contact comes or goes: one step of a run
/// looks like any other, so a jump is known by its neighbours.
class ForceJumps {
public:
  /// The next step: from `time` on, `h` seconds, `force` newtons on average beside others of up to
  /// `others`, whose rounding is no jump.
  void add(double time, double h, double force, double others);
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
