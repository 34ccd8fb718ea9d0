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

TEST_CASE("[T.16] a carried plate turns as the convex oracle says, in at most 16 rounds") {
  constexpr double reach = 0.02;
  unsigned settled = 0, total = 300;
  for (unsigned seed = 0; seed < total; ++seed) {
    const CarriedPlate plate(seed);
    test::SolvedPush<double> push(plate.scene, true);
    if (push.solve() != Status::solved || push.run.turns >= 16) continue;
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

/// Newton, and |f| <= mu lambda with f against the slip, by this test's own arithmetic.
template <class S> double cone_violation(const test::SolvedPush<S>& push) {
  double fastest = 0, worst = 0;
  const auto slip = [&](const ContactAnswer<S>& contact, const Body<S>& body) {
    const Vector3<S>& a = contact.acceleration;
    const Vector3<S> along = a - a.dot(body.normal) * body.normal;
    return std::hypot(double(along.norm()), double(body.torsion_radius * contact.spin));
  };
  for (const ContactAnswer<S>& contact : push.answer().contacts)
    fastest = std::max(fastest, slip(contact, push.scene.bodies[contact.body]));
  for (const ContactAnswer<S>& contact : push.answer().contacts) {
    const Body<S>& body = push.scene.bodies[contact.body];
    const Vector3<S> v = in_friction_space(body, contact.acceleration, contact.spin);
    const Vector3<S> f = friction_of(body, contact);
    const double room = double(body.friction) * std::abs(double(contact.normal_force));
    worst = std::max(worst, (double(f.norm()) - room) / double(push.scales().force));
    if (slip(contact, body) < 1e-5 * fastest) continue;
    const Vector3<S> wanted = -S(room) * v / v.norm();
    worst = std::max(worst, double((f - wanted).norm() / push.scales().force));
  }
  return worst;
}

TEST_CASE("[T.16] of random grasps nearly all settle, and what settles is round") {
  constexpr unsigned total = 150;
  for (const Family family : {Family::plain, Family::soft, Family::even})
    for (const Pressure pressure : {Pressure::pad, Pressure::rigid, Pressure::even}) {
      if ((family == Family::even) != (pressure == Pressure::even)) continue;
      unsigned settled = 0;
      for (unsigned seed = 0; seed < total; ++seed) {
        test::OwnedScene<double> scene = test::grasp_of<double>(family, seed);
        scene.base.pressure = pressure;
        scene.base.facets = 8;
        test::SolvedPush<double> push(scene, true);
        if (push.solve() != Status::solved) continue;
        ++settled;
        CAPTURE(seed);
        CHECK(push.residuals.max() <= 1e-9);
        CHECK(cone_violation(push) <= 1e-8);
      }
      CHECK(settled >= total * 98 / 100);
    }
}

TEST_CASE("[T.16] round friction does not see how a body's tangent points") {
  unsigned compared = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    test::OwnedScene<double> scene = test::grasp_of<double>(Family::even, seed);
    scene.base.pressure = Pressure::even;
    scene.base.facets = 8;
    test::SolvedPush<double> first(scene, true);
    for (Body<double>& body : scene.bodies)
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

TEST_CASE("[T.16] single precision settles as well") {
  unsigned settled = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    test::OwnedScene<float> scene = test::grasp_of<float>(Family::even, seed);
    scene.base.pressure = Pressure::even;
    scene.base.facets = 8;
    test::SolvedPush<float> push(scene, true);
    if (push.solve() != Status::solved) continue;
    ++settled;
    CAPTURE(seed);
    CHECK(push.residuals.max() <= Tolerances<float>().residual);
    CHECK(cone_violation(push) <= 1e-2);
  }
  CHECK(settled >= 95);
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

TEST_CASE("[T.16] Gauss-Seidel's sweeps and pivots agree on round friction") {
  unsigned compared = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    const CarriedPlate plate(seed);
    test::SolvedPush<double> push(plate.scene, true);
    const AssemblySize size = size_of(push.scene);
    std::vector<unsigned char> bytes(static_cast<std::size_t>(sweep_bytes<double>(size)));
    Workspace<double> work =
        make_sweep_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size);
    Scene<double> scene = push.scene;
    scene.round_cones = {work.round_cones.data, scene.points.size};
    Assembly<double> assembly(work.assembly);
    assembly.assemble(scene);
    BlockGaussSeidel<double> sweeps(work.sweep_scalars, work.sweep_integers);
    PressureRun run;
    if (solve_pressure(assembly, SweepRounds{sweeps}, work.pressure, {}, run,
                       work.friction_memory(scene)) != Status::solved)
      continue;
    REQUIRE(push.solve() == Status::solved);
    read_answer(assembly, work.pressure.z.data, work.answer, 1.0);
    ++compared;
    CAPTURE(seed);
    CHECK((work.answer.acceleration - push.answer().acceleration).norm() <=
          1e-5 * push.answer().acceleration.norm());
  }
  CHECK(compared >= 25);
}

} // namespace
