// What Lemke carries beside q: free unknowns (symbolic bound), an infinitesimal push, a guessed
// basis, and scales.
#include <doctest/doctest.h>

#include <cmath>

#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

DenseLcp<double> positive_definite(Random& random, Index n) {
  const MatrixX<double> A = random_matrix(random, n, n);
  return {A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n), random_vector(random, n)};
}

/// min x'H x / 2 + c'x, B x = b, x >= 0: the multipliers of B x = b are free.
DenseLcp<double> constrained(Random& random, Index n, Index equalities, bool feasible) {
  const MatrixX<double> A = random_matrix(random, n, n);
  const MatrixX<double> B = random_matrix(random, equalities, n).cwiseAbs();
  const VectorX<double> x = random_vector(random, n).cwiseAbs();
  DenseLcp<double> lcp{MatrixX<double>::Zero(n + equalities, n + equalities),
                       random_vector(random, n + equalities), equalities};
  lcp.M.topLeftCorner(n, n) = A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n);
  lcp.M.topRightCorner(n, equalities) = -B.transpose();
  lcp.M.bottomLeftCorner(equalities, n) = B;
  lcp.q.tail(equalities) = feasible ? VectorX<double>(-(B * x)) : VectorX<double>(B * x);
  return lcp;
}

std::vector<unsigned char> basis(const LemkeRun<double>& run, Index n) {
  std::vector<unsigned char> active;
  for (Index i = 0; i < n; ++i) active.push_back(run.lemke.is_basic(i) ? 1 : 0);
  return active;
}

struct Pushed {
  DenseLcp<double> lcp;
  VectorX<double> push;

  Problem<double> view() const {
    Problem<double> problem = lcp.view();
    problem.push = push.data();
    return problem;
  }
  double error_at(double sigma, const VectorX<double>& z) const {
    DenseLcp<double> moved = lcp;
    moved.q += sigma * push;
    return solution_error(moved, z);
  }
};

/// Follows the answer z + sigma z_push over its range, and a little beyond it.
void check_push(const Pushed& pushed, bool bounded_above) {
  const Index n = pushed.lcp.size();
  LemkeRun<double> run(n);
  REQUIRE(run.solve(pushed.view()) == Status::solved);
  const VectorX<double> rate = Eigen::Map<const VectorX<double>>(run.lemke.z_push(), n);
  const double end = run.lemke.valid_to();
  for (const double part : {0.0, 0.25, 0.5, 0.999}) {
    const double sigma = part * (end < 0 ? 10.0 : end);
    CHECK(pushed.error_at(sigma, run.z() + sigma * rate) <= 1e-9);
  }
  if (bounded_above && end >= 0) {
    const double beyond = 1.5 * end + 1e-3;
    CHECK(pushed.error_at(beyond, run.z() + beyond * rate) > 1e-6);
  }
}

} // namespace

TEST_CASE("free unknowns take either sign and their rows are equalities") {
  Index negative = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const DenseLcp<double> lcp = constrained(random, random.integer(3, 14), 2, true);
    LemkeRun<double> run(lcp.size());
    REQUIRE(run.solve(lcp) == Status::solved);
    CHECK(solution_error(lcp, run.z()) <= 1e-9);
    const VectorX<double> w = lcp.M * run.z() + lcp.q;
    CHECK(w.tail(2).cwiseAbs().maxCoeff() <= 1e-9 * lcp.q.cwiseAbs().maxCoeff());
    if (run.z().tail(2).minCoeff() < 0) ++negative;
  }
  CHECK(negative > 5);
}

TEST_CASE("a free unknown is not merely bounded by a large number: any size of it is reached") {
  for (const double size : {1.0, 1e6, 1e12}) {
    CAPTURE(size);
    // 0 <= x _|_ x + s / size >= 0 and (1 - x) / size = 0 with s free: x = 1, s = -size.
    DenseLcp<double> lcp{MatrixX<double>(2, 2), VectorX<double>(2), 1};
    lcp.M << 1, 1 / size, -1 / size, 0;
    lcp.q << 0, 1 / size;
    LemkeRun<double> run(2);
    REQUIRE(run.solve(lcp) == Status::solved);
    CHECK(run.z()[0] == doctest::Approx(1));
    CHECK(run.z()[1] == doctest::Approx(-size));
  }
}

