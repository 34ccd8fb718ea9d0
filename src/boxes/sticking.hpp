// [T.20] How wide a box may be, with rounding.
#pragma once

#include "boxes/push_model.hpp"

#include <functional>
#include <vector>

namespace lcpush::desktop {

/// A box of other ends than its own, of all sides.
struct BoxEnds {
  std::vector<double> low, high;
};

/// The load's largest share of what the grip holds alone, over the corners, and where it is; less
/// than 1: held.
double holding_share(const Box& box, const PushModel& model, const BoxEnds& ends,
                     std::vector<double>& worst);

/// The largest margin at which the push sticks in the box of these ends and the load is held before
/// it, a little below; 0: none.
double sticking_margin(const Box& box, const PushModel& model,
                       const std::function<BoxEnds(double margin)>& ends);

/// "the grasp does not hold the box before it is pushed".
std::string falls_words(const SceneFile& file);
/// "the box slips over wall along -y": where that condition fails.
std::string slip_words(const SceneFile& file, const PushModel& model, std::size_t condition);

} // namespace lcpush::desktop
