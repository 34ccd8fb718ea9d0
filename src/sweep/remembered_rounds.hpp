// Rounds of a pressure law (mechanics/solve/rounds.hpp) that first try the bases in which the same
// rounds ended at a neighbouring value.
#pragma once

#include <algorithm>

#include "dense/basis_solution.hpp"
#include "lcpush/mechanics/solve/rounds.hpp"
#include "sweep/sweep_solver.hpp"

namespace lcpush::desktop {

/// What stays between two values.
struct RoundMemory {
  std::vector<Basis>& bases;            ///< by the number of the round
  std::vector<FactoredBasis>& factored; ///< the same
  bool is_fresh = bases.empty();        ///< nothing nearby: as a solve, by its own pivots alone
  std::size_t next = 0;                 ///< round of this solve
  Index cold = 0;                       ///< rounds that began from nothing

  std::size_t begin_round() {
    if (factored.size() <= next) factored.resize(next + 1);
    return next++;
  }
};

/// A round's first basis is the one that it ended in at the neighbour.
struct RememberedStart {
  RoundMemory& memory;
  std::size_t round = 0;

  bool knows(Index size) const {
    return round < memory.bases.size() && static_cast<Index>(basis().size()) == size;
  }
  const Basis& basis() const { return memory.bases[round]; }
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

/// By Lemke over either basis.
template <class Pivots> class RememberedRounds {
  using Then = LemkeRounds<double, const Attendant, Pivots>;

public:
  static constexpr bool carries_push = true;
  static constexpr bool predicts = false;

  RememberedRounds(Pivots& lemke, RoundMemory& memory, const Attendant& attendant)
      : then_(RememberedStart{memory}, Then(lemke, {}, attendant)) {}

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& pressure) {
    then_.pivots().watcher.look();
    RememberedStart& start = then_.start;
    start.round = start.memory.begin_round();
    size_ = problem.size;
    holds_ = !start.memory.is_fresh && start.knows(problem.size) && holds_here(problem);
    if (!holds_) then_.begin(problem, warm, pressure);
  }

  Status step(const PressureMemory<double>& pressure, PressureRun& run) {
    if (holds_) {
      std::copy(solution_.z.begin(), solution_.z.end(), pressure.z.data);
      then_.start.copy_to(pressure);
      run.reason = Reason::none;
      return Status::solved;
    }
    const Status status = then_.step(pressure, run);
    if (status == Status::solved) remember(pressure);
    return status;
  }

  void vary() { then_.vary(); }
  Then& pivots() { return then_.pivots(); }
  void demand(double) {}
  bool propose_breaking(const PressureMemory<double>&, FirstBasis&) { return false; }

private:
  StartedRounds<double, RememberedStart, const Attendant, Pivots> then_;
  BasisSolution solution_;
  Index size_ = 0;     ///< unknowns of the round: the memory may have room for more
  bool holds_ = false; ///< is the remembered basis the answer itself?

  void remember(const PressureMemory<double>& pressure) {
    std::vector<Basis>& bases = then_.start.memory.bases;
    const std::size_t round = then_.start.round;
    if (bases.size() <= round) bases.resize(round + 1);
    bases[round].assign(pressure.active.begin(), pressure.active.begin() + size_);
  }
  bool holds_here(const Problem<double>& problem) {
    constexpr Index most_kept = 400; // unknowns: 0.5 MB a round
    const RememberedStart& start = then_.start;
    FactoredBasis* const near =
        problem.size <= most_kept ? &start.memory.factored[start.round] : nullptr;
    return solve_on_basis(problem, start.basis(), solution_, near);
  }
};

} // namespace lcpush::desktop
