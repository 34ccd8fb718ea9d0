// The solvers that a pressure law's rounds may use: Lemke's pivots, block Gauss-Seidel, or the one
// finished by the other. Each solves one problem after the other, cold or from the last answer:
//
//     void begin(problem, warm, memory)
//     Status step(memory, run)     running; solved, and memory.z holds the unknowns; or why not
//
// A step is at most one pivot; sweeps are made all at once. The watcher (lcp/trace.hpp) sees every
// pivot and every check of sweeps, of all rounds.
#pragma once

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"

namespace lcpush {

/// What a pressure solve did, for reports.
struct PressureRun {
  Index rounds = 0;
  Index pivots = 0;
  Index sweeps = 0;
  Index cold_restarts = 0; ///< rounds that could not go on from the last basis
  Index turns = 0;         ///< times that round friction has turned its pyramids
  Index worst_point = -1;  ///< not_settled: the point whose friction is farthest from [T.16]
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

/// Where pivots are to begin: at memory.active, taken as `guess` says, under `covers` covering
/// vectors one after the other, each of at most `limit` pivots.
struct FirstBasis {
  Guess guess = Guess::near;
  Index covers = 1;
  Index limit = 0;
};

/// `Pivots`, Lemke over either basis: cold under its covering vectors, warm from the last basis.
template <class S, class Watcher = const Unwatched, class Pivots = Lemke<S>> struct LemkeRounds {
  Pivots& lemke;
  LemkeOptions<S> options;
  Watcher& watcher;
  /// Does it solve for the limit of a vanishing push exactly?
  static constexpr bool carries_push = true;
  static constexpr bool predicts = false; ///< starts from the modes that one expects
  static constexpr bool retreats = true;  ///< to softer pads, as PressureOptions may ask

  explicit LemkeRounds(Pivots& solver, const LemkeOptions<S>& its_options = {},
                       Watcher& its_watcher = unwatched)
      : lemke(solver), options(its_options), watcher(its_watcher) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    if (warm)
      begin_near(problem, memory, Guess::basis, options.covers);
    else
      begin_cold(problem);
  }

  Status step(const PressureMemory<S>& memory, PressureRun& run) {
    const Status status = lemke.status() == Status::running ? lemke.step(watcher) : lemke.status();
    if (status == Status::running) return status;
    run.pivots += lemke.pivots();
    run.reason = lemke.reason();
    if (status == Status::solved) {
      for (Index i = 0; i < problem_.size; ++i) {
        memory.z[i] = lemke.z()[i];
        memory.active[i] = lemke.is_basic(i) ? 1 : 0;
      }
      return status;
    }
    if (covers_tried_ == covers_) return status;
    // Copositivity does not protect a warm start: try it under each covering vector.
    start_near(memory);
    return Status::running;
  }

  /// Other covering vectors from now on.
  void vary() { options.first_cover += options.covers; }
  LemkeRounds& pivots() { return *this; }
  bool propose_breaking(const PressureMemory<S>&, FirstBasis&) { return false; }
  void demand(const S&) {} // pivots end at rounding anyway

  void begin_cold(const Problem<S>& problem) {
    problem_ = problem;
    covers_ = covers_tried_ = 0;
    (void)lemke.init(problem, options);
  }

  /// From memory.active, under `covers` covering vectors one after the other, each of at most
  /// `limit` pivots (0: the solver's own limit).
  void begin_near(const Problem<S>& problem, const PressureMemory<S>& memory, Guess guess,
                  Index covers, Index limit = 0) {
    problem_ = problem;
    guess_ = guess;
    limit_ = limit;
    covers_ = covers;
    covers_tried_ = 0;
    start_near(memory);
  }

  const Problem<S>& problem() const { return problem_; }

private:
  Problem<S> problem_{};
  Guess guess_ = Guess::basis;
  Index limit_ = 0, covers_ = 0, covers_tried_ = 0;

