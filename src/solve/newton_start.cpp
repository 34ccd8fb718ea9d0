#include "solve/newton_start.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/sweeps/proximal_newton.hpp"
#include "solve/modes_of_forces.hpp"

namespace lcpush::desktop {
namespace {

using Flags = ModesOfForces::Flags;

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

Owned<ProximalNewton<double>> newton_for(const Problem<double>& problem) {
  const Index couplings = coupling_count(problem), sums = problem.factored->sums.size;
  return {proximal_scalars(problem.size, couplings, sums),
          proximal_integers(problem.size, couplings, sums)};
}

Index differences(const Flags& a, const Flags& b) {
  Index count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

} // namespace

Index coupling_count(const Problem<double>& problem) {
  Index count = 0;
  for (const SumGroup<double>& sum : problem.factored->sums) count += sum.count;
  return count;
}

bool settle_pads(const Problem<double>& problem, std::vector<double>& z, Flags& active) {
  constexpr Index most_passes = 400, passes_each = 60, few = 8; // changes
  constexpr double softest = 1000, stiff = 0.1, sooner = 0.1;
  Owned<ProximalNewton<double>> newton = newton_for(problem);
  if (!newton.init(problem, z.data())) return false;
  Flags before = active;
  bool found = false;
  Index last_changes = problem.size;
  double eps = 0.1, factor = 0.5;
  while (newton.passes() < most_passes) {
    if (!newton.settle(eps, passes_each)) {
      eps = std::min(softest, 5 * eps);
      factor = std::min(0.97, std::sqrt(factor));
      continue;
    }
    newton.recover(z.data());
    const ModesOfForces modes(problem, z.data());
    Flags now = modes.plain();
    const Index changes = differences(before, now);
    const bool stays = changes <= few && last_changes <= few;
    if (stays) active = modes.vertex();
    found = found || stays;
    if (stays && eps <= stiff * slip_by_friction(problem, z)) return true;
    eps *= stays ? sooner : factor;
    last_changes = changes;
    before = std::move(now);
  }
  return found;
}

} // namespace lcpush::desktop
