// What a part of an answer determines of the rest.
#pragma once

#include "lcpush/desktop/foreign_answer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

struct Completion {
  bool has_forces = false;            ///< were forces filled in?
  std::vector<std::string> completed; ///< a phrase for each thing that was not given
  std::string missing;                ///< what would have to be given as well; empty: it is whole
};

/// Fills `answer` from what is given and what follows from it: the object's acceleration from all
/// forces or from the motion of its points; the closings from the motion; forces from the motion,
/// as those that fit the laws best (nonnegative least squares); what generators and slips make of
/// them. Numbers that are given stay as they are. `push` is only asked for its scene and its
/// assembly. `tolerance`: in scaled units, below this nothing moves. Cost: least squares of 6 +
/// actuators + 4 points rows.
Completion complete_answer(Push& push, const ForeignAnswer& given, double tolerance,
                           Answer<double>& answer);

} // namespace lcpush::desktop
