// What counts as zero in words, decided once for each report.
#pragma once

#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// Sets the report's noise and brief_noise. They are measured by the smallest load that the file
/// gives, so that what is shown as nothing is nothing beside that load too, but are never below
/// what rounding leaves of F; a brief report's also by the fastest of `answer`'s contacts.
void find_noise(const SceneFile& file, const Answer<double>& answer, RunReport& report);

/// The actuator whose force is no more than what rounding leaves of F, or -1.
Index lost_actuator(const SceneFile& file, const Scales<double>& scales);

/// Is a push (m/s^2) too slow to stand out from what rounding does? `beside`: of Residuals.
bool is_too_slow(double push, const Scales<double>& scales, double beside);

} // namespace lcpush::desktop
