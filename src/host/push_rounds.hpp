// Push::with_rounds, shared by the files of Push.
#pragma once

#include "lcpush/host/push.hpp"

namespace lcpush::host {

/// Calls `use` with the rounds of the solver asked for. A warm start for pivots is near enough
/// where sweeps agree to six digits.
template <class Use> Status Push::with_rounds(const PushOptions& options, const Use& use) {
  constexpr double near = 1e-6;
  constexpr Index few = 200; // sweeps before the pivots take over
  if (options.solver == Solver::lemke) return use(LemkeRounds<double>{pivots(), options.lemke});
  SweepRounds<double> sweeps{sweeps_, options.sweeps};
  if (options.record_history) {
    sweeps.options.context = this;
    sweeps.options.on_check = [](void* self, Index sweep, const double* z, const double&) {
      static_cast<Push*>(self)->record(sweep, z);
    };
  }
  if (options.solver == Solver::gauss_seidel) return use(sweeps);
  sweeps.options.tolerance = near;
  sweeps.options.max_sweeps = few;
  return use(HybridRounds<double>{sweeps, {pivots(), options.lemke}});
}

} // namespace lcpush::host
