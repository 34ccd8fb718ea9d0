// The assembled rows are the laws in SI units, for any unknowns whatever.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "support/dense_lcp.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// The unknowns z of an assembly in SI units.
struct Unknowns {
  const Assembly<double>& assembly;
  const VectorX<double>& z;

  const Scales<double>& scales() const { return assembly.layout().scales; }
  double normal(Index i) const { return z[assembly.layout().normal_index(i)] * scales().force; }
  double friction(Index i, Index j) const {
    return z[assembly.layout().friction_index(i, j)] * scales().force;
  }
  double slip(Index i) const { return z[assembly.layout().slip_index(i)] * scales().acceleration; }
  double closing(Index a) const {
    return z[assembly.layout().closing_index(a)] * scales().acceleration /
           assembly.layout().reach[a];
  }
};

Vector6<double> wrench_at(const Vec3& p, const Vec3& force) {
  Vector6<double> wrench;
  wrench << force, p.cross(force);
  return wrench;
}

Vec3 at(const Vec3& p, const Vector6<double>& twist) {
  return twist.head<3>() + twist.tail<3>().cross(p);
}

Vec3 contact_force(const Scene<double>& scene, const Unknowns& u, Index b, Index i) {
  const Body<double>& body = scene.bodies[b];
  Vec3 force = u.normal(i) * body.normal;
  for (Index j = 0; body.friction > 0 && j < scene.facets; ++j)
    force += u.friction(i, j) * generator(body, j, scene.facets).force;
  return force;
}

Vector6<double> object_acceleration(const Scene<double>& scene, const Unknowns& u) {
  Vector6<double> wrench = wrench_at(Vec3::Zero(), scene.object.mass * scene.gravity);
  for (Index b = 0; b < scene.bodies.size; ++b)
    for (Index k = 0; k < scene.bodies[b].point_count; ++k) {
      const Index i = scene.bodies[b].first_point + k;
      wrench += wrench_at(scene.points[i], contact_force(scene, u, b, i));
    }
  Vector6<double> a;
  a << wrench.head<3>() / scene.object.mass, scene.object.inertia.inverse() * wrench.tail<3>();
  return a;
}

Vector6<double> twist_of(const Scene<double>& scene, const Unknowns& u, Index b, double sigma) {
  Vector6<double> twist = sigma * scene.bodies[b].acceleration;
  for (const Drive<double>& drive : scene.drives)
    if (drive.body == b) twist += u.closing(drive.actuator) * drive.twist;
  return twist;
}

void check_point(const Scene<double>& scene, const Unknowns& u, const VectorX<double>& w, Index b,
                 Index i, const Vector6<double>& relative) {
  const Body<double>& body = scene.bodies[b];
  const Layout<double>& layout = u.assembly.layout();
  const Scales<double>& scales = u.scales();
  const Vec3 acceleration = at(scene.points[i], relative);
  const double rounding = 1e-11 * w.cwiseAbs().maxCoeff();
  CHECK(absolute(w[layout.normal_index(i)] - body.normal.dot(acceleration) / scales.acceleration) <=
        rounding);
  if (!(body.friction > 0)) return;
  double room = body.friction * u.normal(i);
  for (Index j = 0; j < scene.facets; ++j) {
    const double row = generator(body, j, scene.facets).force.dot(acceleration) + u.slip(i);
    CHECK(absolute(w[layout.friction_index(i, j)] - row / scales.acceleration) <= rounding);
    room -= u.friction(i, j);
  }
  CHECK(absolute(w[layout.slip_index(i)] - room / scales.force) <= rounding);
}

void check_grip(const Scene<double>& scene, const Unknowns& u, const VectorX<double>& w, Index a) {
  double row = scene.actuators[a].inertia * u.closing(a) - scene.actuators[a].force;
  for (const Drive<double>& drive : scene.drives) {
    if (drive.actuator != a) continue;
    const Body<double>& body = scene.bodies[drive.body];
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      row += contact_force(scene, u, drive.body, i).dot(at(scene.points[i], drive.twist));
  }
  const Layout<double>& layout = u.assembly.layout();
  CHECK(absolute(w[layout.closing_index(a)] - row / (u.scales().force * layout.reach[a])) <=
        1e-11 * w.cwiseAbs().maxCoeff());
}

