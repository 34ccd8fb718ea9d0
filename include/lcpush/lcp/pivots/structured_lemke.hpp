// Lemke's method on a factored problem with pivots in O(n): for thousands of cones.
// Same rules, same watchers and checks as the dense one; the dictionary is never formed.
#pragma once

#include <cstdint>

#include "lcpush/lcp/pivots/lemke.hpp"
#include "lcpush/lcp/pivots/structured/structured_basis.hpp"

namespace lcpush {

template <class S> using StructuredLemke = Lemke<S, StructuredBasis<S>>;
/// On a device, with the exchanges that LemkeOptions says, and no ray().
template <class S> using SmallBasis = StructuredBasis<S, DeviceMemory>;
template <class S> using SmallLemke = Lemke<S, SmallBasis<S>>;

namespace detail {
template <class Basis>
constexpr Index scalars_on(Index n, Index cones, Index shared, Index exchanges) {
  constexpr Index right_hand_sides = max_rhs + tie_columns;
  const Index ray = Basis::Memory::keeps_ray ? 1 : 0;
  return Basis::scalars(n, cones, shared, right_hand_sides, exchanges) +
         // Rows and columns have one scale, and the entering column's memory is scratch.
         n * (lemke_vectors - right_hand_sides - 4 + ray);
}
} // namespace detail

/// Scalars and ints that StructuredLemke needs for n unknowns in `cones` groups; `shared` counts
/// the sum groups of more than one force, or with inertia. O(n).
constexpr Index structured_lemke_scalars(Index n, Index cones, Index shared) {
  return detail::scalars_on<StructuredBasis<double>>(n, cones, shared, 0);
}
constexpr Index structured_lemke_integers(Index n, Index cones) {
  return n + StructuredBasis<double>::integers(n, cones, 0, 0);
}
/// Those of SmallLemke. O(n), and the square of `exchanges`: what a basis may hold beyond cones
/// that slide, in the end about a contact's normal force a cone, 6 forces of all cones and two a
/// shared group.
constexpr Index small_lemke_scalars(Index n, Index cones, Index shared, Index exchanges) {
  return detail::scalars_on<SmallBasis<double>>(n, cones, shared, exchanges);
}
constexpr Index small_lemke_integers(Index n, Index cones, Index shared, Index exchanges) {
  return n + SmallBasis<double>::integers(n, cones, shared, exchanges);
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template class StructuredBasis<double>;
extern template class Lemke<double, StructuredBasis<double>>;
#endif
} // namespace lcpush
