// How a push is to be solved.
#pragma once

#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/watcher.hpp"
#include "lcpush/lcp/sweeps/judged_sweeps.hpp"

namespace lcpush::desktop {

/// Sweeps end at their own scaled residual; the laws, in SI units, are to pass theirs as well.
constexpr SweepOptions<double> strict_sweeps() {
  SweepOptions<double> options;
  options.tolerance /= 32;
  return options;
}

struct PushOptions {
  Solver solver = Solver::lemke;
  LemkeOptions<double> lemke{};
  SweepOptions<double> sweeps = strict_sweeps();
  bool record_history = false;  ///< RunReport::history; costs a check of the laws each time
  Index other_covers = 3;       ///< covers tried in search of another answer
  bool explain_jams = true;     ///< solve again with each change that might free a jam
  bool dense = false;           ///< pivots on the whole dictionary, whatever the size
  bool study_existence = true;  ///< ask the existence lemma's conditions: two linear programs
  Watcher* watcher = nullptr;   ///< told of all pivots and sweeps of the answer
  Watcher* searching = nullptr; ///< told of those of the search for other answers
};

} // namespace lcpush::desktop