void check_rows(const Scene3& owned, double sigma, Random& random) {
  SolvedPush<double> push(owned);
  push.assembly.push_by(sigma);
  const Problem<double> problem = push.assembly.problem();
  const VectorX<double> z = random_vector(random, problem.size);
  VectorX<double> w(problem.size);
  multiply(problem, z.data(), w.data());
  for (Index i = 0; i < problem.size; ++i) w[i] += problem.q[i];
  const Unknowns u{push.assembly, z};
  const Vector6<double> a = object_acceleration(push.scene, u);
  for (Index b = 0; b < push.scene.bodies.size; ++b)
    for (Index k = 0; k < push.scene.bodies[b].point_count; ++k)
      check_point(push.scene, u, w, b, push.scene.bodies[b].first_point + k,
                  a - twist_of(push.scene, u, b, sigma));
  for (Index actuator = 0; actuator < push.scene.actuators.size; ++actuator)
    check_grip(push.scene, u, w, actuator);
}

Scene3 in_other_units(Scene3 scene, double mass, double length, double time) {
  const double acceleration = length / (time * time), force = mass * acceleration;
  scene.base.object.mass *= mass;
  scene.base.object.inertia *= mass * length * length;
  scene.base.gravity *= acceleration;
  for (Vec3& p : scene.points) p *= length;
  for (Body<double>& body : scene.bodies) {
    body.acceleration.head<3>() *= acceleration;
    body.acceleration.tail<3>() /= time * time;
  }
  for (Drive<double>& drive : scene.drives) drive.twist.tail<3>() /= length;
  for (Actuator<double>& actuator : scene.actuators) {
    actuator.force *= force;
    actuator.inertia *= mass;
  }
  return scene;
}

void check_units(const Scene3& scene) {
  SolvedPush<double> push(scene);
  const Problem<double> problem = push.assembly.problem();
  const Index n = problem.size;
  for (const auto& [mass, length, time] :
       {std::array<double, 3>{1e3, 1, 1}, std::array<double, 3>{1, 1e3, 1},
        std::array<double, 3>{1, 1, 1e3}, std::array<double, 3>{1e-4, 70, 0.3}}) {
    SolvedPush<double> other(in_other_units(scene, mass, length, time));
    const Problem<double> same = other.assembly.problem();
    REQUIRE(same.size == n);
    MatrixX<double> M(n, n), N(n, n);
    fill_matrix(problem, MatrixMap<double>(M.data(), n, n));
    fill_matrix(same, MatrixMap<double>(N.data(), n, n));
    CHECK((M - N).cwiseAbs().maxCoeff() <= 1e-13 * M.cwiseAbs().maxCoeff());
    double q_size = 0;
    for (Index i = 0; i < n; ++i) q_size = larger(q_size, absolute(problem.q[i]));
    for (Index i = 0; i < n; ++i) CHECK(absolute(problem.q[i] - same.q[i]) <= 1e-13 * q_size);
  }
}

} // namespace

TEST_CASE("every row is its law in SI units: random grasps, any unknowns") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    check_rows(random_grasp<double>(seed), 1, random);
    check_rows(random_grasp<double>(seed), 0.01, random);
  }
}

TEST_CASE("every row is its law with a parallel jaw, actuator inertia, crooked drives and no "
          "friction somewhere") {
  Random random(3);
  Scene3 scene = rolling({});
  scene.actuators[0].inertia = 0.4;
  scene.bodies[1].friction = 0;
  check_rows(scene, 1, random);
  for (Drive<double>& drive : scene.drives) drive.twist = random_vector(random, 6);
  scene.base.object.inertia(0, 1) = scene.base.object.inertia(1, 0) = 1e-5;
  check_rows(scene, 1, random);
}

TEST_CASE("another unit of mass, length or time leaves the scaled problem as it is") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    check_units(random_grasp<double>(seed));
  }
}

TEST_CASE("so it does with an actuator that turns its bodies and has inertia") {
  Random random(4);
  Scene3 scene = rolling({});
  scene.actuators[0].inertia = 0.4;
  for (Drive<double>& drive : scene.drives) drive.twist.tail<3>() = 40 * random_vector(random, 3);
  check_units(scene);
}

