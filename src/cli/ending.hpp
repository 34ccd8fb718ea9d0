// How a command ends before its work is done: after some time, or at Ctrl-C.
#pragma once

#include <string>

namespace lcpush::cli {

/// What a command takes unless it is given more. Changed digits in a scene must not occupy a
/// machine for an hour; who has a large scene knows it and says so.
constexpr double usual_seconds = 8;

/// From now on the command ends by itself after so much processor time, with exit status 1, and
/// says on stderr what to do.
void limit_time(const std::string& command, double seconds);

/// Has this process taken more processor time than `seconds` by now?
bool is_over(double seconds);

/// The work is done: what is left is to write it down, whole.
void lift_time_limit();

/// From now on the first SIGINT or SIGTERM is noted; the next one ends the process, as it would
/// without this.
void listen_for_signals();
bool is_asked_to_end();

} // namespace lcpush::cli
