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
