// One function a command, each in its own file.
#pragma once

#include "cli/arguments.hpp"

namespace lcpush::cli {

Command lcp_command();
Command solve_command();
Command break_command();
Command export_command();
Command matrices_command();
Command pivots_command();
Command report_command();
Command sweep_command();
Command verify_command();
Command spread_command();

} // namespace lcpush::cli
