// One law, one test case, computed by hand in SI units on a crooked scene.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "lcpush/mechanics/model/laws.hpp"
#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

const Scales<double> scales{20, 0.05, 100}; // force, length, acceleration: mass 0.2

/// No number is 0 or 1, the inertia has products.
Scene3 crooked() {
  Scene3 scene = bare_scene(0.2, {3e-4, 4e-4, 5e-4}, {1, -9, 2});
  scene.base.object.inertia(0, 1) = scene.base.object.inertia(1, 0) = 1e-4;
  scene.base.object.inertia(1, 2) = scene.base.object.inertia(2, 1) = -0.5e-4;
  scene.add_body(Role::finger, {1, 2, -2}, 0.4, {{0.01, 0.02, 0.03}, {-0.02, 0.01, 0.03}});
  scene.bodies.back().acceleration << 0.3, -0.2, 0.5, 3, 1, -2;
  Vector6<double> twist;
  twist << 0.6, 0.7, -0.4, 5, -3, 2;
  scene.drives.push_back({0, 0, twist});
  scene.actuators.push_back({7, 0.3});
  return scene;
}

double force_along(const Vec3& u, const Vec3& acceleration) { return u.dot(acceleration); }

Vec3 point_acceleration(const Vector6<double>& twist, const Vec3& p) {
  return twist.head<3>() + twist.tail<3>().cross(p);
}

} // namespace

TEST_CASE("[T.1] Newton: the mobility turns a wrench into the acceleration that M a = w gives") {
  const Scene3 owned = crooked();
  const Scene<double> scene = owned.view();
  Vector6<double> wrench; // N, N m
  wrench << 1, -2, 3, 0.04, 0.05, -0.06;
  Vector6<double> scaled = wrench / scales.force;
  scaled.tail<3>() /= scales.length;
  Vector6<double> a = laws::newton(scene, scales) * scaled * scales.acceleration;
  a.tail<3>() /= scales.length;
  CHECK((scene.object.mass * a.head<3>() - wrench.head<3>()).norm() <= 1e-14);
  CHECK((scene.object.inertia * a.tail<3>() - wrench.tail<3>()).norm() <= 1e-15);
  const Vector6<double> weight = laws::load(scene, scales);
  CHECK((weight.head<3>() * scales.force - 0.2 * Vec3(1, -9, 2)).norm() <= 1e-15);
  CHECK(weight.tail<3>().isZero(0));
  Scene<double> pulled = scene;
  pulled.object.wrench = wrench;
  CHECK((laws::load(pulled, scales) - weight - scaled).norm() <= 1e-15);
}

TEST_CASE("[T.2] normal: the column is n and its moment, the row is the opening acceleration") {
  const Scene3 owned = crooked();
  const Body<double>& body = owned.bodies[0];
  for (const Vec3& p : owned.points) {
    const Vector6<double> column = laws::normal_direction(body, p, scales);
    CHECK((column.head<3>() - body.normal).norm() <= 1e-15);
    CHECK((column.tail<3>() * scales.length - p.cross(body.normal)).norm() <= 1e-16);
    Vector6<double> a;
    a << 0.4, -1, 2, 10, 20, -30;
    Vector6<double> scaled = a / scales.acceleration;
    scaled.tail<3>() *= scales.length;
    const double opening = column.dot(scaled) * scales.acceleration;
    CHECK(opening == doctest::Approx(force_along(body.normal, point_acceleration(a, p))));
  }
}

TEST_CASE("[T.3] dissipation: the columns are the generators and their moments") {
  const Scene3 owned = crooked();
  const Body<double>& body = owned.bodies[0];
  const Index g = 8;
  for (const Vec3& p : owned.points)
    for (Index j = 0; j < g; ++j) {
      const Vec3 d = generator(body, j, g).force;
      const Vector6<double> column =
          laws::friction_direction(body, p, generator(body, j, g), scales);
      CHECK((column.head<3>() - d).norm() <= 1e-15);
      CHECK((column.tail<3>() * scales.length - p.cross(d)).norm() <= 1e-16);
    }
  const Vector6<double> A_b = laws::prescribed(body, scales);
  CHECK((A_b.head<3>() * scales.acceleration - body.acceleration.head<3>()).norm() <= 1e-15);
  CHECK(
      (A_b.tail<3>() * scales.acceleration / scales.length - body.acceleration.tail<3>()).norm() <=
      1e-14);
}

