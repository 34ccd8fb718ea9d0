// The answer in one plain sentence: how hard, which way, what the object does, what slips.
#pragma once

#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <string>

namespace lcpush::desktop {

/// "the box", "the cylinder", "the object".
std::string object_name(const SceneFile& file);

/// What turns over where it sticks to what carries it: "rolls"; of a box "tips".
const char* rolling_verb(const SceneFile& file);

/// "counter-clockwise about z", seen from the axis' tip; by its direction if it is no axis.
std::string turn_phrase(const Vector3<double>& axis);

/// "along x", "up", "along (0.6, 0.8, 0)". Precondition: unit.
std::string direction_phrase(const SceneFile& file, const Vector3<double>& direction);
/// What the object does, after its name: "slides along x"; nothing of the grip where the hand
/// moves, or is none.
std::string motion_phrase(const SceneFile& file, const RunReport& report);

/// "sticks", "slips", "opens".
const char* mode_verb(Mode mode);
/// What a body's points do: "slips", or "1 sticks and 3 slip".
std::string modes_text(const Answer<double>& answer, const Body<double>& body);

/// "20.1 N (20 N along x, 1.96 N up)": three digits; "up" and "down" where gravity has an axis.
std::string force_phrase(const SceneFile& file, const Vector3<double>& force);

/// "Push with 20.1 N along x: the box slides along x, every finger point slips."
/// Precondition: solved.
std::string push_sentence(const SceneFile& file, const PushReport& report);

/// "The grasp breaks at 20 N, the normal force of wall: the box then slides along x.", "The push
/// does not break the grasp: sheet slides along the box, which does not move."
/// Precondition: solved.
std::string break_sentence(const SceneFile& file, const BreakReport& report);

} // namespace lcpush::desktop
