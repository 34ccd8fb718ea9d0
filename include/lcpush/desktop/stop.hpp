// Why work ends before it is done: its time is up, or whoever asked has ended it.
#pragma once

#include <functional>

namespace lcpush::desktop {

enum class Stop { none, time, signal };

/// As `stopped` prints it; empty: nothing did.
constexpr const char* stop_text(Stop stop) {
  return stop == Stop::none ? "" : stop == Stop::time ? "time" : "signal";
}

/// Is the work to end now, with what there is? `part` of it may take this part of the processor
/// time that there is for all.
using StopCheck = std::function<Stop(double part)>;

inline Stop stop_now(const StopCheck& check, double part = 1) {
  return check ? check(part) : Stop::none;
}

} // namespace lcpush::desktop
