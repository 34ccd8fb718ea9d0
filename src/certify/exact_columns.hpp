// Columns of fractions, and the rows of a mixed problem applied to them.
#pragma once

#include "certify/mixed_problem.hpp"
#include "exact/exact_system.hpp"

namespace lcpush::desktop {

using Column = std::vector<Rational>;

/// L x + cover z0 + constant.
Column times(const MixedProblem& problem, Column x, const Column& constant = {},
             const Column& cover = {}, const Rational& z0 = 0);

/// Of the numbers at `i`, the first that is not zero decides.
int sign_at(const std::vector<Column>& columns, std::size_t i);

/// The submatrix of these rows and columns, in their order.
std::vector<ExactRow> cut(const MixedProblem& problem, const std::vector<std::size_t>& rows,
                          const std::vector<std::size_t>& columns);

} // namespace lcpush::desktop
