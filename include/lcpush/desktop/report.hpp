// Reports: text for people, JSON for programs.
#pragma once

#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/desktop/telling.hpp"

namespace lcpush::desktop {

/// `solve`: one plain sentence, then the contacts. A line a sentence: wrap them as you like.
std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report,
                       Telling telling = Telling::brief);
/// `solve --json`: one object.
std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report);

std::string break_text(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report, Telling telling = Telling::brief);
std::string break_json(const SceneFile& file, const HoldReport& hold, const GripReport& grip,
                       const BreakReport& report);

} // namespace lcpush::desktop
