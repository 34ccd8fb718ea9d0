// A plan as a scene of strokes, which `move` replays.
#pragma once

#include "lcpush/desktop/plan.hpp"

namespace lcpush::desktop {

/// The scene file's text with the plan's pushes in the place of its pushers. Sets when each push
/// begins and ends. `gap` (m): how far before the object a later push begins.
std::string strokes_text(std::string_view text, const SceneFile& file,
                         std::vector<PlannedPush>& pushes, double speed, double gap);

} // namespace lcpush::desktop
