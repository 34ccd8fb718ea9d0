// Pushes whose answer is known on paper.
#include <doctest/doctest.h>

#include "lcpush/mechanics/study/motion.hpp"
#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

bool near(double x, double expected, double unit) { return absolute(x - expected) <= exact * unit; }

MotionKind kind_of(const SolvedPush<double>& push) {
  return describe_motion(push.scene, push.answer(), push.scales().length,
                         push.scales().acceleration, push_size(push.scene))
      .kind;
}

double rolling_ratio(const Roll& roll, Pressure pressure) {
  Scene3 scene = rolling(roll);
  scene.base.pressure = pressure;
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  CHECK(push.residuals.max() <= exact);
  return absolute(push.answer().acceleration[5]) * roll.radius / roll.acceleration;
}

} // namespace

TEST_CASE("a horizontal straight slide pushes with 2 mu F + m a") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid})
    for (const double a : {0.01, 0.1, 3.0})
      for (const double F : {15.0, 20.0, 60.0}) {
        Slide slide;
        slide.F = F;
        slide.acceleration = a;
        Scene3 scene = straight_slide(slide);
        scene.base.pressure = pressure;
        SolvedPush<double> push(scene);
        REQUIRE(push.solve() == Status::solved);
        const double expected = 2 * slide.mu * F + slide.mass * a;
        CHECK(near(push.normal_force(slide_wall), expected, F));
        CHECK(near(push.answer().acceleration[0], a, a));
        CHECK(push.answer().acceleration.tail<5>().norm() <= exact * push.scales().acceleration);
        CHECK(kind_of(push) == MotionKind::slide);
      }
}

TEST_CASE("a slide with four-point pads pushes with 2 mu F + m a under the pad law") {
  Slide slide;
  slide.pads = ring(4, 0.005);
  SolvedPush<double> push(straight_slide(slide));
  REQUIRE(push.solve() == Status::solved);
  CHECK(near(push.normal_force(slide_wall),
             2 * slide.mu * slide.F + slide.mass * slide.acceleration, slide.F));
}

TEST_CASE("the wall's two points carry the weight's moment as a couple") {
  const Slide slide;
  SolvedPush<double> push(straight_slide(slide));
  REQUIRE(push.solve() == Status::solved);
  const Span<ContactAnswer<double>>& contacts = push.answer().contacts;
  const double lower = contacts[2].normal_force, upper = contacts[3].normal_force;
  // The wall lifts m g at x = -half_width; the couple of its normals turns against that.
  const double moment = slide.mass * 9.81 * slide.half_width;
  CHECK(near((lower - upper) * slide.half_wall, moment, slide.F * slide.half_width));
  CHECK(near(push.wrench(slide_wall)[1], slide.mass * 9.81, slide.F));
}

TEST_CASE("a frictionless pusher transmits no tangential force") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SolvedPush<double> push(determined_grasp(seed));
    REQUIRE(push.solve() == Status::solved);
    const Vector6<double> wrench = push.wrench(slide_wall);
    CHECK(wrench[1] == 0);
    CHECK(wrench[2] == 0);
    CHECK(push.answer().contacts[2].friction_force.isZero(0));
  }
}

TEST_CASE("point fingers at the centre pivot freely: the push is I a / y^2") {
  for (const double y : {0.01, 0.02, 0.04}) {
    const Vec3 inertia(1e-4, 1e-4, 2e-4);
    Scene3 scene = bare_scene(0.2, inertia, Vec3::Zero());
    add_pinch(scene, {Vec3::Zero()}, 0.005, 0.5, 20);
    scene.add_body(Role::pusher, {1, 0, 0}, 0, {{-0.03, y, 0}});
    scene.bodies.back().acceleration[0] = 0.5;
    SolvedPush<double> push(scene);
    REQUIRE(push.solve() == Status::solved);
    CHECK(near(push.normal_force(slide_wall), inertia[2] * 0.5 / (y * y), 20));
    CHECK(near(push.answer().acceleration[5], -0.5 / y, 0.5 / y));
    CHECK(push.answer().acceleration.head<3>().norm() <= exact * push.scales().acceleration);
    CHECK(kind_of(push) == MotionKind::pivot);
  }
}

TEST_CASE("rings carry 2 mu F R of a pure couple, and no more") {
  const double R = 0.005, F = 20, mu = 0.5, y = 0.02, alpha = 3, inertia = 2e-4;
  for (const Index k : {4, 8}) {
    CAPTURE(k);
    Scene3 scene = bare_scene(0.2, {1e-4, 1e-4, inertia}, Vec3::Zero());
    add_pinch(scene, ring(k, R), 0.005, mu, F);
    for (const double side : {1.0, -1.0}) {
      scene.add_body(Role::pusher, {side, 0, 0}, 0, {{-side * 0.03, side * y, 0}});
      scene.bodies.back().acceleration[0] = side * alpha * y;
    }
    SolvedPush<double> push(scene);
    REQUIRE(push.solve() == Status::solved);
    const double couple = (push.normal_force(2) + push.normal_force(3)) * y;
    CHECK(near(couple, 2 * mu * F * R + inertia * alpha, F * R));
    CHECK(near(push.answer().acceleration[5], -alpha, push.scales().acceleration / R));
  }
}

TEST_CASE("a cylinder in a parallel jaw rolls below the threshold F* and slides above it") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) {
    Roll roll; // mu_sheet (1 + mu_finger) = 0.65: the threshold is sharp
    const double threshold = roll.threshold();
    roll.F = 0.5 * threshold;
    CHECK(rolling_ratio(roll, pressure) == doctest::Approx(1).epsilon(exact));
    roll.F = 0.999 * threshold;
    CHECK(rolling_ratio(roll, pressure) == doctest::Approx(1).epsilon(exact));
    roll.F = 1.001 * threshold;
    const double just_above = rolling_ratio(roll, pressure);
    CHECK(just_above < 0.999);
    roll.F = 1.1 * threshold;
    CHECK(rolling_ratio(roll, pressure) <= exact);
  }
}

TEST_CASE("a rolling cylinder: the jaw's forces add to 2 F and differ by the sheet's drag") {
  Roll roll;
  roll.F = 0.5 * roll.threshold();
  SolvedPush<double> push(rolling(roll));
  REQUIRE(push.solve() == Status::solved);
  const double left = push.normal_force(0), right = push.normal_force(1);
  CHECK(near(left + right, 2 * roll.F, roll.F));
  const double drag = 2 * roll.mu_finger * roll.F +
                      roll.inertia() * roll.acceleration / (roll.radius * roll.radius);
  CHECK(near(push.wrench(2)[0], drag, roll.F));
  CHECK(near(right - left, drag, roll.F));
  CHECK(near(push.normal_force(2), roll.mass * 9.81 + roll.mu_finger * drag, roll.F));
}
