// Even pressure: every point a pad of its own with its even share.
#include <doctest/doctest.h>

#include "lcpush/mechanics/study/uniqueness.hpp"
#include "support/dense_lcp.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

Scene3 under(Scene3 scene, Pressure pressure) {
  scene.base.pressure = pressure;
  return scene;
}

/// A pinched bar, pushed at its end: it pivots in the grip. Free of weight.
Scene3 pivot(bool planar) {
  Slide slide;
  slide.pads = ring(4, 0.005);
  slide.gravity.setZero();
  Scene3 scene = straight_slide(slide);
  scene.bodies.back().friction = 0;
  scene.base.planar = planar;
  for (std::size_t i = scene.points.size() - 2; i < scene.points.size(); ++i)
    scene.points[i] = {-0.05, i % 2 == 0 ? 0.04 : 0.041, 0};
  return scene;
}

} // namespace

TEST_CASE("[T.7] spreading: a body, an actuator and a share of the force for each point") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  Scene3 owned = under(straight_slide(slide), Pressure::even);
  owned.actuators[1].inertia = 0.2;
  const Scene3 pads = owned.spread();
  CHECK(pads.bodies.size() == 4 + 4 + 1);
  CHECK(pads.actuators.size() == 8);
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(pads.bodies[i].first_point == static_cast<Index>(i));
    CHECK(pads.bodies[i].point_count == 1);
    CHECK(pads.actuators[i].force == slide.F / 4);
    CHECK(pads.actuators[i].inertia == (i < 4 ? 0.0 : 0.05));
    CHECK(pads.drives[i].body == static_cast<Index>(i));
    CHECK(pads.drives[i].actuator == static_cast<Index>(i));
    CHECK(pads.drives[i].twist == owned.drives[i / 4].twist);
  }
  CHECK(pads.bodies[8].point_count == 2); // the wall's motion is prescribed: it stays whole
  const Scene3 again = pads.spread();
  CHECK(again.bodies.size() == pads.bodies.size());
}

TEST_CASE("[T.7] spreading refuses a shared actuator and too little memory, and leaves pad alone") {
  const Scene3 jaw = under(grasp_of<double>(Family::parallel, 1), Pressure::even);
  const Scene<double> scene = jaw.view();
  CHECK(shares_an_actuator(scene));
  Scene<double> spread;
  std::vector<Body<double>> bodies(100);
  std::vector<Actuator<double>> actuators(100);
  std::vector<Drive<double>> drives(100);
  EvenMemory<double> memory{{bodies.data(), 100}, {actuators.data(), 100}, {drives.data(), 100}};
  CHECK(spread_evenly(scene, memory, spread) == Status::bad_input);
  const Scene3 fingers = under(straight_slide(), Pressure::even);
  CHECK(spread_evenly(fingers.view(), memory, spread) == Status::solved);
  memory.drives.size = 1;
  CHECK(spread_evenly(fingers.view(), memory, spread) == Status::bad_input);
  const Scene3 pad = under(fingers, Pressure::pad);
  CHECK(spread_evenly(pad.view(), memory, spread) == Status::solved);
  CHECK(spread.bodies.data == pad.bodies.data());
}

TEST_CASE("every point carries exactly its share, and closes by itself") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Scene3 whole = grasp_of<double>(Family::even, seed);
    SolvedPush<double> push(whole);
    REQUIRE(push.solve() == Status::solved);
    CHECK(push.residuals.max() <= exact);
    for (std::size_t b = 0; b < 2; ++b) {
      const Body<double>& finger = whole.bodies[b];
      const double share = whole.actuators[b].force / static_cast<double>(finger.point_count);
      for (Index i = finger.first_point; i < finger.first_point + finger.point_count; ++i) {
        const ContactAnswer<double>& contact = push.answer().contacts[i];
        CHECK(absolute(contact.normal_force - share) <= exact * push.scales().force);
        CHECK(absolute(contact.acceleration.dot(finger.normal)) <=
              exact * push.scales().acceleration);
      }
    }
  }
}

TEST_CASE("even, pad and rigid agree where statics determines the pressure") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) { // one point a finger
    CAPTURE(seed);
    const Scene3 scene = determined_grasp(seed);
    SolvedPush<double> even(under(scene, Pressure::even)), pad(under(scene, Pressure::pad)),
        rigid(under(scene, Pressure::rigid));
    for (SolvedPush<double>* push : {&even, &pad, &rigid}) REQUIRE(push->solve() == Status::solved);
    const double unit = even.answer().acceleration.norm() + even.scales().acceleration;
    CHECK((even.answer().acceleration - pad.answer().acceleration).norm() <= exact * unit);
    CHECK((even.answer().acceleration - rigid.answer().acceleration).norm() <= exact * unit);
  }
  Slide slide; // translation: friction does not care how the patch shares its force
  slide.pads = ring(4, 0.005);
  slide.gravity.setZero();
  for (const Pressure pressure : {Pressure::even, Pressure::pad, Pressure::rigid}) {
    SolvedPush<double> push(under(straight_slide(slide), pressure));
    REQUIRE(push.solve() == Status::solved);
    const double expected = 2 * slide.mu * slide.F + slide.mass * slide.acceleration;
    CHECK(push.wrench(push.scene.bodies.size - 1)[0] == doctest::Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("where statics leaves the pressure open rigid holds least, and pad as much as even") {
  double force[3];
  for (const Pressure pressure : {Pressure::even, Pressure::pad, Pressure::rigid}) {
    SolvedPush<double> push(under(pivot(true), pressure));
    REQUIRE(push.solve() == Status::solved);
    force[static_cast<int>(pressure)] = push.wrench(push.scene.bodies.size - 1)[0];
  }
  const double even = force[static_cast<int>(Pressure::even)];
  const double pad = force[static_cast<int>(Pressure::pad)];
  const double rigid = force[static_cast<int>(Pressure::rigid)];
  CHECK(pad == doctest::Approx(even).epsilon(1e-6));
  CHECK(rigid < 0.9 * pad);
}

TEST_CASE("even pressure cannot resist tilting, a pad can") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  slide.gravity.setZero();
  Scene3 scene = straight_slide(slide);
  for (Vec3& p : scene.points) // the wall pushes above the plane of the grip
    if (p[0] < -0.04) p[2] = 0.004;
  SolvedPush<double> even(under(scene, Pressure::even)), pad(under(scene, Pressure::pad));
  REQUIRE(even.solve() == Status::solved);
  REQUIRE(pad.solve() == Status::solved);
  CHECK(absolute(even.answer().acceleration[4]) > 1e-2);
  CHECK(absolute(pad.answer().acceleration[4]) <= 1e-6);
}

TEST_CASE("under even pressure and a pusher without friction the motion is proved unique") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  slide.wall_friction = 0;
  slide.gravity.setZero();
  CHECK(motion_is_determined(under(straight_slide(slide), Pressure::even).spread().view()));
  CHECK_FALSE(motion_is_determined(under(straight_slide(slide), Pressure::pad).view()));
}
