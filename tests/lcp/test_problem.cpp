// The two forms of a problem are one problem.
#include <doctest/doctest.h>

#include "lcpush/lcp/residual.hpp"
#include "support/factored_groups.hpp"

using namespace lcpush;
using namespace lcpush::test;

TEST_CASE("the factored product is the product with the filled matrix") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const FactoredGroups groups(random);
    const MatrixX<double> M = groups.matrix();
    const VectorX<double> z = random_vector(random, groups.size);
    VectorX<double> out(groups.size);
    multiply(groups.view(), z.data(), out.data());
    CHECK((out - M * z).cwiseAbs().maxCoeff() <= 1e-13 * M.cwiseAbs().maxCoeff() * 60);
  }
}

TEST_CASE("the filled matrix has the structure of the laws") {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const FactoredGroups groups(random);
    const MatrixX<double> M = groups.matrix();
    for (const ConeGroup<double>& cone : groups.cones) {
      if (cone.generators == 0) continue;
      CHECK(M(cone.slip(), cone.variable) == cone.friction);
      CHECK(M(cone.slip(), cone.slip()) == 0);
      for (Index k = 1; k <= cone.generators; ++k) {
        CHECK(M(cone.variable + k, cone.slip()) == 1);
        CHECK(M(cone.slip(), cone.variable + k) == -1);
      }
    }
    const Index actuators = groups.size - groups.free_begin;
    const MatrixX<double> rows = M.bottomLeftCorner(actuators, groups.free_begin);
    const MatrixX<double> columns = M.topRightCorner(groups.free_begin, actuators);
    CHECK(rows == -columns.transpose()); // the coupling is skew
  }
}

TEST_CASE("z'Mz is the power of the forces plus what compliance, inertia and friction add") {
  // z'Mz = f'A f + sum m s^2 + sum c lambda^2 + sum mu lambda xi: copositive for every mu >= 0.
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const FactoredGroups groups(random);
    const VectorX<double> z = random_vector(random, groups.size).cwiseAbs();
    Vector6<double> f = Vector6<double>::Zero();
    double expected = 0;
    for (const ConeGroup<double>& cone : groups.cones) {
      const double lambda = z[cone.variable];
      for (Index k = 0; k <= cone.generators; ++k)
        f += groups.wrenches[static_cast<std::size_t>(cone.force + k)] * z[cone.variable + k];
      expected += cone.compliance * lambda * lambda;
      if (cone.generators > 0) expected += cone.friction * lambda * z[cone.slip()];
    }
    for (Index a = groups.free_begin; a < groups.size; ++a)
      expected +=
          groups.sums[static_cast<std::size_t>(a - groups.free_begin)].inertia * z[a] * z[a];
    expected += f.dot(groups.factored.mobility * f);
    CHECK(z.dot(groups.matrix() * z) == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("the referee's own rows are M z, and their term sizes bound every row") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const FactoredGroups groups(random);
    const MatrixX<double> M = groups.matrix();
    const VectorX<double> z = random_vector(random, groups.size), y = z.cwiseAbs();
    const VectorX<double> terms = M.cwiseAbs() * y;
    VectorX<double> w(groups.size), sizes(groups.size);
    detail::factored_rows(groups.view(), z.data(), y.data(), w.data(), sizes.data());
    CHECK((w - M * z).cwiseAbs().maxCoeff() <= 1e-13 * terms.maxCoeff());
    CHECK((sizes - terms).minCoeff() >= -1e-13 * terms.maxCoeff());
    // A bound of no use would be infinite; this one is within the terms of |W|'|A||W| .
    CHECK(sizes.maxCoeff() <= 1e3 * terms.maxCoeff());

    const DenseLcp<double> dense{M, y};
    detail::dense_rows(dense.view(), z.data(), y.data(), w.data(), sizes.data());
    CHECK((w - M * z).cwiseAbs().maxCoeff() <= 1e-13 * terms.maxCoeff());
    CHECK((sizes - terms).cwiseAbs().maxCoeff() <= 1e-13 * terms.maxCoeff());
  }
}

TEST_CASE("the dense product is M z, zeros in z skipped") {
  Random random(1);
  const DenseLcp<double> lcp{random_matrix(random, 7, 7), random_vector(random, 7)};
  VectorX<double> z = random_vector(random, 7), out(7);
  z[2] = z[5] = 0;
  multiply(lcp.view(), z.data(), out.data());
  CHECK((out - lcp.M * z).cwiseAbs().maxCoeff() <= 1e-14);
}
