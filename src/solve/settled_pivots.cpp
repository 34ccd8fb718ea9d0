#include "solve/settled_pivots.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"
#include "solve/basis_values.hpp"
#include "solve/few_generators.hpp"
#include "solve/few_points.hpp"
#include "solve/modes_of_forces.hpp"
#include "solve/newton_start.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {

Status SettledPivots::begin(const Problem<double>& problem, Status status) {
  problem_ = problem;
  last_patience_ = std::numeric_limits<Index>::max();
  is_swept_ = false;
  may_sweep_ = problem.size > limits::unknowns_dense && problem.push == nullptr &&
               has_pads(problem) && ModesOfForces::fits(problem);
  return status;
}

/// Where neither pivots nor sweeps end, other covering vectors hardly do; and where that has
/// happened several times, stiffer pads do not either: more pivots would only take time.
bool SettledPivots::gives_up(const Problem<double>& problem) const {
  constexpr int most_failures = 4;
  if (is_spent()) return true;
  if (lost_compliance_ == 0 || !has_pads(problem)) return false;
  const double now = softness(problem);
  return now == lost_compliance_ ||
         (now < lost_compliance_ && sweeps_that_failed_ >= most_failures);
}

Status SettledPivots::init(const Problem<double>& problem, const LemkeOptions<double>& options,
                           const unsigned char* active, Guess guess) {
  if (guess == Guess::near && softness(problem) != lost_compliance_) { // a solve begins
    sweeps_that_failed_ = 0;
    lost_compliance_ = 0;
  }
  is_lost_ = gives_up(problem);
  if (is_lost_) return status();
  const Status status = begin(problem, lemke_.init(problem, options, active, guess));
  if (status != Status::running || problem.size < smallest) return status;
  const Index against = points_against(lemke_, problem, values_);
  const bool is_fine = has_pads(problem) && FewGenerators::helps(problem);
  if (against <= (is_fine ? 0 : few)) return status; // few points turn many where they are fine
  Flags better(active, active + problem.size);
  if (find_better(problem, options, guess, better) &&
      lemke_.init(problem, options, better.data(), Guess::near) == Status::running)
    return lemke_.status();
  return lemke_.init(problem, options, active, guess);
}

void SettledPivots::keep_answer() {
  if (problem_.size >= smallest) swept_.assign(lemke_.z(), lemke_.z() + problem_.size);
}

/// `basis`: what values_ are of; a better one, if there is any.
bool SettledPivots::find_better(const Problem<double>& problem, const LemkeOptions<double>& options,
                                Guess guess, Flags& basis) {
  LemkeOptions<double> own;
  own.first_cover = options.first_cover;
  if (!has_pads(problem)) {
    if (assembly_.scene().pressure == Pressure::even) return false;
    const Span<Index>& body = assembly_.layout().body;
    return FewPoints(problem, {body.data, body.size}).solve(own, basis);
  }
  if (problem.push != nullptr || !ModesOfForces::fits(problem)) return false;
  swept_ = values_;
  for (Index i = 0; i < problem.free_begin; ++i) {
    double& z_i = swept_[static_cast<std::size_t>(i)];
    if (basis[static_cast<std::size_t>(i)] == 0 || z_i < 0) z_i = 0;
  }
  if (!FewGenerators::helps(problem)) return settle_pads(problem, swept_, basis);
  return FewGenerators(problem).solve(own, values_, guess, swept_, basis);
}

/// The round by sweeps, and a note if they lose it.
bool SettledPivots::sweep() {
  if (try_sweeps()) return true;
  lost_compliance_ = softness(problem_);
  ++sweeps_that_failed_;
  last_patience_ = lemke_.pivots() + more_patience;
  return false;
}

/// From the last answer, judged as theirs are; their modes are the next round's start.
bool SettledPivots::try_sweeps() {
  may_sweep_ = false;
  const Span<const SumGroup<double>>& sums = problem_.factored->sums;
  const Index couplings = coupling_count(problem_);
  Owned<BlockGaussSeidel<double>> sweeps(
      block_gauss_seidel_scalars(problem_.size, couplings, sums.size),
      block_gauss_seidel_integers(problem_.size, couplings, sums.size));
  SweepOptions<double> options;
  options.tolerance /= 100; // as far as rounding allows: the next round starts from it
  Status status = sweeps.init(problem_, options, swept_.empty() ? nullptr : swept_.data());
  if (status == Status::running) status = sweeps.solve();
  sweeps_ += sweeps.sweeps();
  const double allowed = lemke_.status() == Status::solved ? lemke_.residual().residual
                                                           : Tolerances<double>().residual;
  const bool passes = sweeps.residual().residual <= allowed;
  is_swept_ = status != Status::bad_input && passes && !sweeps.runs_away();
  if (!is_swept_) return false;
  swept_.assign(sweeps.z(), sweeps.z() + problem_.size);
  swept_basis_ = ModesOfForces(problem_, swept_.data()).vertex();
  return true;
}

} // namespace lcpush::desktop
