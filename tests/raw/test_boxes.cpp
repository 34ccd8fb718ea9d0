// Problems in boxes against all places that their unknowns can have: at an end, or between.
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/lcp/sweeps/small_solve.hpp"
#include "support/raw_families.hpp"

#include <doctest/doctest.h>

#include <limits>

namespace {

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The largest violation in the form given, by arithmetic of its own.
double box_violation(const RawProblem& given, const std::vector<double>& z) {
  double worst = 0;
  for (Index i = 0; i < given.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    double w = given.q[at];
    for (Index j = 0; j < given.size(); ++j) w += given.M(i, j) * z[static_cast<std::size_t>(j)];
    double lo = given.bounds.lo[at], hi = given.bounds.hi[at];
    if (given.bounds.leader(i) >= 0) {
      hi *= z[static_cast<std::size_t>(given.bounds.leader(i))];
      lo = -hi;
    }
    worst = std::max({worst, lo - z[at], z[at] - hi});
    if (w > 0) worst = std::max(worst, std::min(w, z[at] - lo));
    if (w < 0) worst = std::max(worst, std::min(-w, hi - z[at]));
  }
  return worst;
}

/// Whether one of the 3^n choices of lo, hi or w = 0 for each row is an answer.
bool has_answer(const RawProblem& given) {
  const Index n = given.size();
  Index choices = 1;
  for (Index i = 0; i < n; ++i) choices *= 3;
  for (Index choice = 0; choice < choices; ++choice) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    bool is_finite = true;
    for (Index i = 0, rest = choice; i < n; ++i, rest /= 3) {
      const auto at = static_cast<std::size_t>(i);
      if (rest % 3 == 2) {
        for (Index j = 0; j < n; ++j) A(i, j) = given.M(i, j);
        b[i] = -given.q[at];
        continue;
      }
      A(i, i) = 1;
      const double end = rest % 3 == 0 ? given.bounds.lo[at] : given.bounds.hi[at];
      if (given.bounds.leader(i) >= 0)
        A(i, given.bounds.leader(i)) = rest % 3 == 0 ? given.bounds.hi[at] : -given.bounds.hi[at];
      else
        b[i] = end;
      is_finite = is_finite && std::isfinite(b[i]);
    }
    if (!is_finite) continue;
    if (solve_small(MatrixMap<double>(A.data(), n, n), b.data()) &&
        box_violation(given, {b.data(), b.data() + n}) <= 1e-9)
      return true;
  }
  return false;
}

RawProblem boxed(const DenseRaw& given, Random& random, bool has_friction) {
  RawProblem problem = given.raw();
  for (Index i = 0; i < given.size(); ++i) {
    const Index kind = random.integer(0, 5);
    const double lo = random.uniform(-1, 1), width = random.uniform(0, 2);
    const bool follows = has_friction && i % 2 == 1;
    const bool leads = has_friction && i % 2 == 0;
    problem.bounds.lo.push_back(leads || kind == 0 ? 0 : kind < 3 ? -infinite : lo);
    problem.bounds.hi.push_back(follows                  ? (kind == 5 ? 0 : width)
                                : leads || kind % 3 == 0 ? infinite
                                : kind == 5              ? lo
                                                         : lo + width);
    problem.bounds.follows.push_back(follows ? i - 1 : -1);
  }
  return problem;
}

void check_boxed(const RawProblem& problem) {
  const bool is_solvable = has_answer(problem);
  for (const Solver solver : {Solver::lemke, Solver::hybrid, Solver::gauss_seidel}) {
    CAPTURE(static_cast<int>(solver));
    RawOptions options;
    options.solver = solver;
    const RawAnswer answer = solve_raw(problem, options);
    if (answer.status == Status::solved) {
      CHECK(box_violation(problem, answer.z) <= 1e-7);
      CHECK(is_solvable);
    } else if (solver != Solver::gauss_seidel) {
      CHECK_FALSE(is_solvable);
    }
  }
}

} // namespace

TEST_CASE("boxes: what is solved is right, and what can be solved is") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 6);
    Eigen::MatrixXd M = seed % 3 == 0 ? Eigen::MatrixXd::Zero(n, n) : definite(n, random);
    for (Index k = 0; seed % 3 == 0 && k < M.size(); ++k) M.data()[k] = random.uniform(-1, 1);
    Eigen::VectorXd q(n);
    for (Index i = 0; i < n; ++i) q[i] = random.uniform(-3, 3);
    check_boxed(boxed(dense_raw(M, q), random, false));
  }
}

