// Lemke's contract: how runs end, what is refused, what is repeatable.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>

#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

DenseLcp<double> scalar_lcp(double M, double q) {
  return {MatrixX<double>::Constant(1, 1, M), VectorX<double>::Constant(1, q)};
}

DenseLcp<double> positive_definite(std::uint64_t seed, Index n) {
  Random random(seed);
  const MatrixX<double> A = random_matrix(random, n, n);
  return {A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n), random_vector(random, n)};
}

/// The run that needs most memory: with free unknowns and a push.
Status status_with(DenseLcp<double> lcp, Index missing_scalars, Index missing_integers) {
  const Index n = lcp.size();
  lcp.free_count = 1;
  Problem<double> problem = lcp.view();
  problem.push = lcp.q.data();
  LemkeRun<double> run(n);
  Lemke<double> lemke({run.scalars.data(), lemke_scalars(n) - missing_scalars},
                      {run.integers.data(), lemke_integers(n) - missing_integers});
  const Status status = lemke.init(problem);
  if (status == Status::bad_input) CHECK(lemke.reason() == Reason::memory_too_small);
  return status;
}

} // namespace

TEST_CASE("n = 0 is solved without a pivot") {
  const DenseLcp<double> lcp{MatrixX<double>(0, 0), VectorX<double>(0)};
  LemkeRun<double> run(0);
  CHECK(run.solve(lcp) == Status::solved);
  CHECK(run.lemke.pivots() == 0);
}

TEST_CASE("n = 1: every sign of M and q") {
  struct Case {
    double M, q;
    Status status;
    double z;
  };
  for (const Case& c : {Case{2, -3, Status::solved, 1.5}, Case{2, 3, Status::solved, 0},
                        Case{0, 3, Status::solved, 0}, Case{0, 0, Status::solved, 0},
                        Case{-1, 3, Status::solved, 0}, Case{0, -3, Status::ray, 0},
                        Case{-1, -3, Status::ray, 0}}) {
    CAPTURE(c.M);
    CAPTURE(c.q);
    LemkeRun<double> run(1);
    REQUIRE(run.solve(scalar_lcp(c.M, c.q)) == c.status);
    if (c.status == Status::solved) CHECK(run.z()[0] == doctest::Approx(c.z));
  }
}

TEST_CASE("q >= 0 needs no pivot, whatever M is") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    DenseLcp<double> lcp{random_matrix(random, 7, 7), random_vector(random, 7).cwiseAbs()};
    lcp.q[3] = 0;
    LemkeRun<double> run(7);
    REQUIRE(run.solve(lcp) == Status::solved);
    CHECK(run.lemke.pivots() == 0);
    CHECK(run.z().isZero(0));
  }
}

TEST_CASE("memory of the stated length is enough, one element less is bad input") {
  for (const Index n : {1, 2, 9}) {
    const DenseLcp<double> lcp = positive_definite(3, n);
    CHECK(status_with(lcp, 0, 0) == Status::running);
    CHECK(status_with(lcp, 1, 0) == Status::bad_input);
    CHECK(status_with(lcp, 0, 1) == Status::bad_input);
    CHECK(status_with(lcp, lemke_scalars(n), 0) == Status::bad_input);
  }
}

TEST_CASE("a run writes nothing beyond its memory") {
  const Index n = 6, guard = 16;
  const DenseLcp<double> lcp = positive_definite(4, n);
  std::vector<double> scalars(static_cast<std::size_t>(lemke_scalars(n) + guard), 77.0);
  std::vector<int> integers(static_cast<std::size_t>(lemke_integers(n) + guard), 77);
  Lemke<double> lemke({scalars.data(), lemke_scalars(n)}, {integers.data(), lemke_integers(n)});
  REQUIRE(lemke.init(lcp.view()) == Status::running);
  REQUIRE(lemke.solve() == Status::solved);
  for (std::size_t i = 1; i <= guard; ++i) {
    CHECK(scalars[scalars.size() - i] == 77.0);
    CHECK(integers[integers.size() - i] == 77);
  }
}

