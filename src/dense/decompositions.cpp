#include "dense/decompositions.hpp"

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/QR>

namespace lcpush::desktop {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

std::optional<VectorXd> least_squares(const MatrixXd& A, const VectorXd& b, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  qr.setThreshold(threshold);
  if (qr.rank() < A.cols()) return std::nullopt;
  return VectorXd(qr.solve(b));
}

VectorXd shortest_solution(const MatrixXd& A, const VectorXd& b, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(A);
  decomposition.setThreshold(threshold);
  return decomposition.solve(b);
}

void correct(const MatrixXd& A, const VectorXd& b, double threshold, VectorXd& x) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(threshold);
  decomposition.compute(A);
  for (int round = 0; round < 2; ++round) {
    const VectorXd off = A * x + b;
    const VectorXd step = decomposition.solve(off);
    x -= step;
  }
}

namespace {

/// The least squares of the chosen columns, 0 elsewhere.
VectorXd solve_chosen(const MatrixXd& A, const VectorXd& b, const std::vector<Index>& chosen) {
  MatrixXd columns(A.rows(), static_cast<Index>(chosen.size()));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    columns.col(static_cast<Index>(k)) = A.col(chosen[k]);
  const VectorXd found = least_squares(columns, b);
  VectorXd x = VectorXd::Zero(A.cols());
  for (std::size_t k = 0; k < chosen.size(); ++k) x[chosen[k]] = found[static_cast<Index>(k)];
  return x;
}

} // namespace

VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b) {
  constexpr double rounding = 1e-13;
  const Index n = A.cols();
  VectorXd x = VectorXd::Zero(n);
  std::vector<Index> chosen;
  for (Index exchange = 0; exchange < 3 * n; ++exchange) {
    VectorXd gain = A.transpose() * (b - A * x);
    for (const Index j : chosen) gain[j] = 0;
    Index entering = 0;
    if (!(gain.size() > 0 && gain.maxCoeff(&entering) > rounding * (1 + b.norm()))) break;
    chosen.push_back(entering);
    for (;;) {
      const VectorXd target = solve_chosen(A, b, chosen);
      double step = 1;
      for (const Index j : chosen)
        if (target[j] <= 0) step = std::min(step, x[j] > 0 ? x[j] / (x[j] - target[j]) : 0.0);
      x += step * (target - x);
      if (!(step < 1)) break;
      const auto leaves = [&](Index j) { return !(x[j] > rounding); };
      for (const Index j : chosen)
        if (leaves(j)) x[j] = 0;
      chosen.erase(std::remove_if(chosen.begin(), chosen.end(), leaves), chosen.end());
    }
  }
  return x;
}

RowSpace row_space(const MatrixXd& A, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(A.transpose());
  qr.setThreshold(threshold);
  const Index columns = A.cols(), rank = qr.rank();
  const MatrixXd Q = qr.householderQ() * MatrixXd(MatrixXd::Identity(columns, columns));
  RowSpace space{Q.leftCols(rank),
                 Q.rightCols(columns - rank),
                 qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>(),
                 {}};
  for (Index k = 0; k < rank; ++k) space.order.push_back(qr.colsPermutation().indices()[k]);
  return space;
}

Orthogonal orthogonal(const MatrixXd& A, double small) {
  if (A.cols() == 0) return {MatrixXd::Identity(A.rows(), A.rows()), 0};
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  const auto pivots = qr.matrixQR().diagonal().cwiseAbs().array();
  return {qr.householderQ(), (pivots > small).count()};
}

MatrixXd compressed(const MatrixXd& A) {
  const Index n = A.rows();
  MatrixXd transposed = MatrixXd::Zero(std::max(A.cols(), n), n);
  transposed.topRows(A.cols()) = A.transpose();
  const Eigen::HouseholderQR<MatrixXd> qr(transposed);
  const MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
  return R.transpose();
}

MatrixXd kernel(const MatrixXd& A, double threshold) {
  Eigen::FullPivLU<MatrixXd> lu(A);
  lu.setThreshold(threshold);
  if (lu.rank() == A.cols()) return MatrixXd(A.cols(), 0);
  return lu.kernel();
}

VectorXd solved_by_full_pivots(const MatrixXd& A, const VectorXd& b) {
  return A.fullPivLu().solve(b);
}

} // namespace lcpush::desktop
