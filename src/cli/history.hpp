// --history: how the residual fell, in the formats that tables are read in.
#pragma once

#include "cli/arguments.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::cli {

/// What was measured after so many sweeps, one number a column.
struct HistoryRow {
  Index sweep;
  std::vector<double> values;
};

/// The rows as "text" (aligned columns), "csv" (a header, then numbers that read back as the same
/// doubles) or "json" ({"solver", "status", "history": [{"sweep", ..}]}). `columns` names the
/// values; the sweep's number comes before them.
std::string history_text(const std::string& format, const std::string& solver, Status status,
                         const std::vector<std::string>& columns,
                         const std::vector<HistoryRow>& rows);

/// Of pushes: what is left of each law.
inline const Option history_option{
    "--history", "", "instead of the answer, each law's residual sweep by sweep (also csv)"};
/// The format asked for; csv goes with --history, and --history with a solver that sweeps.
std::string push_format(const Arguments& arguments, Solver solver);
std::string push_history(const std::string& format, Solver solver, Status status,
                         const std::vector<SweepRecord>& records);

} // namespace lcpush::cli