TEST_CASE("a number that is not finite is bad input, wherever it stands") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const Index n = 4;
  for (const double bad : {nan, inf, -inf}) {
    for (Index k = 0; k < n * n; ++k) {
      DenseLcp<double> lcp = positive_definite(5, n);
      lcp.M(k / n, k % n) = bad;
      LemkeRun<double> run(n);
      CHECK(run.solve(lcp) == Status::bad_input);
      CHECK(run.lemke.reason() == Reason::not_finite);
    }
    for (Index i = 0; i < n; ++i) {
      DenseLcp<double> lcp = positive_definite(5, n);
      Problem<double> problem = lcp.view();
      const VectorX<double> push = VectorX<double>::Unit(n, i) * bad;
      problem.push = push.data();
      LemkeRun<double> pushed(n);
      CHECK(pushed.solve(problem) == Status::bad_input);
      lcp.q[i] = bad;
      LemkeRun<double> run(n);
      CHECK(run.solve(lcp) == Status::bad_input);
      CHECK(run.lemke.reason() == Reason::not_finite);
    }
  }
}

TEST_CASE("the pivot limit holds for each cover and is reported") {
  const DenseLcp<double> lcp = positive_definite(6, 12);
  LemkeRun<double> free_run(12);
  REQUIRE(free_run.solve(lcp) == Status::solved);
  REQUIRE(free_run.lemke.pivots() > 3);
  LemkeOptions<double> options;
  options.max_pivots = 2;
  options.covers = 3;
  LemkeRun<double> run(12);
  CHECK(run.solve(lcp, options) == Status::pivot_limit);
  CHECK(run.lemke.pivots() == 6);
  CHECK(run.lemke.covers_tried() == 3);
}

TEST_CASE("step by step is the same run as solve, one pivot a step") {
  const DenseLcp<double> lcp = positive_definite(7, 10);
  LemkeRun<double> whole(10), single(10);
  REQUIRE(whole.solve(lcp) == Status::solved);
  Status status = single.lemke.init(lcp.view());
  Index steps = 0;
  Index last_left = -1;
  while (status == Status::running) {
    status = single.lemke.step();
    ++steps;
    CHECK(single.lemke.pivots() == steps);
    const Pivot& pivot = single.lemke.last_pivot();
    if (steps > 1) CHECK(pivot.entering == complement(last_left, 10));
    last_left = pivot.leaving;
  }
  CHECK(status == Status::solved);
  CHECK(last_left == artificial(10));
  CHECK(single.z() == whole.z());
  CHECK(single.lemke.step() == Status::solved);
  CHECK(single.lemke.pivots() == steps);
}

TEST_CASE("every basis on the way keeps all values >= 0 and exactly one pair open") {
  const DenseLcp<double> lcp = positive_definite(9, 10);
  LemkeRun<double> run(10);
  Status status = run.lemke.init(lcp.view());
  while (status == Status::running) {
    status = run.lemke.step();
    const Dictionary<double>& d = run.lemke.dictionary();
    CHECK(d.values.col(0).minCoeff() >= -1e-12);
    Index open = 0;
    for (Index i = 0; i < 10; ++i)
      if (d.row_of(slack(i)) < 0 && d.row_of(unknown(i, 10)) < 0) ++open;
    CHECK(open == (status == Status::running ? 1 : 0));
  }
}

TEST_CASE("same input, same bits: what the memory held before does not matter") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const DenseLcp<double> lcp = positive_definite(seed, 15);
    LemkeRun<double> clean(15), dirty(15);
    for (double& x : dirty.scalars) x = std::numeric_limits<double>::quiet_NaN();
    for (int& x : dirty.integers) x = -12345;
    REQUIRE(clean.solve(lcp) == Status::solved);
    REQUIRE(dirty.solve(lcp) == Status::solved);
    CHECK(clean.lemke.pivots() == dirty.lemke.pivots());
    CHECK(std::memcmp(clean.lemke.z(), dirty.lemke.z(), 15 * sizeof(double)) == 0);
    REQUIRE(dirty.solve(lcp) == Status::solved);
    CHECK(std::memcmp(clean.lemke.z(), dirty.lemke.z(), 15 * sizeof(double)) == 0);
  }
}

TEST_CASE("generic covers are positive, differ from each other and repeat") {
  for (std::uint32_t seed = 0; seed < 6; ++seed)
    for (Index i = 0; i < 200; ++i) {
      CHECK(generic_number<double>(seed, i) >= 1);
      CHECK(generic_number<double>(seed, i) < 2);
      CHECK(generic_number<double>(seed, i) != generic_number<double>(seed + 1, i));
      CHECK(generic_number<double>(seed, i) != generic_number<double>(seed, i + 1));
      CHECK(double(generic_number<float>(seed, i)) == generic_number<double>(seed, i));
    }
}
