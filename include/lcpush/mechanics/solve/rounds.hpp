// The solvers that the proximal iterations of a pressure law ("rounds") may use: Lemke's pivots, or
// block Gauss-Seidel. Each solves one problem after the other, cold or from the last answer:
//
//     void begin(problem, warm, memory)
//     Status step(memory, run)     running; solved, and memory.z holds the unknowns; or why not
//     void vary()                  other covering vectors from now on, where there are any
//
// and for a breaking force
//
//     void require(tolerance)      of the answers from now on, as far as the solver gets
//     bool carries_push()          does it solve for the limit of a vanishing push exactly?
//     Status solve_limit(assembly, memory, run, limit)    that limit, if so
//     bool goes_on()               may a slower push go on from the last one's pressure?
//     bool goes_on_turning()       the same of pads that settle together with pyramids that turn
//
// A step is at most one pivot; Gauss-Seidel sweeps are made all at once. The watcher
// (lcp/trace.hpp) sees every pivot and every check of sweeps, of all rounds. Where pivots may begin
// but at nothing and at the last answer: first_basis.hpp.
#pragma once

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"
#include "lcpush/mechanics/model/assemble.hpp"

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
/// vectors one after the other, each of at most `limit` pivots (0: the solver's own limit).
struct FirstBasis {
  Guess guess = Guess::near;
  Index covers = 1;
  Index limit = 0;
};

/// The answer of a vanishing push: z + sigma z_push for 0 <= sigma <= valid_to (< 0: no bound). It
/// looks into the solver.
template <class S> struct PushLimit {
  const S* z = nullptr;
  const S* z_push = nullptr;
  S valid_to{-1};
};

/// `Pivots`, Lemke over either basis: cold under its covering vectors, warm from the last basis.
template <class S, class Watcher = const Unwatched, class Pivots = Lemke<S>> struct LemkeRounds {
  Pivots& lemke;
  LemkeOptions<S> options;
  Watcher& watcher;
  static constexpr bool carries_push() { return true; }
  static constexpr bool goes_on() { return false; }
  static constexpr bool goes_on_turning() { return false; }

  explicit LemkeRounds(Pivots& solver, const LemkeOptions<S>& its_options = {},
                       Watcher& its_watcher = unwatched)
      : lemke(solver), options(its_options), watcher(its_watcher) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    if (warm)
      begin_near(problem, memory, {Guess::basis, options.covers, 0});
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
    if (covers_tried_ == first_.covers) return status;
    // Copositivity does not protect a warm start: try it under each covering vector.
    start_near(memory);
    return Status::running;
  }

  void vary() { options.first_cover += options.covers; }
  void require(const S&) {} // pivots end at rounding anyway

  void begin_cold(const Problem<S>& problem) {
    problem_ = problem;
    first_.covers = covers_tried_ = 0;
    (void)lemke.init(problem, options);
  }
  void begin_near(const Problem<S>& problem, const PressureMemory<S>& memory,
                  const FirstBasis& first) {
    problem_ = problem;
    first_ = first;
    covers_tried_ = 0;
    start_near(memory);
  }

  Status solve_limit(Assembly<S>& assembly, const PressureMemory<S>&, PressureRun& run,
                     PushLimit<S>& limit) {
    return end_limit(lemke.init(assembly.breaking_problem(), options), run, limit);
  }
  /// From memory.active, cold if that leads nowhere.
  Status solve_limit_near(Assembly<S>& assembly, const PressureMemory<S>& memory,
                          const FirstBasis& first, PressureRun& run, PushLimit<S>& limit) {
    const LemkeOptions<S> single = single_cover(first);
    const Status begun =
        lemke.init(assembly.breaking_problem(), single, memory.active.data, first.guess);
    const Status status = end_limit(begun, run, limit);
    return status == Status::solved ? status : solve_limit(assembly, memory, run, limit);
  }

  const Problem<S>& problem() const { return problem_; }

private:
  Problem<S> problem_{};
  FirstBasis first_;
  Index covers_tried_ = 0;

  LemkeOptions<S> single_cover(const FirstBasis& first) const {
    LemkeOptions<S> single = options;
    single.covers = 1;
    if (first.limit > 0) single.max_pivots = first.limit;
    return single;
  }
  void start_near(const PressureMemory<S>& memory) {
    LemkeOptions<S> single = single_cover(first_);
    single.first_cover += covers_tried_++;
    (void)lemke.init(problem_, single, memory.active.data, first_.guess);
  }
  Status end_limit(Status begun, PressureRun& run, PushLimit<S>& limit) {
    const Status status = begun == Status::running ? lemke.solve(watcher) : begun;
    run.pivots += lemke.pivots();
    run.reason = lemke.reason();
    if (status == Status::solved) limit = {lemke.z(), lemke.z_push(), lemke.valid_to()};
    return status;
  }
};

template <class S, class B>
LemkeRounds(Lemke<S, B>&) -> LemkeRounds<S, const Unwatched, Lemke<S, B>>;

/// Block Gauss-Seidel: cold from even shares, warm from the last forces.
template <class S, class Watcher = const Unwatched> struct SweepRounds {
  BlockGaussSeidel<S>& sweeps;
  SweepOptions<S> options;
  Watcher& watcher;
  static constexpr bool carries_push() { return false; }
  static constexpr bool goes_on() { return false; }
  static constexpr bool goes_on_turning() { return false; }

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
  void require(const S& tolerance) { options.tolerance = tolerance; }
  Status solve_limit(Assembly<S>&, const PressureMemory<S>&, PressureRun&, PushLimit<S>&) {
    return Status::bad_input;
  }

private:
  Index size_ = 0;
};

} // namespace lcpush
