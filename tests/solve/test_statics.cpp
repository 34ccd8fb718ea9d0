// [T.12] Statics of files: the smallest factor on the grip forces, against closed forms and solved
// scenes.
#include "support/fixture_push.hpp"

#include <cmath>

#include "dense/simplex.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"
#include "solve/grip_statics.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double none_holds = std::numeric_limits<double>::infinity();

/// Of the grip; it has to be known.
double least_factor(const Scene3& scene) {
  const desktop::SceneFile file = file_of(scene);
  const std::optional<double> factor = desktop::least_factor(desktop::GripStatics(file));
  REQUIRE(factor);
  return *factor;
}

/// [T.12] as it stands, by the simplex method: forces, phi, and what is left of the cones.
double literal_program(const Scene3& scene) {
  const Scene<double> view = scene.view();
  OwnedWorkspace<double> memory(size_of(view));
  Assembly<double> assembly(memory.work.assembly);
  REQUIRE(assembly.assemble(view) == Status::running);
  const Layout<double>& layout = assembly.layout();
  const FactoredProblem<double>& f = assembly.factored();
  const Index phi = layout.forces, rows = 6 + layout.actuators;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows + layout.points, phi + 1 + layout.points);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(A.rows());
  b.head<6>() = -laws::load(assembly.scene(), layout.scales);
  for (Index i = 0; i < layout.points; ++i) {
    for (Index k = 0; k < layout.cones[i].forces(); ++k) {
      const Index j = layout.cones[i].force + k;
      A.col(j).head<6>() = f.wrenches[j];
      A(rows + i, j) = k == 0 ? layout.cones[i].friction : -1;
    }
    A(rows + i, phi + 1 + i) = -1;
  }
  for (Index a = 0; a < layout.actuators; ++a) {
    A(6 + a, phi) = -f.sums[a].target;
    for (Index k = f.sums[a].first; k < f.sums[a].first + f.sums[a].count; ++k) {
      const Index variable = f.coupled_variable[k];
      const ConeGroup<double>& cone = layout.cones[cone_of(layout.cones, variable)];
      A(6 + a, cone.force + variable - cone.variable) += f.coupling[k];
    }
  }
  desktop::Simplex program(A, b, 0);
  using Ending = desktop::Simplex::Ending;
  if (program.find_point() == Ending::none) return none_holds;
  REQUIRE(program.minimise(Eigen::VectorXd::Unit(A.cols(), phi)) == Ending::found);
  return program.point()[phi];
}

/// A cube of 1 kg pinched at its centre from z = +-1 cm.
Scene3 pinched(const Vec3& gravity, double friction, double F,
               const std::vector<Vec3>& pads = {Vec3::Zero()}) {
  Scene3 scene = bare_scene(1, Vec3::Constant(1e-4), gravity);
  add_pinch(scene, pads, 0.01, friction, F);
  return scene;
}

void add_point(Scene3& scene, Role role, const Vec3& normal, double friction, const Vec3& at) {
  scene.add_body(role, normal, friction, {at});
}

/// Does the scene itself, solved under its own law, stay at rest with this factor on all forces?
bool stays(Scene3 scene, double factor) {
  for (Actuator<double>& actuator : scene.actuators) actuator.force *= factor;
  SolvedPush<double> push(scene);
  REQUIRE(push.solve(0) == Status::solved);
  return motion_size(push.answer().acceleration, push.scales()) <= 1e-9;
}

} // namespace

TEST_CASE("[T.12] two opposite points hold m g across them with F = m g / (2 mu)") {
  for (const double mu : {0.1, 0.5, 2.0})
    for (const double F : {1e-3, 20.0, 1e5}) {
      CHECK(least_factor(pinched({0, -9.81, 0}, mu, F)) * F ==
            doctest::Approx(9.81 / (2 * mu)).epsilon(1e-9));
    }
}

TEST_CASE("[T.12] between two generators the pyramid gives cos(pi / g) of the friction") {
  const double angle = 3.14159265358979323846 / 8;
  const Vec3 gravity(9.81 * std::sin(angle), 9.81 * std::cos(angle), 0);
  CHECK(least_factor(pinched(gravity, 0.5, 20)) * 20 ==
        doctest::Approx(9.81 / std::cos(angle)).epsilon(1e-9));
}

TEST_CASE("[T.12] what a stop carries needs no grip") {
  Scene3 scene = pinched({0, -9.81, 0}, 0.5, 20);
  add_point(scene, Role::finger, {0, 1, 0}, 0, {0, -0.01, 0});
  CHECK(least_factor(scene) <= 1e-12);
}

TEST_CASE("[T.12] no grip force holds without friction, or away from a one-sided contact") {
  CHECK(least_factor(pinched({0, -9.81, 0}, 0, 20)) == none_holds);
  Scene3 one = bare_scene(1, Vec3::Constant(1e-4), {0, -9.81, 0});
  add_point(one, Role::finger, {0, -1, 0}, 0.5, {0, 0.01, 0});
  one.drive_last_body(5);
  CHECK(least_factor(one) == none_holds);
  one.bodies.back().bilateral = true; // it pulls, but only with its own force
  CHECK(least_factor(one) == none_holds);
  one.actuators.back().force = -5;
  CHECK(least_factor(one) == doctest::Approx(9.81 / 5).epsilon(1e-9));
}

