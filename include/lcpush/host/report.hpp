// Reports: text for people, JSON for programs.
#pragma once

#include "lcpush/host/push.hpp"

namespace lcpush::host {

/// `solve`: the answer in words, then contacts and residuals.
std::string solve_text(const SceneFile& file, const HoldReport& hold, const PushReport& report);
/// `solve --json`: the keys of docs/formats.md.
std::string solve_json(const SceneFile& file, const HoldReport& hold, const PushReport& report);

std::string break_text(const SceneFile& file, const HoldReport& hold, const BreakReport& report);
std::string break_json(const SceneFile& file, const HoldReport& hold, const BreakReport& report);

} // namespace lcpush::host
