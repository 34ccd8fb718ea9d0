// [T.10] The instant of breaking.
#include <doctest/doctest.h>

#include "support/dense_lcp.hpp"
#include "support/owned_sweeps.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

struct Broken {
  SolvedPush<double> push;
  Breaking<double> breaking;
  Status status;

  Broken(Scene3 scene, Pressure pressure) : push(with(scene, pressure)) {
    status = find_breaking(push.assembly, LemkeRounds{push.lemke}, push.memory.work,
                           push.scene.bodies[slide_wall], push.options, breaking, push.run);
  }
  static Scene3 with(Scene3 scene, Pressure pressure) {
    scene.base.pressure = pressure;
    return scene;
  }
};

constexpr Pressure both_laws[] = {Pressure::pad, Pressure::rigid};

} // namespace

TEST_CASE("[T.10] a horizontal straight slide breaks at 2 mu F and feels the inertia m") {
  for (const Pressure pressure : both_laws)
    for (const double a : {0.01, 0.1, 5.0}) { // the size of the push does not matter
      Slide slide;
      slide.acceleration = a;
      Broken broken(straight_slide(slide), pressure);
      REQUIRE(broken.status == Status::solved);
      CHECK(broken.breaking.break_force == doctest::Approx(2 * slide.mu * slide.F).epsilon(1e-7));
      CHECK(broken.breaking.force[0] == doctest::Approx(20).epsilon(1e-7));
      CHECK(broken.breaking.inertia_normal == doctest::Approx(slide.mass).epsilon(1e-5));
      CHECK(broken.breaking.twist[0] == doctest::Approx(1).epsilon(1e-7));
      CHECK(broken.breaking.twist.tail<5>().norm() <= 1e-5);
      CHECK(broken.breaking.rest.norm() <= 1e-6);
      CHECK(broken.breaking.line_error <= 1e-7);
      CHECK(broken.breaking.residuals.max() <= 1e-9);
    }
}

TEST_CASE("[T.10] rigid is exact: 2 mu F and m to 1e-9") {
  Broken broken(straight_slide(), Pressure::rigid);
  REQUIRE(broken.status == Status::solved);
  CHECK(absolute(broken.breaking.break_force - 20) <= 2e-8);
  CHECK(absolute(broken.breaking.inertia_normal - 0.2) <= 1e-9);
}

TEST_CASE("[T.10] sweeps find the force of breaking as pivots do") {
  SolvedPush<double> push(straight_slide());
  OwnedSweeps<double> owned(size_of(push.scene));
  Breaking<double> breaking;
  SweepRounds<double> rounds{owned.sweeps};
  REQUIRE(find_breaking(push.assembly, rounds, push.memory.work, push.scene.bodies[slide_wall], {},
                        breaking, push.run) == Status::solved);
  CHECK(breaking.break_force == doctest::Approx(20).epsilon(1e-7));
  CHECK(push.run.pivots == 0);
  CHECK(push.run.sweeps > 0);
}

TEST_CASE("[T.10] a grasp that drops its load says so, with the motion") {
  for (const Pressure pressure : both_laws) {
    Slide weak;
    weak.F = 1; // carries 2 mu F = 1 N of 1.96 N
    Broken broken(straight_slide(weak), pressure);
    CHECK(broken.status == Status::does_not_hold);
    CHECK(broken.breaking.rest[1] < -1);
  }
}

TEST_CASE(
    "[T.10] pad: next to the grip that holds, a pusher that would have to pull is no answer") {
  for (const double mu : {0.49049, 0.490495, 0.490499}) { // 0.4905 carries the weight
    CAPTURE(mu);
    Slide weak;
    weak.F = 2;
    weak.mu = mu;
    weak.wall_friction = 0;
    Broken broken(straight_slide(weak), Pressure::pad);
    // The core looks at pushes alone, and all are stronger than so slow a fall.
    CHECK(broken.status == Status::numerical_breakdown);
    CHECK(broken.push.run.reason == Reason::pull);
    CHECK(broken.breaking.break_force < 0);
  }
}

TEST_CASE("[T.10] pad: next to the grip that holds, pushes go below what it holds with") {
  for (const double more : {1e-2, 1e-3, 1e-4, 1e-5}) {
    CAPTURE(more);
    Slide barely;
    barely.F = 1.962 * (1 + more); // 1.962 N carries the weight
    Scene3 scene = straight_slide(barely);
    scene.bodies.resize(slide_wall);
    scene.points.resize(2);
    scene.add_body(Role::pusher, {1, 0, 0}, 0, {{-0.05, 0.007, 0}});
    scene.bodies.back().acceleration[0] = 0.1;
    // The tip turns the box about its two points, which nothing resists.
    Broken broken(scene, Pressure::pad);
    REQUIRE(broken.status == Status::solved);
    const double open = 2 * broken.breaking.line_error * broken.push.scales().force;
    CHECK(absolute(broken.breaking.break_force) <= 1e-6 + open);
    CHECK(broken.breaking.twist[5] == doctest::Approx(-1 / 0.007).epsilon(1e-6));
  }
}

TEST_CASE("[T.10] a scene without a prescribed motion has no push to speak of") {
  Slide still;
  still.acceleration = 0;
  for (const Pressure pressure : both_laws)
    CHECK(Broken(straight_slide(still), pressure).status == Status::bad_input);
}

