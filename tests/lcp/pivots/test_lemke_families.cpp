// Matrix classes for which theory says how Lemke's method must end.
#include <doctest/doctest.h>

#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double allowed = 1e-9;

void check_solved(const DenseLcp<double>& lcp) {
  LemkeRun<double> run(lcp.size());
  REQUIRE(run.solve(lcp) == Status::solved);
  CHECK(solution_error(lcp, run.z()) <= allowed);
  CHECK(run.lemke.residual().residual <= Tolerances<double>().residual);
}

/// A ray of a copositive matrix: v0 = 0, M v >= 0, v'M v = 0 and v'q < 0, which proves that no
/// z >= 0 has M z + q >= 0 if M is positive semidefinite.
void check_unsolvable(const DenseLcp<double>& lcp) {
  LemkeRun<double> run(lcp.size());
  REQUIRE(run.solve(lcp) == Status::ray);
  CHECK(run.lemke.ray_artificial() <= allowed);
  CHECK(ray_error(lcp.M, VectorX<double>(), run.ray(), 0) <= allowed);
  CHECK(run.ray().dot(lcp.q) < -allowed * lcp.q.cwiseAbs().maxCoeff());
}

MatrixX<double> low_rank(Random& random, Index n, Index rank) {
  const MatrixX<double> A = random_matrix(random, n, rank);
  return A * A.transpose();
}

/// min c'x, A x >= b, x >= 0, with optimality as a complementarity problem.
DenseLcp<double> linear_program(const MatrixX<double>& A, const VectorX<double>& b,
                                const VectorX<double>& c) {
  const Index m = A.rows(), n = A.cols();
  DenseLcp<double> lcp{MatrixX<double>::Zero(n + m, n + m), VectorX<double>(n + m)};
  lcp.M.topRightCorner(n, m) = -A.transpose();
  lcp.M.bottomLeftCorner(m, n) = A;
  lcp.q << c, -b;
  return lcp;
}

} // namespace

TEST_CASE("positive definite problems are solved, symmetric or not") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 30);
    DenseLcp<double> lcp{low_rank(random, n, n) + 0.01 * MatrixX<double>::Identity(n, n),
                         random_vector(random, n)};
    if (seed % 2 == 0) {
      const MatrixX<double> skew = random_matrix(random, n, n);
      lcp.M += skew - skew.transpose();
    }
    check_solved(lcp);
  }
}

TEST_CASE("feasible positive semidefinite problems are solved") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 24);
    DenseLcp<double> lcp{low_rank(random, n, n / 2), VectorX<double>(n)};
    const VectorX<double> z = random_vector(random, n).cwiseMax(0);
    lcp.q = random_vector(random, n).cwiseMax(0) - lcp.M * z; // feasible at z
    check_solved(lcp);
  }
}

TEST_CASE("infeasible positive semidefinite problems end in a ray that proves it") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 16);
    // M v = 0 for a positive v, and v'q < 0.
    const VectorX<double> v = random_vector(random, n).cwiseAbs() + VectorX<double>::Ones(n);
    const MatrixX<double> away =
        MatrixX<double>::Identity(n, n) - v * v.transpose() / v.squaredNorm();
    const DenseLcp<double> lcp{away * low_rank(random, n, n) * away, -v + random_vector(random, n)};
    check_unsolvable(lcp);
  }
}

TEST_CASE("P-matrices are solved at the one solution they have") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 20);
    // Strictly diagonally dominant with a positive diagonal: a P-matrix, not symmetric.
    DenseLcp<double> lcp{random_matrix(random, n, n), VectorX<double>(n)};
    for (Index i = 0; i < n; ++i) {
      lcp.M(i, i) = 0;
      lcp.M(i, i) = 1.01 * lcp.M.row(i).cwiseAbs().sum() + 0.01;
    }
    VectorX<double> z(n), w(n);
    for (Index i = 0; i < n; ++i) {
      const double x = random.uniform(-1, 1);
      z[i] = x > 0 ? x : 0;
      w[i] = x > 0 ? 0 : -x;
    }
    lcp.q = w - lcp.M * z;
    LemkeRun<double> run(n);
    REQUIRE(run.solve(lcp) == Status::solved);
    CHECK((run.z() - z).cwiseAbs().maxCoeff() <= 1e-10);
  }
}

