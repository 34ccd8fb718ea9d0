// The small parts of the block solvers: points of a simplex, small equations, proximal Newton.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "lcpush/lcp/sweeps/proximal_newton.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"
#include "support/sweep_runs.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// Held, Wolfe, Crowder 1974: sort, and take the largest support that is consistent.
double sorted_threshold(std::vector<double> y, double total) {
  std::sort(y.begin(), y.end(), std::greater<double>());
  double sum = 0, theta = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    sum += y[k];
    const double next = (sum - total) / static_cast<double>(k + 1);
    if (y[k] > next) theta = next;
  }
  return std::max(0.0, theta);
}

/// A pinched object with one point a finger, and a first guess at its forces.
struct Prepared {
  SolvedPush<double> push;
  Problem<double> problem;
  std::vector<double> scalars;
  std::vector<int> integers;
  ProximalNewton<double> newton;

  explicit Prepared(const Scene3& scene)
      : push(scene), problem(push.assembly.problem()),
        scalars(static_cast<std::size_t>(proximal_scalars(problem.size, couplings(), sums()))),
        integers(static_cast<std::size_t>(proximal_integers(problem.size, couplings(), sums()))),
        newton({scalars.data(), static_cast<Index>(scalars.size())},
               {integers.data(), static_cast<Index>(integers.size())}) {}
  Index couplings() const { return coupling_count(problem); }
  Index sums() const { return problem.factored->sums.size; }
};

} // namespace

TEST_CASE("the threshold of a simplex is the one that sorting finds") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<double> y(static_cast<std::size_t>(random.integer(1, 20)));
    for (double& entry : y) entry = random.uniform(-2, 2);
    if (seed % 5 == 0) y.assign(y.size(), y[0]); // ties
    const double total = random.uniform(0.01, 3);
    const double theta = simplex_threshold(y.data(), static_cast<Index>(y.size()), total);
    CHECK(theta == doctest::Approx(sorted_threshold(y, total)).epsilon(1e-12));
    double sum = 0;
    for (const double entry : y) sum += std::max(0.0, entry - theta);
    CHECK(sum <= total + 1e-12);
    if (theta > 0) CHECK(sum == doctest::Approx(total));
  }
}

TEST_CASE("a point inside the simplex has threshold 0, and so has one without positive entries") {
  const double inside[] = {0.2, -1, 0.3}, negative[] = {-1, -2, 0};
  CHECK(simplex_threshold(inside, 3, 1.0) == 0);
  CHECK(simplex_threshold(inside, 3, 0.5) == 0);
  CHECK(simplex_threshold(inside, 3, 0.1) == doctest::Approx(0.2));
  CHECK(simplex_threshold(negative, 3, 1.0) == 0);
  CHECK(simplex_threshold(inside, 0, 1.0) == 0);
}

TEST_CASE("small equations hold, rows swapped where the first pivot is zero") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 10);
    MatrixX<double> J = random_matrix(random, n, n);
    if (n > 1) J(0, 0) = 0;
    const VectorX<double> b = random_vector(random, n);
    VectorX<double> x = b;
    MatrixX<double> used = J;
    REQUIRE(solve_small(MatrixMap<double>(used.data(), n, n), x.data()));
    CHECK((J * x - b).cwiseAbs().maxCoeff() <= 1e-12 * (1 + x.cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("singular equations and those with NaN are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MatrixX<double> zero_column = MatrixX<double>::Identity(3, 3);
  zero_column(1, 1) = 0;
  MatrixX<double> equal_rows = MatrixX<double>::Ones(2, 2);
  MatrixX<double> no_number = MatrixX<double>::Constant(1, 1, nan);
  double b[] = {1, 2, 3};
  CHECK_FALSE(solve_small(MatrixMap<double>(zero_column.data(), 3, 3), b));
  CHECK_FALSE(solve_small(MatrixMap<double>(equal_rows.data(), 2, 2), b));
  CHECK_FALSE(solve_small(MatrixMap<double>(no_number.data(), 1, 1), b));
}

TEST_CASE("a solution is a fixed point of proximal Newton at any eps") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const double eps : {10.0, 1.0, 0.01}) {
      CAPTURE(seed);
      CAPTURE(eps);
      Prepared run(determined_grasp(seed));
      LemkeRun<double> lemke(run.problem.size);
      REQUIRE(lemke.solve(run.problem) == Status::solved);
      const VectorX<double> expected = lemke.z();
      REQUIRE(run.newton.init(run.problem, expected.data()));
      REQUIRE(run.newton.settle(eps, 200));
      VectorX<double> z = VectorX<double>::Constant(run.problem.size, 77);
      run.newton.recover(z.data());
      // The eps in the denominator of a friction force lets rounding grow.
      CHECK((z - expected).cwiseAbs().maxCoeff() <= 1e-9 * (1 + expected.cwiseAbs().maxCoeff()));
    }
}

TEST_CASE("proximal Newton wants all of its memory") {
  Prepared run(determined_grasp(1));
  const VectorX<double> start = VectorX<double>::Zero(run.problem.size);
  const Span<double> scalars{run.scalars.data(), static_cast<Index>(run.scalars.size())};
  const Span<int> integers{run.integers.data(), static_cast<Index>(run.integers.size())};
  CHECK(ProximalNewton<double>(scalars, integers).init(run.problem, start.data()));
  CHECK_FALSE(ProximalNewton<double>({scalars.data, scalars.size - 1}, integers)
                  .init(run.problem, start.data()));
  CHECK_FALSE(ProximalNewton<double>(scalars, {integers.data, integers.size - 1})
                  .init(run.problem, start.data()));
}
