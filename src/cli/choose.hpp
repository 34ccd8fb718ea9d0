// Asking a student for the row that leaves.
#pragma once

#include "lcpush/desktop/pivots.hpp"

namespace lcpush::cli {

/// Shows the tableau before the trace's last pivot on standard error, where it does not mix with
/// the trace, and reads the name of a variable, or a row's number, from standard input until it is
/// one that may leave; a wrong one is explained. At the end of the input the rule's own row is
/// taken from then on.
Index ask_for_row(const desktop::PivotTrace& trace);

} // namespace lcpush::cli
