// Ranks, least squares, shortest solutions and null spaces of matrices whose rank is known.
#include <doctest/doctest.h>

#include <random>

#include "dense/decompositions.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

Eigen::MatrixXd random_matrix(std::mt19937& random, Index rows, Index columns) {
  std::uniform_real_distribution<double> entry(-1, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return entry(random); });
}

} // namespace

TEST_CASE(
    "a matrix of known rank: A = Q R, its null space, least squares and the shortest of them") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const Index m = 1 + trial % 9, n = 1 + trial / 9 % 11;
    const Index rank = std::min({m, n, Index{1 + trial % 4}});
    const Eigen::MatrixXd A = random_matrix(random, m, rank) * random_matrix(random, rank, n);
    const PivotedQr qr(A, 1e-10 * longest_column(A));
    const Eigen::MatrixXd Q = qr.Q(), N = qr.kernel();
    REQUIRE(qr.rank() == rank);
    CHECK((Q.transpose() * Q - Eigen::MatrixXd::Identity(m, m)).norm() <= 1e-13);
    CHECK((Q * qr.R() - A).norm() <= 1e-13 * (1 + A.norm()));
    REQUIRE(N.cols() == n - rank);
    CHECK((A * N).norm() <= 1e-11 * (1 + N.norm()));
    CHECK(PivotedQr(N).rank() == n - rank);
    const Eigen::VectorXd b = random_matrix(random, m, 1), x = qr.solve(b), y = qr.shortest(b);
    for (const Eigen::VectorXd& solution : {x, y})
      CHECK((A.transpose() * (A * solution - b)).norm() <= 1e-11 * (1 + solution.norm()));
    CHECK((N.transpose() * y).norm() <= 1e-11 * (1 + x.norm()));
    CHECK((x.array() != 0).count() <= rank);
  }
}

TEST_CASE("columns of all sizes, none, and only zeros") {
  Eigen::MatrixXd A = Eigen::Vector3d(1e-3, 1, 1e3).asDiagonal();
  CHECK(PivotedQr(A).rank() == 3);
  CHECK((PivotedQr(A).solve(Eigen::Vector3d(1e-3, 2, 3e3)) - Eigen::Vector3d(1, 2, 3)).norm() <=
        1e-8);
  CHECK(PivotedQr(A, 0.1).rank() == 2);
  CHECK(PivotedQr(Eigen::MatrixXd::Zero(2, 3)).kernel() == Eigen::MatrixXd::Identity(3, 3));
  CHECK(PivotedQr(Eigen::MatrixXd(2, 0)).Q() == Eigen::MatrixXd::Identity(2, 2));
  CHECK(PivotedQr(Eigen::MatrixXd(0, 2)).kernel() == Eigen::MatrixXd::Identity(2, 2));
  CHECK_FALSE(least_squares(Eigen::MatrixXd::Ones(3, 2), Eigen::VectorXd::Ones(3), 1e-10));
}

TEST_CASE("systems of several right sides by elimination; singular ones, and definite ones") {
  std::mt19937 random(6);
  for (const Index n : {1, 3, 15, 16, 17, 70}) {
    for (const Index band : {n, Index{2}}) {
      CAPTURE(n);
      RowMatrix A = random_matrix(random, n, n + 2);
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
          if (std::abs(i - j) > band) A(i, j) = 0;
      if (n > 1) A(0, 0) = 0; // pivots beside the diagonal
      RowMatrix spent = A;
      const auto X = eliminate(spent);
      REQUIRE(X);
      CHECK((A.leftCols(n) * *X - A.rightCols(2)).norm() <= 1e-11 * (1 + X->norm()));
    }
    RowMatrix A = random_matrix(random, n, n + 1), M = A.leftCols(n) * A.leftCols(n).transpose();
    A.leftCols(n) = M + RowMatrix::Identity(n, n);
    RowMatrix spent = A;
    const auto x = eliminate(spent, true);
    REQUIRE(x);
    CHECK((A.leftCols(n) * *x - A.col(n)).norm() <= 1e-11 * (1 + x->norm()));
    A(n - 1, n - 1) -= 1000;
    CHECK_FALSE(eliminate(A, true));
    A.row(0).head(n).setZero();
    CHECK_FALSE(eliminate(A));
  }
}