TEST_CASE("boxes: whole numbers, zeros among them, and rows in any unit are solved") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(1, 4);
    Eigen::MatrixXd B(n, n);
    for (Index k = 0; k < B.size(); ++k) B.data()[k] = static_cast<double>(random.integer(-2, 2));
    Eigen::MatrixXd M = B * B.transpose() + Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd q(n), unit(n);
    for (Index i = 0; i < n; ++i) {
      q[i] = random.integer(0, 1) == 0 ? 0 : static_cast<double>(random.integer(-5, 5));
      unit[i] = seed % 2 == 0 ? 1 : std::pow(10.0, static_cast<double>(random.integer(-9, 9)));
    }
    RawProblem problem = dense_raw(unit.asDiagonal() * M, unit.cwiseProduct(q)).raw();
    RawProblem plain = dense_raw(M, q).raw();
    for (Index i = 0; i < n; ++i) {
      problem.bounds.lo.push_back(static_cast<double>(-random.integer(0, 3)));
      problem.bounds.hi.push_back(static_cast<double>(random.integer(0, 3)));
    }
    plain.bounds = problem.bounds;
    const RawAnswer answer = solve_raw(problem, {});
    REQUIRE(answer.status == Status::solved); // definite: there is one, and no other
    CHECK(box_violation(plain, answer.z) <= 1e-7);
  }
}

TEST_CASE("an unknown at its upper end is there to the last bit, and a closed box fixes it") {
  RawProblem problem = dense_raw(Eigen::Matrix2d{{2, 1}, {1, 2}}, Eigen::Vector2d(-5, -6)).raw();
  problem.bounds = {{0, 0.3}, {0.1, 0.3}, {}};
  const RawAnswer answer = solve_raw(problem, {});
  REQUIRE(answer.status == Status::solved);
  CHECK(answer.z == std::vector<double>{0.1, 0.3});
  CHECK(answer.residual == 0);
}

TEST_CASE("the referee of boxes refuses what is outside, and what leans the wrong way") {
  RawProblem problem = dense_raw(Eigen::Matrix2d{{2, 0}, {0, 2}}, Eigen::Vector2d(-5, -3)).raw();
  problem.bounds = {{0, 0}, {infinite, 0.5}, {-1, 0}};
  std::vector<double> w;
  CHECK(raw_residual(problem, {2.5, 1.25}, w).residual <= 1e-15); // at its end, w < 0
  CHECK(w == std::vector<double>{0, -0.5});
  CHECK(raw_residual(problem, {2.5, 1.5}, w).residual >= 0.01);   // w = 0, beyond its end
  CHECK(raw_residual(problem, {2.5, -1.25}, w).residual >= 0.01); // at the other end
  CHECK(raw_residual(problem, {2.5, 1.0}, w).residual >= 0.01);   // between, w not 0
  CHECK(raw_residual(problem, {-1.0, 0.0}, w).residual >= 0.01);  // crossed ends
}

TEST_CASE("the referee of sparse rows says what natural_residual says") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Index n = random.integer(1, 10);
    const Eigen::MatrixXd M = definite(n, random);
    Eigen::VectorXd q(n);
    std::vector<double> z(static_cast<std::size_t>(n)), w, dense_w(z.size()), scratch(2 * z.size());
    for (Index i = 0; i < n; ++i) {
      q[i] = random.uniform(-1, 1);
      z[static_cast<std::size_t>(i)] = random.integer(0, 1) == 0 ? 0.0 : random.uniform(-0.1, 1);
    }
    Problem<double> dense;
    dense.size = dense.free_begin = n;
    dense.matrix = M.data();
    dense.q = q.data();
    const std::vector<double> unit(z.size(), 1.0);
    const double expected = natural_residual(
                                dense, q.data(), z.data(), unit.data(), [](Index) { return false; },
                                dense_w.data(), scratch.data())
                                .residual;
    // definite() has entries near 1: its balanced units are powers of two around it.
    const double found = raw_residual(dense_raw(M, q).raw(), z, w).residual;
    CHECK(found >= expected / 4);
    CHECK(found <= expected * 4);
    for (std::size_t i = 0; i < z.size(); ++i) CHECK(std::abs(w[i] - dense_w[i]) <= 1e-14);
  }
}

TEST_CASE("an unknown in small units does not hide a wrong one beside it") {
  // z = (1, 1), the first one in units of 1e-12.
  const DenseRaw given =
      dense_raw(Eigen::Matrix2d{{2e-12, 1}, {1e-12, 2}}, Eigen::Vector2d(-3, -3));
  std::vector<double> w;
  CHECK(raw_residual(given.raw(), {1e12, 1.0}, w).residual <= 1e-12);
  CHECK(raw_residual(given.raw(), {1e12, 1.5}, w).residual >= 0.01);
}
