// Which sum groups each force enters, variable by variable, and which of these groups have an
// unknown: a sum of one normal force, without inertia, fixes that force instead.
#pragma once

#include "lcpush/lcp/memory.hpp"
#include "lcpush/lcp/problem.hpp"

namespace lcpush {

template <class S> struct CouplingTable {
  Span<S> coupling;   ///< by variable: coupling[first[i] .. first[i + 1])
  Span<int> first;    ///< n + 1
  Span<int> sum;      ///< the groups' slots, as coupling
  Span<int> slot;     ///< of a sum group among the unknowns; -1: it fixes one force, and has none
  Span<int> is_fixed; ///< by variable: 1 if such a sum group fixes it

  void take(Block<S>& scalars, Block<int>& integers, Index n, Index couplings, Index sums) {
    coupling = scalars.take(couplings);
    first = integers.take(n + 1);
    sum = integers.take(couplings);
    slot = integers.take(sums);
    is_fixed = integers.take(n);
  }

  /// The slots go on from `dimension`; returns their end. Fixed forces are written to `force`.
  Index sort_sums(const FactoredProblem<S>& factored, Index dimension, Span<S> force) {
    for (int& fixed : is_fixed) fixed = 0;
    for (const ConeGroup<S>& cone : factored.cones)
      if (cone.normals == 1) is_fixed[cone.variable] = -1; // a candidate
    for (const SumGroup<S>& group : factored.sums)
      for (Index k = group.first; k < group.first + group.count; ++k) {
        int& fixed = is_fixed[factored.coupled_variable[k]];
        fixed = fixed == -1 ? -2 : 0; // coupled once: still a candidate
      }
    for (Index a = 0; a < factored.sums.size; ++a) {
      const SumGroup<S>& group = factored.sums[a];
      const Index i = group.count == 1 ? factored.coupled_variable[group.first] : -1;
      const bool fixes = i >= 0 && is_fixed[i] == -2 && !(group.inertia > S(0)) &&
                         factored.coupling[group.first] > S(0);
      slot[a] = fixes ? -1 : static_cast<int>(dimension++);
      if (!fixes) continue;
      is_fixed[i] = 1;
      force[i] = group.target / factored.coupling[group.first];
    }
    for (int& fixed : is_fixed)
      if (fixed < 0) fixed = 0;
    return dimension;
  }

  /// The coupling entries of the sum groups with an unknown. After sort_sums.
  void sort_couplings(const FactoredProblem<S>& factored) {
    const Index n = is_fixed.size;
    for (int& begin : first) begin = 0;
    const auto each = [&](const auto& visit) {
      for (Index a = 0; a < factored.sums.size; ++a) {
        const SumGroup<S>& group = factored.sums[a];
        for (Index k = group.first; slot[a] >= 0 && k < group.first + group.count; ++k)
          visit(factored.coupled_variable[k], a, factored.coupling[k]);
      }
    };
    each([&](Index i, Index, const S&) { ++first[i + 1]; });
    for (Index i = 0; i < n; ++i) first[i + 1] += first[i];
    each([&](Index i, Index a, const S& value) {
      sum[first[i]] = slot[a];
      coupling[first[i]++] = value;
    });
    for (Index i = n; i > 0; --i) first[i] = first[i - 1];
    first[0] = 0;
  }
};

} // namespace lcpush
