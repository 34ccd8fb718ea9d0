// What the solves of a push share: their rounds, and how far those go.
#pragma once

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "solve/settled_pivots.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {

/// Where points are many, a cold start is dear and rarely ends where stiff pads have failed.
inline PressureOptions<double> breaking_options(const Assembly<double>& assembly) {
  PressureOptions<double> options;
  if (assembly.layout().size >= SettledPivots::smallest) options.max_retreats = 5;
  return options;
}

/// A slow push moves everything slowly: what is left of [T.2] must be small against that.
inline PressureOptions<double> pressure_options(const Assembly<double>& assembly, double sigma) {
  PressureOptions<double> options = breaking_options(assembly);
  const double push = sigma * push_size(assembly.scene()) / assembly.layout().scales.acceleration;
  if (push > 0 && push < 1) options.tolerance *= std::max(push, 1e-4);
  return options;
}

/// Does a body move by more than a thousandth of the unit that its closing is measured in?
inline bool any_moves(const std::vector<NamedValue>& closings) {
  return std::any_of(closings.begin(), closings.end(),
                     [](const NamedValue& closing) { return std::abs(closing.value) > 1e-3; });
}

/// Passes everything on, and has checks of sweeps recorded if the options ask for a history.
class Push::PassingWatcher : public Watcher {
public:
  PassingWatcher(Push& push, const PushOptions& options)
      : push_(push), to_(options.watcher != nullptr ? *options.watcher : nobody_),
        records_(options.record_history) {}

  void starts(const Lemke<double>& lemke) override { to_.starts(lemke); }
  Index choose_leaving_row(const Lemke<double>& lemke, const PendingPivot& pending) override {
    return to_.choose_leaving_row(lemke, pending);
  }
  void stepped(const Lemke<double>& lemke) override { to_.stepped(lemke); }
  void progressed(Index unknowns, Index covers) override { to_.progressed(unknowns, covers); }
  void swept(Index sweep, const double* z, double residual) override {
    if (records_) push_.record(sweep, z);
    to_.swept(sweep, z, residual);
  }

private:
  Push& push_;
  Watcher nobody_;
  Watcher& to_;
  bool records_;
};

/// Calls `use` with the rounds of the solver asked for: by pivots on the structured basis where
/// that is faster, and once more on the whole dictionary if that finds no answer.
template <class Use> Status Push::with_rounds(const PushOptions& options, const Use& use) {
  PassingWatcher watcher(*this, options);
  last_structured_ = options.solver != Solver::gauss_seidel && takes_structure(options);
  if (last_structured_) {
    const Status status = with_settled_pivots(options, watcher, use);
    const bool ended = status == Status::solved || status == Status::does_not_hold;
    const Index largest = status == Status::ray || pivots_left_ ? limits::unknowns_dense_after_ray
                                                                : limits::unknowns_dense;
    if (ended || layout().size > largest) return status;
    last_structured_ = false;
  }
  if (options.solver == Solver::gauss_seidel)
    return use(SweepRounds<double, Watcher>{sweeps_, options.sweeps, watcher});
  return with_pivots(options, pivots(), watcher, use);
}

template <class Use>
Status Push::with_settled_pivots(const PushOptions& options, Watcher& watcher, const Use& use) {
  SettledPivots pivots(structured_pivots(), assembly_, pivots_left_);
  Status status = with_pivots(options, pivots, watcher, use);
  const bool may_sweep = pivots.sweeps() > 0 && !pivots.is_spent(); // pads that sweeps can move
  if (status == Status::numerical_breakdown && may_sweep)
    status = use(SweepRounds<double, Watcher>{sweeps_, options.sweeps, watcher});
  settled_by_sweeps_ += pivots.sweeps();
  return status;
}

/// A warm start for pivots is near enough where sweeps agree to six digits.
template <class Pivots, class Use>
Status Push::with_pivots(const PushOptions& options, Pivots& pivots, Watcher& watcher,
                         const Use& use) {
  constexpr double near = 1e-6;
  constexpr Index few = 200; // sweeps before the pivots take over
  const LemkeRounds<double, Watcher, Pivots> by_pivots{pivots, options.lemke, watcher};
  if (options.solver == Solver::lemke) {
    // Large problems: the first opinion from the modes that one expects, others from nothing.
    if constexpr (!std::is_same_v<Pivots, Lemke<double>>)
      if (options.lemke.first_cover == 0)
        return use(PredictedRounds<double, Watcher, Pivots>{assembly_, by_pivots});
    return use(by_pivots);
  }
  SweepRounds<double, Watcher> sweeps{sweeps_, options.sweeps, watcher};
  sweeps.options.tolerance = near;
  sweeps.options.max_sweeps = few;
  return use(HybridRounds<double, Watcher, Pivots>{sweeps, by_pivots});
}

/// Other covers are the pivots' own; after sweeps they are a second opinion too.
inline PushOptions by_other_cover(const PushOptions& options, Index k) {
  PushOptions other = options;
  other.solver = Solver::lemke;
  other.record_history = false;
  other.watcher = options.searching;
  other.lemke.first_cover += k * other.lemke.covers;
  return other;
}

/// Does the object rest before it is pushed? The desktop's word on what the core has found:
/// report.status (solved or does_not_hold, with report.breaking and report.scales), or the other of
/// the two; numerical_breakdown: the breaking force is below zero, yet no fall is seen. `scene` as
/// solved. Changes report.breaking.rest alone, to a fall that the core did not see.
Status holding_verdict(const SceneFile& file, BreakReport& report, const PushOptions& options);

} // namespace lcpush::desktop
