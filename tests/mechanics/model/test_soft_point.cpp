// Soft points: friction generators that twist, and the torque of patches that they stand for.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "lcpush/mechanics/model/laws.hpp"
#include "lcpush/mechanics/model/patch.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"
#include "support/dense_lcp.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double mu = 0.5, F = 20, R = 0.005;

Body<double> soft_body(double radius) {
  Body<double> body{};
  body.normal = Vec3(1, 2, -2) / 3;
  body.tangent = Vec3(2, 1, 2) / 3;
  body.friction = mu;
  body.torsion_radius = radius;
  return body;
}

/// (f_t, f_o, torque / r) of generator k.
Vec3 on_sphere(const Body<double>& body, Index k, Index g) {
  const Generator<double> d = generator(body, k, g);
  return {d.force.dot(body.tangent), d.force.dot(cross(body.normal, body.tangent)),
          d.torque / body.torsion_radius};
}

/// Torque that a pinch holds against a pure couple: two opposite pushers without friction, turning
/// about the grip. Both fingers together, N m.
double couple(const Scene3& pinch) {
  constexpr double lever = 0.04, alpha = 2;
  Scene3 scene = pinch;
  for (const double side : {1.0, -1.0}) {
    scene.add_body(Role::pusher, {side, 0, 0}, 0, {{-0.05 * side, lever * side, 0}});
    scene.bodies.back().acceleration[5] = -alpha;
  }
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  CHECK(push.residuals.max() <= exact);
  CHECK(push.answer().acceleration[5] == doctest::Approx(-alpha));
  const Index pushers = push.scene.bodies.size - 2;
  const double inertia = scene.base.object.inertia(2, 2) * alpha;
  return lever * (push.normal_force(pushers) + push.normal_force(pushers + 1)) - inertia;
}

Scene3 pinch(const std::vector<Vec3>& at, Pressure pressure) {
  Scene3 scene = bare_scene(0.2, {2e-4, 2e-4, 3e-4}, Vec3::Zero());
  scene.base.facets = 16;
  scene.base.pressure = pressure;
  scene.base.planar = pressure == Pressure::even;
  add_pinch(scene, at, 0.005, mu, F);
  return scene;
}

std::vector<Vec3> pad_of(Index k) {
  std::vector<Vec3> points(static_cast<std::size_t>(k));
  sample_disc<double>(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), R, {points.data(), k});
  return points;
}

/// Both fingertips of a pinch are discs.
Scene3 disc_pinch(Index k, Pressure pressure) {
  Scene3 scene = pinch(pad_of(k), pressure);
  scene.weights.resize(2 * static_cast<std::size_t>(k));
  disc_weights<double>({scene.weights.data(), k});
  disc_weights<double>({scene.weights.data() + k, k});
  return scene;
}

} // namespace

TEST_CASE("[T.3] a soft point has 5 g + 2 generators, opposite in pairs, on the ellipsoid") {
  const Body<double> body = soft_body(0.01);
  Scene<double> scene{};
  for (const Index g : {4, 6, 8, 16}) {
    scene.facets = g;
    const Index count = generator_count(scene, body);
    CHECK(count == 5 * g + 2);
    for (Index k = 0; k < count; ++k) {
      const Vec3 d = on_sphere(body, k, g);
      CHECK(d.norm() == doctest::Approx(1));
      CHECK(absolute(generator(body, k, g).force.dot(body.normal)) <= 1e-15);
      Index opposite = 0;
      for (Index l = 0; l < count; ++l)
        if (on_sphere(body, l, g) == -d) ++opposite;
      CHECK(opposite == 1);
    }
  }
}

TEST_CASE("[T.4] the soft polyhedron reaches at worst as far as docs/theory/theory.md says") {
  const Body<double> body = soft_body(0.01);
  for (const Index g : {4, 8, 16}) {
    CAPTURE(g);
    const double c = std::cos(3.14159265358979 / static_cast<double>(g)), k = 2 - std::sqrt(3.0);
    const double least = c / std::sqrt(1 + c * c * k * k);
    Random random(5);
    double worst = 1;
    for (int trial = 0; trial < 20000; ++trial) {
      const Vec3 u = random_vector(random, 3).normalized();
      double reach = 0;
      for (Index j = 0; j < soft_generators(g); ++j)
        reach = std::max(reach, u.dot(on_sphere(body, j, g)));
      worst = std::min(worst, reach);
    }
    // A facet's distance is the least reach over the directions; random ones come close to it.
    CHECK(worst >= least - 1e-12);
    CHECK(worst <= least + 0.01);
  }
}

