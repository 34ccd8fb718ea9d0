// Steps in time: the law, holds, slides, falls, tumbles, rolls.
#include <doctest/doctest.h>

#include <cstring>

#include "support/owned_motion.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// Steps to `time`, each solved and checked; the deepest penetration.
template <class S> double run_to(OwnedMotion<S>& run, double time, double h) {
  double deepest = 0;
  const Index steps = static_cast<Index>(std::lround(time / h));
  for (Index k = 0; k < steps; ++k) {
    CAPTURE(k);
    const Status status = run->advance(S(h));
    REQUIRE(status_text(status) == std::string("solved"));
    REQUIRE(double(run->run().residual) <= double(Tolerances<S>().residual));
    deepest = std::max(deepest, double(run->run().penetration));
  }
  return deepest;
}

double turned_about_z(const Pose<double>& pose) {
  return std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
}

} // namespace

TEST_CASE("[T.13] the first step from rest is the push with A_b = V_b / h, bit for bit") {
  Index compared = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    OwnedMotion<double> run(random_grasp<double>(seed));
    REQUIRE(run.begin() == Status::running);
    const double h = 0x1p-12; // a power of two: A_b h / h is A_b
    run->prescribed(2) = run.owned.bodies[2].acceleration * h;
    REQUIRE(run->advance(h) == Status::solved);
    if (run->run().corrections > 0) continue; // bent gaps are another problem
    ++compared;
    const Scene<double> scene = run.owned.view();
    OwnedWorkspace<double> work(size_of(scene));
    Assembly<double> push(work.work.assembly);
    REQUIRE(push.assemble(scene) == Status::running);
    Assembly<double> step(run->assembly());
    step.push_by(1.0); // without the pads' compliance
    const Index n = push.layout().size;
    REQUIRE(step.layout().size == n);
    CHECK(std::memcmp(push.problem().q, step.problem().q, sizeof(double) * std::size_t(n)) == 0);
    for (ConeGroup<double>& cone : step.cones()) cone.compliance = 0;
    Eigen::MatrixXd a(n, n), b(n, n);
    fill_matrix(push.problem(), MatrixMap<double>(a.data(), n, n));
    fill_matrix(step.problem(), MatrixMap<double>(b.data(), n, n));
    CHECK(std::memcmp(a.data(), b.data(), sizeof(double) * std::size_t(n * n)) == 0);
  }
  CHECK(compared >= 36);
}

TEST_CASE("[T.13] velocities, gaps, spin and jaws in motion enter as the law says") {
  const Scene3 scene = straight_slide();
  const Scene<double> view = scene.view();
  std::vector<Body<double>> bodies(3);
  std::vector<Actuator<double>> actuators(2);
  std::vector<double> clearances(4);
  std::vector<Vector6<double>> twists(3, Vector6<double>::Constant(0.3));
  const std::vector<double> speeds{0.2, 0.0}, gaps{0, 0, 0.001, 0.004};
  StepStart<double> start;
  start.h = 0.1;
  start.velocity << 0.1, 0.2, 0.3, 1, 2, 3;
  start.bodies = {twists.data(), 3};
  start.closing_speeds = {speeds.data(), 2};
  start.gaps = {gaps.data(), 4};
  Scene<double> heavy = view;
  const std::vector<Actuator<double>> jaws{{20, 0.5}, {20, 0.5}};
  heavy.actuators = {jaws.data(), 2};
  const Scene<double> step = laws::time_step(
      heavy, start, {{bodies.data(), 3}, {actuators.data(), 2}, {clearances.data(), 4}});
  CHECK((step.bodies[1].acceleration - (twists[1] - start.velocity) / 0.1).norm() == 0);
  CHECK(step.actuators[0].force == doctest::Approx(20 + 0.5 * 0.2 / 0.1));
  CHECK(step.actuators[1].force == 20);
  CHECK(step.clearances[3] == doctest::Approx(0.4));
  const Vec3 omega(1, 2, 3);
  const Vec3 torque = -cross<double>(omega, view.object.inertia * omega);
  CHECK((step.object.turning - torque).norm() < 1e-18);
  CHECK(step.object.wrench.norm() == 0);
  // It comes of the motion: what is small of it may be lost in the rounding of the forces.
  std::vector<ContactAnswer<double>> contacts(4);
  Answer<double> rest;
  rest.acceleration.setZero();
  rest.contacts = {contacts.data(), 4};
  const Scales<double> units{20, 0.05, 100};
  const lcpush::detail::TermSizes<double> before(view, units, rest), then(step, units, rest);
  CHECK(then.load == before.load);
  CHECK((then.wrench - before.wrench).tail<3>() == torque.cwiseAbs());
}

