// How a grasp gives way: the dual of a statics program is a motion; what slips, opens and yields?
#pragma once

#include "lcpush/desktop/hold.hpp"
#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// `contacts`: what presses while the motion begins; none: nothing is known of that.
GiveWay read_motion(const SceneFile& file, const GripStatics& statics,
                    const Eigen::VectorXd& motion,
                    const std::vector<StaticsProgram::Contact>& contacts);

/// What the laws do with a hand whose load it does not hold; none: they hold it, or no answer was
/// found. A dual shows one of the motions that cost as little, and friction that lifts.
std::optional<GiveWay> read_fall(const SceneFile& hand, const PushOptions& options);

/// "turns it about +z in the pads", "slides it along -z over left and right", "tips it, ..". `way`:
/// instead of "about +z", "along -z".
std::string give_way_words(const SceneFile& file, const GiveWay& gives,
                           const std::string& way = "");

} // namespace lcpush::desktop
