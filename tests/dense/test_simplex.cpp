// The simplex tableau: by hand, and against nonnegative least squares, which decide whether a set
// is empty.
#include <doctest/doctest.h>

#include <random>

#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"

using namespace lcpush;
using desktop::Simplex;
using Ending = Simplex::Ending;

namespace {

/// Whole numbers: many corners on which more rows meet than they need to.
Eigen::MatrixXd random_matrix(std::mt19937& draw, Index rows, Index columns) {
  std::uniform_int_distribution<int> small(-2, 2);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return double(small(draw)); });
}

bool is_empty(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return (A * desktop::nonnegative_least_squares(A, b) - b).norm() > 1e-9;
}

/// The points of A v = b, v >= 0 with c v <= value: is there none?
bool none_is_as_cheap(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const Eigen::VectorXd& c,
                      double value) {
  Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(A.rows() + 1, A.cols() + 1);
  Eigen::VectorXd target(A.rows() + 1);
  wide.topLeftCorner(A.rows(), A.cols()) = A;
  wide.bottomRows(1) << c.transpose(), 1;
  target << b, value;
  return is_empty(wide, target);
}

} // namespace

TEST_CASE("corner after corner of a triangle, and its open side") {
  // x + y - s = 1, x and y >= 0: a corner each, and no end away from the origin.
  const Eigen::MatrixXd A = Eigen::RowVector3d(1, 1, -1);
  Simplex simplex(A, Eigen::VectorXd::Ones(1), 0);
  REQUIRE(simplex.find_point() == Ending::found);
  REQUIRE(simplex.minimise(Eigen::Vector3d(1, 2, 0)) == Ending::found);
  CHECK(simplex.point() == Eigen::Vector3d(1, 0, 0));
  REQUIRE(simplex.minimise(Eigen::Vector3d(2, 1, 0)) == Ending::found);
  CHECK(simplex.point() == Eigen::Vector3d(0, 1, 0));
  REQUIRE(simplex.minimise(Eigen::Vector3d(0, -1, 0)) == Ending::unbounded);
  CHECK((A * simplex.ray()).norm() == 0);
  CHECK(simplex.ray()[1] == 1);
}

TEST_CASE("a free variable may be negative, a row may follow from another, or contradict it") {
  Eigen::MatrixXd A(2, 2);
  A << 1, 1, 2, 2;
  Simplex follows(A, Eigen::Vector2d(-1, -2), 1);
  REQUIRE(follows.find_point() == Ending::found);
  REQUIRE(follows.minimise(Eigen::Vector2d(-1, 0)) == Ending::found);
  CHECK(follows.point() == Eigen::Vector2d(-1, 0));
  CHECK(Simplex(A, Eigen::Vector2d(-1, -3), 1).find_point() == Ending::none);
  CHECK(Simplex(A, Eigen::Vector2d(-1, -2), 0).find_point() == Ending::none);
}

TEST_CASE("no columns, no rows") {
  CHECK(Simplex(Eigen::MatrixXd(1, 0), Eigen::VectorXd::Ones(1), 0).find_point() == Ending::none);
  CHECK(Simplex(Eigen::MatrixXd(1, 0), Eigen::VectorXd::Zero(1), 0).find_point() == Ending::found);
  Simplex orthant(Eigen::MatrixXd(0, 2), Eigen::VectorXd(0), 0);
  REQUIRE(orthant.find_point() == Ending::found);
  REQUIRE(orthant.minimise(Eigen::Vector2d(1, 1)) == Ending::found);
  CHECK(orthant.minimise(Eigen::Vector2d(1, -1)) == Ending::unbounded);
}

TEST_CASE("random programs, one after the other on one tableau: nothing in the set is cheaper") {
  std::mt19937 draw(7);
  Index found = 0, none = 0, unbounded = 0;
  for (int scene = 0; scene < 400; ++scene) {
    CAPTURE(scene);
    const Index rows = 2 + scene % 6, columns = rows + 1 + scene % 5;
    const Eigen::MatrixXd A = random_matrix(draw, rows, columns);
    Eigen::VectorXd b = random_matrix(draw, rows, 1);
    if (scene % 3 != 0) b = A * random_matrix(draw, columns, 1).cwiseMax(0);
    Simplex simplex(A, b, 0);
    const Ending first = simplex.find_point();
    REQUIRE(first == (is_empty(A, b) ? Ending::none : Ending::found));
    if (first == Ending::none) {
      ++none;
      continue;
    }
    for (int k = 0; k < 4; ++k) {
      const Eigen::VectorXd c = random_matrix(draw, columns, 1);
      const Ending ending = simplex.minimise(c);
      REQUIRE((ending == Ending::found || ending == Ending::unbounded));
      CHECK((A * simplex.point() - b).norm() <= 1e-9);
      CHECK(simplex.point().minCoeff() >= 0);
      if (ending == Ending::found) {
        ++found;
        CHECK(none_is_as_cheap(A, b, c, c.dot(simplex.point()) - 1e-4));
      } else {
        ++unbounded;
        CHECK(c.dot(simplex.ray()) < 0);
        CHECK((A * simplex.ray()).norm() <= 1e-9);
        CHECK(simplex.ray().minCoeff() >= 0);
      }
    }
  }
  CHECK(found > 100);
  CHECK(none > 50);
  CHECK(unbounded > 100);
}

TEST_CASE("where every point of the set is cheapest, rounding does not get in between") {
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (int trial = 0; trial < 100; ++trial) { // c = A' nu: reduced costs are noise
    CAPTURE(trial);
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(1, 6, [&] { return entry(draw); });
    const Eigen::VectorXd b = A * Eigen::VectorXd::NullaryExpr(6, [&] { return entry(draw) + 1; });
    const double nu = entry(draw);
    const auto point = desktop::cheapest_point(A, b, nu * A.transpose(), 0);
    REQUIRE(point);
    CHECK(std::abs((nu * A * *point)[0] - nu * b[0]) <= 1e-13);
  }
}

TEST_CASE("columns that are added later count as those that were there") {
  std::mt19937 draw(7);
  int improved = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::MatrixXd A = random_matrix(draw, 4, 14);
    const Eigen::VectorXd b = A.leftCols(7) * Eigen::VectorXd::Ones(7);
    Eigen::VectorXd c = random_matrix(draw, 14, 1).cwiseAbs();
    Simplex whole(A, b, 0), grown(A.leftCols(7), b, 0);
    REQUIRE(whole.find_point() == Ending::found);
    REQUIRE(grown.find_point() == Ending::found);
    if (c.head(7).isZero(0) || grown.minimise(c.head(7)) != Ending::found) continue;
    const double before = c.head(7).dot(grown.point());
    grown.add(A.rightCols(7));
    REQUIRE(whole.minimise(c) == Ending::found);
    REQUIRE(grown.minimise(c) == Ending::found);
    const double after = c.dot(grown.point());
    CHECK(after == doctest::Approx(c.dot(whole.point())).epsilon(1e-9));
    CHECK(((c - A.transpose() * grown.multipliers() * c.maxCoeff()).minCoeff() >= -1e-7));
    improved += after < before - 1e-9;
  }
  CHECK(improved > 50);
}
