#include "solve/settled_pivots.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"
#include "solve/basis_values.hpp"
#include "solve/few_points.hpp"
#include "solve/modes_of_forces.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

constexpr double clearly = 1e-12;

/// How fast the fastest point slips, over how much the firmest can rub.
double slip_by_friction(const Problem<double>& problem, const std::vector<double>& z) {
  double slip = 0, limit = 0;
  for (const ConeGroup<double>& cone : problem.factored->cones) {
    if (cone.generators == 0) continue;
    slip = std::max(slip, z[static_cast<std::size_t>(cone.slip())]);
    limit = std::max(limit, cone.friction_limit(z.data()));
  }
  return limit > 0 ? slip / limit : 0;
}

Index coupling_count(const Problem<double>& problem) {
  Index count = 0;
  for (const SumGroup<double>& sum : problem.factored->sums) count += sum.count;
  return count;
}

Owned<ProximalNewton<double>> newton_for(const Problem<double>& problem) {
  const Index couplings = coupling_count(problem), sums = problem.factored->sums.size;
  return {proximal_scalars(problem.size, couplings, sums),
          proximal_integers(problem.size, couplings, sums)};
}

Index differences(const SettledPivots::Flags& a, const SettledPivots::Flags& b) {
  Index count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

} // namespace

Status SettledPivots::begin(const Problem<double>& problem, Status status) {
  problem_ = problem;
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
  if (guess == Guess::near && softness(problem) > lost_compliance_) { // a solve begins
    sweeps_that_failed_ = 0;
    lost_compliance_ = 0;
  }
  is_lost_ = gives_up(problem);
  if (is_lost_) return status();
  const Status status = begin(problem, lemke_.init(problem, options, active, guess));
  if (status != Status::running || problem.size < smallest || opposed(problem) <= few)
    return status;
  const Flags from(active, active + problem.size);
  Flags better;
  if (find_better(problem, options, from, better) &&
      lemke_.init(problem, options, better.data(), Guess::near) == Status::running)
    return lemke_.status();
  return lemke_.init(problem, options, active, guess);
}

void SettledPivots::keep_answer() {
  if (problem_.size >= smallest) swept_.assign(lemke_.z(), lemke_.z() + problem_.size);
}

/// How many points are against the basis, in whatever way: some basic value is negative. values_
/// becomes z_i where it is basic, w_i where that is.
Index SettledPivots::opposed(const Problem<double>& problem) {
  const Dictionary<double>& basis = lemke_.dictionary();
  const Index n = problem.size, push = problem.free_begin < n ? 2 : 1;
  std::vector<unsigned char> is_against(static_cast<std::size_t>(n));
  values_.assign(static_cast<std::size_t>(n), 0.0);
  visit_basis(lemke_, problem, [&](Index i, double value, Index row) {
    values_[static_cast<std::size_t>(i)] = value;
    const bool falls =
        problem.push != nullptr && value <= clearly && basis.values(row, push) < -clearly;
    is_against[static_cast<std::size_t>(i)] = value < -clearly || falls ? 1 : 0;
  });
  Index count = 0;
  for (const ConeGroup<double>& cone : problem.factored->cones) {
    const auto first = is_against.begin() + cone.variable;
    count +=
        std::any_of(first, first + cone.size(), [](unsigned char x) { return x != 0; }) ? 1 : 0;
  }
  return count;
}

bool SettledPivots::find_better(const Problem<double>& problem, const LemkeOptions<double>& options,
                                const Flags& from, Flags& to) {
  if (has_pads(problem))
    return problem.push == nullptr && ModesOfForces::fits(problem) && settle(problem, from, to);
  if (assembly_.scene().pressure == Pressure::even) return false;
  LemkeOptions<double> own;
  own.first_cover = options.first_cover;
  const Span<Index>& body = assembly_.layout().body;
  return FewPoints(problem, {body.data, body.size}).solve(own, to);
}

/// Newton's method from the forces in values_, ever stiffer, until who presses and who slides
/// whither stays, and until that is not for want of stiffness.
bool SettledPivots::settle(const Problem<double>& problem, const Flags& from, Flags& to) {
  constexpr Index most_passes = 400, passes_each = 60;
  constexpr double softest = 1000, stiff = 0.1, sooner = 0.1;
  std::vector<double> z = values_;
  for (Index i = 0; i < problem.free_begin; ++i) {
    double& z_i = z[static_cast<std::size_t>(i)];
    if (from[static_cast<std::size_t>(i)] == 0 || z_i < 0) z_i = 0;
  }
  Owned<ProximalNewton<double>> newton = newton_for(problem);
  if (!newton.init(problem, z.data())) return false;
  Flags before = from;
  Index last_changes = problem.size;
  double eps = 0.1, factor = 0.5;
  while (newton.passes() < most_passes) {
    if (!newton.settle(eps, passes_each)) {
      eps = std::min(softest, 5 * eps);
      factor = std::min(0.97, std::sqrt(factor));
      continue;
    }
    newton.recover(z.data());
    swept_ = z;
    const ModesOfForces modes(problem, z.data());
    Flags now = modes.plain();
    const Index changes = differences(before, now);
    const bool stays = changes <= few && last_changes <= few;
    if (stays) to = modes.vertex();
    if (stays && eps <= stiff * slip_by_friction(problem, z)) return true;
    eps *= stays ? sooner : factor;
    last_changes = changes;
    before = std::move(now);
  }
  return !to.empty();
}

/// The round by sweeps, and a note if they lose it.
bool SettledPivots::sweep() {
  if (try_sweeps()) return true;
  lost_compliance_ = softness(problem_);
  ++sweeps_that_failed_;
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
