// Small problems against all their complementary bases: what is called solved is right, and what
// has a solution is solved.
#include "lcpush/desktop/raw_problem.hpp"
#include "support/raw_families.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

namespace {

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Is z >= 0, w >= 0, z w = 0 to rounding, each row by its own terms?
bool is_solution(const DenseRaw& given, const LongVector& z, long double tolerance) {
  const LongMatrix M = given.M.cast<long double>();
  const LongVector q = given.q.cast<long double>(), w = M * z + q;
  const LongVector sizes = M.cwiseAbs() * z.cwiseAbs() + q.cwiseAbs();
  const long double z_size = z.size() > 0 ? z.cwiseAbs().maxCoeff() : 0;
  for (Index i = 0; i < z.size(); ++i) {
    const long double scaled_w = sizes[i] > 0 ? w[i] / sizes[i] : 0;
    const long double scaled_z = z_size > 0 ? z[i] / z_size : 0;
    if (!(std::abs(std::min(scaled_w, scaled_z)) <= tolerance)) return false;
  }
  return true;
}

/// One of the 2^n complementary bases that are regular has a solution.
bool has_solution(const DenseRaw& given) {
  const Index n = given.size();
  for (Index basis = 0; basis < Index{1} << n; ++basis) {
    LongMatrix columns = LongMatrix::Identity(n, n);
    for (Index j = 0; j < n; ++j)
      if ((basis >> j & 1) != 0) columns.col(j) = -given.M.col(j).cast<long double>();
    const Eigen::FullPivLU<LongMatrix> lu(columns);
    if (!lu.isInvertible()) continue;
    const LongVector x = lu.solve(given.q.cast<long double>().eval());
    LongVector z = LongVector::Zero(n);
    for (Index j = 0; j < n; ++j)
      if ((basis >> j & 1) != 0) z[j] = x[j];
    if (is_solution(given, z, 1e-14L)) return true;
  }
  return false;
}

DenseRaw small_problem(Index kind, Random& random) {
  const Index n = random.integer(1, 8);
  Eigen::MatrixXd M(n, n);
  Eigen::VectorXd q(n);
  const auto fill = [&](auto entry) {
    for (Index k = 0; k < M.size(); ++k) M.data()[k] = entry();
  };
  for (Index i = 0; i < n; ++i) q[i] = random.uniform(-2, 1);
  const auto small_integer = [&](Index low) {
    return static_cast<double>(random.integer(low, 2)) * (random.integer(0, 1) == 0 ? 0 : 1);
  };
  switch (kind) {
  case 0: fill([&] { return random.uniform(-1, 1); }); break;
  case 1: // degenerate: small whole numbers, many of them zero
    fill([&] { return small_integer(-2); });
    for (Index i = 0; i < n; ++i) q[i] = small_integer(-2);
    break;
  case 2: M = definite(n, random); break;
  case 3: // copositive: nothing below zero
    fill([&] { return std::max(0.0, random.uniform(-1, 1)); });
    break;
  case 4: // a game: no diagonal blocks
    fill([&] { return small_integer(0) + 1; });
    M.topLeftCorner(n / 2, n / 2).setZero();
    M.bottomRightCorner(n - n / 2, n - n / 2).setZero();
    q.setConstant(-1);
    break;
  case 5: // nothing helps
    fill([&] { return -random.uniform(0, 1); });
    q = -q.cwiseAbs();
    break;
  case 6: // skew: a linear program's
    fill([&] { return small_integer(-2); });
    M = (M - M.transpose()).eval();
    break;
  default: // rows and columns of all sizes
    fill([&] { return random.uniform(-1, 1); });
    return in_other_units(dense_raw(M, q), random, 5);
  }
  return dense_raw(M, q);
}

} // namespace

TEST_CASE("of 2000 small problems none is solved wrongly and none that is solvable is missed") {
  Index solvable = 0, solved = 0, missed = 0, wrong = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed + 7000);
    const DenseRaw given = small_problem(static_cast<Index>(seed % 8), random);
    const RawAnswer answer = solve_raw(given.raw(), {});
    const bool is_solved = answer.status == Status::solved;
    CAPTURE(seed);
    if (is_solved) {
      ++solved;
      const bool is_right = violation(given, answer.z, 1e-8) <= 1e-8;
      CHECK(is_right);
      wrong += is_right ? 0 : 1;
    }
    if (!has_solution(given)) continue;
    ++solvable;
    CHECK(is_solved);
    missed += is_solved ? 0 : 1;
  }
  MESSAGE("solvable " << solvable << ", solved " << solved << ", missed " << missed << ", wrong "
                      << wrong);
  CHECK(solvable > 900);
  CHECK(solved >= solvable);
}

TEST_CASE("all cones tried is a proof: what it says has no solution has none") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed + 9000);
    const DenseRaw given = small_problem(seed % 2 == 0 ? 1 : 5, random);
    const RawAnswer answer = solve_raw(given.raw(), {});
    if (answer.search.whole) CHECK_FALSE(has_solution(given));
  }
}

TEST_CASE("a row is judged by its own terms beside a huge unknown") {
  const auto given = [](double huge, double coupling) {
    DenseRaw raw;
    raw.M = Eigen::MatrixXd::Zero(2, 2);
    raw.M(0, 0) = 2 / huge;
    raw.M(1, 0) = coupling / huge;
    raw.M(1, 1) = 2;
    raw.q = Eigen::Vector2d(-2, -2 - coupling);
    raw.free.assign(2, 0);
    return raw;
  };
  for (const double huge : {1e3, 1e6, 1e9, 1e12, 1e15})
    for (const double coupling : {0.0, 1e-3, 1.0}) {
      CAPTURE(huge);
      CAPTURE(coupling);
      const RawProblem problem = given(huge, coupling).raw();
      std::vector<double> w;
      CHECK(raw_residual(problem, {huge, 1.0}, w).residual <= 1e-12);
      // z_2 = 1.5 leaves w_2 = 1: neither is zero.
      CHECK(raw_residual(problem, {huge, 1.5}, w).residual > 0.1);
      CHECK(raw_residual(problem, {huge, 0.5}, w).residual > 0.1);
      const RawAnswer answer = solve_raw(problem, RawOptions());
      REQUIRE(answer.status == Status::solved);
      CHECK(answer.z[1] == doctest::Approx(1).epsilon(1e-9));
    }
}
