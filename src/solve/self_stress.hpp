// May contacts squeeze an object against each other, as hard as they like?
#pragma once

#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// Are there forces within the cones that balance without load or grip? A wedge has them where
/// friction reaches from face to face, and between locked jaws. How large they are is nobody's to
/// say: what statics holds by them is no promise. A cone is taken by a few of its rays, a little
/// too wide.
bool has_self_stress(const GripStatics& statics);

/// Is that so, and nobody says how hard? Locked jaws are closed with a force that is given, and
/// other laws than pads' leave forces to statics.
inline bool is_squeezed(const SceneFile& hand, const GripStatics& statics) {
  return hand.hand != Hand::locked && hand.pressure == Pressure::pad && has_self_stress(statics);
}

} // namespace lcpush::desktop
