// The examples of docs/theory/theory.md 5.6 that bound the lemma's statement, each run.
#include <doctest/doctest.h>

#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

const Vec3 small_inertia = Vec3(2e-4, 2e-4, 2e-4), weightless = Vec3::Zero();

Scene3 bare(Pressure pressure) {
  Scene3 scene = bare_scene(0.2, small_inertia, weightless);
  scene.base.pressure = pressure;
  return scene;
}

/// A stop on the right and a pusher on the left of a part, moving as told.
Scene3 stop_and_pusher(const Vec3& motion, double offset, Pressure pressure) {
  Scene3 scene = bare(pressure);
  scene.add_body(Role::finger, {-1, 0, 0}, 0.5, {{0.02, 0, 0}});
  scene.add_body(Role::pusher, {1, 0, 0}, 0.5, {{-0.02, offset, 0}});
  scene.bodies.back().acceleration.head<3>() = motion;
  return scene;
}

/// A finger whose actuator moves it along `twist` only.
Scene3 driven_along(const Vec3& twist, double force, double actuator_inertia) {
  Scene3 scene = bare(Pressure::rigid);
  scene.add_body(Role::finger, {0, 0, -1}, 0.6, {{0, 0, 0.01}});
  scene.add_body(Role::finger, {0, 0, 1}, 0.6, {{0, 0, -0.01}});
  scene.drive_last_body(5);
  Vector6<double> J = Vector6<double>::Zero();
  J.head<3>() = twist;
  scene.drives.push_back({0, 1, J});
  scene.actuators.push_back({force, actuator_inertia});
  return scene;
}

Scene3 lever() {
  Scene3 scene = bare(Pressure::rigid);
  scene.add_body(Role::finger, {0, 1, 0}, 0, {{-0.045, -0.002, 0}});
  scene.add_body(Role::finger, {0, -1, 0}, 0, {{0.053, 0.002, 0}});
  scene.drive_last_body(1);
  scene.add_body(Role::pusher, {0, -1, 0}, 0, {{-0.046, 0.002, 0}});
  scene.bodies.back().acceleration[1] = -1;
  scene.base.planar = true;
  return scene;
}

constexpr Pressure both_laws[] = {Pressure::pad, Pressure::rigid};

} // namespace

TEST_CASE("[T.8] a pusher against a stop is a jam: a ray that names both normals and no friction") {
  for (const Pressure pressure : both_laws) {
    SolvedPush<double> push(stop_and_pusher({0.1, 0, 0}, 0, pressure));
    REQUIRE(push.solve() == Status::ray);
    const Layout<double>& layout = push.assembly.layout();
    for (Index i = 0; i < layout.size; ++i)
      CHECK((push.lemke.ray()[i] > 1e-9) ==
            (i == layout.normal_index(0) || i == layout.normal_index(1)));
    CHECK(push.lemke.ray_artificial() <= 1e-12);
  }
}

TEST_CASE("[T.8] (H2) is not necessary: a sideways push in both cones is solved") {
  for (const Pressure pressure : both_laws) {
    SolvedPush<double> push(stop_and_pusher({0, 0.1, 0}, 0.01, pressure));
    REQUIRE(push.solve() == Status::solved);
    CHECK(push.residuals.max() <= 1e-9);
  }
}

TEST_CASE("[T.8] (H1) fails: a massless actuator across the normal runs away, one with mass not") {
  const double slides = 0.6 * 5; // what friction holds
  SolvedPush<double> runs(driven_along(Vec3::UnitX(), slides + 1, 0));
  CHECK(runs.solve() == Status::ray);
  CHECK(runs.lemke.ray()[runs.assembly.layout().closing_index(1)] > 0);
  SolvedPush<double> heavy(driven_along(Vec3::UnitX(), slides + 1, 0.1));
  REQUIRE(heavy.solve() == Status::solved);
  CHECK(heavy.residuals.max() <= 1e-9);
  CHECK(heavy.answer().closing[1] > 0);
}

