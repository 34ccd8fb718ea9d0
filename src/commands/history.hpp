// How the residual fell, in the formats that tables are read in.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/push.hpp"

namespace lcpush::commands {

using namespace desktop;

/// What was measured after so many sweeps, one number a column.
struct HistoryRow {
  Index sweep;
  std::vector<double> values;
};

/// The rows as "text" (aligned columns), "csv" (a header, then numbers that read back as the same
/// doubles) or "json" ({"solver", "status", "history": [{"sweep", ..}]}). `columns` names the
/// values; the sweep's number comes before them.
std::string history_text(const std::string& format, Solver solver, Status status,
                         const std::vector<std::string>& columns,
                         const std::vector<HistoryRow>& rows);
/// Of a push: what is left of each law.
std::string history_text(const std::string& format, Solver solver, Status status,
                         const std::vector<SweepRecord>& records);

} // namespace lcpush::commands
