// Rounds of a pressure law (mechanics/solve/rounds.hpp) that first try the bases in which the same
// rounds ended at a neighbouring value.
#pragma once

#include <algorithm>
#include <type_traits>

#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/mechanics/solve/first_basis.hpp"
#include "sweep/sweep_solver.hpp"

namespace lcpush::desktop {

/// What stays between two values.
struct RoundMemory {
  std::vector<Basis>& bases;     ///< by the number of the round; empty: it has failed
  bool is_fresh = bases.empty(); ///< nothing nearby: as a solve, by its own pivots alone
  std::size_t next = 0;          ///< round of this solve
  Index cold = 0;                ///< rounds that began from nothing
  bool follows = !is_fresh;      ///< have all rounds ended as they did at the neighbour?

  /// `basis`: the one that the round has ended in, or none.
  void end_round(std::size_t round, Basis basis) {
    follows = follows && round < bases.size() && bases[round] == basis;
    if (bases.size() <= round) bases.resize(round + 1);
    bases[round] = std::move(basis);
  }
  /// By another solver.
  void begin_again() {
    next = 0;
    follows = false;
  }
  /// No more rounds.
  void end() { bases.resize(std::min(bases.size(), next)); }
};

/// The basis that Lemke stands at.
template <class Pivots> Basis basis_of(const Pivots& lemke, Index size) {
  Basis basis(static_cast<std::size_t>(size));
  for (Index i = 0; i < size; ++i) basis[static_cast<std::size_t>(i)] = lemke.is_basic(i) ? 1 : 0;
  return basis;
}

/// A round's first basis is the one that it ended in at the neighbour.
struct RememberedStart {
  static constexpr bool knows_limit = false;
  RoundMemory& memory;
  std::size_t round = 0;

  bool knows(Index size) const {
    return round < memory.bases.size() && static_cast<Index>(basis().size()) == size;
  }
  const Basis& basis() const { return memory.bases[round]; }
  bool failed() const {
    return memory.follows && round < memory.bases.size() && memory.bases[round].empty();
  }
  void copy_to(const PressureMemory<double>& pressure) const {
    std::copy(basis().begin(), basis().end(), pressure.active.data);
  }
  bool propose(const Problem<double>& problem, const PressureMemory<double>& pressure, PressureRun&,
               FirstBasis& first) {
    if (!knows(problem.size)) return false;
    copy_to(pressure);
    first = {Guess::basis, 1, problem.size};
    return true;
  }
  void begins_cold() { ++memory.cold; }
};

/// By Lemke over either basis: where `Pivots` are dense, `structured` tries first to get there from
/// the neighbour's basis. Dense pivots start slowly from one, as each unknown has to be brought in.
template <class Pivots> class RememberedRounds {
  using Then = LemkeRounds<double, Watcher, Pivots>;

public:
  static constexpr bool carries_push() { return true; }
  static constexpr bool goes_on() { return true; } ///< as slower pushes of a solve do

  RememberedRounds(Pivots& lemke, RoundMemory& memory, StopWatcher& watcher,
                   HeldBasis<double>& held, StructuredLemke<double>& structured)
      : then_(RememberedStart{memory}, Then(lemke, {}, watcher)), watcher_(watcher), held_(held),
        structured_(structured) {}

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& pressure) {
    watcher_.look();
    RememberedStart& start = then_.start;
    start.round = start.memory.next++;
    size_ = problem.size;
    known_ = nullptr;
    if (!start.memory.is_fresh && start.knows(problem.size) && !holds_here(problem))
      find_near(problem);
    fails_ = warm && start.failed();
    if (known_ == nullptr && !fails_) then_.begin(problem, warm, pressure);
  }

  Status step(const PressureMemory<double>& pressure, PressureRun& run) {
    if (known_ != nullptr) {
      std::copy_n(known_, size_, pressure.z.data);
      then_.start.copy_to(pressure);
      run.reason = Reason::none;
      return Status::solved;
    }
    if (fails_) return Status::numerical_breakdown;
    const Status status = then_.step(pressure, run);
    if (status != Status::running) remember(status, pressure);
    return status;
  }

  void vary() { then_.vary(); }
  void require(double) {}
  Status solve_limit(Assembly<double>& assembly, const PressureMemory<double>& memory,
                     PressureRun& run, PushLimit<double>& limit) {
    return then_.then.solve_limit(assembly, memory, run, limit);
  }

private:
  StartedRounds<double, RememberedStart, Watcher, Pivots> then_;
  StopWatcher& watcher_;
  HeldBasis<double>& held_;
  StructuredLemke<double>& structured_;
  Index size_ = 0;                ///< unknowns of the round: the memory may have room for more
  const double* known_ = nullptr; ///< the round's answer, if the memory has its basis
  bool fails_ = false; ///< the same rounds led here at the neighbour, and pivots no further

  void remember(Status status, const PressureMemory<double>& pressure) {
    Basis basis;
    if (status == Status::solved)
      basis.assign(pressure.active.begin(), pressure.active.begin() + size_);
    then_.start.memory.end_round(then_.start.round, std::move(basis));
  }
  bool holds_here(const Problem<double>& problem) {
    if (held_.look(problem, then_.start.basis().data()) != Status::solved) return false;
    known_ = held_.z();
    return true;
  }
  /// Does the round end after a few pivots from there? More of them may end at another answer than
  /// the neighbour's goes on to.
  void find_near(const Problem<double>& problem) {
    if (std::is_same_v<Pivots, StructuredLemke<double>>) return;
    RememberedStart& start = then_.start;
    LemkeOptions<double> options = then_.then.options;
    options.covers = 1;
    options.max_pivots = SolveSettings().near_pivots;
    Status status = structured_.init(problem, options, start.basis().data());
    if (status == Status::running) status = structured_.solve<Watcher>(watcher_);
    if (status != Status::solved) return;
    known_ = structured_.z();
    start.memory.end_round(start.round, basis_of(structured_, problem.size));
  }
};

} // namespace lcpush::desktop
