// What texts count by: the scene's force, or less where a load is small beside it.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush::desktop {

/// N: F, at most a thousand times the smallest load that the file gives, so that what is shown as
/// nothing is nothing beside that load too; but not where rounding of F is all there is to show.
double told_force(const SceneFile& file, const Scales<double>& scales);

/// N: a force shown with three digits is nothing below this: a millionth of the told force, but a
/// load that stands out from what rounding leaves of F is shown.
double shown_as_nothing(const SceneFile& file, const Scales<double>& scales);

/// The actuator whose force is no more than what rounding leaves of F, or -1.
Index lost_actuator(const SceneFile& file, const Scales<double>& scales);

/// A push has to stand out from what rounding does: `beside` (Residuals) by 1e5, and so that
/// motions a tenth as fast are not what rounding leaves of F / m, which is shown as rest.
bool is_lost(double push, const Scales<double>& scales, double beside);

} // namespace lcpush::desktop
