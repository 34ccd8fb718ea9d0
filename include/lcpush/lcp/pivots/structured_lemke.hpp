// Lemke's method on a factored problem with pivots in O(n): for thousands of cones.
// Same rules, same watchers and checks as the dense one; the dictionary is never formed.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"
#include "lcpush/lcp/pivots/structured/structured_basis.hpp"

namespace lcpush {

template <class S> using StructuredLemke = Lemke<S, StructuredBasis<S>>;

/// Scalars and ints that StructuredLemke needs for n unknowns in `cones` groups; `shared` counts
/// the sum groups of more than one force, or with inertia. O(n).
constexpr Index structured_lemke_scalars(Index n, Index cones, Index shared) {
  constexpr Index right_hand_sides = detail::max_rhs + detail::tie_columns;
  return StructuredBasis<double>::scalars(n, cones, shared, right_hand_sides) +
         n * (detail::lemke_vectors - right_hand_sides);
}
constexpr Index structured_lemke_integers(Index n, Index cones) {
  return 2 * n + StructuredBasis<double>::integers(n, cones);
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class StructuredBasis<double>;
extern template class Lemke<double, StructuredBasis<double>>;
#endif
} // namespace lcpush
