// Is a point in a finitely generated cone? Both answers are judged by their own proof.
#include <doctest/doctest.h>

#include <vector>

#include "lcpush/lcp/cone_membership.hpp"
#include "support/random_grasp.hpp"

using namespace lcpush;
using lcpush::test::Random;

namespace {

struct Asked {
  std::vector<double> scalars;
  std::vector<int> integers;
  ConeMembership<double> question;

  Asked(Index m, Index n)
      : scalars(static_cast<std::size_t>(cone_membership_scalars(m, n))),
        integers(static_cast<std::size_t>(least_squares_integers(m, n))),
        question({scalars.data(), static_cast<Index>(scalars.size())},
                 {integers.data(), static_cast<Index>(integers.size())}, m, n) {}
};

} // namespace

TEST_CASE("a sum of generators lies in their cone, and the weights that come back make it up") {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const Index m = random.integer(1, 9), n = random.integer(1, 40);
    Asked asked(m, n);
    REQUIRE(asked.question.fits);
    for (Index j = 0; j < n; ++j) {
      for (Index i = 0; i < m; ++i) asked.question.A(i, j) = random.uniform(-1, 1);
      if (random.integer(0, 2) == 0)
        asked.question.b += random.uniform(0, 1) * asked.question.A.col(j);
    }
    REQUIRE(asked.question.ask(n) == Status::solved);
    CHECK(asked.question.x.minCoeff() >= 0);
    CHECK((asked.question.A * asked.question.x - asked.question.b).norm() <= 1e-9);
  }
}

TEST_CASE("beyond a half-space that holds all generators nothing lies in their cone") {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const Index m = random.integer(1, 9), n = random.integer(1, 40);
    Asked asked(m, n);
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < m; ++i)
        asked.question.A(i, j) = i == 0 ? random.uniform(0, 1) : random.uniform(-1, 1);
    asked.question.b[0] = -1; // the generators have a first component >= 0
    REQUIRE(asked.question.ask(n) == Status::ray);
    const Eigen::VectorXd r = asked.question.residual;
    CHECK(r.dot(asked.question.b) > 0);
    CHECK((asked.question.A.transpose() * r).maxCoeff() <= 1e-9 * r.squaredNorm());
  }
}

TEST_CASE("no generator, equal ones and too little memory are told apart") {
  Asked none(3, 1);
  none.question.b[1] = 1;
  CHECK(none.question.ask(0) == Status::ray);
  Asked equal(2, 3);
  for (Index j = 0; j < 3; ++j) equal.question.A(0, j) = 1;
  equal.question.b[0] = 2;
  CHECK(equal.question.ask(3) == Status::solved);
  CHECK(equal.question.x.sum() == doctest::Approx(2));
  std::vector<double> few(4);
  std::vector<int> ints(4);
  CHECK_FALSE(ConeMembership<double>({few.data(), 4}, {ints.data(), 4}, 3, 3).fits);
}
