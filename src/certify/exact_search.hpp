// The exact answer that pivots lead to: in doubles if those suffice, else in more and more digits.
#pragma once

#include "certify/exact_pivots.hpp"

#include <functional>

namespace lcpush::desktop {

/// Bases are tried in a fixed order, and the first that solves the problem without any error ends
/// the search: `rounded_basis`(k), final bases of pivots in doubles (k = 0, 1, .. `rounded_bases` -
/// 1; empty where there is none), then those of pivots in 32 digits, then in 77. Pivots are
/// counted, not timed, so that a problem has one answer wherever it is asked.
std::optional<ExactAnswer> searched_answer(const MixedProblem& problem,
                                           const std::function<Basis(Index)>& rounded_basis,
                                           Index rounded_bases);

} // namespace lcpush::desktop
