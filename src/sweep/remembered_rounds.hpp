// Rounds of a pressure law (mechanics/solve/rounds.hpp) that first try the bases in which the same
// rounds ended at a neighbouring value.
#pragma once

#include <algorithm>
#include <type_traits>

#include "dense/basis_solution.hpp"
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

/// Is the basis the answer as it is, without a pivot? Then `lemke` stands there.
template <class Pivots>
bool stands_on(const Basis& basis, const Problem<double>& problem, LemkeOptions<double> options,
               Pivots& lemke) {
  options.covers = 1;
  if (static_cast<Index>(basis.size()) != problem.size) return false;
  if (lemke.init(problem, options, basis.data(), Guess::basis) != Status::running) return false;
  return lemke.step(unwatched) == Status::solved && lemke.pivots() == 0;
}

/// By Lemke over either basis. `structured`, if there is one, looks whether a basis holds where the
/// neighbour's factors do not help.
template <class Pivots> class RememberedRounds {
  using Then = LemkeRounds<double, const Attendant, Pivots>;

public:
  static constexpr bool carries_push = true;
  static constexpr bool predicts = true; ///< slower pushes go on, as those of a solve do
  static constexpr bool retreats = true;

  RememberedRounds(Pivots& lemke, RoundMemory& memory, const Attendant& attendant,
                   StructuredLemke<double>* structured)
      : then_(RememberedStart{memory}, Then(lemke, {}, attendant)), structured_(structured) {}

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& pressure) {
    then_.pivots().watcher.look();
    RememberedStart& start = then_.start;
    start.round = start.memory.begin_round();
    size_ = problem.size;
    holds_ = !start.memory.is_fresh && start.knows(problem.size) && holds_here(problem);
    fails_ = warm && start.failed();
    if (!holds_ && !fails_) then_.begin(problem, warm, pressure);
  }

  Status step(const PressureMemory<double>& pressure, PressureRun& run) {
    if (holds_) {
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
  StructuredLemke<double>* structured_;
  BasisSolution solution_;
  Index size_ = 0;     ///< unknowns of the round: the memory may have room for more
  bool holds_ = false; ///< is the remembered basis the answer itself?
  bool fails_ = false; ///< the same rounds led here at the neighbour, and pivots no further

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
    const bool drifts = factored.drifts && factored.basis == start.basis();
    if (problem.size <= most_kept && !drifts)
      return solve_on_basis(problem, start.basis(), solution_, &factored);
    if (structured_ == nullptr) return solve_on_basis(problem, start.basis(), solution_);
    if (!stands_on(start.basis(), problem, then_.pivots().options, *structured_)) return false;
    solution_.z = Eigen::Map<const Eigen::VectorXd>(structured_->z(), problem.size);
    return true;
  }
};

} // namespace lcpush::desktop
