// What counts as zero in words, decided once for each report.
#pragma once

#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// A part of the smallest load that the file gives, so that what is shown as nothing is nothing
/// beside that load too, but never below what rounding leaves of F.
Noise noise_below(const SceneFile& file, const Scales<double>& scales, double part);

/// How fast the fastest of the contact points moves, m/s^2.
double fastest_contact(const Answer<double>& answer);

/// Sets the report's noise and brief_noise; a brief report's also by the fastest of `answer`'s
/// contacts.
void find_noise(const SceneFile& file, const Answer<double>& answer, RunReport& report);

/// What moves no faster than noise stands still. A contact whose point does sticks: without a force
/// it neither slips nor opens.
void clear_noise(const SceneFile& file, const Scales<double>& scales, const Noise& noise,
                 Answer<double>& answer);

/// The actuator whose force is no more than what rounding leaves of F, or -1.
Index lost_actuator(const SceneFile& file, const Scales<double>& scales);

/// N: weight and applied forces where what an answer's residual leaves of F could be as large, so
/// that no motion is theirs; else 0.
double lost_load(const SceneFile& file, const Scales<double>& scales, double residual);

/// Is a push (m/s^2) too slow to stand out from what rounding does? `beside`: of Residuals.
bool is_too_slow(double push, const Scales<double>& scales, double beside);

} // namespace lcpush::desktop
