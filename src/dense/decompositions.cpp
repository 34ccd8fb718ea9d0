#include "dense/decompositions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dense/settings.hpp"
#include "lcpush/lcp/nonnegative_least_squares.hpp"

namespace lcpush::desktop {

using Eigen::MatrixXd;
using Eigen::VectorXd;

PivotedQr::PivotedQr(const MatrixXd& A, double small)
    : factors_(A), scales_(VectorXd::Zero(std::min(A.rows(), A.cols()))),
      order_(static_cast<std::size_t>(A.cols())) {
  std::iota(order_.begin(), order_.end(), Index{0});
  const Index m = A.rows(), n = A.cols();
  // Of what each column has left below the rows that are done; squares, kept up to date, and taken
  // afresh where subtracting has cost their digits.
  VectorXd left = A.colwise().squaredNorm().transpose(), fresh = left;
  for (Index k = 0; k < scales_.size(); ++k) {
    const Index best = std::max_element(left.data() + k, left.data() + n) - left.data();
    if (best != k) factors_.col(k).swap(factors_.col(best));
    std::swap(left[k], left[best]);
    std::swap(fresh[k], fresh[best]);
    std::swap(order_[static_cast<std::size_t>(k)], order_[static_cast<std::size_t>(best)]);
    // The reflection that leads column k to its first entry.
    auto column = factors_.col(k).tail(m - k);
    const double size = column.norm();
    if (!(size > 0)) break;
    const double first = column[0], diagonal = first > 0 ? -size : size;
    scales_[k] = 1 - first / diagonal;
    column.tail(m - k - 1) /= first - diagonal;
    column[0] = diagonal;
    for (Index j = k + 1; j < n; ++j) {
      reflect(k, &factors_(0, j));
      left[j] -= factors_(k, j) * factors_(k, j);
      if (left[j] > DenseSettings::digits_left * fresh[j]) continue;
      left[j] = fresh[j] = factors_.col(j).tail(m - k - 1).squaredNorm();
    }
    const double least = std::max(small, DenseSettings::rounding(m, n) * std::abs(factors_(0, 0)));
    if (rank_ == k && size > least) ++rank_;
  }
}

/// column -= s v (v' column), v = (1, what is stored below the diagonal).
void PivotedQr::reflect(Index k, double* column) const {
  const Index below = factors_.rows() - k - 1;
  const double* const v = factors_.data() + k * factors_.rows() + k + 1;
  double along = column[k];
  for (Index i = 0; i < below; ++i) along += v[i] * column[k + 1 + i];
  along *= scales_[k];
  column[k] -= along;
  for (Index i = 0; i < below; ++i) column[k + 1 + i] -= along * v[i];
}

MatrixXd PivotedQr::Q() const {
  MatrixXd Q = MatrixXd::Identity(factors_.rows(), factors_.rows());
  for (Index j = 0; j < Q.cols(); ++j)
    for (Index k = scales_.size() - 1; k >= 0; --k) reflect(k, &Q(0, j));
  return Q;
}

MatrixXd PivotedQr::R() const {
  MatrixXd R = MatrixXd::Zero(factors_.rows(), factors_.cols());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const auto column = static_cast<Index>(k), above = std::min(column + 1, R.rows());
    R.col(order_[k]).head(above) = factors_.col(column).head(above);
  }
  return R;
}

/// R x = y for the columns that count, in their places among A's; the others get 0.
VectorXd PivotedQr::solve_triangle(VectorXd y) const {
  VectorXd x = VectorXd::Zero(factors_.cols());
  for (Index k = rank_ - 1; k >= 0; --k) {
    const double value = y[k] / factors_(k, k);
    y.head(k) -= value * factors_.col(k).head(k);
    x[order_[static_cast<std::size_t>(k)]] = value;
  }
  return x;
}

VectorXd PivotedQr::solve(const VectorXd& b) const {
  VectorXd y = b; // Q' b
  for (Index k = 0; k < rank_; ++k) reflect(k, y.data());
  return solve_triangle(std::move(y));
}

VectorXd PivotedQr::shortest(const VectorXd& b) const {
  VectorXd x = solve(b);
  if (rank_ == factors_.cols()) return x;
  const MatrixXd N = kernel();
  return x - product(N, PivotedQr(N).solve(x));
}

MatrixXd PivotedQr::kernel() const {
  MatrixXd N(factors_.cols(), factors_.cols() - rank_);
  for (Index k = 0; k < N.cols(); ++k) {
    N.col(k) = solve_triangle(-factors_.col(rank_ + k).head(rank_));
    N(order_[static_cast<std::size_t>(rank_ + k)], k) = 1;
  }
  return N;
}