TEST_CASE("z + sigma z_push solves the pushed problem inside valid_to and not beyond") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 14);
    const Pushed pushed{positive_definite(random, n), random_vector(random, n)};
    check_push(pushed, true);
  }
}

TEST_CASE("z + sigma z_push holds with free unknowns too") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const DenseLcp<double> lcp = constrained(random, 8, 2, true);
    VectorX<double> push = random_vector(random, lcp.size());
    push.tail(2).setZero();
    check_push({lcp, push}, true);
  }
}

TEST_CASE("at a degenerate point the push chooses the branch: q = 0 answers with the push's sign") {
  for (const double sign : {1.0, -1.0}) {
    Pushed pushed{{MatrixX<double>::Identity(2, 2), VectorX<double>::Zero(2)}, VectorX<double>(2)};
    pushed.push << -3 * sign, 2 * sign;
    LemkeRun<double> run(2);
    REQUIRE(run.solve(pushed.view()) == Status::solved);
    CHECK(run.z().isZero(0));
    CHECK(run.lemke.z_push()[0] == doctest::Approx(sign > 0 ? 3 : 0));
    CHECK(run.lemke.z_push()[1] == doctest::Approx(sign > 0 ? 0 : 2));
    CHECK(run.lemke.valid_to() < 0); // for every size of the push
  }
}

TEST_CASE("started from the solution's basis it takes no pivot and finds the same z") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 16);
    const bool with_free = seed % 2 == 0;
    const DenseLcp<double> lcp =
        with_free ? constrained(random, n, 1, true) : positive_definite(random, n);
    LemkeRun<double> cold(lcp.size()), warm(lcp.size());
    REQUIRE(cold.solve(lcp) == Status::solved);
    const auto active = basis(cold, lcp.size());
    REQUIRE(warm.lemke.init(lcp.view(), {}, active.data()) == Status::running);
    REQUIRE(warm.lemke.solve() == Status::solved);
    CHECK(warm.lemke.pivots() == 0);
    CHECK((warm.z() - cold.z()).cwiseAbs().maxCoeff() <=
          1e-10 * (1 + cold.z().cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("started from any basis of a P-matrix it reaches the one solution") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 14);
    const DenseLcp<double> lcp = positive_definite(random, n);
    LemkeRun<double> cold(n), warm(n);
    REQUIRE(cold.solve(lcp) == Status::solved);
    std::vector<unsigned char> guess;
    for (Index i = 0; i < n; ++i) guess.push_back(random.integer(0, 1) == 1 ? 1 : 0);
    REQUIRE(warm.lemke.init(lcp.view(), {}, guess.data()) == Status::running);
    REQUIRE(warm.lemke.solve() == Status::solved);
    CHECK((warm.z() - cold.z()).cwiseAbs().maxCoeff() <=
          1e-9 * (1 + cold.z().cwiseAbs().maxCoeff()));
  }
}

TEST_CASE("a singular guessed basis is refused by name") {
  const DenseLcp<double> lcp = dense_lcp<double>(2, {1, 1, 1, 1}, {-1, -1});
  LemkeRun<double> run(2);
  const unsigned char both[] = {1, 1};
  CHECK(run.lemke.init(lcp.view(), {}, both) == Status::numerical_breakdown);
  CHECK(run.lemke.reason() == Reason::singular_basis);
}

TEST_CASE("badly scaled copies end in the same basis and the same answer") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 14);
    const DenseLcp<double> lcp = positive_definite(random, n);
    DenseLcp<double> scaled = lcp;
    VectorX<double> columns(n);
    for (Index i = 0; i < n; ++i) {
      const double row = std::pow(10.0, random.uniform(-5, 5));
      columns[i] = std::pow(10.0, random.uniform(-5, 5));
      scaled.M.row(i) *= row;
      scaled.q[i] *= row;
      scaled.M.col(i) *= columns[i];
    }
    LemkeRun<double> plain(n), rescaled(n);
    REQUIRE(plain.solve(lcp) == Status::solved);
    REQUIRE(rescaled.solve(scaled) == Status::solved);
    CHECK(basis(plain, n) == basis(rescaled, n));
    const VectorX<double> z = rescaled.z().cwiseProduct(columns);
    CHECK((z - plain.z()).cwiseAbs().maxCoeff() <= 1e-9 * (1 + plain.z().maxCoeff()));
  }
}
