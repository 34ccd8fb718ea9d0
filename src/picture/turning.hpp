// Questions about a motion that pictures ask.
#pragma once

#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// Does the object turn about an axis?
inline bool turns(const Motion<double>& motion) {
  return motion.kind != MotionKind::rest && motion.kind != MotionKind::slide;
}

} // namespace lcpush::desktop
