// The parts of planning, in the order in which plan() uses them.
#pragma once

#include "plan/roadmap.hpp"

namespace lcpush::desktop {

/// The same scene, but of a pusher that reaches over the end of the face that it touches only what
/// is along it, and a little less: the motion's steps must not take its end over the corner.
SceneFile along_faces(SceneFile file);

/// Where a push ends in which the object may slip over the pusher: `move` says it. `body` is the
/// scene's that pushes. None: the motion ends before its time.
std::optional<PlanarPose> slid(const SceneFile& file, Index body, const PlanarPose& from,
                               const Slip& slip);

/// The plan as a scene of strokes, which `move` replays: the scene file's text with the plan's
/// pushes in the place of its pushers. Sets when each push begins and ends. `gap` (m): how far
/// before the object a later push begins.
std::string strokes_text(std::string_view text, const SceneFile& file,
                         std::vector<PlannedPush>& pushes, double speed, double gap);

} // namespace lcpush::desktop
