// Where the push force falls or rises at once though no contact comes or goes: one step of a run
// looks like any other, so a jump is told by its neighbours.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

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
