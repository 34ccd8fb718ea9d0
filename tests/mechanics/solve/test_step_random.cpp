// Steps in time on random scenes: nothing wrong called solved, order of accuracy, energy, edges.
#include <doctest/doctest.h>

#include "support/owned_motion.hpp"
#include "support/seeds.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A point pushes a plate that two soft fingers hold; the fingers' points ride on the plate.
double turn_of_push(double h, bool follows) {
  const double rho = 0.04, angle = 0.6;
  Scene3 scene = bare_scene(0.01, {1e-6, 1e-6, 2e-6}, Vec3::Zero());
  scene.base.planar = true;
  scene.base.facets = 16;
  add_pinch(scene, {Vec3::Zero()}, 0.005, 0.5, 20);
  for (Body<double>& body : scene.bodies) body.torsion_radius = 0.03;
  scene.add_body(Role::pusher, {1, 0, 0}, 1.0,
                 {{-rho * std::cos(angle), -rho * std::sin(angle), 0}});
  OwnedMotion<double> run(scene);
  const Riding riding = follows ? Riding::on_object : Riding::on_body;
  run.touching = {{riding, -1, 0}, {riding, -1, 0}, {Riding::on_body, -1, 0}};
  REQUIRE(run.begin() == Status::running);
  run->prescribed(2)[0] = 0.02;
  for (Index k = 0; k < static_cast<Index>(std::lround(1 / h)); ++k) {
    REQUIRE(run->advance(h) == Status::solved);
    REQUIRE(run->run().penetration <= 1e-9);
  }
  return std::atan2(run->pose().rotation(1, 0), run->pose().rotation(0, 0));
}

/// Kinetic energy, the weight's and that of the forces which actuators hold.
double energy(const OwnedScene<double>& owned,
              const TimeStepper<double, StructuredLemke<double>>& run) {
  const Object<double>& object = owned.base.object;
  const Vector6<double>& v = run.velocity();
  const Matrix3<double>& R = run.pose().rotation;
  const Vec3 spin = R.transpose() * v.tail<3>();
  double sum = object.mass * v.head<3>().squaredNorm() / 2 + spin.dot(object.inertia * spin) / 2 -
               object.mass * owned.base.gravity.dot(run.pose().position);
  for (std::size_t a = 0; a < owned.actuators.size(); ++a)
    sum -= owned.actuators[a].force * run.closing(static_cast<Index>(a));
  return sum;
}

} // namespace

TEST_CASE("halving the step halves the error of a pivoting push") {
  for (const bool follows : {false, true}) {
    CAPTURE(follows);
    const double turn[] = {turn_of_push(0.01, follows), turn_of_push(0.005, follows),
                           turn_of_push(0.0025, follows), turn_of_push(0.00125, follows)};
    CHECK(std::abs(turn[3]) > 0.1);
    for (const int k : {0, 1}) {
      const double ratio = (turn[k + 1] - turn[k]) / (turn[k + 2] - turn[k + 1]);
      CHECK(ratio >= 1.9);
      CHECK(ratio <= 2.1);
    }
  }
}

TEST_CASE("random motions: every step is checked, and a step goes on from the last basis") {
  std::vector<Index> pivots;
  for (std::uint64_t seed = 0; seed < seeds(30); ++seed) {
    CAPTURE(seed);
    OwnedMotion<double> run(random_grasp<double>(seed));
    begin_random(run, seed);
    for (Index k = 0; k < 200; ++k) {
      CAPTURE(k);
      const Status status = run->advance(1e-3);
      if (run->run().lost) break;
      REQUIRE(status_text(status) == std::string("solved"));
      const Assembly<double>& assembly = run->assembly();
      const Residuals<double> residuals =
          check(run->step_scene(), assembly.layout().scales, run->step_answer(), 1.0);
      REQUIRE(residuals.max() <= Tolerances<double>().residual);
      CHECK(run->run().penetration <= 1e-9);
      if (k > 0) pivots.push_back(run->run().pivots);
    }
  }
  std::sort(pivots.begin(), pivots.end());
  CHECK(pivots[pivots.size() / 2] <= 3);
}

TEST_CASE(
    "a step that would end inside a face is too long; half of it, or a part of that, is not") {
  // Fingers run along a face that stands nearly on edge: corrections ended 1.1 um and 9 nm deep.
  for (const auto& run_of : {std::pair(5048, 122), std::pair(1520, 20)}) {
    const auto seed = static_cast<std::uint64_t>(run_of.first);
    CAPTURE(seed);
    OwnedMotion<double> run(random_grasp<double>(seed));
    begin_random(run, seed);
    Index refused = 0;
    const double end = run_of.second * 1e-3;
    for (double h = 1e-3; run->time() < end - 1e-9;) {
      CAPTURE(run->time());
      const Pose<double> before = run->pose();
      if (run->advance(h) == Status::solved) {
        REQUIRE(run->run().penetration <= 1e-10);
        h = std::min(1e-3, 2 * h);
        continue;
      }
      REQUIRE(run->run().reason == Reason::leap);
      CHECK(run->pose().position == before.position);
      ++refused;
      h /= 2;
      REQUIRE(h > 1e-5);
    }
    CHECK(refused > 0);
  }
}

