// [T.7] The pad law: where it starts, and that it ends in the literal equations.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// Preload in N and compliance of every point.
struct Pad {
  SolvedPush<double> push;
  explicit Pad(const Scene3& scene) : push(scene) {
    pad_preload(push.assembly, push.memory.work.pressure);
  }
  double preload(Index i) const {
    return push.memory.work.pressure.preload[i] * push.scales().force;
  }
  double compliance(Index i) const { return push.memory.work.pressure.compliance[i]; }
};

/// A crate on four feet, named in that order, and a smooth rod that pushes it beside its middle.
Scene3 on_feet(const std::array<std::size_t, 4>& order) {
  const std::array<Vec3, 4> corners{
      {{0.1, 0.06, -0.05}, {0.1, -0.06, -0.05}, {-0.1, 0.06, -0.05}, {-0.1, -0.06, -0.05}}};
  Scene3 scene = bare_scene(1, {0.002, 0.004, 0.005}, {0, 0, -9.81});
  for (const std::size_t foot : order)
    scene.add_body(Role::finger, {0, 0, 1}, 0.3, {corners[foot]});
  scene.add_body(Role::pusher, {1, 0, 0}, 0, {{-0.1, 0.04, 0.01}});
  scene.bodies.back().acceleration[0] = 1;
  return scene;
}

Vector6<double> motion_on_feet(const std::array<std::size_t, 4>& order) {
  SolvedPush<double> push(on_feet(order));
  REQUIRE(push.solve() == Status::solved);
  return push.answer().acceleration;
}

} // namespace

TEST_CASE("[T.7] the preload is each patch's own force shared evenly, nothing at pushers") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  const Pad pad(straight_slide(slide));
  for (Index i = 0; i < 8; ++i) CHECK(pad.preload(i) == doctest::Approx(slide.F / 4));
  for (Index i = 8; i < 10; ++i) CHECK(pad.preload(i) == 0);
}

TEST_CASE("[T.7] a parallel jaw's force 2 F is shared by its two fingers") {
  Roll roll;
  roll.F = 3;
  const Pad pad(rolling(roll));
  for (Index i = 0; i < 4; ++i) CHECK(pad.preload(i) == doctest::Approx(1.5));
  CHECK(pad.preload(4) == 0);
}

TEST_CASE(
    "[T.7] compliance: k on driven patches of k points, k / 1000 on more than two of a pusher "
    "or of the hand's stops, 0 otherwise") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  const Pad ring_and_line(straight_slide(slide));
  for (Index i = 0; i < 8; ++i) CHECK(ring_and_line.compliance(i) == 4);
  for (Index i = 8; i < 10; ++i) CHECK(ring_and_line.compliance(i) == 0); // 2 on a line: no

  slide.pads = {Vec3::Zero()};
  Scene3 scene = straight_slide(slide);
  CHECK(Pad(scene).compliance(0) == 1); // a single point
  scene.add_body(Role::pusher, {0, 1, 0}, 0.2,
                 {{0, -0.015, 0}, {0.01, -0.015, 0}, {0.02, -0.015, 0}});
  CHECK(Pad(scene).compliance(4) == doctest::Approx(0.003));
  scene.bodies.back().role = Role::finger; // the hand's only stop
  CHECK(Pad(scene).compliance(4) == doctest::Approx(0.003));

  Scene3 feet = on_feet({0, 1, 2, 3});
  for (Index i = 0; i < 4; ++i) CHECK(Pad(feet).compliance(i) == doctest::Approx(0.001));
  feet.bodies[0].preload = feet.bodies[1].preload = 1; // locked fingers are no stops
  for (Index i = 0; i < 4; ++i) CHECK(Pad(feet).compliance(i) == (i < 2 ? 1 : 0));
  feet.bodies[0].preload = feet.bodies[1].preload = 0;
  feet.bodies[0].role = feet.bodies[1].role = Role::pusher;
  for (Index i = 0; i < 4; ++i) CHECK(Pad(feet).compliance(i) == 0); // two stops: no
}

TEST_CASE("[T.7] whichever foot of a crate is named first, it slides and turns alike") {
  const Vector6<double> a = motion_on_feet({0, 1, 2, 3});
  CHECK(a.tail<3>().norm() > 1);
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end()))
    CHECK((motion_on_feet(order) - a).norm() <= 1e-9 * a.norm());
}

TEST_CASE("[T.7] a round's pressure is the next one's preload; what it changed is the violation") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  Pad pad(straight_slide(slide));
  const PressureMemory<double> memory = pad.push.memory.work.pressure;
  Assembly<double>& assembly = pad.push.assembly;
  set_compliance(assembly, memory, 0.01);
  const double changes[] = {-0.04, 0.02, -0.01, 0.03, 0, 0, 0, 0}; // of pressures near 0.25
  std::fill(memory.z.begin(), memory.z.end(), 0.0);
  for (Index i = 0; i < 8; ++i) {
    memory.preload[i] = 0.25;
    memory.z[assembly.cones()[i].variable] = 0.25 + changes[i];
  }
  memory.z[assembly.cones()[8].variable] = 3; // the pusher gives way to nothing
  memory.preload[8] = 100;

  CHECK(lcpush::detail::largest_normal(assembly, memory) == 3);
  bool differs = true, slides = true;
  const double violation = lcpush::detail::take_pressure(assembly, memory, differs, slides);
  CHECK(violation == doctest::Approx(0.01 * 4 * 0.04));
  CHECK_FALSE(differs);
  CHECK_FALSE(slides);
  for (Index i = 0; i < 8; ++i) CHECK(memory.preload[i] == doctest::Approx(0.25 + changes[i]));
  CHECK(memory.preload[8] == 3);
}

TEST_CASE("[T.7] the answer obeys the literal laws, whatever the pad's compliance was") {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(random_grasp<double>(seed));
    REQUIRE(push.solve() == Status::solved);
    CHECK(push.residuals.max() <= 1e-9);
    CHECK(push.run.rounds >= 1);
  }
}

TEST_CASE("[T.7] the pad keeps a ring's friction torque, which rigid may lose") {
  // The pivoting primitive: ring of 4 points, radius 5 mm, pushed 40 mm off the grip.
  Scene3 scene = bare_scene(0.2, {1e-4, 1e-4, 2e-4}, Vec3::Zero());
  add_pinch(scene, ring(4, 0.005), 0.005, 0.5, 20);
  scene.add_body(Role::pusher, {1, 0, 0}, 0, {{-0.03, 0.04, 0}});
  scene.bodies.back().acceleration[0] = 1e-3;
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  CHECK(push.normal_force(2) > 1.5); // torque 2 mu F R = 0.1 N m at 40 mm: about 2 N
  CHECK(push.normal_force(2) < 0.1 / 0.04 + 0.1);
}

TEST_CASE("a parallel jaw under both laws: the forces add to 2 F, the gear carries the rest") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) {
    Roll roll;
    Scene3 scene = rolling(roll);
    scene.base.pressure = pressure;
    SolvedPush<double> push(scene);
    REQUIRE(push.solve() == Status::solved);
    CHECK(push.residuals.max() <= 1e-9);
    CHECK(push.normal_force(0) + push.normal_force(1) == doctest::Approx(2 * roll.F));
    CHECK(absolute(push.answer().closing[0]) <= 1e-7);
  }
}
