// The paper's matrices mean what their comments say, in SI units.
#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "support/contact_generators.hpp"
#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

MatrixMap<double> map_of(MatrixX<double>& A) { return {A.data(), A.rows(), A.cols()}; }

double worst_of(const MatrixX<double>& A) { return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff(); }

/// A random grasp with a soft, a bilateral and a frictionless body now and then, and drives that
/// turn and shift their bodies.
Scene3 some_scene(std::uint64_t seed) {
  Scene3 scene = random_grasp<double>(seed);
  Random random(seed + 9);
  for (Body<double>& body : scene.bodies) {
    if (random.integer(0, 2) == 0) body.torsion_radius = random.uniform(0.001, 0.01);
    if (random.integer(0, 2) == 0) body.bilateral = true;
    if (random.integer(0, 3) == 0) body.friction = 0;
    body.normal = (body.normal + 0.4 * Vec3(random_vector(random, 3))).normalized();
    body.tangent = body.normal.cross(Vec3(random_vector(random, 3))).normalized();
  }
  for (Drive<double>& drive : scene.drives) drive.twist = random_vector(random, 6);
  for (const Index body : {0, 2}) scene.drives.push_back({body, 0, random_vector(random, 6)});
  return scene;
}

struct Matrices {
  Scene<double> scene;
  MatrixX<double> G, G_bar, J, E;

  explicit Matrices(const Scene<double>& given)
      : scene(given), G(6, contact_components(scene)), G_bar(6, force_count(scene)),
        J(contact_components(scene), scene.actuators.size), E(contact_generators(scene)) {
    grasp_matrix(scene, map_of(G));
    polyhedral_grasp_matrix(scene, map_of(G_bar));
    hand_jacobian(scene, map_of(J));
  }
};

/// The components of a vector at a point, and of a moment or spin if it is soft.
void append(std::vector<double>& all, const Body<double>& body, const Vec3& v, const Vec3& turn) {
  for (const Vec3& u : {body.normal, body.tangent, Vec3(body.normal.cross(body.tangent))})
    all.push_back(v.dot(u));
  if (body.torsion_radius > 0) all.push_back(turn.dot(body.normal));
}

VectorX<double> as_vector(const std::vector<double>& all) {
  return Eigen::Map<const VectorX<double>>(all.data(), static_cast<Index>(all.size()));
}

} // namespace

TEST_CASE("G f is the wrench of the contact forces") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Scene3 owned = some_scene(seed);
    const Matrices m(owned.view());
    Random random(seed);
    Vector6<double> wrench = Vector6<double>::Zero();
    std::vector<double> f;
    for (const Body<double>& body : m.scene.bodies)
      for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
        const Vec3 force = random_vector(random, 3);
        const double moment = body.torsion_radius > 0 ? random.uniform(-1, 1) : 0;
        append(f, body, force, moment * body.normal);
        wrench.head<3>() += force;
        wrench.tail<3>() += m.scene.points[i].cross(force) + moment * body.normal;
      }
    CHECK(worst_of(m.G * as_vector(f) - wrench) <= rounding * (1 + wrench.norm()));
  }
}

TEST_CASE("G' A is the acceleration of the contact points") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Scene3 owned = some_scene(seed);
    const Matrices m(owned.view());
    Random random(seed);
    const Vector6<double> A = random_vector(random, 6);
    std::vector<double> r;
    for (const Body<double>& body : m.scene.bodies)
      for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
        append(r, body, acceleration_at<double>(m.scene.points[i], A), A.tail<3>());
    CHECK(worst_of(m.G.transpose() * A - as_vector(r)) <= rounding);
  }
}

TEST_CASE("J is how the bodies' points move when the actuators move: finite displacements") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Scene3 owned = some_scene(seed);
    const Matrices m(owned.view());
    for (Index a = 0; a < m.scene.actuators.size; ++a) {
      std::vector<double> moved;
      for (Index b = 0; b < m.scene.bodies.size; ++b) {
        Vector6<double> twist = Vector6<double>::Zero();
        for (const Drive<double>& drive : m.scene.drives)
          if (drive.body == b && drive.actuator == a) twist += drive.twist;
        const double step = 1e-5, angle = twist.tail<3>().norm();
        const Vec3 axis = angle > 0 ? Vec3(twist.tail<3>() / angle) : Vec3::UnitX();
        const Eigen::AngleAxisd forth(step * angle, axis), back(-step * angle, axis);
        const Body<double>& body = m.scene.bodies[b];
        for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
          const Vec3& p = m.scene.points[i];
          const Vec3 speed = twist.head<3>() + (forth * p - back * p) / (2 * step);
          append(moved, body, speed, twist.tail<3>());
        }
      }
      CHECK(worst_of(m.J.col(a) - as_vector(moved)) <= 1e-9);
    }
  }
}

TEST_CASE("an answer obeys the paper's equations written with its matrices") {
  Index solved = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(random_grasp<double>(seed));
    if (push.solve() != Status::solved) continue;
    ++solved;
    const Matrices m(push.scene);
    const Answer<double>& answer = push.answer();
    std::vector<double> f, r, prescribed;
    for (Index i = 0; i < push.scene.points.size; ++i) {
      const ContactAnswer<double>& contact = answer.contacts[i];
      const Body<double>& body = push.scene.bodies[contact.body];
      append(f, body, contact.normal_force * body.normal + contact.friction_force,
             contact.torsion * body.normal);
      append(r, body, contact.acceleration, contact.spin * body.normal);
      append(prescribed, body, acceleration_at(push.scene.points[i], body.acceleration),
             body.acceleration.tail<3>());
    }
    const VectorX<double> s =
        Eigen::Map<const VectorX<double>>(answer.closing.data, answer.closing.size);
    const double F = push.scales().force, unit = push.scales().acceleration;
    const Vector6<double> newton =
        inertia_matrix(push.scene) * answer.acceleration - load(push.scene) - m.G * as_vector(f);
    CHECK(worst_of(newton) <= 1e-9 * F);
    const VectorX<double> motion =
        m.G.transpose() * answer.acceleration - m.J * s - as_vector(prescribed) - as_vector(r);
    CHECK(worst_of(motion) <= 1e-9 * unit);
    const VectorX<double> grip = m.J.transpose() * as_vector(f);
    for (Index a = 0; a < grip.size(); ++a)
      CHECK(absolute(grip[a] - push.scene.actuators[a].force) <= 1e-9 * F);
  }
  CHECK(solved >= 25);
}
