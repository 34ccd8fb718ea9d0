// How long a command may take.
#pragma once

#include "cli/arguments.hpp"

namespace lcpush::cli {

/// What a command takes unless it is given more. Changed digits in a scene must not occupy a
/// machine for an hour; who has a large scene knows it and says so.
constexpr double usual_seconds = 8;

/// From now on the command ends by itself after so much processor time, with exit status 1, and
/// says on stderr what to do.
void limit_time(const std::string& command, double seconds);
/// If it takes --seconds: those, or the usual ones. `lcpush lcp` says beforehand what it will take.
void limit_time(const Command& command, const Arguments& arguments);

/// Has this process taken more processor time than `seconds` by now?
bool is_over(double seconds);

/// The work is done: what is left is to write it down, whole.
void lift_time_limit();

inline const Option seconds_option{"--seconds", "S",
                                   "stop after so much processor time (8), with nothing written"};

} // namespace lcpush::cli