TEST_CASE("[T.4] friction cone: mu lambda - sum beta in one row, xi in every generator's") {
  const Scene3 owned = crooked();
  const Index g = 6;
  const ConeGroup<double> group = laws::friction_cone(owned.bodies[0], g, 0, 0);
  CHECK(group.size() == g + 2);
  CHECK(group.slip() == g + 1);
  std::vector<Vector6<double>> none(static_cast<std::size_t>(g + 1), Vector6<double>::Zero());
  FactoredProblem<double> factored{};
  factored.mobility.setIdentity();
  factored.wrenches = {none.data(), g + 1};
  factored.cones = {&group, 1};
  Problem<double> problem;
  problem.size = problem.free_begin = g + 2;
  problem.factored = &factored;
  VectorX<double> z(g + 2), out(g + 2);
  z << 10, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 5; // lambda, six beta, xi
  multiply(problem, z.data(), out.data());
  CHECK(out[group.slip()] == doctest::Approx(0.4 * 10 - 2.1));
  for (Index j = 1; j <= g; ++j) CHECK(out[j] == 5);
  CHECK(out[0] == 0);
}

TEST_CASE("[T.5] grip force: the power of the contact forces per unit of the actuator") {
  const Scene3 owned = crooked();
  const Scene<double> scene = owned.view();
  const double reach = 1.7;
  const SumGroup<double> sum = laws::grip_force(scene, 0, reach, scales);
  // In SI: sum J'f + m_a s - tau, with s = s_scaled acceleration / reach; the row is in F reach.
  CHECK(sum.target * scales.force * reach == doctest::Approx(7));
  CHECK(sum.inertia * scales.force * reach / (scales.acceleration / reach) == doctest::Approx(0.3));
  for (const Vec3& p : owned.points) {
    const Vec3 u = owned.bodies[0].normal;
    const Vector6<double> column = laws::normal_direction(owned.bodies[0], p, scales);
    const double power = u.dot(point_acceleration(owned.drives[0].twist, p));
    CHECK(laws::grip_coefficient(owned.drives[0], column, reach, scales) * reach ==
          doctest::Approx(power));
  }
}

TEST_CASE("[T.6] patch rigidity: zero for every rigid motion, the stretching rate otherwise") {
  Random random(6);
  for (int k = 0; k < 50; ++k) {
    const Vec3 p = random_vector(random, 3), r = random_vector(random, 3);
    const Vector6<double> twist = random_vector(random, 6);
    CHECK(absolute(laws::patch_rigidity<double>(p, point_acceleration(twist, p), r,
                                                point_acceleration(twist, r))) <= 1e-14);
    const Vec3 apart = (p - r).normalized();
    const Vec3 stretched = point_acceleration(twist, p) + 0.3 * apart;
    CHECK(laws::patch_rigidity<double>(p, stretched, r, point_acceleration(twist, r)) ==
          doctest::Approx(0.3));
  }
}

TEST_CASE("[T.16] round friction: an inertia across the slip resists what turns it") {
  Scene3 owned = crooked();
  for (const double torsion_radius : {0.0, 0.007}) {
    Body<double>& body = owned.bodies[0];
    body.torsion_radius = torsion_radius;
    const Scene<double> scene = owned.view();
    const bool is_soft = torsion_radius > 0;
    LinearizedCone<double> round_cone;
    round_cone.along = Vec3(0.6, -0.7, is_soft ? 0.5 : 0).normalized();
    round_cone.body_motion = {0.1, 0.2, is_soft ? -0.3 : 0};
    round_cone.inertia = 3;
    const Vec3 p = scene.points[0];
    Matrix6<double> B = laws::newton(scene, scales);
    Vector6<double> wrench, load = laws::load(scene, scales);
    wrench << 1, -2, 3, 0.4, 0.5, -0.6;
    laws::round_cone(body, p, round_cone, scene.object.mass, scales, B, load);
    Vector6<double> a = B * (wrench + load) * scales.acceleration; // as a round solves for it
    a.tail<3>() /= scales.length;

    // M a = w + contact forces + the resistance - k (1 - u u') (v - c), by hand.
    const Vec3 t = body.tangent, o = body.normal.cross(t), r = point_acceleration(a, p);
    Vec3 v(r.dot(t), r.dot(o), torsion_radius * a.tail<3>().dot(body.normal));
    v -= round_cone.body_motion;
    Vec3 resists = -3 * (v - round_cone.along * round_cone.along.dot(v));
    if (!is_soft) resists[2] = 0;
    CHECK((laws::resisting_force(body, p, round_cone, a) - resists).norm() <=
          1e-12 * resists.norm());
    const Vec3 force = resists[0] * t + resists[1] * o;
    const Vec3 moment = p.cross(force) + torsion_radius * resists[2] * body.normal;
    const Vec3 pushed = scales.force * wrench.head<3>() + 0.2 * scene.gravity + force;
    const Vec3 turned = scales.force * scales.length * wrench.tail<3>() + moment;
    CHECK((0.2 * a.head<3>() - pushed).norm() <= 1e-12 * pushed.norm());
    CHECK((scene.object.inertia * a.tail<3>() - turned).norm() <= 1e-11 * turned.norm());
  }
}