  void start_near(const PressureMemory<S>& memory) {
    LemkeOptions<S> single = options;
    single.covers = 1;
    if (limit_ > 0) single.max_pivots = limit_;
    single.first_cover += covers_tried_;
    ++covers_tried_;
    (void)lemke.init(problem_, single, memory.active.data, guess_);
  }
};

template <class S, class B>
LemkeRounds(Lemke<S, B>&) -> LemkeRounds<S, const Unwatched, Lemke<S, B>>;

/// Block Gauss-Seidel: cold from even shares, warm from the last forces.
template <class S, class Watcher = const Unwatched> struct SweepRounds {
  BlockGaussSeidel<S>& sweeps;
  SweepOptions<S> options;
  Watcher& watcher;
  static constexpr bool carries_push = false;
  static constexpr bool predicts = false;
  static constexpr bool retreats = true;

  explicit SweepRounds(BlockGaussSeidel<S>& solver, const SweepOptions<S>& its_options = {},
                       Watcher& its_watcher = unwatched)
      : sweeps(solver), options(its_options), watcher(its_watcher) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    size_ = problem.size;
    (void)sweeps.init(problem, options, warm ? memory.z.data : nullptr, watcher);
  }

  Status step(const PressureMemory<S>& memory, PressureRun& run) {
    Status status = sweeps.solve(watcher);
    run.sweeps += sweeps.sweeps();
    run.reason = Reason::none;
    // Asked for more than rounding allows: what the referee lets pass is an answer all the same.
    const bool passes = sweeps.residual().residual <= Tolerances<S>().residual;
    if (status != Status::solved && passes && !sweeps.runs_away()) status = Status::solved;
    if (status != Status::solved) return status;
    for (Index i = 0; i < size_; ++i) memory.z[i] = sweeps.z()[i];
    return status;
  }

  void vary() {} // the same input takes the same path
  /// Answers have to be this good, as far as the solver gets.
  void demand(const S& tolerance) { options.tolerance = tolerance; }

private:
  Index size_ = 0;
};

/// Lemke's pivots from a first basis, cold if there is none or if it leads nowhere; warm rounds go
/// on from the last answer. It is never less reliable than LemkeRounds. The basis is Start's:
///
///     bool propose(problem, memory, run, first)     fills memory.active and `first`, if it can
///     void begins_cold()                            it could not, or its basis led nowhere
///     knows_breaking                                does it propose for a vanishing push as well?
template <class S, class Start, class Watcher = const Unwatched, class Pivots = Lemke<S>>
struct StartedRounds {
  Start start;
  LemkeRounds<S, Watcher, Pivots> then;
  static constexpr bool carries_push = true;
  static constexpr bool predicts = Start::knows_breaking;
  static constexpr bool retreats = true;

  StartedRounds(const Start& its_start, const LemkeRounds<S, Watcher, Pivots>& pivots)
      : start(its_start), then(pivots) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    problem_ = problem;
    phase_ = warm ? Phase::pivots : Phase::start;
    if (warm) then.begin(problem, true, memory);
  }

  Status step(const PressureMemory<S>& memory, PressureRun& run) {
    if (phase_ == Phase::start) {
      FirstBasis first;
      const bool found = start.propose(problem_, memory, run, first);
      if (!found) return begin_cold();
      phase_ = Phase::proposed;
      then.begin_near(problem_, memory, first.guess, first.covers, first.limit);
      return Status::running;
    }
    const Status status = then.step(memory, run);
    const bool astray = status != Status::running && status != Status::solved;
    return astray && phase_ == Phase::proposed ? begin_cold() : status;
  }

  void vary() { then.vary(); }
  LemkeRounds<S, Watcher, Pivots>& pivots() { return then; }
  void demand(const S&) {}
  /// A first basis for the limit of a vanishing push, if Start knows one.
  bool propose_breaking(const PressureMemory<S>& memory, FirstBasis& first) {
    PressureRun ignored;
    return Start::knows_breaking && start.propose(problem_, memory, ignored, first);
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
  static constexpr bool knows_breaking = false;
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
