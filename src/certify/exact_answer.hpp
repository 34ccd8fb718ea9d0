// From an answer in doubles to one without any error.
#pragma once

#include "certify/mixed_problem.hpp"

#include <optional>
#include <vector>

namespace lcpush::desktop {

struct ExactAnswer {
  Column x, w;
};

/// Does it solve the problem, without any error? Its own arithmetic.
bool solves_exactly(const MixedProblem& problem, const ExactAnswer& answer);

/// Which of a pair's two is not zero.
enum class Part : unsigned char { x, w, neither };

/// The answer next to `guess` in which these x and the free ones act, their w zero. Dependent ones
/// stay at the guess. nullopt if there is none with the right signs.
std::optional<ExactAnswer> answer_near(const MixedProblem& problem, const std::vector<Part>& acting,
                                       const std::vector<double>& guess);

/// Of every pair: is x (else w) basic?
using Basis = std::vector<unsigned char>;

/// The answer of this complementary basis; nullopt if it is singular or a value is negative.
std::optional<ExactAnswer> answer_of_basis(const MixedProblem& problem, const Basis& basic);

/// The answer to which Lemke's pivots in fractions lead from one of these bases, as rounding has
/// hidden it. Pivots are counted, not timed, so that a problem has one answer wherever it is asked.
/// nullopt if all paths end on rays or are too long.
std::optional<ExactAnswer> answer_by_pivots(const MixedProblem& problem,
                                            const std::vector<Basis>& bases);

} // namespace lcpush::desktop
