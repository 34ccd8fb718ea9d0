// Ranks, least squares and null spaces of small dense matrices, by one decomposition.
#pragma once

#include <optional>
#include <vector>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// A P = Q R by Householder's reflections, the largest of the remaining columns first: R's diagonal
/// falls, and what it falls to is what rounding, or dependence, has left. [Golub, Van Loan 5.4]
/// Cost: O(rows columns min(rows, columns)).
class PivotedQr {
public:
  /// The first entries of R's diagonal that are above `small`, and above rounding, count.
  explicit PivotedQr(const Eigen::MatrixXd& A, double small = 0);

  Index rank() const { return rank_; }
  Eigen::MatrixXd Q() const; ///< square; its first rank() columns span what A leads to
  Eigen::MatrixXd R() const; ///< R P': A = Q() R()

  /// An x of least |A x - b| with at most rank() entries that are not 0.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Of all x of least |A x - b| the shortest.
  Eigen::VectorXd shortest(const Eigen::VectorXd& b) const;
  /// A basis of all x with A x = 0, a column each: 1 in one of the columns that others make up.
  Eigen::MatrixXd kernel() const;

private:
  Eigen::MatrixXd factors_;  // on and above the diagonal R, below it Householder's vectors
  Eigen::VectorXd scales_;   // of them, whose first entry is 1
  std::vector<Index> order_; // column k of A P is order_[k] of A
  Index rank_ = 0;

  void reflect(Index k, double* column) const;
  Eigen::VectorXd solve_triangle(Eigen::VectorXd y) const;
};

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// X of A X = B, of [A | B], which is spent; nothing if A is singular. Row after row is freed of
/// the pivots above it and pivots on its largest entry; or on the diagonal of a matrix that is
/// `definite`, and nothing if it is not. Zeros cost nothing: of a band O(rows band^2).
std::optional<RowMatrix> eliminate(Eigen::Ref<RowMatrix> A, bool definite = false);

/// A B, the terms of an entry added in their order. Eigen's own products differ in their bits with
/// a processor's caches, and each kind of factor costs a compiler a second.
Eigen::MatrixXd product(const Eigen::Ref<const Eigen::MatrixXd>& A,
                        const Eigen::Ref<const Eigen::MatrixXd>& B);

/// R's first diagonal entry, in size: what `small` may be a part of.
double longest_column(const Eigen::MatrixXd& A);

/// The x of least |A x - b|; nothing if columns of A depend on each other to `threshold`.
std::optional<Eigen::VectorXd> least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                             double threshold);

/// An x >= 0 with the least |A x - b|, or the nearest to it that was reached; b near 1.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

} // namespace lcpush::desktop
