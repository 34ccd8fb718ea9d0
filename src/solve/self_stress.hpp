// May contacts squeeze an object against each other, as hard as they like?
#pragma once

#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// Are there forces within the cones that balance without load or grip? A wedge has them where
/// friction reaches from face to face, and between locked jaws. How large they are is nobody's to
/// say: what statics holds by them is no promise. A cone is taken by a few of its rays, a little
/// too wide.
bool has_self_stress(const GripStatics& statics);

} // namespace lcpush::desktop
