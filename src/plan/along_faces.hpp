// Where the pushers of a plan touch the object: along its faces, not beside them.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// The same scene, but of a pusher that reaches over the end of the face that it touches only what
/// is along it, and a little less: the motion's steps must not take its end over the corner.
SceneFile along_faces(SceneFile file);

} // namespace lcpush::desktop
