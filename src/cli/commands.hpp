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
Command move_command();
Command cone_command();
Command plan_command();
Command play_command();
Command verify_command();
Command spread_command();
Command example_command();
Command new_command();
Command completion_command();

/// In the order of the overview.
std::vector<Command> all_commands();

} // namespace lcpush::cli
