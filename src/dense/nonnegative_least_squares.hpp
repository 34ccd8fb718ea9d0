// Least squares with x >= 0, by active sets. [Lawson, Hanson 1974, chapter 23]
#pragma once

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// An x >= 0 with the least |A x - b|, to rounding; b near 1. Ends always: after 3 columns' worth
/// of exchanges with what it has. Cost: a few least squares of rows x rows.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

} // namespace lcpush::desktop
