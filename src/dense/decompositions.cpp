#include "dense/decompositions.hpp"

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

} // namespace lcpush::desktop
