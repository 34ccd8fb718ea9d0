// What the solves of a push share: their rounds, and how far those go.
#pragma once

#include <algorithm>

#include "lcpush/host/push.hpp"

namespace lcpush::host {

/// A slow push moves everything slowly: what is left of [T.2] must be small against that.
inline PressureOptions<double> pressure_options(const Scene<double>& scene,
                                                const Scales<double>& scales, double sigma) {
  PressureOptions<double> options;
  const double push = sigma * push_size(scene) / scales.acceleration;
  if (push > 0 && push < 1) options.tolerance *= std::max(push, 1e-4);
  return options;
}

/// Passes everything on, and has checks of sweeps recorded if the options ask for a history.
class Push::Listener : public Watcher {
public:
  Listener(Push& push, const PushOptions& options)
      : push_(push), to_(options.watcher), records_(options.record_history) {}

  void starts(const Lemke<double>& lemke) override {
    if (to_ != nullptr) to_->starts(lemke);
  }
  Index leaves(const Lemke<double>& lemke, const Turn& turn) override {
    return to_ != nullptr ? to_->leaves(lemke, turn) : turn.blocking.row;
  }
  void stepped(const Lemke<double>& lemke) override {
    if (to_ != nullptr) to_->stepped(lemke);
  }
  void swept(Index sweep, const double* z, double residual) override {
    if (records_) push_.record(sweep, z);
    if (to_ != nullptr) to_->swept(sweep, z, residual);
  }

private:
  Push& push_;
  Watcher* to_;
  bool records_;
};

/// Calls `use` with the rounds of the solver asked for. A warm start for pivots is near enough
/// where sweeps agree to six digits.
template <class Use> Status Push::with_rounds(const PushOptions& options, const Use& use) {
  constexpr double near = 1e-6;
  constexpr Index few = 200; // sweeps before the pivots take over
  Listener listener(*this, options);
  if (options.solver == Solver::lemke)
    return use(LemkeRounds<double, Watcher>{pivots(), options.lemke, listener});
  SweepRounds<double, Watcher> sweeps{sweeps_, options.sweeps, listener};
  if (options.solver == Solver::gauss_seidel) return use(sweeps);
  sweeps.options.tolerance = near;
  sweeps.options.max_sweeps = few;
  return use(HybridRounds<double, Watcher>{
      sweeps, LemkeRounds<double, Watcher>{pivots(), options.lemke, listener}});
}

} // namespace lcpush::host
