// Eigen's decompositions of real matrices behind plain functions: each is compiled once.
#pragma once

#include <optional>
#include <vector>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// The x of least |A x - b|, for columns that are independent to rounding.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// The same; nothing if columns of A depend on each other to `threshold`.
std::optional<Eigen::VectorXd> least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                             double threshold);

/// Of all x of least |A x - b|, A singular to `threshold`, the shortest.
Eigen::VectorXd shortest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                  double threshold);

/// Moves x, twice, by the shortest step after which A x + b is as near to 0 as it can be.
void correct(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, double threshold,
             Eigen::VectorXd& x);

/// An x >= 0 with the least |A x - b|, to rounding, by active sets [Lawson, Hanson
/// 1974, chapter 23]; b near 1. Ends always: after 3 columns' worth
/// of exchanges with what it has. Cost: a few least squares of rows x rows.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// What the rows of A span, and what is orthogonal to them: A' = [basis complement] R, in an order.
struct RowSpace {
  Eigen::MatrixXd basis;      ///< columns x rank, orthonormal
  Eigen::MatrixXd complement; ///< columns x (columns - rank), orthonormal
  Eigen::MatrixXd triangle;   ///< rank x rank, upper: R of the independent rows
  std::vector<Index> order;   ///< those rows, as R's columns stand
};
RowSpace row_space(const Eigen::MatrixXd& A, double threshold);

/// Q of A = Q R, square: its first `rank` columns are what A leads to, as far as R's diagonal is
/// above `small`.
struct Orthogonal {
  Eigen::MatrixXd Q;
  Index rank;
};
Orthogonal orthogonal(const Eigen::MatrixXd& A, double small);

/// L, square, of A = L O' with orthonormal columns O.
Eigen::MatrixXd compressed(const Eigen::MatrixXd& A);

/// A basis of all x with A x = 0, a column each; none: A has full rank to `threshold`.
Eigen::MatrixXd kernel(const Eigen::MatrixXd& A, double threshold);

/// The x of A x = b for a square A, singular ones to rounding.
Eigen::VectorXd solved_by_full_pivots(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

} // namespace lcpush::desktop
