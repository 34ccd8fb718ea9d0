// A moment of a motion as a scene of its own.
#pragma once

#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

/// The scene as it stands at `frame` of its motion, seen from the object: that stays where it was,
/// and the bodies, their motions and gravity are turned back to it. Points that touch nothing are
/// left out, and bodies without others. Throws InputError where an actuator drives one of those.
SceneFile scene_at(const SceneFile& file, const MotionFrame& frame);

} // namespace lcpush::desktop