TEST_CASE("[T.3] a soft generator's column holds its torque, its row the spin") {
  const Body<double> body = soft_body(0.01);
  const Vec3 p(0.01, 0.02, 0.03);
  for (const Index k : {3, 11, 30, 40, 41}) { // g = 8
    const Generator<double> d = generator(body, k, 8);
    const Vector6<double> column = laws::friction_direction(body, p, generator(body, k, 8), scales);
    const Vec3 moment = p.cross(d.force) + d.torque * body.normal;
    CHECK((column.head<3>() - d.force).norm() <= 1e-15);
    CHECK((column.tail<3>() * scales.length - moment).norm() <= 1e-16);
  }
}

TEST_CASE("against a pure couple a ring holds 2 mu F R and a disc tends to 2 * 2/3 mu F R") {
  constexpr double pi = 3.14159265358979, of_ring = 2 * mu * F * R, of_disc = of_ring * 2 / 3;
  for (const Pressure pressure : {Pressure::pad, Pressure::even}) {
    for (const Index k : {4, 16}) // their slips lie along generators
      CHECK(absolute(couple(pinch(ring(k, R), pressure)) - of_ring) <= exact * of_ring);
    for (const Index k : {5, 6, 7, 9}) {
      const double torque = couple(pinch(ring(k, R), pressure));
      CHECK(torque >= of_ring * std::cos(pi / 16) * (1 - exact));
      CHECK(torque <= of_ring * (1 + exact));
    }
    for (const Index k : {3, 8, 12, 32}) {
      const double torque = couple(disc_pinch(k, pressure));
      CHECK(torque >= of_disc * std::cos(pi / 16) * (1 - exact));
      CHECK(torque <= of_disc * (1 + exact));
    }
  }
}

TEST_CASE("a spinning soft point slides, a held one sticks, and torsion is its moment") {
  for (const double push_force : {0.5, 2.0}) { // of what the grip holds
    Scene3 scene = pinch({Vec3::Zero()}, Pressure::pad);
    for (Body<double>& body : scene.bodies) body.torsion_radius = 2 * R / 3;
    const double holds = 2 * 2.0 / 3 * mu * F * R, lever = 0.04;
    for (const double side : {1.0, -1.0}) {
      scene.add_body(Role::pusher, {side, 0, 0}, 0, {{-0.05 * side, lever * side, 0}});
      scene.drive_last_body(push_force * holds / (2 * lever));
    }
    SolvedPush<double> push(scene);
    REQUIRE(push.solve() == Status::solved);
    double torque = 0;
    for (Index b = 0; b < 2; ++b) {
      const ContactAnswer<double>& tip = push.answer().contacts[b];
      const Vec3 n = push.scene.bodies[b].normal, moment = push.wrench(b).tail<3>();
      CHECK(tip.mode == (push_force > 1 ? Mode::slide : Mode::stick));
      CHECK((absolute(tip.spin) > 1) == (push_force > 1));
      CHECK(moment.dot(n) == doctest::Approx(tip.torsion));
      torque += moment[2];
    }
    CHECK(absolute(torque) == doctest::Approx(holds * std::min(push_force, 1.0)));
  }
}

TEST_CASE("the referee sees a torsion outside the polyhedron and one that helps the spin") {
  Scene3 scene = grasp_of<double>(Family::soft, 3);
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  REQUIRE(push.residuals.max() <= exact);
  for (Index i = 0; i < 2; ++i) {
    ContactAnswer<double>& tip = push.memory.work.answer.contacts[i];
    const ContactAnswer<double> right = tip;
    tip.torsion += 1e-6 * push.scales().force * push.scales().length;
    const Residuals<double> residuals = check(push.scene, push.scales(), push.answer(), 1.0);
    CHECK(residuals.cone > exact);
    CHECK(residuals.newton > exact);
    tip = right;
  }
  // Only the spin differs: the grip turns the other way about the fingers' common normal.
  push.memory.work.answer.acceleration[5] += 1e-3 * push.scales().acceleration;
  CHECK(check(push.scene, push.scales(), push.answer(), 1.0).dissipation > exact);
}

TEST_CASE("[T.9] a soft point whose actuator turns it has no known normal force") {
  Scene3 scene = pinch({Vec3::Zero()}, Pressure::rigid);
  CHECK(motion_is_determined(scene.view()));
  for (Body<double>& body : scene.bodies) body.torsion_radius = R;
  CHECK(motion_is_determined(scene.view()));
  scene.drives[0].twist.tail<3>() = 200 * scene.bodies[0].normal; // a screw's
  CHECK_FALSE(motion_is_determined(scene.view()));
  scene.bodies[0].torsion_radius = 0; // a hard point does not feel the turn
  CHECK(motion_is_determined(scene.view()));
}
