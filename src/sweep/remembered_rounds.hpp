// Rounds of a pressure law (mechanics/solve/rounds.hpp) that first try the bases in which the same rounds
// ended at a neighbouring value.
#pragma once

#include "lcpush/mechanics/solve/rounds.hpp"
#include "sweep/basis_solution.hpp"

namespace lcpush::desktop {

/// What stays between two values.
struct RoundMemory {
  std::vector<Basis>& bases; ///< by the number of the round
  std::size_t next = 0;      ///< round of this solve
  Index cold = 0;            ///< rounds that began from nothing
};

class RememberedRounds {
public:
  static constexpr bool carries_push = true;

  RememberedRounds(Lemke<double>& lemke, RoundMemory& memory) : then_(lemke), memory_(memory) {}

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& pressure) {
    problem_ = problem;
    round_ = memory_.next++;
    const bool known = round_ < memory_.bases.size() &&
                       static_cast<Index>(memory_.bases[round_].size()) == problem.size;
    phase_ = Phase::pivots;
    if (known && solve_on_basis(problem, memory_.bases[round_], solution_)) {
      phase_ = Phase::remembered;
    } else if (warm) {
      then_.begin(problem, true, pressure);
    } else if (known) {
      phase_ = Phase::near;
      for (Index i = 0; i < problem.size; ++i)
        pressure.active[i] = memory_.bases[round_][static_cast<std::size_t>(i)];
      then_.begin_near(problem, pressure, Guess::basis, 1, problem.size);
    } else {
      begin_cold();
    }
  }

  Status step(const PressureMemory<double>& pressure, PressureRun& run) {
    if (phase_ == Phase::remembered) {
      for (Index i = 0; i < problem_.size; ++i) {
        pressure.z[i] = solution_.z[i];
        pressure.active[i] = memory_.bases[round_][static_cast<std::size_t>(i)];
      }
      run.reason = Reason::none;
      return Status::solved;
    }
    const Status status = then_.step(pressure, run);
    if (status == Status::solved) keep(pressure);
    if (status == Status::solved || status == Status::running || phase_ != Phase::near)
      return status;
    phase_ = Phase::pivots;
    begin_cold();
    return Status::running;
  }

  void vary() { then_.vary(); }
  LemkeRounds<double>& pivots() { return then_; }
  void demand(double) {}

private:
  enum class Phase { remembered, near, pivots };
  LemkeRounds<double> then_;
  RoundMemory& memory_;
  Problem<double> problem_{};
  BasisSolution solution_;
  std::size_t round_ = 0;
  Phase phase_ = Phase::pivots;

  void begin_cold() {
    ++memory_.cold;
    then_.begin_cold(problem_);
  }

  void keep(const PressureMemory<double>& pressure) {
    if (memory_.bases.size() <= round_) memory_.bases.resize(round_ + 1);
    memory_.bases[round_].assign(pressure.active.begin(), pressure.active.end());
  }
};

} // namespace lcpush::desktop
