// What texts count by: the scene's force, or less where a load is small beside it.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush::desktop {

/// N: F, at most a thousand times the smallest load that the file gives, so that what is shown as
/// nothing is nothing beside that load too; but not where rounding of F is all there is to show.
double told_force(const SceneFile& file, const Scales<double>& scales);

} // namespace lcpush::desktop