namespace {

constexpr Index together = DenseSettings::rows_together, step = DenseSettings::vector_step;

static_assert(together == 4, "subtract names each of them");

/// row -= by * rows above, those one by one: a compiler gives entries of a step to a vector unit.
void subtract(const double (&by)[together], const double* above, Index stride, Index count,
              double* __restrict row) {
  Index j = 0;
  for (; j + step <= count; j += step)
    for (Index i = j; i < j + step; ++i)
      row[i] = row[i] - by[0] * above[i] - by[1] * above[i + stride] -
               by[2] * above[i + 2 * stride] - by[3] * above[i + 3 * stride];
  for (; j < count; ++j)
    for (Index k = 0; k < together; ++k) row[j] -= by[k] * above[j + k * stride];
}

struct Pivot {
  Index column, begin, end; ///< in A; where the row's other entries may stand
};

} // namespace

std::optional<RowMatrix> eliminate(Eigen::Ref<RowMatrix> A, bool definite) {
  const Index n = A.rows(), width = A.cols();
  std::vector<Pivot> pivots;
  const auto reduce = [&](Index i, Index k, Index count) {
    double by[together] = {};
    Index begin = n, end = 0;
    for (Index a = 0; a < count; ++a) {
      const Pivot& pivot = pivots[static_cast<std::size_t>(k + a)];
      by[a] = A(i, pivot.column);
      for (Index b = 0; b < a; ++b) by[a] -= by[b] * A(k + b, pivot.column);
      if (by[a] == 0) continue;
      begin = std::min(begin, pivot.begin);
      end = std::max(end, pivot.end);
    }
    if (begin >= end) return;
    const Index stride = count == 1 ? 0 : A.outerStride();
    subtract(by, &A(k, begin), stride, end - begin, &A(i, begin));
    subtract(by, &A(k, 0) + n, stride, width - n, &A(i, 0) + n);
    for (Index a = 0; a < count; ++a) A(i, pivots[static_cast<std::size_t>(k + a)].column) = 0;
  };
  // Some rows at a time, which stay in a processor's cache while those above pass by.
  for (Index first = 0; first < n; first += DenseSettings::rows_at_once) {
    const Index last = std::min(n, first + DenseSettings::rows_at_once);
    for (Index k = 0; k < first; k += together)
      for (Index i = first; i < last; ++i) reduce(i, k, together);
    for (Index i = first; i < last; ++i) {
      for (Index k = first; k < i; ++k) reduce(i, k, 1);
      Pivot pivot{i, n, 0};
      for (Index j = 0; j < n; ++j) {
        if (A(i, j) == 0) continue;
        pivot.begin = std::min(pivot.begin, j);
        pivot.end = j + 1;
        const double size = std::abs(A(i, j)) * (pivot.column == i ? DenseSettings::diagonal : 1);
        if (!definite && size > std::abs(A(i, pivot.column))) pivot.column = j;
      }
      const double size = A(i, pivot.column);
      if (!(definite ? size > 0 : std::abs(size) > 0)) return std::nullopt;
      A.row(i) /= size;
      pivots.push_back(pivot);
    }
  }
  RowMatrix X(n, width - n);
  for (Index i = n - 1; i >= 0; --i) {
    const Pivot& pivot = pivots[static_cast<std::size_t>(i)];
    X.row(pivot.column) = A.row(i).tail(X.cols());
    for (Index j = pivot.begin; j < pivot.end; ++j)
      if (j != pivot.column && A(i, j) != 0) X.row(pivot.column) -= A(i, j) * X.row(j);
  }
  return X;
}

MatrixXd product(const Eigen::Ref<const MatrixXd>& A, const Eigen::Ref<const MatrixXd>& B) {
  MatrixXd C = MatrixXd::Zero(A.rows(), B.cols());
  for (Index j = 0; j < B.cols(); ++j)
    for (Index k = 0; k < B.rows(); ++k)
      for (Index i = 0; i < A.rows(); ++i) C(i, j) += A(i, k) * B(k, j);
  return C;
}

double longest_column(const MatrixXd& A) {
  return A.cols() > 0 ? A.colwise().norm().maxCoeff() : 0;
}

std::optional<VectorXd> least_squares(const MatrixXd& A, const VectorXd& b, double threshold) {
  const PivotedQr qr(A, threshold * longest_column(A));
  if (qr.rank() < A.cols()) return std::nullopt;
  return qr.solve(b);
}

VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b) {
  const Index m = A.rows(), n = A.cols();
  std::vector<double> scalars(static_cast<std::size_t>(least_squares_scalars(m, n)));
  std::vector<int> integers(static_cast<std::size_t>(least_squares_integers(m, n)));
  MatrixXd columns = A; // the solver's views are of what may change
  VectorXd target = b;
  NonnegativeLeastSquares<double> solver({scalars.data(), static_cast<Index>(scalars.size())},
                                         {integers.data(), static_cast<Index>(integers.size())});
  (void)solver.solve(MatrixMap<double>(columns.data(), m, n), VectorMap<double>(target.data(), m));
  return solver.x();
}

} // namespace lcpush::desktop
