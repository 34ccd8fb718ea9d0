// The parametric path: how far a basis holds as the right-hand side moves, and what comes next.
#include <doctest/doctest.h>

#include "lcpush/lcp/pivots/parametric.hpp"
#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A path from the solution that Lemke finds of w = q + M z.
struct Walk {
  DenseLcp<double> lcp;
  VectorX<double> push, direction;
  LemkeRun<double> run;
  std::vector<double> scalars;
  std::vector<int> integers;
  ParametricPath<double> path;
  Status status;

  Walk(const DenseLcp<double>& given, const VectorX<double>& by, const VectorX<double>& pushed = {},
       bool moves_push = false)
      : lcp(given), push(pushed), direction(by), run(given.size()),
        scalars(static_cast<std::size_t>(parametric_scalars(given.size()))),
        integers(static_cast<std::size_t>(parametric_integers(given.size()))),
        path({scalars.data(), parametric_scalars(given.size())},
             {integers.data(), parametric_integers(given.size())}) {
    REQUIRE(run.solve(problem()) == Status::solved);
    status = path.init(run.lemke, problem(), direction.data(), moves_push);
  }
  Problem<double> problem() const {
    Problem<double> p = lcp.view();
    if (push.size() > 0) p.push = push.data();
    return p;
  }
};

VectorX<double> vector(std::initializer_list<double> numbers) {
  VectorX<double> v(static_cast<Index>(numbers.size()));
  Index k = 0;
  for (const double x : numbers) v[k++] = x;
  return v;
}

constexpr double least = 1e-12;

} // namespace

TEST_CASE("where a slack comes to zero its unknown takes over, forwards") {
  Walk walk(dense_lcp<double>(1, {2}, {1}), vector({-4})); // w = 1 - 4 t, then z = (4 t - 1) / 2
  const PathStep<double> step = walk.path.advance(least);
  CHECK(step.end == PathEnd::forward);
  CHECK(step.until == doctest::Approx(0.25));
  CHECK_FALSE(step.next_ends);
  CHECK_FALSE(step.jumps);
  CHECK(walk.path.is_active(0));
}

TEST_CASE("where the diagonal is negative the path turns back: beyond, there is no solution near") {
  Walk walk(dense_lcp<double>(1, {-1}, {1}), vector({-2}));
  const PathStep<double> step = walk.path.advance(least);
  CHECK(step.end == PathEnd::turned_back);
  CHECK(step.until == doctest::Approx(0.5));
}

TEST_CASE("where nothing can take over it is a ray") {
  Walk walk(dense_lcp<double>(1, {0}, {1}), vector({-2}));
  const PathStep<double> step = walk.path.advance(least);
  CHECK(step.end == PathEnd::ray);
  CHECK(step.until == doctest::Approx(0.5));
}

TEST_CASE("where the diagonal is zero two pairs change places, and the unknowns jump") {
  // w1 = 1 - z2, w2 = 1 - 2 t + z1: at t = 1/2, z2 goes from 0 to 1 while t stands still.
  Walk walk(dense_lcp<double>(2, {0, -1, 1, 0}, {1, 1}), vector({0, -2}));
  const PathStep<double> step = walk.path.advance(least);
  CHECK(step.end == PathEnd::forward);
  CHECK(step.until == doctest::Approx(0.5));
  CHECK(step.jumps);
  CHECK(walk.path.is_active(0));
  CHECK(walk.path.is_active(1));
}

