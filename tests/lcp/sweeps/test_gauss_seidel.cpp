// Component-wise projected Gauss-Seidel: what it solves, what it refuses, how its runs end.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <string>

#include "support/checked_sweeps.hpp"
#include "support/sweep_runs.hpp"
#include "support/textbook.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

DenseLcp<double> positive_definite(std::uint64_t seed, Index n) {
  Random random(seed);
  const MatrixX<double> A = random_matrix(random, n, n);
  return {A * A.transpose() + 0.5 * MatrixX<double>::Identity(n, n), 2 * random_vector(random, n)};
}

/// Not symmetric; every diagonal entry outweighs the rest of its row.
DenseLcp<double> dominant(std::uint64_t seed, Index n) {
  Random random(seed);
  DenseLcp<double> lcp{random_matrix(random, n, n), 2 * random_vector(random, n)};
  for (Index i = 0; i < n; ++i) {
    lcp.M(i, i) = 0;
    lcp.M(i, i) = 1.05 * lcp.M.row(i).cwiseAbs().sum() + 0.1;
  }
  return lcp;
}

SweepOptions<double> to_rounding() {
  SweepOptions<double> options;
  options.tolerance = 1e-13;
  options.max_sweeps = 100000;
  return options;
}

/// How far the sweeps' answer is from Lemke's; both have to be solved.
double off_lemke(const DenseLcp<double>& lcp, const SweepOptions<double>& options) {
  SweepRun<double> run(lcp.size());
  LemkeRun<double> lemke(lcp.size());
  REQUIRE(run.solve(lcp, options) == Status::solved);
  REQUIRE(lemke.solve(lcp) == Status::solved);
  CHECK(solution_error(lcp, run.z()) <= 10 * options.tolerance);
  return (run.z() - lemke.z()).cwiseAbs().maxCoeff() / larger(1, lemke.z().cwiseAbs().maxCoeff());
}

/// What symmetric problems minimise over z >= 0.
double energy(const DenseLcp<double>& lcp, const VectorX<double>& z) {
  return 0.5 * z.dot(lcp.M * z) + lcp.q.dot(z);
}

} // namespace

TEST_CASE("positive definite and diagonally dominant problems: Lemke's answer to 1e-8") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    const Index n = 1 + static_cast<Index>(seed % 12);
    CHECK(off_lemke(positive_definite(seed, n), to_rounding()) <= 1e-8);
    CHECK(off_lemke(dominant(seed, n), to_rounding()) <= 1e-8);
  }
}

TEST_CASE("equalities with a free unknown and a positive diagonal: Lemke's answer") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    DenseLcp<double> lcp = positive_definite(seed, 8);
    lcp.free_count = 3;
    CHECK(off_lemke(lcp, to_rounding()) <= 1e-8);
    lcp = dominant(seed, 8);
    lcp.free_count = 8;
    CHECK(off_lemke(lcp, to_rounding()) <= 1e-8);
  }
}

TEST_CASE("relaxation by 0.7 and by 1.5 still converges where M is positive definite") {
  for (const double relaxation : {0.7, 1.5})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      SweepOptions<double> options = to_rounding();
      options.relaxation = relaxation;
      CHECK(off_lemke(positive_definite(seed, 9), options) <= 1e-8);
    }
}

TEST_CASE("where M is symmetric positive definite, no sweep raises the energy") {
  for (const double relaxation : {1.0, 1.5})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      const DenseLcp<double> lcp = positive_definite(seed, 10);
      SweepOptions<double> options = to_rounding();
      options.relaxation = relaxation;
      SweepRun<double> run(10);
      Status status = run.sweeps.init(lcp.view(), options);
      double before = 0;
      while (status == Status::running) {
        status = run.sweeps.sweep();
        const double now = energy(lcp, run.z());
        CHECK(now <= before + 1e-14 * absolute(before));
        CHECK(run.z().minCoeff() >= 0);
        before = now;
      }
      CHECK(status == Status::solved);
    }
}

// Floudas et al. 1999, problem 10.2.1, after Murty 1978: a triangle is solved from its end.
TEST_CASE("Murty's triangular family is solved exactly, within n sweeps") {
  for (const Index n : {1, 2, 5, 12, 30}) {
    CAPTURE(n);
    DenseLcp<double> lcp{MatrixX<double>::Identity(n, n), VectorX<double>::Constant(n, -1)};
    lcp.M.triangularView<Eigen::StrictlyUpper>().setConstant(2);
    SweepOptions<double> options;
    options.check_every = 1;
    SweepRun<double> run(n);
    REQUIRE(run.solve(lcp, options) == Status::solved);
    CHECK(run.sweeps.sweeps() <= n);
    CHECK(run.z() == VectorX<double>::Unit(n, n - 1));
  }
}

TEST_CASE("a P-matrix or a positive semidefinite one is not enough: the sweeps cycle and end "
          "stagnated, with finite numbers") {
  for (const char* name : {"kostreva_1", "murty_2_8"}) {
    CAPTURE(std::string(name));
    const DenseLcp<double> lcp = textbook(name);
    SweepRun<double> run(lcp.size());
    CHECK(run.solve(lcp) == Status::stagnated);
    CHECK(run.sweeps.sweeps() < SweepOptions<double>{}.max_sweeps);
    CHECK(run.z().allFinite());
    CHECK(solution_error(lcp, run.z()) > 0.01);
  }
}

