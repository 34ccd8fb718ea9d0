// Where Lemke's pivots begin: the starts, and who asks for each.
//
//     cold         z = 0 under a covering vector: LemkeRounds (rounds.hpp), and all others where
//                  their basis leads nowhere
//     previous     the last round's basis: warm rounds, of everyone
//     predicted    the modes that one expects (predicted_modes.hpp): pushes on the structured basis
//     swept        what a few Gauss-Seidel sweeps press: the solver `hybrid`
//     last step    the basis of the last time step: motions, a device's ticks (step_rounds.hpp)
//     neighbour    the basis at the last value: parameter sweeps (src/sweep/remembered_rounds.hpp)
#pragma once

#include "lcpush/mechanics/solve/rounds.hpp"

namespace lcpush {

/// Lemke's pivots from a first basis, cold if there is none or if it leads nowhere; warm rounds go
/// on from the last answer. It is never less reliable than LemkeRounds. The basis is Start's:
///
///     bool propose(problem, memory, run, first)     fills memory.active and `first`, if it can
///     void begins_cold()                            it could not, or its basis led nowhere
///     knows_limit                                   does it propose for a vanishing push as well?
template <class S, class Start, class Watcher = const Unwatched, class Pivots = Lemke<S>>
struct StartedRounds {
  Start start;
  LemkeRounds<S, Watcher, Pivots> then;
  static constexpr bool carries_push() { return true; }
  static constexpr bool goes_on() { return Start::knows_limit; }
  static constexpr bool goes_on_turning() { return Start::knows_limit; }

  StartedRounds(const Start& its_start, const LemkeRounds<S, Watcher, Pivots>& pivots)
      : start(its_start), then(pivots) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    problem_ = problem;
    phase_ = warm ? Phase::pivots : Phase::start;
    if (warm) then.begin(problem, true, memory);
  }

  /// Warm, from what `first` says of memory.active.
  void begin_near(const Problem<S>& problem, const PressureMemory<S>& memory,
                  const FirstBasis& first) {
    problem_ = problem;
    phase_ = Phase::pivots;
    then.begin_near(problem, memory, first);
  }

  Status step(const PressureMemory<S>& memory, PressureRun& run) {
    if (phase_ == Phase::start) {
      FirstBasis first;
      const bool found = start.propose(problem_, memory, run, first);
      if (!found) return begin_cold();
      phase_ = Phase::proposed;
      then.begin_near(problem_, memory, first);
      return Status::running;
    }
    const Status status = then.step(memory, run);
    const bool astray = status != Status::running && status != Status::solved;
    return astray && phase_ == Phase::proposed ? begin_cold() : status;
  }

  void vary() { then.vary(); }
  void require(const S&) {}
  Status solve_limit(Assembly<S>& assembly, const PressureMemory<S>& memory, PressureRun& run,
                     PushLimit<S>& limit) {
    FirstBasis first;
    if (!Start::knows_limit || !start.propose(problem_, memory, run, first))
      return then.solve_limit(assembly, memory, run, limit);
    return then.solve_limit_near(assembly, memory, first, run, limit);
  }

private:
  enum class Phase { start, proposed, pivots };
  Problem<S> problem_{};
  Phase phase_ = Phase::pivots;

  Status begin_cold() {
    phase_ = Phase::pivots;
    start.begins_cold();
    then.begin_cold(problem_);
    return Status::running;
  }
};

/// A few sweeps: their positive unknowns are the first basis.
template <class S, class Watcher = const Unwatched> struct SweptStart {
  static constexpr bool knows_limit = false;
  SweepRounds<S, Watcher> sweeps;

  SweptStart(const SweepRounds<S, Watcher>& its_sweeps) : sweeps(its_sweeps) {}

  bool propose(const Problem<S>& problem, const PressureMemory<S>& memory, PressureRun& run,
               FirstBasis& first) {
    sweeps.begin(problem, false, memory);
    if (sweeps.step(memory, run) != Status::solved) return false;
    const S positive = S(1) / S(10000); // forces are of order 1 in the scene's units
    for (Index i = 0; i < problem.size; ++i)
      memory.active[i] = i >= problem.free_begin || memory.z[i] > positive ? 1 : 0;
    first = {Guess::near, 1, problem.size};
    return true;
  }
  void begins_cold() {}
};
template <class S, class Watcher = const Unwatched, class Pivots = Lemke<S>>
using HybridRounds = StartedRounds<S, SweptStart<S, Watcher>, Watcher, Pivots>;

} // namespace lcpush
