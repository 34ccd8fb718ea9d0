// What a part of an answer determines of the rest.
#pragma once

#include "lcpush/desktop/foreign_answer.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// An Answer with its arrays.
struct OwnedAnswer {
  std::vector<ContactAnswer<double>> contacts;
  std::vector<double> friction, closing;
  Vector6<double> acceleration = Vector6<double>::Zero();

  explicit OwnedAnswer(const Layout<double>& layout);
  Answer<double> view() {
    return {acceleration, span_of(contacts), span_of(friction), span_of(closing)};
  }
};

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
                           OwnedAnswer& answer);

} // namespace lcpush::desktop