TEST_CASE("where nothing drives, energy never grows") {
  for (std::uint64_t seed = 100; seed < 124; ++seed) {
    CAPTURE(seed);
    Scene3 grasp = random_grasp<double>(seed);
    for (Actuator<double>& actuator : grasp.actuators) actuator.inertia = 0;
    OwnedMotion<double> run(grasp);
    begin_random(run, seed);
    run->prescribed(2).setZero();
    Random random(seed);
    for (Index k = 0; k < 6; ++k) run->velocity()[k] = random.uniform(-0.1, 0.1) * (k < 3 ? 1 : 20);
    double before = energy(grasp, *run);
    const double size = std::abs(before) + grasp.actuators[0].force * 0.01;
    for (Index k = 0; k < 100; ++k) {
      CAPTURE(k);
      const Status status = run->advance(5e-4);
      if (status != Status::solved) {
        CHECK(run->run().lost);
        break;
      }
      const double now = energy(grasp, *run);
      CHECK(now <= before + 1e-6 * size);
      before = now;
    }
  }
}

TEST_CASE("a finger's point leaves its face, the others carry on; a bare finger is lost") {
  Slide slide;
  slide.pads = {{0.02, 0, 0}, {-0.02, 0, 0}};
  slide.gravity.setZero();
  OwnedMotion<double> run(straight_slide(slide));
  run.touching = {{Riding::on_body, 0, 0}, {Riding::on_body, 1, 0}, {Riding::on_body, -1, 0}};
  for (const double side : {1.0, -1.0})
    run.add_face({0, 0, 0.005 * side}, {0, 0, side}, {0.05, 0, 0}, {0, 0.015, 0});
  REQUIRE(run.begin() == Status::running);
  run->prescribed(2)[0] = 0.1;
  Index leaves = -1, lost = -1;
  for (Index k = 0; k < 1000 && lost < 0; ++k) {
    const Status status = run->advance(1e-3);
    if (status == Status::does_not_hold && run->run().lost)
      lost = k;
    else
      REQUIRE(status == Status::solved);
    if (leaves < 0 && run->contact(1).absence == Absence::outside) leaves = k;
  }
  // The object's rear edge, at -50 mm, passes the points at -20 and +20 mm.
  CHECK(leaves == doctest::Approx(301).epsilon(0.004));
  CHECK(lost == doctest::Approx(701).epsilon(0.004));
}

TEST_CASE("a point that has left its face comes back to it") {
  Scene3 scene = bare_scene(0.1, {1e-4, 1e-4, 1e-4}, {0, 0, -9.81});
  scene.add_body(Role::pusher, {0, 0, 1}, 0.0,
                 {{0.01, 0, -0.01}, {-0.01, 0.01, -0.01}, {-0.01, -0.01, -0.01}});
  scene.add_body(Role::pusher, {0, 0, 1}, 0.0, {{0.04, 0, -0.01}});
  OwnedMotion<double> run(scene);
  run.touching = {{Riding::on_body, -1, 0}, {Riding::on_body, 0, 0}};
  run.add_face({0, 0, -0.01}, {0, 0, -1}, {0.05, 0, 0}, {0, 0.05, 0});
  REQUIRE(run.begin() == Status::running);
  std::vector<bool> touches;
  for (Index k = 0; k < 60; ++k) {
    run->prescribed(1)[0] = k < 30 ? 1.0 : -1.0;
    REQUIRE(run->advance(1e-3) == Status::solved);
    touches.push_back(run->contact(3).absence == Absence::none);
    CHECK(run->run().penetration <= 1e-9);
  }
  CHECK(touches.front());
  CHECK_FALSE(touches[30]);
  CHECK(touches.back());
  CHECK(run->pose().position.norm() <= 1e-12);
}

TEST_CASE("a falling block lands on a floor, through a gap, and stays") {
  Scene3 scene = bare_scene(0.1, {1e-4, 1e-4, 1e-4}, {0, 0, -9.81});
  const double half = 0.02;
  scene.add_body(
      Role::pusher, {0, 0, 1}, 0.4,
      {{half, half, -half}, {-half, half, -half}, {half, -half, -half}, {-half, -half, -half}});
  OwnedMotion<double> run(scene);
  run.touching = {{Riding::on_object, -1, 0}};
  REQUIRE(run.begin() == Status::running);
  // The floor sinks away for 50 ms, and the block is set going.
  for (Index k = 0; k < 400; ++k) {
    run->prescribed(0)[2] = k < 50 ? -0.5 : 0.0;
    if (k == 0) run->velocity() << 0.1, 0, 0, 0.4, 0.2, 0;
    REQUIRE(run->advance(1e-3) == Status::solved);
    CHECK(run->run().penetration <= 1e-9);
  }
  CHECK(std::abs(run->pose().position[2] + 0.025) <= 1e-6);
  CHECK(run->velocity().norm() <= 1e-9);
  double weight = 0;
  for (Index i = 0; i < 4; ++i) weight += run->contact(i).normal_force;
  CHECK(weight == doctest::Approx(0.981));
}

TEST_CASE("what cannot be begun or stepped says why") {
  Scene3 scene = straight_slide();
  OwnedMotion<double> run(scene);
  run.touching.resize(2);
  CHECK(run.begin() == Status::bad_input);
  CHECK(run->run().touch == TouchMistake::index);
  run.touching.clear();
  REQUIRE(run.begin() == Status::running);
  CHECK(run->advance(0) == Status::bad_input);
  CHECK(run->advance(-1) == Status::bad_input);
  CHECK(run->advance(std::nan("")) == Status::bad_input);
  run->velocity()[0] = std::nan("");
  CHECK(run->advance(1e-3) == Status::bad_input);
  scene.base.object.mass = -1;
  OwnedMotion<double> bad(scene);
  CHECK(bad.begin() == Status::bad_input);
  CHECK(bad->run().mistake == Mistake::mass);
}
