// The smallest grip force that holds the object before it is pushed, with the pushers absent and
// with them in place: statics' bound [T.12], and the scene's own pressure law.
#pragma once

#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/study/study_memory.hpp"

namespace lcpush::desktop {

enum class GripSource {
  not_known,
  not_searched, ///< too many unknowns
  no_grip,      ///< proved: no factor on the grip forces holds
  statics,      ///< proved smallest for every pressure law, and the scene's own law holds at it
  search,       ///< the scene's law needs more than statics: the least that was found to hold, by
                ///< bisection and looks below
};

/// Does the scene still hold when it is gripped harder than it has to be?
enum class MoreGrip {
  not_known, ///< not asked, as it holds as it is; or with a little more, but not with twice as much
  holds,     ///< at 1.01 times the smallest grip, and at twice
  drops,     ///< not even at 1.01 times: only just that grip holds
};

struct SmallestGrip {
  GripSource source = GripSource::not_known;
  double factor = -1;  ///< on all grip forces of the scene; < 0: none, or not known
  double bound = -1;   ///< of statics: below it no pressure law holds; < 0: not known
  double certain = -1; ///< every larger factor that was tried holds; more than `factor` where what
                       ///< does not hold lies between what does
  MoreGrip more = MoreGrip::not_known;

  bool is_known() const { return factor >= 0; }
};

struct GripReport {
  SmallestGrip alone;   ///< pushers absent
  SmallestGrip at_rest; ///< pushers in place, in the limit of a vanishing push
  double force = 0;     ///< N, the scene's: of the first finger with a grip force, or of its
                        ///< [[actuator]], N m if that turns it; 0: nothing grips
  std::string of;       ///< whose force that is: "per finger", "at left", "of actuator hand", ..
  bool of_actuator = false; ///< it is an [[actuator]]'s
};

/// The force that a factor on the grip is told of, and whose it is; nothing is searched.
GripReport named_grip(const SceneFile& file);

/// `hold` and `broken` are the answers for the scene as it is.
GripReport find_smallest_grip(const SceneFile& file, const HoldReport& hold,
                              const BreakReport& broken, const PushOptions& options);

/// N: what locked jaws pressed with before they were locked; 0: there are none.
double locked_force(const SceneFile& file);

/// The scene with `factor` times its grip forces.
SceneFile with_grip(SceneFile file, double factor);

/// The hand before any push: its fingers alone and at rest, with the actuators that drive one.
SceneFile hand_at_rest(const SceneFile& file);

} // namespace lcpush::desktop
