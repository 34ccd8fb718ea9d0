// Linear equations in fractions, solved exactly.
#pragma once

#include "lcpush/desktop/rational.hpp"

#include <optional>
#include <vector>

namespace lcpush::desktop {

/// The least common multiple of two numbers > 0.
BigInteger common_multiple(const BigInteger& a, const BigInteger& b);

/// An entry of a sparse row; a row may name a column twice.
struct ExactEntry {
  Index column;
  Rational value;
};
using ExactRow = std::vector<ExactEntry>;

// By Dixon's p-adic lifting (J. D. Dixon, Exact solution of linear equations using p-adic
// expansions, Numer. Math. 40, 1982): the factors of A modulo one prime give a digit of x for a
// product with A, so that numbers only become long where x is. Elimination in fractions would do
// for scenes, whose rows share few columns; a typed matrix of a hundred dense rows takes it
// minutes. Modulo 2^61 - 1 a minor that is not zero vanishes with a chance of 1e-18 a digit: then a
// true answer is missed, and nothing wrong is said.

/// x with `rows` x = right for each right-hand side, n rows of n columns, checked; nullopt if they
/// are dependent.
std::optional<std::vector<std::vector<Rational>>>
exact_solutions(const std::vector<ExactRow>& rows, const std::vector<std::vector<Rational>>& right);

/// x with `rows` x = right, as far as the rows do not depend on those before them. What they leave
/// open, of columns that depend on those before them, stays at `guess`, rounded to `bits` of the
/// largest guess. nullopt if there is none.
std::optional<std::vector<Rational>> solution_near(const std::vector<ExactRow>& rows,
                                                   const std::vector<Rational>& right,
                                                   const std::vector<double>& guess, int bits);

/// The columns that do not depend on those before them.
std::vector<std::size_t> independent_columns(const std::vector<ExactRow>& rows,
                                             std::size_t columns);

} // namespace lcpush::desktop
