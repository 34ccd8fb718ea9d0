// How a grasp gives way: the dual of a statics program is a motion; what slips, opens and yields?
#pragma once

#include "lcpush/desktop/hold.hpp"
#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// `contacts`: what presses while the motion begins; none: nothing is known of that.
GiveWay read_motion(const SceneFile& file, const GripStatics& statics,
                    const Eigen::VectorXd& motion,
                    const std::vector<StaticsProgram::Contact>& contacts);

/// "turns in the pads", "slides along -z at left and right", "tips over table".
std::string give_way_words(const SceneFile& file, const GiveWay& gives);

} // namespace lcpush::desktop
