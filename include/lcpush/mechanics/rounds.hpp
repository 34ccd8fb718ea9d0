// The solvers that a pressure law's rounds may use: Lemke's pivots, block Gauss-Seidel, or the one
// finished by the other. Each solves one problem after the other, cold or from the last answer:
//
//     Status solve(problem, warm, memory, run)
//
// Post: solved, and memory.z holds the unknowns; or why not. The observer (lcp/trace.hpp) sees
// every pivot and every check of sweeps, of all rounds.
#pragma once

#include "lcpush/lcp/block_gauss_seidel.hpp"
#include "lcpush/lcp/lemke.hpp"

namespace lcpush {

/// What a pressure solve did, for reports.
struct PressureRun {
  Index rounds = 0;
  Index pivots = 0;
  Index sweeps = 0;
  Index cold_restarts = 0; ///< rounds that could not go on from the last basis
  Reason reason = Reason::none;
  bool jammed = false; ///< a ray of the problem without compliance: a squeeze, not a pad's failure
};

/// Memory beside the solver's: one Scalar a point for the last round's pressure, three a point and
/// unknown for bookkeeping, one flag an unknown.
template <class S> struct PressureMemory {
  Span<S> preload;            ///< points: lambda of the last round
  Span<S> compliance;         ///< points: c_i
  Span<S> z;                  ///< unknowns: the last round's solution
  Span<unsigned char> active; ///< unknowns: its basis
};

/// Lemke's pivots: cold under its covers, warm from the last basis.
template <class S, class Observer = const Unobserved> struct LemkeRounds {
  Lemke<S>& lemke;
  LemkeOptions<S> options{};
  Observer& observer = unobserved;
  static constexpr bool carries_push = true; ///< solves for the limit of a vanishing push exactly

  Status solve(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory,
               PressureRun& run) {
    if (!warm) return finish(lemke.init(problem, options), problem, memory, run);
    // Copositivity does not protect a warm start: try it under each cover.
    LemkeOptions<S> single = options;
    single.covers = 1;
    Status status = Status::ray;
    for (Index k = 0; k < options.covers && status != Status::solved; ++k, ++single.first_cover)
      status = finish(lemke.init(problem, single, memory.active.data), problem, memory, run);
    return status;
  }

  /// Other covers from now on.
  void vary() { options.first_cover += options.covers; }
  LemkeRounds& pivots() { return *this; }
  void demand(const S&) {} // pivots end at rounding anyway

  Status finish(Status status, const Problem<S>& problem, const PressureMemory<S>& memory,
                PressureRun& run) {
    if (status == Status::running) status = lemke.solve(observer);
    run.pivots += lemke.pivots();
    run.reason = lemke.reason();
    if (status != Status::solved) return status;
    for (Index i = 0; i < problem.size; ++i) {
      memory.z[i] = lemke.z()[i];
      memory.active[i] = lemke.is_basic(i) ? 1 : 0;
    }
    return status;
  }
};

/// Block Gauss-Seidel: cold from even shares, warm from the last forces.
template <class S, class Observer = const Unobserved> struct SweepRounds {
  BlockGaussSeidel<S>& sweeps;
  SweepOptions<S> options{};
  Observer& observer = unobserved;
  static constexpr bool carries_push = false;

  Status solve(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory,
               PressureRun& run) {
    Status status = sweeps.init(problem, options, warm ? memory.z.data : nullptr, observer);
    if (status == Status::running) status = sweeps.solve(observer);
    run.sweeps += sweeps.sweeps();
    run.reason = Reason::none;
    // Asked for more than rounding allows: what the referee lets pass is an answer all the same.
    const bool passes = sweeps.residual().residual <= Tolerances<S>().residual;
    if (status != Status::solved && passes && !sweeps.runs_away()) status = Status::solved;
    if (status != Status::solved) return status;
    for (Index i = 0; i < problem.size; ++i) memory.z[i] = sweeps.z()[i];
    return status;
  }

  void vary() {} // the same input takes the same path
  /// Answers have to be this good, as far as the solver gets.
  void demand(const S& tolerance) { options.tolerance = tolerance; }
};

/// A few sweeps, their positive unknowns as Lemke's first basis, and the pivots that remain. Warm
/// rounds, and whatever fails, are Lemke's: it is never less reliable.
template <class S, class Observer = const Unobserved> struct HybridRounds {
  SweepRounds<S, Observer> first;
  LemkeRounds<S, Observer> then;
  static constexpr bool carries_push = true;

  Status solve(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory,
               PressureRun& run) {
    if (warm) return then.solve(problem, true, memory, run);
    const S positive = S(1) / S(10000); // forces are of order 1 in the scene's units
    if (first.solve(problem, false, memory, run) == Status::solved) {
      for (Index i = 0; i < problem.size; ++i)
        memory.active[i] = i >= problem.free_begin || memory.z[i] > positive ? 1 : 0;
      LemkeOptions<S> single = then.options;
      single.covers = 1;
      single.max_pivots =
          problem.size; // a start that leads astray shall not cost more than a cold one
      const Status status = then.finish(
          then.lemke.init(problem, single, memory.active.data, Guess::near), problem, memory, run);
      if (status == Status::solved) return status;
    }
    return then.solve(problem, false, memory, run);
  }

  void vary() { then.vary(); }
  LemkeRounds<S, Observer>& pivots() { return then; }
  void demand(const S&) {}
};

} // namespace lcpush