TEST_CASE("an infinitesimal push decides only where what is finite has come to zero") {
  SUBCASE("t moves q: the breakpoint is the finite one") {
    Walk walk(dense_lcp<double>(1, {1}, {1}), vector({-2}), vector({-100}));
    const PathStep<double> step = walk.path.advance(least);
    CHECK(step.until == doctest::Approx(0.5));
    CHECK(step.end == PathEnd::forward);
  }
  SUBCASE("t moves q away from zero: sigma stays smaller") {
    // w = t + sigma: the push alone decides at t = 0.
    Walk walk(dense_lcp<double>(1, {1}, {0}), vector({1}), vector({1}));
    CHECK(walk.path.advance(least).end == PathEnd::unbounded);
  }
  SUBCASE("t moves the push: w = sigma (1 - 2 t)") {
    Walk walk(dense_lcp<double>(1, {1}, {0}), vector({-2}), vector({1}), true);
    const PathStep<double> step = walk.path.advance(least);
    CHECK(step.end == PathEnd::forward);
    CHECK(step.until == doctest::Approx(0.5));
  }
  SUBCASE("t moves the push of a value that is finite: nothing happens") {
    Walk walk(dense_lcp<double>(1, {1}, {3}), vector({-2}), vector({1}), true);
    CHECK(walk.path.advance(least).end == PathEnd::unbounded);
  }
}

TEST_CASE("too little memory, or a run that has not ended in a solution, is bad input") {
  const DenseLcp<double> lcp = dense_lcp<double>(1, {1}, {-1});
  const VectorX<double> direction = vector({1});
  LemkeRun<double> run(1);
  std::vector<double> scalars(static_cast<std::size_t>(parametric_scalars(1)));
  std::vector<int> integers(static_cast<std::size_t>(parametric_integers(1)));
  ParametricPath<double> path({scalars.data(), parametric_scalars(1)},
                              {integers.data(), parametric_integers(1)});
  CHECK(path.init(run.lemke, lcp.view(), direction.data(), false) == Status::bad_input);
  REQUIRE(run.solve(lcp) == Status::solved);
  CHECK(path.init(run.lemke, lcp.view(), direction.data(), true) == Status::bad_input); // no push
  CHECK(path.init(run.lemke, lcp.view(), direction.data(), false) == Status::running);
  // Without a push one vector is to spare.
  ParametricPath<double> small({scalars.data(), parametric_scalars(1) - 2},
                               {integers.data(), parametric_integers(1)});
  CHECK(small.init(run.lemke, lcp.view(), direction.data(), false) == Status::bad_input);
}

TEST_CASE(
    "on positive definite problems the path goes through every basis that a fresh solve finds") {
  Index breakpoints = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 12);
    const MatrixX<double> A = random_matrix(random, n, n), skew = random_matrix(random, n, n);
    const VectorX<double> q0 = random_vector(random, n), q1 = random_vector(random, n);
    DenseLcp<double> lcp{
        A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n) + (skew - skew.transpose()), q0};
    const VectorX<double> direction = q1 - q0;
    double t = 0, reference = 0;
    for (Index pieces = 0; pieces < 100; ++pieces) {
      lcp.q = q0 + reference * direction;
      Walk walk(lcp, direction);
      double back = 0;
      if (walk.path.holds_back_to(back)) CHECK(reference + back <= t + 1e-9);
      std::vector<bool> basis;
      for (Index i = 0; i < n; ++i) basis.push_back(walk.run.lemke.is_basic(i));
      const PathStep<double> step = walk.path.advance(least);
      const double end = step.end == PathEnd::unbounded ? 1 : std::min(1.0, reference + step.until);
      for (const double share : {0.02, 0.5, 0.98}) {
        lcp.q = q0 + (t + share * (end - t)) * direction;
        LemkeRun<double> fresh(n);
        REQUIRE(fresh.solve(lcp) == Status::solved);
        for (Index i = 0; i < n; ++i)
          CHECK(fresh.lemke.is_basic(i) == basis[static_cast<std::size_t>(i)]);
      }
      if (end >= 1) break;
      REQUIRE(step.end == PathEnd::forward); // never back: M is a P matrix
      ++breakpoints;
      t = end;
      const double next = step.next_ends ? std::min(1.0, reference + step.next_until) : 1;
      reference = (t + next) / 2;
    }
  }
  CHECK(breakpoints >= 60);
}
