// Lemke's method on a factored problem with pivots in O(n): for thousands of cones.
// Same rules, same watchers and checks as the dense one; the dictionary is never formed.
#pragma once

#include <cstdint>

#include "lcpush/lcp/pivots/lemke.hpp"
#include "lcpush/lcp/pivots/structured/structured_basis.hpp"

namespace lcpush {

template <class S> using StructuredLemke = Lemke<S, StructuredBasis<S>>;
/// Where memory is small: at most 16383 unknowns, and some exchanges (structured_lemke_scalars).
template <class S> using SmallLemke = Lemke<S, StructuredBasis<S, std::int16_t>>;

/// Scalars and ints that StructuredLemke needs for n unknowns in `cones` groups; `shared` counts
/// the sum groups of more than one force, or with inertia. O(n), and the square of `exchanges`:
/// what a basis may hold beyond cones that slide and pads that give way, in the end about a
/// contact's normal force a cone, 6 forces of all cones and two a shared group. 0: enough for
/// whatever pays; else there is no memory for ray().
constexpr Index structured_lemke_scalars(Index n, Index cones, Index shared, Index exchanges = 0) {
  constexpr Index right_hand_sides = detail::max_rhs + detail::tie_columns;
  const Index ray = exchanges > 0 ? 0 : 1;
  return StructuredBasis<double>::scalars(n, cones, shared, right_hand_sides, exchanges) +
         // Rows and columns have one scale, and the entering column's memory is scratch.
         n * (detail::lemke_vectors - right_hand_sides - 4 + ray);
}
constexpr Index structured_lemke_integers(Index n, Index cones, Index exchanges = 0) {
  return 2 * n + StructuredBasis<double>::integers(n, cones, exchanges);
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class StructuredBasis<double>;
extern template class Lemke<double, StructuredBasis<double>>;
#endif
} // namespace lcpush
