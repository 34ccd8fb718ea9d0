// --history for pushes: what is left of each law after so many sweeps.
#pragma once

#include "cli/arguments.hpp"
#include "cli/history.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::cli {

inline Option history_option() {
  return {"--history", "", "instead of the answer, each law's residual sweep by sweep (also csv)"};
}

/// The format asked for; csv goes with --history, and --history with a solver that sweeps.
inline std::string push_format(const Arguments& arguments, desktop::Solver solver) {
  if (!arguments.has("--history")) return arguments.format({"text", "json"});
  if (solver == desktop::Solver::lemke)
    throw UsageError("--history goes with --solver gauss-seidel or hybrid; lemke has no sweeps");
  return arguments.format({"text", "csv", "json"});
}

inline std::string push_history(const std::string& format, desktop::Solver solver, Status status,
                                const std::vector<desktop::SweepRecord>& records) {
  std::vector<HistoryRow> rows;
  for (const desktop::SweepRecord& record : records) {
    Residuals<double> residuals = record.residuals;
    HistoryRow row{record.sweep, {}};
    for (Index k = 0; k < law_count; ++k) row.values.push_back(residuals[static_cast<Law>(k)]);
    row.values.push_back(residuals.max());
    rows.push_back(row);
  }
  std::vector<std::string> names;
  for (Index k = 0; k < law_count; ++k) names.emplace_back(law_text(static_cast<Law>(k)));
  names.emplace_back("max");
  return history_text(format, desktop::solver_text(solver), status, names, rows);
}

} // namespace lcpush::cli
