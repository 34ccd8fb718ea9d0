#include "move/force_jumps.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// Less than this part of the force is no jump, nor is what is next to nothing in the whole motion.
constexpr double least_jump = 0.1, worth_a_jump = 1e-3;
// A change is at once if it is so many times as fast as the ones before and after it. A force that
// changes gradually has steps alike; a blow goes up and down at the same rate.
constexpr double times_neighbours = 8;

} // namespace

void ForceJumps::add(double time, double h, double force) {
  const auto& [before, jump] = last_;
  const Step now{time, h, force, steps_ > 0 ? std::abs(force - jump.force) / h : 0};
  // The first step sets everything going: a change to the second is not one of the push.
  if (steps_ >= 4) {
    const double change = std::abs(jump.force - before.force);
    const bool is_large = change > least_jump * std::max(before.force, jump.force) &&
                          change > worth_a_jump * largest_;
    if (is_large && jump.rate > times_neighbours * std::max(before.rate, now.rate))
      found_.push_back({jump.time, jump.h, before.force, jump.force});
  }
  if (steps_ > 0) largest_ = std::max(largest_, force);
  last_[0] = jump;
  last_[1] = now;
  ++steps_;
}

} // namespace lcpush::desktop
