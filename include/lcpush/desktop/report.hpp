// Reports: text for people, JSON for programs.
#pragma once

#include "lcpush/desktop/smallest_grip.hpp"

namespace lcpush::desktop {

/// `solve`: the answer in words, then contacts and residuals.
std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report);
/// `solve --json`: one object.
std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report);

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report);
std::string break_json(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report);

} // namespace lcpush::desktop
