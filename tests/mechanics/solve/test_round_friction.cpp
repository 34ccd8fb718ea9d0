// [T.16] Round friction: the rounds against a convex oracle, the laws, and themselves seen
// otherwise.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

namespace {

using namespace lcpush;
using test::Family;

/// A plate between fingers of known force that a pusher carries along: it sticks, so that only the
/// plate's turning is open.
struct CarriedPlate {
  test::OwnedScene<double> scene;
  Vector3<double> pivot; ///< where the pusher sticks, from the centre of mass

  explicit CarriedPlate(unsigned seed) {
    test::Random random(seed);
    scene.base.object = {0.2, Matrix3<double>(1e-4 * Matrix3<double>::Identity()),
                         Vector3<double>::Zero()};
    scene.base.gravity.setZero();
    scene.base.facets = 8;
    scene.base.pressure = Pressure::rigid;
    scene.base.planar = true;
    const Index fingers = random.integer(2, 6);
    for (Index f = 0; f < fingers; ++f) {
      const double angle = random.uniform(0, 6.28), r = random.uniform(0, 0.02);
      const Vector3<double> at(r * std::cos(angle), r * std::sin(angle), 0);
      scene.add_body(Role::finger, {0, 0, f % 2 == 0 ? 1.0 : -1.0}, random.uniform(0.1, 1), {at});
      if (random.integer(0, 1) == 0)
        scene.bodies.back().torsion_radius = random.uniform(0.002, 0.01);
      scene.actuators.push_back({random.uniform(5, 30), 0.0});
      Vector6<double> closing = Vector6<double>::Zero();
      closing.head<3>() = scene.bodies.back().normal;
      scene.drives.push_back({f, f, closing});
    }
    const double angle = random.uniform(0, 6.28), along = angle + 3.14 + random.uniform(-0.5, 0.5);
    pivot = {0.04 * std::cos(angle), 0.04 * std::sin(angle), 0};
    scene.add_body(Role::pusher, {std::cos(along), std::sin(along), 0}, 50.0, {pivot});
    scene.bodies.back().acceleration.head<3>() =
        random.uniform(0.01, 2) * scene.bodies.back().normal;
  }

  const Vector6<double>& push() const { return scene.bodies.back().acceleration; }
  /// The plate's twist if it turns with w about the pivot.
  Vector6<double> twist(double w) const {
    Vector6<double> a = push();
    const Vector3<double> spin(0, 0, w);
    a.head<3>() -= cross(spin, pivot);
    a.tail<3>() = spin;
    return a;
  }
  /// Half the derivative by w of a' M a + 2 sum mu F |v|, which the true w minimises (Gauss's
  /// principle; friction's part is convex).
  double slope(double w) const {
    const Vector6<double> a = twist(w), da = twist(1) - twist(0);
    double sum = scene.base.object.mass * a.head<3>().dot(da.head<3>()) +
                 scene.base.object.inertia(2, 2) * w;
    for (std::size_t f = 0; f + 1 < scene.bodies.size(); ++f) {
      const Vector3<double> v = slip_of<double>(scene.bodies[f], scene.points[f], a);
      const Vector3<double> dv = slip_of<double>(scene.bodies[f], scene.points[f], da);
      sum += scene.bodies[f].friction * scene.actuators[f].force * v.dot(dv) / v.norm();
    }
    return sum;
  }
  double oracle() const {
    double low = -1, high = 1;
    while (slope(low) > 0) low *= 2;
    while (slope(high) < 0) high *= 2;
    for (int k = 0; k < 200; ++k) {
      const double middle = (low + high) / 2;
      (slope(middle) > 0 ? high : low) = middle;
    }
    return (low + high) / 2;
  }
};

TEST_CASE("[T.16] a carried plate turns as the convex oracle says") {
  constexpr double reach = 0.02;
  unsigned settled = 0, total = 300;
  for (unsigned seed = 0; seed < total; ++seed) {
    const CarriedPlate plate(seed);
    test::SolvedPush<double> push(plate.scene, true);
    if (push.solve() != Status::solved) continue;
    ++settled;
    CAPTURE(seed);
    const double w = plate.oracle(), unit = plate.push().norm() / reach;
    CHECK(std::abs(push.answer().acceleration[5] - w) <= 1e-6 * unit);
    const Vector6<double> a = plate.twist(w);
    for (std::size_t f = 0; f + 1 < plate.scene.bodies.size(); ++f) {
      const Body<double>& body = plate.scene.bodies[f];
      const Vector3<double> v = slip_of<double>(body, plate.scene.points[f], a);
      if (v.norm() < 1e-3 * plate.push().norm()) continue; // its force follows the others'
      const Vector3<double> f_true = -body.friction * plate.scene.actuators[f].force * v / v.norm();
      const ContactAnswer<double>& contact = push.answer().contacts[static_cast<Index>(f)];
      CHECK((friction_of(body, contact) - f_true).norm() <= 1e-8 * push.scales().force);
    }
  }
  CHECK(settled >= total - 1);
}

TEST_CASE("[T.16] round friction does not see how a body's tangent points") {
  unsigned compared = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    test::OwnedScene<double> scene = test::grasp_of<double>(Family::even, seed);
    scene.base.pressure = Pressure::even;
    scene.base.facets = 8;
    test::SolvedPush<double> first(scene, true);
    for (Body<double>& body : scene.bodies)
      if (!body.in_plane)
        body.tangent =
            std::cos(0.3) * body.tangent + std::sin(0.3) * cross(body.normal, body.tangent);
    test::SolvedPush<double> second(scene, true);
    test::SolvedPush<double> pyramids(scene);
    if (first.solve() != Status::solved || second.solve() != Status::solved) continue;
    ++compared;
    CAPTURE(seed);
    const double size = first.answer().acceleration.norm();
    CHECK((first.answer().acceleration - second.answer().acceleration).norm() <= 1e-7 * size);
  }
  CHECK(compared >= 38);
}

TEST_CASE("[T.16] of a pyramid the distance from the round cone is what its facets cost") {
  const CarriedPlate plate(7);
  test::SolvedPush<double> few(plate.scene), round(plate.scene, true);
  REQUIRE(few.solve() == Status::solved);
  REQUIRE(round.solve() == Status::solved);
  const auto cost = [](const test::SolvedPush<double>& push) {
    return RoundDistance<double>(push.scene, push.scales(), push.answer()).worst().distance;
  };
  CHECK(cost(few) > 1e-3);
  CHECK(cost(few) < 0.5);
  CHECK(cost(round) <= 1e-9);
}

TEST_CASE("[T.16] rounds that may not turn do not settle, and name the worst point") {
  test::SolvedPush<double> push(CarriedPlate(3).scene, true);
  push.options.max_turns = 1;
  CHECK(push.solve() == Status::not_settled);
  CHECK(push.run.reason == Reason::turning);
  CHECK(push.run.worst_point >= 0);
  CHECK(push.run.worst_point < push.scene.points.size);
}

} // namespace
