#include "verify/foreign_point.hpp"

#include <doctest/doctest.h>

#include "dense/decompositions.hpp"

#include <random>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

Eigen::MatrixXd random_matrix(std::mt19937& random, Index rows, Index columns) {
  std::uniform_real_distribution<double> entry(-1, 1);
  Eigen::MatrixXd A(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) A(i, j) = entry(random);
  return A;
}

} // namespace

TEST_CASE("nonnegative least squares: x >= 0, and no column gains") {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Index rows = 3 + trial % 8, columns = 2 + trial % 17;
    Eigen::MatrixXd A = random_matrix(random, rows, columns);
    if (trial % 3 == 0) A.col(1) = A.col(0); // ties
    const Eigen::VectorXd b =
        trial % 2 == 0 ? Eigen::VectorXd(random_matrix(random, rows, 1))
                       : Eigen::VectorXd(A * random_matrix(random, columns, 1).cwiseAbs());
    const Eigen::VectorXd x = nonnegative_least_squares(A, b);
    const Eigen::VectorXd rest = b - A * x, gain = A.transpose() * rest;
    CHECK(x.minCoeff() >= 0);
    CHECK(gain.maxCoeff() <= 1e-11);
    CHECK(std::abs(x.dot(gain)) <= 1e-11 * (1 + x.norm()));
    if (trial % 2 == 1) CHECK(rest.norm() <= 1e-11);
  }
}

TEST_CASE("refined point: a rounded solution becomes exact, and its basis' other rows tell") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-1e-6, 1e-6);
  for (int trial = 0; trial < 100; ++trial) {
    const Index n = 2 + trial % 12;
    DenseProblem problem;
    problem.M = random_matrix(random, n, n) + 4.0 * Eigen::MatrixXd::Identity(n, n);
    problem.free.assign(static_cast<std::size_t>(n), 0);
    problem.free.back() = 1;
    Eigen::VectorXd z = random_matrix(random, n, 1), w = random_matrix(random, n, 1).cwiseAbs();
    for (Index i = 0; i < n - 1; ++i) {
      if (z[i] > 0) w[i] = 0;
      z[i] = std::max(z[i], 0.0);
    }
    w[n - 1] = 0;
    problem.q = w - problem.M * z;
    CHECK(measure_point(problem, z).natural_map <= 1e-14);
    Eigen::VectorXd rounded = z;
    for (double& x : rounded) x += noise(random);
    const auto refined = refine_point(problem, rounded);
    REQUIRE(refined);
    CHECK((*refined - z).cwiseAbs().maxCoeff() <= 2e-6);
    CHECK(measure_point(problem, *refined).natural_map <= 2e-6);
  }
}

TEST_CASE("stationary points of z'w: where no feasible step lowers it") {
  // Of a skew M, z'w = q'z: linear, so its minimum is a corner.
  DenseProblem skew{
      (Eigen::MatrixXd(2, 2) << 0, 1, -1, 0).finished(), Eigen::Vector2d(1, 1), {0, 0}};
  CHECK_FALSE(is_stationary(skew, Eigen::Vector2d(1, 1)));
  // z w = z (3 - 2 z) on 1/2 <= z <= 3/2 with a second row z - 1/2 >= 0 that z2 = 0 leaves alone:
  // both ends are corners, z = 1/2 is a local minimum with z w = 1.
  DenseProblem stuck{
      (Eigen::MatrixXd(2, 2) << -2, 0, 1, 0).finished(), Eigen::Vector2d(3, -0.5), {0, 0}};
  CHECK(is_stationary(stuck, Eigen::Vector2d(0.5, 0)));
  CHECK_FALSE(is_stationary(stuck, Eigen::Vector2d(1, 0)));
  CHECK(measure_point(stuck, Eigen::Vector2d(0.5, 0)).products == doctest::Approx(1));
}
