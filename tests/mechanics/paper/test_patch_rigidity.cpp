// Patch rigidity by hand: references, weights, and the count of independent conditions.
#include <doctest/doctest.h>

#include "lcpush/mechanics/model/patch.hpp"
#include "support/full_elimination.hpp"
#include "support/scenes.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A patch, its references and its weights.
struct Patch {
  std::vector<Vec3> points;
  PatchReferences<double> at;
  std::vector<double> weights;

  explicit Patch(const std::vector<Vec3>& given)
      : points(given), at(choose_references<double>(view())), weights(4 * given.size()) {
    interpolation_weights<double>(view(), at, span_of(weights));
  }
  Span<const Vec3> view() const { return {points.data(), static_cast<Index>(points.size())}; }
  RigidityCheck<double> check() const {
    std::vector<double> memory(static_cast<std::size_t>(rigidity_scalars(view().size)));
    return check_rigidity<double>(view(), at, {weights.data(), static_cast<Index>(weights.size())},
                                  span_of(memory));
  }
  /// How far the weights are from p_j = sum alpha_c p_c with sum 1, in patch sizes.
  double error() const {
    double worst = 0;
    for (std::size_t j = 0; j < points.size(); ++j) {
      Vec3 off = points[j];
      double sum = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        sum += weights[4 * j + c];
        off -= weights[4 * j + c] * points[static_cast<std::size_t>(at.point[c])];
      }
      worst = larger(worst, larger(absolute(sum - 1), off.norm() / at.size));
    }
    return worst;
  }
};

/// k points spread over an affine space of dimension m, turned and moved anywhere.
Patch random_patch(std::uint64_t seed, Index k, Index m) {
  Random random(seed);
  const double size = random.uniform(1e-3, 1e-1);
  const MatrixX<double> axes = random_matrix(random, 3, 3);
  const Vec3 center = random_vector(random, 3);
  std::vector<Vec3> points;
  for (Index i = 0; i < k; ++i) {
    Vec3 p = 0.1 * center;
    for (Index c = 0; c < m; ++c) p += size * random.uniform(-1, 1) * axes.col(c);
    points.push_back(p);
  }
  return Patch(points);
}

void check_patch(const Patch& patch, Index m, Index count) {
  CAPTURE(m);
  const RigidityCheck<double> check = patch.check();
  CHECK(patch.at.rank == m);
  CHECK(check.count == count);
  CHECK(check.rank == count);
  CHECK(check.residual <= rounding);
  CHECK(check.holds());
  CHECK(patch.error() <= rounding);
}

} // namespace

TEST_CASE("references that do not carry their patch show in the rank") {
  Patch face = random_patch(4, 5, 2);
  face.at.rank = 1; // a face taken for an edge: its points do not follow two references
  CHECK_FALSE(face.check().holds());
  Patch edge = random_patch(5, 4, 1);
  edge.at.rank = 2; // an edge taken for a face: three distances on a line are two conditions
  edge.at.point[2] = 0;
  while (edge.at.point[2] == edge.at.point[0] || edge.at.point[2] == edge.at.point[1])
    ++edge.at.point[2];
  CHECK(edge.check().rank < rigidity_count(4, 2));
  CHECK_FALSE(edge.check().holds());
}

TEST_CASE("3k - m - 4 conditions are independent on edges and faces, 3k - 6 in space") {
  CHECK(rigidity_count(1, 0) == 0);
  check_patch(Patch({{0.01, 0.02, 0.03}}), 0, 0);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    for (Index k = 2; k <= 12; ++k) {
      CAPTURE(k);
      check_patch(random_patch(seed, k, 1), 1, 3 * k - 1 - 4);
      if (k >= 3) check_patch(random_patch(seed, k, 2), 2, 3 * k - 2 - 4);
      if (k >= 4) check_patch(random_patch(seed, k, 3), 3, 3 * k - 6);
    }
  }
}

TEST_CASE("the conditions hold for any rigid motion and for no stretched one") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Patch patch = random_patch(seed, 6, 1 + static_cast<Index>(seed % 3));
    Random random(seed);
    Vector6<double> twist = random_vector(random, 6);
    twist.tail<3>() /= patch.at.size;
    const Vec3& origin = patch.points[static_cast<std::size_t>(patch.at.point[0])];
    VectorX<double> r(18);
    for (Index i = 0; i < 6; ++i)
      r.segment<3>(3 * i) = acceleration_at(patch.points[static_cast<std::size_t>(i)], twist);

    const Index count = rigidity_count(6, patch.at.rank);
    MatrixX<double> C(count, 18);
    fill_rigidity<double>(patch.view(), patch.at, {patch.weights.data(), 24},
                          {C.data(), count, 18});
    CHECK((C * r).cwiseAbs().maxCoeff() <= rounding * r.cwiseAbs().maxCoeff());
    for (Index i = 0; i < 6; ++i) {
      VectorX<double> stretched = r;
      stretched.segment<3>(3 * i) += patch.points[static_cast<std::size_t>(i)] - origin;
      if (i == patch.at.point[0]) stretched.segment<3>(3 * i) += random_vector(random, 3);
      CHECK((C * stretched).cwiseAbs().maxCoeff() > 1e-6 * patch.at.size);
    }
  }
}

TEST_CASE("a patch that is flat to two billionths is still told from a line or a plane") {
  for (const double flat : {1e-3, 1e-6, 2e-9}) {
    CAPTURE(flat);
    check_patch(Patch({{0, 0, 0}, {0.01, 0, 0}, {0.006, 0.01 * flat, 0}, {0.003, 0, 0}}), 2, 6);
    const Patch solid(
        {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0.004, 0.004, 0.01 * flat}, {0.01, 0.01, 0}});
    CHECK(solid.at.rank == 3);
    CHECK(solid.check().holds());
  }
  const Patch line({{0, 0, 0}, {0.01, 0, 0}, {0.006, 1e-14, 0}, {0.003, 0, 0}});
  CHECK(line.at.rank == 1);
  CHECK(line.check().holds());
}

TEST_CASE("too little memory is refused, not overrun") {
  const Patch patch = random_patch(1, 5, 2);
  std::vector<double> memory(static_cast<std::size_t>(rigidity_scalars(5) - 1));
  CHECK_FALSE(check_rigidity<double>(
                  patch.view(), patch.at,
                  {patch.weights.data(), static_cast<Index>(patch.weights.size())}, span_of(memory))
                  .holds());
}
