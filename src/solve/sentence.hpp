// The answer in one plain sentence: how hard, which way, what the object does, what slips.
#pragma once

#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <string>

namespace lcpush::desktop {

/// "the box", "the cylinder", "the object".
std::string object_name(const SceneFile& file);

/// "sticks", "slips", "opens".
const char* mode_verb(Mode mode);

/// "20.1 N (20 N along x, 1.96 N up)": three digits; "up" and "down" where gravity has an axis.
std::string force_phrase(const SceneFile& file, const Vector3<double>& force);

/// "slides through the grip along x", "pivots counter-clockwise about z in the grip": what the
/// object does, after its name. Precondition: the motion is of this file's scene.
std::string motion_phrase(const SceneFile& file, const Motion<double>& motion, double length);

/// "every finger point slips", "left slips, right sticks, wall opens at 1 of its 2 points".
std::string contacts_phrase(const SceneFile& file, const Answer<double>& answer);

/// "Push with 20.1 N along x: the box slides along x, every finger point slips."
/// Precondition: solved.
std::string push_sentence(const SceneFile& file, const PushReport& report);

/// "The grasp breaks at 20 N, the normal force of wall: the box then slides along x."
/// "This push does not move the box in the grip: wall only touches it, or moves away."
/// Precondition: solved.
std::string break_sentence(const SceneFile& file, const BreakReport& report);

} // namespace lcpush::desktop