TEST_CASE(
    "[T.12] weight along the squeeze cannot be held by equal forces, but in the plane it need "
    "not be") {
  Scene3 scene = pinched({0, -9.81, -5}, 0.5, 20);
  CHECK(least_factor(scene) == none_holds);
  scene.base.planar = true;
  CHECK(least_factor(scene) * 20 == doctest::Approx(9.81).epsilon(1e-9));
}

TEST_CASE("[T.12] below the factor a patch slips too, whatever its pressure") {
  const double r = 0.005, h = 0.02, mu = 0.5, F = 20;
  std::vector<Vec3> pads = ring(4, r);
  for (Vec3& p : pads) p[0] += h;
  const Scene3 scene = pinched({0, -9.81, 0}, mu, F, pads);
  const double factor = least_factor(scene);
  CHECK(factor * F > 9.81 / (2 * mu));
  CHECK_FALSE(stays(scene, factor * (1 - 1e-6)));
}

TEST_CASE("[T.12] a pusher at rest carries what it can; a force-controlled one is a load") {
  Scene3 scene = pinched({0, -9.81, 0}, 0.5, 20);
  add_point(scene, Role::pusher, {0, 1, 0}, 0, {0, -0.01, 0});
  CHECK(least_factor(scene) <= 1e-12);
  scene.drive_last_body(15); // lifts with 15 N against 9.81 N
  CHECK(least_factor(scene) * 20 == doctest::Approx(15 - 9.81).epsilon(1e-9));
}

TEST_CASE("[T.12] parallel jaws share the sum of their forces") {
  Scene3 scene = pinched({0, 0, 0}, 0.5, 20);
  scene.base.gravity = {0, -9.81, 3}; // 3 N along the squeeze, carried by the gear
  scene.actuators = {{40, 0}};
  for (Drive<double>& drive : scene.drives) drive.actuator = 0;
  // The lighter side is left with (sum - 3) / 2, and equal friction on both holds the weight.
  CHECK(least_factor(scene) * 40 == doctest::Approx(9.81 / 0.5 + 3).epsilon(1e-9));
}

TEST_CASE("[T.12] without a load nothing is needed") {
  CHECK(least_factor(pinched({0, 0, 0}, 0.5, 20)) == 0);
}

TEST_CASE("[T.12] by the cones' rays it is the literal program's value, or neither has one") {
  Index held_at_some = 0, hopeless = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Vec3 down(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    Scene3 scene = pinched(9.81 * down, random.uniform(0.1, 1.2), random.uniform(1, 50),
                           {{0.004, 0, 0}, {-0.002, 0.003, 0}, {0, -0.003, 0}});
    scene.base.facets = 2 * random.integer(2, 8);
    if (seed % 3 == 0) scene.actuators[0].force *= random.uniform(0.5, 1);
    add_point(scene, Role::pusher, {1, 0, 0}, random.uniform(0, 1.2), {-0.01, 0.002, 0});
    const double factor = literal_program(scene), found = least_factor(scene);
    ++(factor == none_holds ? hopeless : held_at_some);
    if (factor == none_holds)
      CHECK(found == none_holds);
    else
      CHECK(found == doctest::Approx(factor).epsilon(2e-7));
  }
  CHECK(held_at_some >= 100);
  CHECK(hopeless >= 20);
}

TEST_CASE("[T.12] random grasps with known normal forces hold just above the factor, not below") {
  Index compared = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Vec3 down(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    Scene3 scene = pinched(9.81 * down, random.uniform(0.1, 1.2), random.uniform(1, 50));
    scene.base.facets = 2 * random.integer(2, 8);
    // A third finger across the pinch, and a fourth against it, a little off its line.
    const double third = random.uniform(1, 50);
    add_point(scene, Role::finger, {-1, 0, 0}, random.uniform(0.1, 1.2), {0.01, 0, 0});
    scene.drive_last_body(third);
    add_point(scene, Role::finger, {1, 0, 0}, random.uniform(0.1, 1.2),
              {-0.01, random.uniform(-0.001, 0.001), 0});
    scene.drive_last_body(third * random.uniform(0.8, 1.2));
    scene.base.pressure = Pressure::rigid;
    const double least = least_factor(scene);
    if (least == none_holds) { // then no multiple of the forces may stay
      for (const double factor : {0.1, 1.0, 10.0, 1000.0}) CHECK_FALSE(stays(scene, factor));
      continue;
    }
    REQUIRE(motion_is_determined(scene.view())); // by [T.9] the solve has no choice
    CHECK(stays(scene, least * (1 + 1e-6)));
    CHECK_FALSE(stays(scene, least * (1 - 1e-3)));
    ++compared;
  }
  CHECK(compared >= 100);
}
