// The smallest grip force that holds the object before it is pushed, with the pushers absent and
// with them in place: statics' bound [T.12], and the scene's own pressure law.
#pragma once

#include "lcpush/host/push.hpp"

namespace lcpush::host {

enum class GripSource {
  not_known,
  not_searched, ///< too many unknowns
  no_grip,      ///< proved: no factor on the grip forces holds
  statics,      ///< proved smallest for every pressure law, and the scene's own law holds at it
  search,       ///< the scene's law needs more than statics: where it starts to hold, by bisection
};

struct SmallestGrip {
  GripSource source = GripSource::not_known;
  double factor = -1; ///< on all grip forces of the scene; < 0: none, or not known
  double bound = -1;  ///< of statics: below it no pressure law holds; < 0: not known

  bool is_known() const { return factor >= 0; }
};

struct GripReport {
  SmallestGrip alone;   ///< pushers absent
  SmallestGrip at_rest; ///< pushers in place, in the limit of a vanishing push
  double force = 0;     ///< N, the scene's: of the first finger that an actuator drives, or of its
                        ///< [[actuator]]; 0: nothing grips
  std::string of;       ///< whose force that is: "per finger", "at left", ..
};

/// `hold` and `broken` are the answers for the scene as it is.
GripReport find_smallest_grip(const SceneFile& file, const HoldReport& hold,
                              const BreakReport& broken, const PushOptions& options);

} // namespace lcpush::host
