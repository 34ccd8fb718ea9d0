// A motion in words.
#pragma once

#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "move/rotation.hpp"

namespace lcpush::desktop {

/// "The box slides 12.3 mm along x, then pivots 14 degrees clockwise about z, until left leaves its
/// face after 0.71 s."
std::string move_sentence(const SceneFile& file, const MotionReport& report);
/// "slides 12.3 mm along x".
std::string phase_words(const SceneFile& file, const MotionPhase& phase);
struct EventLine {
  double time, within; ///< s; at the end of a step so long
  std::string words;   ///< "left.3 leaves its face", "left begins to slip at 4 of its 12 points"
};
/// In order of time: what contacts do, points of one body that do the same at once as one, and
/// jumps of the push.
std::vector<EventLine> event_lines(const SceneFile& file, const MotionReport& report);
/// How well it was stepped, without a full stop; brief: with what is as it should be left out.
std::string step_words(const MotionReport& report, bool verbose);
/// "30 mm along x, turned by 12 degrees counter-clockwise about z".
std::string pose_words(const SceneFile& file, const MotionFrame& frame);

inline bool is_touching(Touch touch) { return touch == Touch::sticks || touch == Touch::slips; }
/// "8 slip", "3 stick and 1 beside": how many points of a body do what, in these words for the
/// values of Touch; `counts_all`: the number too where all do the same.
std::vector<std::string> touch_words(const SceneFile& file, const MotionFrame& frame, std::size_t b,
                                     const char* const (&words)[7], bool counts_all);

/// N, of all pushers on the object.
Vector3<double> push_force(const SceneFile& file, const std::vector<BodyForce>& bodies);
/// N, the most that a body presses with.
double hardest(const std::vector<BodyForce>& bodies);
/// What acts beside frame k: at the begin that of the second step, which has started what starts at
/// once. Empty if there was no step.
inline const std::vector<BodyForce>& forces_beside(const MotionReport& report, std::size_t k) {
  return k == 0 ? report.first : report.frames[k].bodies;
}
/// What is odd about the scene, and what the motion shows of it beside: a shape that it would take.
std::vector<SceneDoubt> motion_doubts(const SceneFile& file, const MotionReport& report);

} // namespace lcpush::desktop
