// Lemke's method on a factored problem in little code, for few cones: the whole dictionary is kept.
#pragma once

#include <cstdint>

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

/// Same rules and checks as the others; rows and columns are scaled alike, in two passes. It has no
/// ray(), and takes no push and no covering vector of the caller's. At most 16383 unknowns.
template <class S> using TableLemke = Lemke<S, DenseBasis<S, std::int16_t>>;

/// Scalars and integers that TableLemke needs for n unknowns. O(n^2).
constexpr Index table_lemke_scalars(Index n) {
  constexpr Index solutions = 2, own_vectors = 3; // what it covers with, scales, scratch
  constexpr Index right_hand_sides = detail::max_rhs - 1 + detail::tie_columns;
  return n * (n + 1) + n * (right_hand_sides + solutions + own_vectors);
}
constexpr Index table_lemke_integers(Index n) { return 4 * n + 1; }

} // namespace lcpush
