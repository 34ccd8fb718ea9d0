// Pads of many points: pivots, and Gauss-Seidel where they do not end.
#pragma once

#include <algorithm>

#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {

/// A round that pivots do not end, or not soon, is left to Gauss-Seidel, and its answer is where
/// the next round's pivots begin: as a pad becomes stiffer, Newton's method on the six
/// accelerations goes on where a pivot is lost in the digits.
template <class Watcher, class Pivots> class WideRounds {
public:
  WideRounds(const PredictedRounds<double, Watcher, Pivots>& pivots,
             const SweepRounds<double, Watcher>& sweeps)
      : pivots_(pivots), sweeps_(sweeps) {
    sweeps_.options.tolerance /= SolveSettings().stricter; // the next round starts from it
  }
  static constexpr bool carries_push() { return true; }
  static constexpr bool goes_on() { return true; }

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& memory) {
    problem_ = problem;
    warm_ = warm;
    is_swept_ = false;
    LemkeOptions<double>& options = pivots_.then.options;
    options.max_pivots = problem.size;
    options.covers = warm ? 1 : 2;
    if (warm)
      pivots_.begin_near(problem, memory, {last_, options.covers, 0});
    else
      pivots_.begin(problem, false, memory);
  }

  Status step(const PressureMemory<double>& memory, PressureRun& run) {
    if (!is_swept_) {
      const Status status = pivots_.step(memory, run);
      if (status == Status::solved) last_ = Guess::basis;
      if (status == Status::running || status == Status::solved || !has_pads()) return status;
      is_swept_ = true;
      sweeps_.begin(problem_, warm_, memory);
      return Status::running;
    }
    const Status status = sweeps_.step(memory, run);
    if (status != Status::solved) return status;
    for (Index i = 0; i < problem_.size; ++i)
      memory.active[i] =
          i >= problem_.free_begin || memory.z[i] > SolveSettings().swept_force ? 1 : 0;
    last_ = Guess::near;
    return status;
  }

  void vary() { pivots_.vary(); }
  void require(double) {}
  Status solve_limit(Assembly<double>& assembly, const PressureMemory<double>& memory,
                     PressureRun& run, PushLimit<double>& limit) {
    return pivots_.solve_limit(assembly, memory, run, limit);
  }

private:
  PredictedRounds<double, Watcher, Pivots> pivots_;
  SweepRounds<double, Watcher> sweeps_;
  Problem<double> problem_{};
  bool warm_ = false, is_swept_ = false;
  Guess last_ = Guess::basis; // what memory.active is

  /// A ray without them is a jam, and no round's failure.
  bool has_pads() const {
    const Span<const ConeGroup<double>>& cones = problem_.factored->cones;
    return std::any_of(cones.begin(), cones.end(),
                       [](const ConeGroup<double>& cone) { return cone.compliance > 0; });
  }
};

} // namespace lcpush::desktop
