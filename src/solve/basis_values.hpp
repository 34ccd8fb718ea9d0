// What a basis of pivots is worth, and whether pads are in it.
#pragma once

#include <algorithm>
#include <vector>

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

/// How many points are against the basis, in whatever way: some basic value is negative, or falls
/// with the push from zero. `values`: z_i where it is basic, w_i where that is.
inline Index points_against(const StructuredLemke<double>& lemke, const Problem<double>& problem,
                            std::vector<double>& values) {
  constexpr double clearly = 1e-12;
  const Dictionary<double>& basis = lemke.dictionary();
  const Index n = problem.size, push = problem.free_begin < n ? 2 : 1;
  std::vector<unsigned char> is_against(static_cast<std::size_t>(n));
  values.assign(static_cast<std::size_t>(n), 0.0);
  visit_basis(lemke, problem, [&](Index i, double value, Index row) {
    values[static_cast<std::size_t>(i)] = value;
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

} // namespace lcpush::desktop
