// What a basis of pivots is worth, and whether pads are in it.
#pragma once

#include <algorithm>

#include "lcpush/lcp/pivots/structured_lemke.hpp"

namespace lcpush::desktop {

/// The largest compliance of a pad; 0: there is none.
inline double softness(const Problem<double>& problem) {
  double most = 0;
  for (const ConeGroup<double>& cone : problem.factored->cones)
    most = std::max(most, cone.compliance);
  return most;
}
inline bool has_pads(const Problem<double>& problem) { return softness(problem) > 0; }

/// Calls visit(i, value, row) for each i: what z_i or w_i is, whichever is basic.
template <class Visit>
void visit_basis(const StructuredLemke<double>& lemke, const Problem<double>& problem,
                 const Visit& visit) {
  const Dictionary<double>& basis = lemke.dictionary();
  const Index n = problem.size, finite = problem.free_begin < n ? 1 : 0;
  for (Index row = 0; row < n; ++row) {
    const Index variable = basis.basic[row], i = variable < n ? variable : variable - n;
    const double unit = variable < n ? lemke.slack_unit(i) : lemke.unknown_unit(i);
    visit(i, basis.values(row, finite) * unit, row);
  }
}

} // namespace lcpush::desktop
