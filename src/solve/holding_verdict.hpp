// Does the object rest before it is pushed? The host's word on what the core has found.
#pragma once

#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// report.status (solved or does_not_hold, with report.breaking and report.scales), or the other of
/// the two. `scene` as solved.
Status holding_verdict(const SceneFile& file, const Scene<double>& scene, const BreakReport& report,
                       const PushOptions& options);

} // namespace lcpush::desktop