TEST_CASE("a diagonal that is zero, negative or no number is refused") {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    for (const Index row : {0, 3, 5}) {
      DenseLcp<double> lcp = positive_definite(2, 6);
      lcp.M(row, row) = bad;
      SweepRun<double> run(6);
      CHECK(run.solve(lcp) == Status::bad_input);
    }
  for (const char* name : {"cps_4_4_7", "floudas_10_2_4", "murty_2_9", "murty_2_11"}) {
    const DenseLcp<double> lcp = textbook(name);
    SweepRun<double> run(lcp.size());
    CHECK(run.solve(lcp) == Status::bad_input);
  }
}

TEST_CASE("numbers that are not finite are never called solved") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (Index k = 0; k < 4; ++k) {
      DenseLcp<double> lcp = positive_definite(3, 4);
      (k < 3 ? lcp.M(k, k + 1) : lcp.q[1]) = bad;
      SweepRun<double> run(4);
      CHECK(run.solve(lcp) == Status::stagnated);
      CHECK(run.sweeps.sweeps() == 0);
    }
}

TEST_CASE("the limit of sweeps is kept and reported, with the residual that was reached") {
  const DenseLcp<double> lcp = positive_definite(4, 12);
  for (const Index limit : {1, 3, 10}) {
    SweepOptions<double> options;
    options.tolerance = 0;
    options.max_sweeps = limit;
    SweepRun<double> run(12);
    CHECK(run.solve(lcp, options) == Status::sweep_limit);
    CHECK(run.sweeps.sweeps() == limit);
    CHECK(run.sweeps.residual().residual > 0);
    CHECK(solution_error(lcp, run.z()) ==
          doctest::Approx(run.sweeps.residual().residual).epsilon(0.5));
    CHECK(run.sweeps.sweep() == Status::sweep_limit);
    CHECK(run.sweeps.sweeps() == limit);
  }
}

TEST_CASE("a watcher sees every check: at the start, every so many sweeps, and the last one") {
  CheckedSweeps<double> seen;
  const DenseLcp<double> lcp = positive_definite(6, 10);
  SweepOptions<double> options;
  options.tolerance = 0;
  options.max_sweeps = 11;
  options.check_every = 4;
  SweepRun<double> run(10);
  CHECK(run.sweeps.init(lcp.view(), options, seen) == Status::running);
  CHECK(run.sweeps.solve(seen) == Status::sweep_limit);
  CHECK(seen.sweeps == std::vector<Index>{0, 4, 8, 11});
  CHECK(seen.last == run.sweeps.residual().residual);
}

TEST_CASE("same input, same bits: what the memory held before does not matter") {
  const DenseLcp<double> lcp = positive_definite(7, 15);
  SweepRun<double> clean(15), dirty(15);
  for (double& x : dirty.scalars) x = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(clean.solve(lcp) == Status::solved);
  for (int again = 0; again < 2; ++again) {
    REQUIRE(dirty.solve(lcp) == Status::solved);
    CHECK(std::memcmp(clean.sweeps.z(), dirty.sweeps.z(), 15 * sizeof(double)) == 0);
  }
}

TEST_CASE("memory of the stated length is enough, one element less is bad input") {
  for (const Index n : {1, 2, 9}) {
    const DenseLcp<double> lcp = positive_definite(8, n);
    const Index guard = 8, length = gauss_seidel_scalars(n);
    std::vector<double> scalars(static_cast<std::size_t>(length + guard), 77.0);
    GaussSeidel<double> enough({scalars.data(), length});
    CHECK(enough.init(lcp.view()) != Status::bad_input);
    CHECK(enough.solve() == Status::solved);
    for (std::size_t i = 1; i <= guard; ++i) CHECK(scalars[scalars.size() - i] == 77.0);
    GaussSeidel<double> short_by_one({scalars.data(), length - 1});
    CHECK(short_by_one.init(lcp.view()) == Status::bad_input);
  }
}

TEST_CASE("n = 0 and q >= 0 are solved without a sweep") {
  const DenseLcp<double> empty{MatrixX<double>(0, 0), VectorX<double>(0)};
  SweepRun<double> none(0);
  CHECK(none.solve(empty) == Status::solved);
  DenseLcp<double> lcp = positive_definite(9, 5);
  lcp.q = lcp.q.cwiseAbs().eval();
  SweepRun<double> run(5);
  CHECK(run.solve(lcp) == Status::solved);
  CHECK(run.sweeps.sweeps() == 0);
  CHECK(run.z().isZero(0));
}

TEST_CASE("float: random problems are solved to float's precision") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const DenseLcp<double> wide = positive_definite(seed, 12);
    const DenseLcp<float> lcp{wide.M.cast<float>(), wide.q.cast<float>()};
    SweepRun<float> run(12);
    REQUIRE(run.solve(lcp) == Status::solved);
    CHECK(solution_error({lcp.M.cast<double>(), lcp.q.cast<double>()}, run.z().cast<double>()) <=
          4 * double(Tolerances<float>().residual));
  }
}