TEST_CASE("[T.10] without weight the break force is proportional to the grip force") {
  for (const Pressure pressure : both_laws) {
    Slide slide;
    slide.gravity.setZero();
    slide.pads = ring(3, 0.004);
    Broken one(straight_slide(slide), pressure);
    slide.F *= 3.7;
    Broken more(straight_slide(slide), pressure);
    REQUIRE(one.status == Status::solved);
    REQUIRE(more.status == Status::solved);
    CHECK(more.breaking.break_force ==
          doctest::Approx(3.7 * one.breaking.break_force).epsilon(1e-7));
  }
}

TEST_CASE("[T.10] rigid: inside valid_to a finite push answers F0 + F1 a") {
  Broken broken(straight_slide(), Pressure::rigid);
  REQUIRE(broken.status == Status::solved);
  const double reach = broken.breaking.valid_to;
  const double a = reach < 0 ? 1.0 : 0.5 * reach;
  REQUIRE(broken.push.solve(a / push_size(broken.push.scene)) == Status::solved);
  CHECK(broken.push.normal_force(slide_wall) ==
        doctest::Approx(broken.breaking.break_force + broken.breaking.inertia_normal * a)
            .epsilon(1e-9));
}

TEST_CASE("[T.10] on weightless balanced grasps pad and rigid break alike, where the pad's "
          "three pushes lie on a line") {
  Index on_a_line = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Scene3 scene = determined_grasp(seed);
    scene.base.gravity.setZero();
    scene.actuators[1].force = scene.actuators[0].force;
    scene.points[1].head<2>() = scene.points[0].head<2>();
    Broken pad(scene, Pressure::pad), rigid(scene, Pressure::rigid);
    REQUIRE(pad.status == Status::solved);
    REQUIRE(rigid.status == Status::solved);
    if (pad.breaking.line_error > 1e-9) continue; // a kink between them: the pad says so
    ++on_a_line;
    const double force = pad.push.scales().force;
    CHECK(absolute(pad.breaking.break_force - rigid.breaking.break_force) <= 1e-5 * force);
    CHECK((pad.breaking.twist - rigid.breaking.twist).norm() <= 1e-5 * rigid.breaking.twist.norm());
  }
  CHECK(on_a_line >= 24);
}

TEST_CASE(
    "a soft patch, or even pressure that was not spread, is refused by solve and break alike") {
  for (const bool soft : {false, true}) {
    CAPTURE(soft);
    Slide slide;
    slide.pads = ring(4, 0.005);
    Scene3 owned = straight_slide(slide);
    if (soft)
      owned.bodies.front().torsion_radius = 0.002;
    else
      owned.base.pressure = Pressure::even;
    const Scene<double> scene = owned.view();
    OwnedWorkspace<double> memory(size_of(scene));
    Assembly<double> assembly(memory.work.assembly);
    REQUIRE(assembly.assemble(scene) == Status::running);
    Lemke<double> lemke(memory.work.lemke_scalars, memory.work.lemke_integers);
    PressureRun run;
    CHECK(solve_pressure(assembly, LemkeRounds{lemke}, memory.work.pressure, {}, run) ==
          Status::bad_input);
    CHECK(run.reason == Reason::unsupported);
    Breaking<double> breaking;
    const Index pusher = scene.bodies.size - 1;
    CHECK(find_breaking(assembly, LemkeRounds{lemke}, memory.work, scene.bodies[pusher], {},
                        breaking, run) == Status::bad_input);
    CHECK(run.reason == Reason::unsupported);
  }
}

TEST_CASE("in float a breaking force is right to a per cent, or refused") {
  for (const Pressure pressure : both_laws)
    for (const float radius : {0.003F, 0.006F, 0.012F}) {
      CAPTURE(radius);
      OwnedScene<float> owned;
      owned.base.object.mass = 0.2F;
      owned.base.object.inertia = Vector3<float>(1.7e-5F, 1.7e-4F, 1.8e-4F).asDiagonal();
      owned.base.object.center_of_mass.setZero();
      owned.base.gravity.setZero();
      owned.base.facets = 8;
      owned.base.pressure = pressure;
      for (const float side : {1.0F, -1.0F}) {
        owned.add_body(Role::finger, {0, 0, -side}, 0.5F, {{0, 0, 0.005F * side}});
        owned.bodies.back().torsion_radius = radius;
        owned.drive_last_body(20);
      }
      // At 30 degrees of the cone: 2 mu F cos(30 deg).
      const float lever = radius * 0.57735027F;
      owned.add_body(Role::pusher, {1, 0, 0}, 0, {{-0.05F, lever, 0}});
      owned.bodies.back().acceleration[0] = 0.1F;
      SolvedPush<float> push(owned);
      Breaking<float> breaking;
      const Status status = find_breaking(push.assembly, LemkeRounds{push.lemke}, push.memory.work,
                                          push.scene.bodies[2], push.options, breaking, push.run);
      CAPTURE(std::string(status_text(status)));
      CAPTURE(breaking.break_force);
      if (status == Status::solved)
        CHECK(breaking.break_force == doctest::Approx(17.32051).epsilon(0.01));
      else
        CHECK(status == Status::numerical_breakdown);
    }
}
