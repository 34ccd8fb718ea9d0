// From an answer in doubles to one without any error.
#pragma once

#include "certify/mixed_problem.hpp"

#include <optional>
#include <vector>

namespace lcpush::desktop {

/// x and w for every column of q: what is not negative is so in the order of the columns.
struct ExactAnswer {
  std::vector<std::vector<Rational>> x, w;
  std::size_t pivots = 0; ///< exact ones, from the basis in doubles
};

/// Does it solve the problem, without any error? Its own arithmetic.
bool solves_exactly(const MixedProblem& problem, const ExactAnswer& answer);

/// Which of a pair's two is not zero.
enum class Part : unsigned char { x, w, neither };

/// The answer next to `guess` (a column of doubles for every column of q) in which these x and the
/// free ones act, their w zero. Dependent ones stay at the guess. nullopt if there is none with the
/// right signs.
std::optional<ExactAnswer> answer_near(const MixedProblem& problem, const std::vector<Part>& acting,
                                       const std::vector<std::vector<double>>& guess);

/// Of every pair: is x (else w) basic?
using Basis = std::vector<unsigned char>;

/// The answer of one of these complementary bases, after as many of Lemke's pivots as rounding has
/// hidden. nullopt if all are singular, end on rays, or need more than `most_pivots`.
std::optional<ExactAnswer> answer_from_bases(const MixedProblem& problem,
                                             const std::vector<Basis>& bases,
                                             std::size_t most_pivots);

} // namespace lcpush::desktop