TEST_CASE("every unknown has one name, and the name leads back to it") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Scene3 scene = random_grasp<double>(seed);
    if (seed % 2 == 0) scene.bodies[0].friction = 0;
    SolvedPush<double> push(scene);
    const Layout<double>& layout = push.assembly.layout();
    for (Index i = 0; i < layout.size; ++i) {
      const Name name = name_of(layout, i);
      const Index back = name.meaning == Meaning::normal ? layout.normal_index(name.of)
                         : name.meaning == Meaning::friction
                             ? layout.friction_index(name.of, name.generator)
                         : name.meaning == Meaning::slip ? layout.slip_index(name.of)
                                                         : layout.closing_index(name.of);
      CHECK(back == i);
    }
  }
}

namespace {

/// Are they the same numbers, bit by bit?
bool same_assembly(const Assembly<double>& a, const Assembly<double>& b) {
  const FactoredProblem<double>&x = a.factored(), &y = b.factored();
  const Layout<double>&l = a.layout(), &m = b.layout();
  const Problem<double> p = a.problem(), q = b.problem();
  bool same = l.size == m.size && l.points == m.points && x.mobility == y.mobility &&
              a.load() == b.load() && l.scales.force == m.scales.force &&
              l.scales.length == m.scales.length && l.scales.acceleration == m.scales.acceleration;
  for (Index i = 0; same && i < l.forces; ++i) same = x.wrenches[i] == y.wrenches[i];
  for (Index i = 0; same && i < l.points; ++i)
    same = x.cones[i].friction == y.cones[i].friction &&
           x.cones[i].compliance == y.cones[i].compliance;
  for (Index k = 0; same && k < x.sums.size; ++k) {
    const SumGroup<double>&s = x.sums[k], &t = y.sums[k];
    same = s.target == t.target && s.inertia == t.inertia && s.count == t.count;
    for (Index e = s.first; same && e < s.first + s.count; ++e)
      same = x.coupling[e] == y.coupling[e] && x.coupled_variable[e] == y.coupled_variable[e];
  }
  return same && std::equal(p.q, p.q + p.size, q.q);
}

} // namespace

TEST_CASE("a command leaves what a fresh assembly makes of the scene, bit by bit") {
  for (const Family family :
       {Family::plain, Family::planar, Family::even, Family::soft, Family::bilateral,
        Family::parallel, Family::jacobian, Family::weighted, Family::locked})
    for (const bool is_round : {false, true})
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        CAPTURE(static_cast<int>(family));
        CAPTURE(seed);
        SolvedPush<double> push(grasp_of<double>(family, seed), is_round);
        (void)push.solve(); // which changes compliances and right-hand sides
        for (Actuator<double>& actuator : push.owned.actuators) actuator.force *= 1.7;
        for (Body<double>& body : push.owned.bodies) {
          body.acceleration = -0.3 * body.acceleration;
          body.preload *= 2;
        }
        push.scene.gravity += Vector3<double>(0.1, 2, -0.3);
        push.scene.object.wrench[1] += 0.5;
        push.assembly.command();
        OwnedWorkspace<double> fresh(workspace_for<Lemke<double>>(push.scene));
        Assembly<double> assembly(fresh.work.assembly);
        REQUIRE(assembly.assemble(push.scene) == Status::running);
        CHECK(same_assembly(push.assembly, assembly));
        push.assembly.push_by(0.5); // what the motions add, too
        assembly.push_by(0.5);
        CHECK(same_assembly(push.assembly, assembly));
      }
}

TEST_CASE("[T.5] an actuator's couplings ascend, whatever the order and the parts of its drives") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Scene3 scene = grasp_of<double>(Family::parallel, seed);
    SolvedPush<double> given(scene);
    REQUIRE(scene.drives.size() > scene.actuators.size()); // a jaw drives two fingers
    std::reverse(scene.drives.begin(), scene.drives.end());
    scene.drives.front().twist /= 2;
    scene.drives.push_back(scene.drives.front());
    SolvedPush<double> other(scene);
    const FactoredProblem<double>&first = given.assembly.factored(),
          &second = other.assembly.factored();
    for (Index a = 0; a < first.sums.size; ++a) {
      const SumGroup<double>&sum = first.sums[a], &same = second.sums[a];
      REQUIRE(same.count == sum.count);
      for (Index k = 0; k < sum.count; ++k) {
        const Index variable = second.coupled_variable[same.first + k];
        CHECK(variable == first.coupled_variable[sum.first + k]);
        CHECK(second.coupling[same.first + k] ==
              doctest::Approx(first.coupling[sum.first + k]).epsilon(1e-14));
        if (k > 0) CHECK(variable > second.coupled_variable[same.first + k - 1]);
      }
    }
  }
}
