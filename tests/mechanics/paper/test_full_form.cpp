// The paper's full form, eliminated, is the assembled problem.
#include <doctest/doctest.h>

#include <limits>

#include <Eigen/Geometry>

#include "support/full_elimination.hpp"
#include "support/scenes.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

Vector6<double> any_twist(Random& random, double size) {
  Vector6<double> twist = random_vector(random, 6);
  twist.tail<3>() /= size;
  return twist;
}

/// Random grasps of every kind the assembly knows: planar, soft, bilateral, without friction, on a
/// parallel jaw, on actuators with inertia that drive any body in any direction, tumbled so that
/// no number is 0 or 1 by luck.
Scene3 varied_grasp(std::uint64_t seed) {
  Scene3 scene = random_grasp<double>(seed);
  Random random(seed + 5000);
  const double size = -2 * scene.points.back()[0];
  for (Body<double>& body : scene.bodies) {
    if (random.integer(0, 2) == 0) body.bilateral = true;
    if (random.integer(0, 7) == 0) body.friction = 0;
    const bool few = body.point_count * scene.base.facets <= 32; // of many generators each
    if (few && random.integer(0, 1) == 0) body.torsion_radius = size * random.uniform(0.02, 0.2);
  }
  if (random.integer(0, 2) == 0) { // a parallel jaw
    scene.actuators.resize(1);
    for (Drive<double>& drive : scene.drives) drive.actuator = 0;
  }
  for (Actuator<double>& actuator : scene.actuators)
    if (random.integer(0, 1) == 0) actuator.inertia = random.uniform(0, 0.5);
  for (Drive<double>& drive : scene.drives)
    if (random.integer(0, 2) == 0) drive.twist = any_twist(random, size);
  for (const Index body : {0, 2}) // twice in one body, or the pusher as well
    if (random.integer(0, 3) == 0) scene.drives.push_back({body, 0, any_twist(random, size)});
  if (random.integer(0, 2) == 0) { // any axes
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(Eigen::Vector4d(random_vector(random, 4))).normalized();
    const Matrix3<double> R = turn.toRotationMatrix();
    for (Vec3& p : scene.points) p = R * p;
    for (Body<double>& body : scene.bodies) {
      body.normal = (R * body.normal).normalized();
      body.tangent = R * body.tangent;
      body.tangent = (body.tangent - body.tangent.dot(body.normal) * body.normal).normalized();
    }
    scene.base.object.inertia = R * scene.base.object.inertia * R.transpose();
  }
  scene.base.planar = random.integer(0, 3) == 0;
  return scene;
}

} // namespace

TEST_CASE("full = reduced: 400 random grasps of every kind") {
  double worst = 0;
  Index followers = 0;
  for (std::uint64_t seed = 1; seed <= seeds(400); ++seed) {
    const Scene3 owned = varied_grasp(seed);
    SolvedPush<double> push(owned);
    push.assembly.push_by(seed % 2 == 0 ? 1.0 : 0.3);
    FullElimination full(push.assembly);
    const double difference = full.difference();
    worst = larger(worst, difference);
    if (!(difference <= rounding)) FAIL_CHECK("seed " << seed << ": " << difference);
    for (Index b = 0; b < push.scene.bodies.size; ++b)
      followers += push.scene.bodies[b].point_count - full.form.patch(b).count();
  }
  CHECK(followers > static_cast<Index>(seeds(1200))); // there was something to interpolate
  MESSAGE("largest difference between full and reduced: " << worst);
}

TEST_CASE("a wrong weight shows: full and reduced differ, rank and residual say so") {
  Index tried = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(random_grasp<double>(seed));
    FullElimination full(push.assembly);
    Random random(seed);
    for (Index b = 0; b < push.scene.bodies.size; ++b) {
      const PatchReferences<double>& at = full.form.patch(b);
      const Index k = push.scene.bodies[b].point_count;
      if (k <= at.count()) continue;
      Index j = random.integer(0, k - 1);
      while (at.reference_of(j) >= 0) j = (j + 1) % k;
      double& alpha = full.form.weights(b)[most_references * j + random.integer(0, at.rank)];
      const double right = alpha;
      ++tried;
      for (const double off : {1e-6, 0.5}) {
        CAPTURE(off);
        alpha = right + off;
        full.fill();
        CHECK_FALSE(full.difference() <= rounding);
        const RigidityCheck<double> check = full.rigidity(b);
        CHECK(check.rank == check.count); // still as many conditions, but of another motion
        CHECK(check.residual > 0.5 * off);
        CHECK_FALSE(check.holds());
      }
      alpha = std::numeric_limits<double>::quiet_NaN();
      CHECK_FALSE(full.rigidity(b).holds());
      alpha = right;
      CHECK(full.rigidity(b).holds());
    }
  }
  CHECK(tried > 60);
}

TEST_CASE("too little memory is refused, not overrun") {
  SolvedPush<double> push(random_grasp<double>(1));
  std::vector<PatchReferences<double>> patches(3);
  std::vector<Index> first(3);
  std::vector<double> weights(3);
  FullForm<double> form({span_of(patches), span_of(first), span_of(weights)});
  CHECK(form.describe(push.assembly) == Status::bad_input);
}
