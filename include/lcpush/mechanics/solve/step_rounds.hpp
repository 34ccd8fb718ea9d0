// Rounds of a pressure law that begin where those of the last time step began and ended.
#pragma once

#include "lcpush/mechanics/solve/rounds.hpp"

namespace lcpush {

/// What stays between two steps: the basis in which the first round ended. The later rounds change
/// little of it (a median of two pivots), and the next step as little.
struct LastStep {
  Span<unsigned char> active; ///< unknowns of the step to come
  bool known = false;
  Guess guess = Guess::near; ///< Guess::basis: the contacts are the same as then
};

/// LemkeRounds whose first round starts from the last step's basis, cold if that leads nowhere.
template <class S, class Pivots = Lemke<S>> class StepRounds {
public:
  StepRounds(Pivots& lemke, LastStep& last, const LemkeOptions<S>& options = {})
      : then_(lemke, options), last_(&last) {}

  void begin(const Problem<S>& problem, bool warm, const PressureMemory<S>& memory) {
    is_first_ = rounds_++ == 0;
    tries_last_ = is_first_ && last_->known;
    if (!tries_last_) return then_.begin(problem, warm, memory);
    for (Index i = 0; i < problem.size; ++i) memory.active[i] = last_->active[i];
    then_.begin_near(problem, memory, {last_->guess, 2, problem.size / 2 + 16});
  }

  Status step(const PressureMemory<S>& memory, PressureRun& run) {
    const Status status = then_.step(memory, run);
    if (status == Status::running) return status;
    if (status != Status::solved && tries_last_) {
      tries_last_ = false;
      ++run.cold_restarts;
      then_.begin_cold(then_.problem());
      return Status::running;
    }
    if (status == Status::solved && is_first_) {
      for (Index i = 0; i < then_.problem().size; ++i) last_->active[i] = memory.active[i];
      last_->known = true;
    }
    return status;
  }

  void vary() { then_.vary(); }

private:
  LemkeRounds<S, const Unwatched, Pivots> then_;
  LastStep* last_;
  Index rounds_ = 0;
  bool is_first_ = false, tries_last_ = false;
};

} // namespace lcpush