TEST_CASE("degenerate problems are solved: z and w zero together in many rows") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(3, 24);
    DenseLcp<double> lcp{low_rank(random, n, n / 3 + 1), VectorX<double>(n)};
    VectorX<double> z = VectorX<double>::Zero(n);
    for (Index i = 0; i < n; i += 4) z[i] = double(random.integer(1, 3));
    lcp.q = -(lcp.M * z);
    check_solved(lcp);
  }
}

TEST_CASE("integer degenerate problems with repeated rows are solved") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = 12;
    MatrixX<double> A(n, 4);
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < 4; ++j) A(i, j) = double(random.integer(-1, 1));
    A.bottomRows(4) = A.topRows(4);
    VectorX<double> z(n);
    for (Index i = 0; i < n; ++i) z[i] = double(random.integer(0, 1));
    const MatrixX<double> M = A * A.transpose();
    check_solved({M, -(M * z)});
  }
}

TEST_CASE("linear programs: solved at an optimum when there is one") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index m = random.integer(1, 10), n = random.integer(1, 10);
    const MatrixX<double> A = random_matrix(random, m, n);
    const VectorX<double> x = random_vector(random, n).cwiseAbs();
    const VectorX<double> y = random_vector(random, m).cwiseAbs();
    const VectorX<double> b = A * x - random_vector(random, m).cwiseMax(0); // x is feasible
    const VectorX<double> c = A.transpose() * y + random_vector(random, n).cwiseMax(0); // y too
    const DenseLcp<double> lcp = linear_program(A, b, c);
    check_solved(lcp);
    LemkeRun<double> run(m + n);
    REQUIRE(run.solve(lcp) == Status::solved);
    const VectorX<double> z = run.z();
    CHECK(c.dot(z.head(n)) == doctest::Approx(b.dot(z.tail(m))).epsilon(1e-9));
  }
}

TEST_CASE("linear programs without a feasible point, or without a bound, end in a ray") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index m = 5, n = 6;
    const MatrixX<double> A = random_matrix(random, m, n).cwiseAbs();
    const VectorX<double> positive = VectorX<double>::Ones(m);
    // -A x >= 1 has no x >= 0; min -x subject to A x >= 1 has no bound.
    check_unsolvable(linear_program(-A, positive, VectorX<double>::Ones(n)));
    check_unsolvable(linear_program(A, positive, -VectorX<double>::Ones(n)));
  }
}

TEST_CASE("copositive problems that are not semidefinite are solved when their kernel allows") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 20);
    // Strictly copositive: no zero on the diagonal, nothing negative.
    check_solved({random_matrix(random, n, n).cwiseAbs() + 0.01 * MatrixX<double>::Identity(n, n),
                  random_vector(random, n)});
  }
}

TEST_CASE("any matrix: what is called solved is solved, what is called a ray is one") {
  Index solved = 0, rays = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 12);
    const DenseLcp<double> lcp{random_matrix(random, n, n), random_vector(random, n)};
    const VectorX<double> ones = VectorX<double>::Ones(n);
    LemkeOptions<double> options;
    options.cover = ones.data();
    LemkeRun<double> run(n);
    const Status status = run.solve(lcp, options);
    if (status == Status::solved) {
      CHECK(solution_error(lcp, run.z()) <= allowed);
      ++solved;
    } else {
      REQUIRE(status == Status::ray);
      CHECK(ray_error(lcp.M, ones, run.ray(), run.lemke.ray_artificial()) <= allowed);
      ++rays;
    }
  }
  CHECK(solved > 20);
  CHECK(rays > 20);
}
