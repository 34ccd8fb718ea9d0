// What the solves of a push share: their rounds, and how far those go.
#pragma once

#include <algorithm>

#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"

namespace lcpush::desktop {

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

  void progressed(Index unknowns, Index covers) override {
    if (to_ != nullptr) to_->progressed(unknowns, covers);
  }

private:
  Push& push_;
  Watcher* to_;
  bool records_;
};

/// Watches the structured pivots.
struct Push::Meter {
  Watcher& to;

  template <class L> void starts(const L&) const {}
  template <class L> Index leaves(const L&, const Turn& turn) const { return turn.blocking.row; }
  template <class L> void stepped(const L& lemke) const {
    to.progressed(lemke.dictionary().size(), lemke.covers_tried());
  }
  template <class Sweeps> void checked(const Sweeps& solver) const { to.checked(solver); }
};

/// Calls `use` with the rounds of the solver asked for: by pivots on the structured basis where
/// that is faster, and once more on the whole dictionary if that finds no answer.
template <class Use> Status Push::with_rounds(const PushOptions& options, const Use& use) {
  Listener listener(*this, options);
  last_structured_ = options.solver != Solver::gauss_seidel && takes_structure(options);
  if (last_structured_) {
    // Unknowns; beyond, the dictionary takes minutes. A ray has been verified: it gets less time.
    constexpr Index largest_after_ray = 600, largest_dense = 2000;
    const Status status = with_pivots(options, structured_pivots(), Meter{listener}, use);
    const bool ended = status == Status::solved || status == Status::does_not_hold;
    const Index largest = status == Status::ray ? largest_after_ray : largest_dense;
    if (ended || layout().size > largest) return status;
    last_structured_ = false;
  }
  if (options.solver == Solver::gauss_seidel)
    return use(SweepRounds<double, Watcher>{sweeps_, options.sweeps, listener});
  return with_pivots<Watcher&>(options, pivots(), listener, use);
}

/// A warm start for pivots is near enough where sweeps agree to six digits.
template <class Observer, class Pivots, class Use>
Status Push::with_pivots(const PushOptions& options, Pivots& pivots, Observer&& observer,
                         const Use& use) {
  using Watching = std::remove_reference_t<Observer>;
  constexpr double near = 1e-6;
  constexpr Index few = 200; // sweeps before the pivots take over
  const LemkeRounds<double, Watching, Pivots> by_pivots{pivots, options.lemke, observer};
  if (options.solver == Solver::lemke) {
    // Large problems: the first opinion from the modes that one expects, others from nothing.
    if constexpr (std::is_same_v<Pivots, StructuredLemke<double>>)
      if (options.lemke.first_cover == 0)
        return use(PredictedRounds<double, Watching, Pivots>{assembly_, by_pivots});
    return use(by_pivots);
  }
  SweepRounds<double, Watching> sweeps{sweeps_, options.sweeps, observer};
  sweeps.options.tolerance = near;
  sweeps.options.max_sweeps = few;
  return use(HybridRounds<double, Watching, Pivots>{sweeps, by_pivots});
}

} // namespace lcpush::desktop
