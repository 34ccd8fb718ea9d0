// What Lemke's method asks of a basis, and what the two of them share.
//
// A basis is a set of n basic variables out of w, z and z0, with a dictionary: its values (one
// column a right-hand side, all scaled) and the columns of the table that the basis keeps. There
// are two: DenseBasis keeps the whole table, every number visible; StructuredBasis computes the
// entering column of a factored problem in O(contact points). Each has all of these:
//
//     supports(problem, tie_rule)     can it take this problem?
//     carve(problem, ..)              its memory, off two blocks
//     seat(method, ..)                that of Lemke's vectors, which may share its own
//     scale(equilibrates, row, col)   scales; returns 0, or NaN if a number is not finite
//     load(row, col, d)               the basis of all w under the covering vector d
//     set_covering_vector(d, here)    another d, as given and in the present basis
//     enter(variable)                 the column of a nonbasic variable that is to enter
//     exchange(row, column, ..)       the pivot
//     factor(target, ..)              from the basis of all w to the one in target
//     drop_pairs(left, ..)            after factor: without the pairs that it could not take
//     respond(r, out)                 how basic variables answer nonbasic w = r: refinement
//     set_bound_rhs(..)               after factor: the right-hand side of free unknowns' bound
//     must_refactor()                 has it grown so that factoring it afresh pays?
//     is_too_long()                   has it outgrown its memory?
//     product(z, out)                 M z, as given
//     row_sums(col, out)              sum_j |M_ij| col_j, or a bound on it
#pragma once

#include <cstdint>

#include "lcpush/lcp/pivots/dictionary.hpp"

namespace lcpush {

namespace detail {
template <class S> class KeptDirections;
template <class S, class Int> class ReadDirections;
} // namespace detail

/// What a basis keeps where there is memory: a desktop.
struct DesktopMemory {
  using Integer = int; ///< numbers variables, rows and contacts
  template <class S> using Directions = detail::KeptDirections<S>;
  static constexpr bool keeps_ray = true; ///< of a try that failed, while others are made
};

/// What it keeps on a device: at most 16383 unknowns and 2047 contacts, directions read from the
/// problem as given, no ray beside its verdict.
struct DeviceMemory {
  using Integer = std::int16_t;
  template <class S> using Directions = detail::ReadDirections<S, std::int16_t>;
  static constexpr bool keeps_ray = false;
};

/// Lemke's own vectors, n each, that a basis may let share memory with its own.
template <class S, class Int> struct MethodMemory {
  VectorMap<S>&row_scale, &column_scale, &row_sum, &scratch;
  Span<Int>&candidates, &target;
};

} // namespace lcpush