TEST_CASE("held for ten seconds, a part does not creep") {
  for (const double F : {12.0, 30.0, 60.0})
    for (const bool parallel : {false, true}) {
      CAPTURE(F);
      CAPTURE(parallel);
      Scene3 scene = bare_scene(0.045, {1e-5, 2e-5, 2.5e-5}, {0, -9.81, 0});
      add_pinch(scene, ring(4, 0.005), 0.01, 0.7, F);
      if (parallel) {
        scene.actuators.resize(1);
        scene.actuators[0].force = 2 * F;
        for (Drive<double>& drive : scene.drives) drive.actuator = 0;
      }
      OwnedMotion<double> run(scene);
      REQUIRE(run.begin() == Status::running);
      CHECK(run_to(run, 10, 0.02) <= 1e-9);
      for (const Vec3& p : scene.points) CHECK((run->pose().at(p) - p).norm() <= 1e-12);
      CHECK(run->run().pivots <= 3);
    }
}

TEST_CASE("just below the holding grip the fall is the scheme's, exactly") {
  const double m = 0.045, mu = 0.7, F = 0.95 * m * 9.81 / (2 * mu), h = 1e-3;
  Scene3 scene = bare_scene(m, {1e-5, 2e-5, 2.5e-5}, {0, -9.81, 0});
  add_pinch(scene, {Vec3::Zero()}, 0.01, mu, F);
  OwnedMotion<double> run(scene);
  REQUIRE(run.begin() == Status::running);
  run_to(run, 0.1, h);
  const double a = 9.81 - 2 * mu * F / m;
  CHECK(std::abs(run->pose().position[1] + a * h * h * 100 * 101 / 2) <= 1e-14);
}

TEST_CASE("a step that would leap is refused with its reason, and nothing has moved") {
  Scene3 scene = bare_scene(0.2, {1e-4, 1e-4, 1e-4}, {0, 0, 0});
  scene.add_body(Role::pusher, {0, 1, 0}, 0.5, {{0, -1, 0}}); // a floor far below
  OwnedMotion<double> run(scene);
  run.touching = {{Riding::on_body, 0, 0}};
  run.add_face({0, -1, 0}, {0, -1, 0}, {0.01, 0, 0}, {0, 0, 0.01});
  REQUIRE(run.begin() == Status::running);
  run->prescribed(0)[1] = -2000; // and it leaves
  for (const double leap : {1.0001, 0.9999}) {
    for (const bool turns : {true, false}) {
      run->velocity().setZero();
      run->velocity()[turns ? 3 : 0] = turns ? 0.5 * leap / 1e-3 : leap / 1e-3;
      const Vec3 before = run->pose().position;
      const Status status = run->advance(1e-3);
      CHECK((status == Status::solved) == (leap < 1));
      if (leap < 1) continue;
      CHECK(status == Status::numerical_breakdown);
      CHECK(run->run().reason == Reason::leap);
      CHECK(run->pose().position == before);
      CHECK(run->time() == 0);
    }
  }
}

TEST_CASE("a rod between two plates goes half as far as the moving one and turns by s / 2R") {
  Scene3 scene = bare_scene(0.1, {4e-5, 4e-5, 2e-5}, {0, -9.81, 0});
  const double R = 0.02;
  for (const double below : {1.0, -1.0})
    scene.add_body(Role::finger, {0, below, 0}, 0.8,
                   {{0, -below * R, -0.03}, {0, -below * R, 0.03}});
  Vector6<double> down = Vector6<double>::Zero();
  down[1] = -1;
  scene.drives.push_back({1, 0, down});
  scene.actuators.push_back({5, 0});
  OwnedMotion<double> run(scene);
  run.touching.assign(2, {Riding::on_side, -1, 0});
  RoundSide<double> side;
  side.radius = R;
  run.sides = {side};
  REQUIRE(run.begin() == Status::running);
  run->prescribed(1)[0] = 0.05;
  CHECK(run_to(run, 1, 1e-3) <= 1e-9);
  CHECK(std::abs(run->pose().position[0] - 0.025) <= 1e-9);
  CHECK(std::abs(turned_about_z(run->pose()) + 0.05 / (2 * R)) <= 1e-9);
  CHECK(std::abs(run->pose().position[1]) <= 1e-9);
  CHECK(std::abs(run->closing(0)) <= 1e-9);
}