TEST_CASE("[T.8] an oblique drive beyond the friction angle locks itself against a push") {
  for (const double across : {1.0, 2.0}) { // times mu = 0.6: below and above 1
    CAPTURE(across);
    Scene3 scene = bare(Pressure::rigid);
    scene.add_body(Role::finger, {-1, 0, 0}, 0.6, {{0.02, 0, 0}});
    Vector6<double> J = Vector6<double>::Zero();
    J.head<3>() << -1, across, 0;
    scene.drives.push_back({0, 0, J});
    scene.actuators.push_back({1, 0});
    scene.add_body(Role::pusher, {1, 0, 0}, 0.6, {{-0.02, 0, 0}});
    scene.bodies.back().acceleration[0] = 0.1;
    scene.add_body(Role::finger, {0, -1, 0}, 0, {{-0.01, 0.02, 0}, {0.01, 0.02, 0}});
    scene.add_body(Role::finger, {0, 1, 0}, 0, {{-0.01, -0.02, 0}, {0.01, -0.02, 0}});
    SolvedPush<double> push(scene);
    CHECK(push.solve() == (across * 0.6 < 1 ? Status::solved : Status::ray));
  }
}

TEST_CASE("[T.8] a lever of 1 : 98 needs a bound above 98: the symbolic one has it, 97 rays") {
  SolvedPush<double> push(lever());
  REQUIRE(push.solve() == Status::solved);
  CHECK(push.answer().closing[0] == doctest::Approx(-98));

  // The same problem with the finite bound S: s = s' - S, s' >= 0.
  const Problem<double> free = push.assembly.problem();
  DenseLcp<double> bounded{MatrixX<double>(free.size, free.size), VectorX<double>(free.size)};
  fill_matrix(free, MatrixMap<double>(bounded.M.data(), free.size, free.size));
  for (const double S : {97.0, 99.0}) {
    CAPTURE(S);
    const Index s = push.assembly.layout().closing_index(0);
    const double unit = push.scales().acceleration / push.assembly.layout().reach[0];
    for (Index i = 0; i < free.size; ++i) bounded.q[i] = free.q[i] - bounded.M(i, s) * S / unit;
    std::vector<double> scalars(static_cast<std::size_t>(lemke_scalars(free.size)));
    std::vector<int> integers(static_cast<std::size_t>(lemke_integers(free.size)));
    Lemke<double> lemke({scalars.data(), static_cast<Index>(scalars.size())},
                        {integers.data(), static_cast<Index>(integers.size())});
    REQUIRE(lemke.init(bounded.view()) == Status::running);
    CHECK(lemke.solve() == (S < 98 ? Status::ray : Status::solved));
  }
}

TEST_CASE("[T.8] in a plane, a push out of it is a jam of one contact") {
  Scene3 scene = bare(Pressure::rigid);
  scene.base.planar = true;
  scene.add_body(Role::pusher, {0, 0, -1}, 0.5, {{0, 0, 0.01}});
  scene.bodies.back().acceleration[2] = -0.1;
  SolvedPush<double> push(scene);
  CHECK(push.solve() == Status::ray);
}

TEST_CASE("[T.8] compliance hides a jam: the pads alone press on without end") {
  Scene3 scene = bare(Pressure::pad);
  const std::vector<Vec3> at = {
      {0, 0.01, 0.01}, {0, 0.01, -0.01}, {0, -0.01, 0.01}, {0, -0.01, -0.01}};
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec3> points = at;
    for (Vec3& p : points) p[0] = -0.02 * side;
    scene.add_body(side > 0 ? Role::pusher : Role::finger, {side, 0, 0}, 0.3, points);
  }
  scene.bodies.back().acceleration[0] = 0.1;
  SolvedPush<double> push(scene);
  CHECK(push.solve() == Status::ray);
  // What the last round that was solved has left.
  CHECK(push.memory.work.pressure.z[push.assembly.layout().normal_index(0)] > 100);
  CHECK(push.run.jammed);
}
