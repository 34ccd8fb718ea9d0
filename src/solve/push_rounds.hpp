// What the solves of a push share: their rounds, and how far those go.
#pragma once

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "solve/any_rounds.hpp"
#include "solve/settings.hpp"
#include "solve/wide_rounds.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {

/// A slow push moves everything slowly: what is left of [T.2] must be small against that, and what
/// round friction is off by, too.
inline PressureOptions<double> pressure_options(const Assembly<double>& assembly, double sigma) {
  PressureOptions<double> options;
  const double push = sigma * push_size(assembly.scene()) / assembly.layout().scales.acceleration;
  if (push > 0 && push < 1) {
    options.tolerance *= std::max(push, 1e-4);
    options.finest = options.tolerance;
    options.fine_rounds = SolveSettings().fine_rounds;
  }
  return options;
}

/// Does a body move?
inline bool any_moves(const std::vector<NamedValue>& closings) {
  return std::any_of(closings.begin(), closings.end(), [](const NamedValue& closing) {
    return std::abs(closing.value) > SolveSettings().hand_moves;
  });
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
    const Status status = use(rounds_by(structured_pivots(), options, watcher));
    const bool ended = status == Status::solved || status == Status::does_not_hold;
    if (ended || layout().size > limits::unknowns_dense) return status;
    last_structured_ = false;
  }
  if (options.solver == Solver::gauss_seidel)
    return use(AnyRounds(SweepRounds<double, Watcher>{sweeps_, options.sweeps, watcher}));
  return use(rounds_by(pivots(), options, watcher));
}

/// Pivots: after sweeps, or from the modes that one expects (large problems, and of those the first
/// opinion alone), or from nothing.
template <class Pivots>
AnyRounds Push::rounds_by(Pivots& pivots, const PushOptions& options, Watcher& watcher) {
  const LemkeRounds<double, Watcher, Pivots> by_pivots{pivots, options.lemke, watcher};
  if (options.solver == Solver::hybrid) {
    SweepRounds<double, Watcher> sweeps{sweeps_, options.sweeps, watcher};
    sweeps.options.tolerance = SolveSettings().swept_near;
    sweeps.options.max_sweeps = SolveSettings().swept_most;
    return AnyRounds(HybridRounds<double, Watcher, Pivots>{sweeps, by_pivots});
  }
  if constexpr (!std::is_same_v<Pivots, Lemke<double>>) {
    using Predicted = PredictedRounds<double, Watcher, Pivots>;
    const bool is_first = options.lemke.first_cover == 0;
    if (layout().size >= SolveSettings().wide && scene_.pressure == Pressure::pad)
      return AnyRounds(WideRounds<Watcher, Pivots>(
          Predicted{{assembly_, !is_first}, by_pivots},
          SweepRounds<double, Watcher>{sweeps_, options.sweeps, watcher}));
    if (is_first) return AnyRounds(Predicted{assembly_, by_pivots});
  }
  return AnyRounds(by_pivots);
}

/// Of a search beside the answer, which may take some half a second. Pre: other_paths > 0.
PushOptions search_options(const PushOptions& options, Index unknowns);

/// Another path of pivots to an answer of the same laws, in a search that may take as long as some
/// half a second; after sweeps pivots are a second opinion too.
struct OtherPath {
  std::optional<SceneFile> turned; ///< the scene, where not the covering vector is another
  PushOptions options;
};

/// The k-th one: under other covering vectors, and then, where friction is round and has no
/// directions of its own, from the opposite ones. Of 16 grasps whose image in a mirror, or turned,
/// has another answer that led to one in 11.
OtherPath other_path(const SceneFile& file, const PushOptions& options, Index k, Index unknowns);
/// How many there are; the last for where the others have led to nothing else.
Index paths_to_search(const PushOptions& options, bool is_round);

} // namespace lcpush::desktop
