// Rounds of a pressure law (mechanics/solve/rounds.hpp) that first try the bases in which the same
// rounds ended at a neighbouring value.
#pragma once

#include <algorithm>
#include <type_traits>

#include "dense/basis_solution.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"
#include "sweep/sweep_solver.hpp"

namespace lcpush::desktop {

/// What stays between two values.
struct RoundMemory {
  std::vector<Basis>& bases;            ///< by the number of the round; empty: it has failed
  std::vector<FactoredBasis>& factored; ///< the same
  bool is_fresh = bases.empty();        ///< nothing nearby: as a solve, by its own pivots alone
  std::size_t next = 0;                 ///< round of this solve
  Index cold = 0;                       ///< rounds that began from nothing
  bool follows = !is_fresh;             ///< have all rounds ended as they did at the neighbour?

  std::size_t begin_round() {
    if (factored.size() <= next) factored.resize(next + 1);
    return next++;
  }
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
  using Then = LemkeRounds<double, const Attendant, Pivots>;

public:
  static constexpr bool carries_push = true;
  static constexpr bool predicts = true; ///< slower pushes go on, as those of a solve do
  static constexpr bool retreats = true;

  RememberedRounds(Pivots& lemke, RoundMemory& memory, const Attendant& attendant,
                   HeldBasis<double>& held, StructuredLemke<double>& structured)
      : then_(RememberedStart{memory}, Then(lemke, {}, attendant)), held_(held),
        structured_(structured) {}

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& pressure) {
    then_.pivots().watcher.look();
    RememberedStart& start = then_.start;
    start.round = start.memory.begin_round();
    size_ = problem.size;
    is_known_ = !start.memory.is_fresh && start.knows(problem.size) &&
                (holds_here(problem) || is_near(problem));
    fails_ = warm && start.failed();
    if (!is_known_ && !fails_) then_.begin(problem, warm, pressure);
  }

  Status step(const PressureMemory<double>& pressure, PressureRun& run) {
    if (is_known_) {
      std::copy(solution_.z.begin(), solution_.z.end(), pressure.z.data);
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
  Then& pivots() { return then_.pivots(); }
  void demand(double) {}
  bool propose_breaking(const PressureMemory<double>&, FirstBasis&) { return false; }

private:
  StartedRounds<double, RememberedStart, const Attendant, Pivots> then_;
  HeldBasis<double>& held_;
  StructuredLemke<double>& structured_;
  BasisSolution solution_;
  Index size_ = 0;        ///< unknowns of the round: the memory may have room for more
  bool is_known_ = false; ///< `solution_` is the round's answer, and the memory has its basis
  bool fails_ = false;    ///< the same rounds led here at the neighbour, and pivots no further

  void remember(Status status, const PressureMemory<double>& pressure) {
    Basis basis;
    if (status == Status::solved)
      basis.assign(pressure.active.begin(), pressure.active.begin() + size_);
    then_.start.memory.end_round(then_.start.round, std::move(basis));
  }
  /// A dense basis is solved by the neighbour's factors, if they will do.
  bool holds_here(const Problem<double>& problem) {
    constexpr Index most_kept = 199;
    const RememberedStart& start = then_.start;
    FactoredBasis& factored = start.memory.factored[start.round];
    if (problem.size <= most_kept && !factored.drifts)
      return solve_on_basis(problem, start.basis(), solution_, &factored);
    if (held_.look(problem, start.basis().data()) != Status::solved) return false;
    solution_.z = Eigen::Map<const Eigen::VectorXd>(held_.z(), problem.size);
    return true;
  }
  /// Does the round end after a few pivots from there? More of them may end at another answer than
  /// the neighbour's goes on to.
  bool is_near(const Problem<double>& problem) {
    constexpr Index few = 4;
    if (std::is_same_v<Pivots, StructuredLemke<double>>) return false;
    RememberedStart& start = then_.start;
    LemkeOptions<double> options = then_.pivots().options;
    options.covers = 1;
    options.max_pivots = few;
    Status status = structured_.init(problem, options, start.basis().data());
    if (status == Status::running) status = structured_.solve(then_.pivots().watcher);
    if (status != Status::solved) return false;
    solution_.z = Eigen::Map<const Eigen::VectorXd>(structured_.z(), problem.size);
    start.memory.end_round(start.round, basis_of(structured_, problem.size));
    return true;
  }
};

} // namespace lcpush::desktop
