// The referee of lcp/: it passes what is right and refuses every single wrong number.
#include <doctest/doctest.h>

#include <limits>

#include "lcpush/lcp/residual.hpp"
#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double tolerance = Tolerances<double>().residual;

/// A problem with its solution: z and w positive by halves, all terms of ordinary size.
struct Solved {
  DenseLcp<double> lcp;
  VectorX<double> z, unit;

  WorstRow<double> judge() const { return judge(lcp, z); }
  WorstRow<double> judge(const DenseLcp<double>& problem, const VectorX<double>& answer) const {
    const Index n = problem.size();
    VectorX<double> w(n), scratch(2 * n);
    const Problem<double> view = problem.view();
    return natural_residual(
        view, view.q, answer.data(), unit.data(), [&](Index i) { return i >= view.free_begin; },
        w.data(), scratch.data());
  }
};

Solved known_solution(Random& random, Index n, Index free_count) {
  Solved s{{random_matrix(random, n, n), VectorX<double>(n), free_count},
           VectorX<double>::Zero(n),
           VectorX<double>::Ones(n)};
  VectorX<double> w = VectorX<double>::Zero(n);
  for (Index i = 0; i < n; ++i) {
    if (i >= n - free_count)
      s.z[i] = random.uniform(-1, 1);
    else if (i % 2 == 0)
      s.z[i] = random.uniform(0.2, 1);
    else
      w[i] = random.uniform(0.2, 1);
  }
  s.lcp.q = w - s.lcp.M * s.z;
  return s;
}

} // namespace

TEST_CASE("a true solution passes, with free unknowns and without") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Solved s = known_solution(random, 10, random.integer(0, 3));
    CHECK(s.judge().residual <= 1e-14);
  }
}

TEST_CASE("every single number of z, mutated by a millionth, is refused") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Solved s = known_solution(random, 8, 2);
    for (Index i = 0; i < 8; ++i)
      for (const double change : {1e-6, -1e-6}) {
        VectorX<double> z = s.z;
        z[i] += change;
        CHECK(s.judge(s.lcp, z).residual > tolerance);
      }
  }
}

TEST_CASE("every single number of q that matters is watched") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Solved s = known_solution(random, 8, 2);
    for (Index i = 0; i < 8; ++i) {
      DenseLcp<double> lcp = s.lcp;
      const bool positive_w = i < 6 && i % 2 == 1;
      lcp.q[i] += positive_w ? -1.5 : 1e-6; // w_i > 0 may move, but not below zero
      const WorstRow<double> worst = s.judge(lcp, s.z);
      CHECK(worst.residual > tolerance);
      CHECK(worst.row == i);
    }
  }
}

TEST_CASE("a negative z, a negative w and a pair both positive are each refused") {
  const Solved s{dense_lcp<double>(2, {1, 0, 0, 1}, {-1, 1}), VectorX<double>::Unit(2, 0),
                 VectorX<double>::Ones(2)};
  REQUIRE(s.judge().residual == 0);
  VectorX<double> z(2);
  z << 1, -1e-6;
  CHECK(s.judge(s.lcp, z).residual > tolerance); // z_1 < 0
  z << 1 - 1e-6, 0;
  CHECK(s.judge(s.lcp, z).residual > tolerance); // w_0 < 0
  z << 1 + 1e-6, 0;
  CHECK(s.judge(s.lcp, z).residual > tolerance); // z_0 and w_0 > 0
  z << 1, 1e-6;
  CHECK(s.judge(s.lcp, z).residual > tolerance); // z_1 and w_1 > 0
}

TEST_CASE("a free unknown may be negative, its row may not be off to either side") {
  const Solved s{dense_lcp<double>(1, {1}, {2}), VectorX<double>::Constant(1, -2),
                 VectorX<double>::Ones(1)};
  DenseLcp<double> free = s.lcp;
  free.free_count = 1;
  CHECK(s.judge(free, s.z).residual == 0);
  CHECK(s.judge(s.lcp, s.z).residual > 0.5); // not free: refused
  for (const double change : {1e-6, -1e-6})
    CHECK(s.judge(free, s.z + VectorX<double>::Constant(1, change)).residual > tolerance);
}

TEST_CASE("a large answer in another unit hides nothing: each row counts by its own terms") {
  // Block A in units of 1e9, block B of 1, not coupled. B's answer is off by a ten-thousandth,
  // which beside the largest z is 1e-13.
  Solved s{{MatrixX<double>::Identity(2, 2), VectorX<double>(2)},
           VectorX<double>(2),
           VectorX<double>::Ones(2)};
  s.lcp.q << -1e9, -1;
  s.z << 1e9, 1;
  s.unit << 1e9, 1;
  REQUIRE(s.judge().residual == 0);
  s.z[1] = 1 + 1e-4;
  CHECK(s.judge().residual > 1e-5);
  CHECK(s.judge().row == 1);
}

TEST_CASE("the units of z do not matter when they are given") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Solved s = known_solution(random, 6, 1);
    s.z[2] += 1e-7;
    const double plain = s.judge().residual;
    Solved scaled = s;
    for (Index j = 0; j < 6; ++j) {
      const double factor = j % 2 == 0 ? 0x1p30 : 0x1p-30;
      scaled.unit[j] *= factor;
      scaled.z[j] *= factor;
      scaled.lcp.M.col(j) /= factor;
    }
    CHECK(scaled.judge().residual == doctest::Approx(plain).epsilon(1e-12));
  }
}

TEST_CASE("NaN and infinity are refused wherever they stand") {
  Random random(5);
  const Solved s = known_solution(random, 5, 1);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (Index i = 0; i < 5; ++i) {
      VectorX<double> z = s.z;
      z[i] = bad;
      CHECK(!(s.judge(s.lcp, z).residual <= tolerance));
      DenseLcp<double> lcp = s.lcp;
      lcp.q[i] = bad;
      CHECK(!(s.judge(lcp, s.z).residual <= tolerance));
      lcp = s.lcp;
      lcp.M(i, 0) = bad; // z_0 > 0
      CHECK(!(s.judge(lcp, s.z).residual <= tolerance));
    }
}

TEST_CASE("nothing at all is a solution of q >= 0, and of n = 0") {
  const Solved s{dense_lcp<double>(2, {-1, 0, 0, -1}, {0, 3}), VectorX<double>::Zero(2),
                 VectorX<double>::Ones(2)};
  CHECK(s.judge().residual == 0);
  const Solved empty{
      {MatrixX<double>(0, 0), VectorX<double>(0)}, VectorX<double>(0), VectorX<double>(0)};
  CHECK(empty.judge().residual == 0);
}
