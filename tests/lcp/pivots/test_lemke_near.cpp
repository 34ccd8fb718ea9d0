// Lemke's pivots from unknowns that are positive in an answer nearby.
#include <doctest/doctest.h>

#include <limits>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"
#include "support/sweep_runs.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

using Flags = std::vector<unsigned char>;

Flags positive(const VectorX<double>& z, double above = 0) {
  Flags flags(static_cast<std::size_t>(z.size()));
  for (Index i = 0; i < z.size(); ++i) flags[static_cast<std::size_t>(i)] = z[i] > above ? 1 : 0;
  return flags;
}

Status solve_near(LemkeRun<double>& run, const Problem<double>& problem, const Flags& active) {
  LemkeOptions<double> options;
  options.covers = 1;
  const Status status = run.lemke.init(problem, options, active.data(), Guess::near);
  return status == Status::running ? run.lemke.solve() : status;
}

/// M = B' B of rank r < n with a solution z that has more positive unknowns than r: no basis.
struct Redundant {
  DenseLcp<double> lcp;
  VectorX<double> z;

  explicit Redundant(std::uint64_t seed, Index n = 12, Index rank = 3) {
    Random random(seed);
    const MatrixX<double> B = random_matrix(random, rank, n);
    lcp.M = B.transpose() * B;
    z = VectorX<double>::Zero(n);
    VectorX<double> w = VectorX<double>::Zero(n);
    for (Index i = 0; i < n; ++i) (i % 2 == 0 ? z[i] : w[i]) = random.uniform(0.1, 1);
    lcp.q = w - lcp.M * z;
  }
};

} // namespace

TEST_CASE(
    "from the positive unknowns of a solution that is a basis no more than one pivot is due") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const MatrixX<double> A = random_matrix(random, 12, 12);
    const DenseLcp<double> lcp{A * A.transpose() + 0.1 * MatrixX<double>::Identity(12, 12),
                               random_vector(random, 12)};
    LemkeRun<double> cold(12), near(12);
    REQUIRE(cold.solve(lcp) == Status::solved);
    REQUIRE(solve_near(near, lcp.view(), positive(cold.z())) == Status::solved);
    CHECK(near.lemke.pivots() <= 1);
    CHECK((near.z() - cold.z()).cwiseAbs().maxCoeff() <= 1e-9 * (1 + cold.z().maxCoeff()));
  }
}

TEST_CASE("redundant positive unknowns are left out: solved, in fewer pivots than from zero") {
  Index near_pivots = 0, cold_pivots = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    const Redundant problem(seed);
    LemkeRun<double> near(12), cold(12);
    REQUIRE(solve_near(near, problem.lcp.view(), positive(problem.z)) == Status::solved);
    CHECK(solution_error(problem.lcp, near.z()) <= 1e-9);
    REQUIRE(cold.solve(problem.lcp) == Status::solved);
    near_pivots += near.lemke.pivots();
    cold_pivots += cold.lemke.pivots();
  }
  MESSAGE("pivots: " << near_pivots << " from near, " << cold_pivots << " cold");
  CHECK(near_pivots < cold_pivots);
}

TEST_CASE("n = 0, numbers that are not finite, and memory too small are as in a cold start") {
  const unsigned char none = 0;
  LemkeRun<double> empty(0);
  const DenseLcp<double> nothing{MatrixX<double>(0, 0), VectorX<double>(0)};
  REQUIRE(empty.lemke.init(nothing.view(), {}, &none, Guess::near) == Status::running);
  CHECK(empty.lemke.solve() == Status::solved);
  DenseLcp<double> lcp = Redundant(1).lcp;
  const Flags active(12, 1);
  LemkeRun<double> run(12);
  Lemke<double> small({run.scalars.data(), lemke_scalars(12) / 2},
                      {run.integers.data(), lemke_integers(12)});
  CHECK(small.init(lcp.view(), {}, active.data(), Guess::near) == Status::bad_input);
  lcp.q[4] = std::numeric_limits<double>::infinity();
  CHECK(solve_near(run, lcp.view(), active) == Status::bad_input);
  CHECK(run.lemke.reason() == Reason::not_finite);
}
