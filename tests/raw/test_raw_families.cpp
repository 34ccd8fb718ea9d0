// Raw problems that have a solution are solved, in whatever units they come.
#include "lcpush/desktop/raw_problem.hpp"
#include "raw/raw_parts.hpp"
#include "support/raw_families.hpp"

#include <doctest/doctest.h>

namespace {

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

constexpr double bound = 1e-8;

void check_solved(const DenseRaw& given) {
  for (const Solver solver : {Solver::lemke, Solver::hybrid}) {
    RawOptions options;
    options.solver = solver;
    const RawAnswer answer = solve_raw(given.raw(), options);
    CAPTURE(std::string(status_text(answer.status)));
    CHECK(answer.status == Status::solved);
    if (answer.status != Status::solved) continue;
    CHECK(answer.residual <= 1e-9);
    CHECK(violation(given, answer.z, bound) <= bound);
  }
}

} // namespace

TEST_CASE("grasps at rest are solved in any units") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const DenseRaw grasp = grasp_at_rest(seed, seed % 2 == 0);
    check_solved(grasp);
    check_solved(in_other_units(grasp, random, 3));
    check_solved(in_other_units(grasp, random, 6));
  }
}

TEST_CASE("free unknowns may be split in two") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const DenseRaw split = with_free_split(grasp_at_rest(seed, seed % 2 == 0));
    check_solved(split);
    check_solved(in_other_units(split, random, 4));
  }
}

TEST_CASE("rounding noise in q makes no ray") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = random.integer(2, 12);
    DenseRaw given = dense_raw(definite(n, random), Eigen::VectorXd::Zero(n));
    for (Index i = 0; i < n; ++i)
      given.q[i] =
          random.integer(0, 2) == 0 ? random.uniform(-40, 40) : random.uniform(-1, 1) * 1e-16;
    check_solved(given);
    DenseRaw chain = given; // one piece, and hardly connected
    for (Index i = 0; i + 1 < n; ++i) chain.M(i, i + 1) += 1e-3;
    check_solved(chain);
  }
}

TEST_CASE("four contacts of which one carries nothing but noise") {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(12, 12);
  const double block[4][4] = {{0.5, -0.27, 0.3, 1.8},
                              {0.7, -0.36, 0.4, 1.8},
                              {0.6, -0.63, 0.7, 1.8},
                              {0.2, -0.54, 0.6, 1.8}};
  for (Index c = 0; c < 4; ++c) {
    M(2 * c, 2 * c) = block[c][0];
    M(2 * c + 1, 2 * c) = block[c][1];
    M(2 * c + 1, 2 * c + 1) = block[c][2];
    M(2 * c + 1, 8 + c) = 1;
    M(8 + c, 2 * c) = block[c][3];
    M(8 + c, 2 * c + 1) = -1;
  }
  Eigen::VectorXd q = Eigen::VectorXd::Zero(12);
  q << 36, 0, 36, 0, -2e-17, -2e-16, 36, 0, 0, 0, 0, 0;
  check_solved(dense_raw(M, q));
  // The same in one piece: the noise stands beside numbers of 36.
  for (Index c = 0; c + 1 < 4; ++c) M(2 * c, 2 * c + 2) = 1e-3;
  check_solved(dense_raw(M, q));
}

TEST_CASE("a point that is right but for its smallest rows is settled level by level") {
  // Pairs of ever smaller size that hang on each other: z = (1, 1e-9, 1e-18, ..) times something.
  for (const double step : {1e-5, 1e-9, 1e-12}) {
    CAPTURE(step);
    const Index n = 5;
    DenseRaw given = dense_raw(2 * Eigen::MatrixXd::Identity(n, n), Eigen::VectorXd::Zero(n));
    double size = 1;
    for (Index i = 0; i < n; ++i, size *= step) {
      given.q[i] = -size;
      if (i > 0) given.M(i - 1, i) = -1; // the smaller one pushes the larger one
    }
    check_solved(given);
  }
}

TEST_CASE("what Lemke ends on at once is solved from other bases, and that is said") {
  // Two players without their payoffs as unknowns: M >= 0 with empty diagonal blocks.
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6, 6);
  M.topRightCorner(3, 3) << 1, 3, 2, 2, 1, 3, 3, 2, 1;
  M.bottomLeftCorner(3, 3) << 2, 3, 1, 1, 2, 3, 3, 1, 2;
  const DenseRaw game = dense_raw(M, -Eigen::VectorXd::Ones(6));
  const RawAnswer answer = solve_raw(game.raw(), {});
  REQUIRE(answer.status == Status::solved);
  CHECK(answer.search.starts > 0);
  CHECK(violation(game, answer.z, bound) <= 1e-12);
  RawOptions once;
  once.searches = false;
  CHECK(solve_raw(game.raw(), once).status == Status::ray);
}

TEST_CASE("a piece's rows keep their places, and a ray of one is a ray of all") {
  const DenseRaw solvable = dense_raw(Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-1, 1));
  const DenseRaw none = dense_raw(-Eigen::MatrixXd::Identity(1, 1), -Eigen::VectorXd::Ones(1));
  const RawAnswer answer = solve_raw(side_by_side(solvable, none, 1).raw(), {});
  CHECK(answer.status == Status::ray);
  CHECK(answer.search.whole);
  REQUIRE(answer.ray.size() == 3);
  CHECK(answer.ray == std::vector<double>{0, 0, 1});
  CHECK(answer.z.empty());
}
