// A motion in words.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

constexpr double unmoved = 1e-9; ///< of the object's size: rounding goes farther in no run

/// "The box slides 12.3 mm along x, then pivots 14 degrees clockwise about z, until left leaves its
/// face after 0.71 s."
std::string move_sentence(const SceneFile& file, const MotionReport& report);
/// "slides 12.3 mm along x".
std::string phase_words(const SceneFile& file, const MotionPhase& phase);
/// Points of one body that do the same after the same step.
struct EventGroup {
  MotionEvent event; ///< of the first of them
  Index points = 1;
};
std::vector<EventGroup> grouped_events(const SceneFile& file, const MotionReport& report);
/// "left.3 leaves its face", "left begins to slip at 4 of its 12 points".
std::string event_words(const SceneFile& file, const EventGroup& group);
/// How well it was stepped, without a full stop.
std::string step_words(const MotionReport& report);
/// "30 mm along x, turned by 12 degrees counter-clockwise about z".
std::string pose_words(const SceneFile& file, const Pose<double>& pose);

/// rad, a rotation's axis times its angle, up to half a turn.
Vector3<double> rotation_vector(const Matrix3<double>& rotation);
/// N, of all pushers on the object.
Vector3<double> push_force(const SceneFile& file, const MotionFrame& frame);

} // namespace lcpush::desktop
