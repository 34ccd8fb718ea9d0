// Bilateral pushers: the normal motion is imposed, by pulling if it must be.
#include <doctest/doctest.h>

#include "support/dense_lcp.hpp"
#include "support/factored_groups.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

Scene3 slide_along_x(double acceleration, bool bilateral) {
  Slide slide;
  slide.acceleration = acceleration;
  slide.gravity.setZero();
  Scene3 scene = straight_slide(slide);
  scene.bodies[slide_wall].bilateral = bilateral;
  return scene;
}

} // namespace

TEST_CASE("[T.2] a wall that moves away pulls if it is bilateral, and lets go if it is not") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid})
    for (const bool bilateral : {false, true}) {
      Scene3 scene = slide_along_x(-0.1, bilateral);
      scene.base.pressure = pressure;
      SolvedPush<double> push(scene);
      REQUIRE(push.solve() == Status::solved);
      CHECK(push.residuals.max() <= exact);
      const double pull = push.normal_force(slide_wall);
      CHECK(pull == doctest::Approx(bilateral ? -20.02 : 0.0).epsilon(1e-9));
      CHECK(push.answer().acceleration[0] == doctest::Approx(bilateral ? -0.1 : 0.0));
    }
}

TEST_CASE("a bilateral wall that presses anyway changes nothing") {
  SolvedPush<double> with(slide_along_x(0.1, true)), without(slide_along_x(0.1, false));
  REQUIRE(with.solve() == Status::solved);
  REQUIRE(without.solve() == Status::solved);
  CHECK((with.wrench(slide_wall) - without.wrench(slide_wall)).norm() <=
        exact * with.scales().force);
  CHECK((with.answer().acceleration - without.answer().acceleration).norm() <=
        exact * with.scales().acceleration);
}

TEST_CASE("[T.2] bilateral rows are exact negatives, and at most one of the pair acts") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(grasp_of<double>(Family::bilateral, seed));
    const Problem<double> problem = push.assembly.problem();
    MatrixX<double> M(problem.size, problem.size);
    fill_matrix(problem, MatrixMap<double>(M.data(), problem.size, problem.size));
    REQUIRE(push.solve() == Status::solved);
    CHECK(push.residuals.max() <= exact);
    for (const ConeGroup<double>& cone : push.assembly.cones()) {
      if (cone.normals == 1) continue;
      const Index i = cone.variable;
      CHECK((M.row(i) + M.row(i + 1)).norm() == 0);
      CHECK(problem.q[i] == -problem.q[i + 1]);
      const Span<double> z = push.memory.work.pressure.z;
      CHECK(std::min(z[i], z[i + 1]) == 0);
    }
    const Body<double>& body = push.scene.bodies[slide_wall];
    for (Index k = 0; k < body.point_count; ++k) {
      const ContactAnswer<double>& contact = push.answer().contacts[body.first_point + k];
      CHECK(absolute(contact.acceleration.dot(body.normal)) <= exact * push.scales().acceleration);
    }
  }
}

TEST_CASE("the referee holds a bilateral wall to its motion and to mu |lambda|") {
  SolvedPush<double> push(slide_along_x(-0.1, true));
  REQUIRE(push.solve() == Status::solved);
  Answer<double>& answer = push.memory.work.answer;
  const Vector6<double> right = answer.acceleration;
  answer.acceleration[0] -= 1e-5 * push.scales().acceleration; // leaving the wall
  CHECK(check(push.scene, push.scales(), push.answer(), 1.0).pusher > exact);
  answer.acceleration = right;
  ContactAnswer<double>& contact = answer.contacts[2];
  contact.normal_force = -contact.normal_force; // a push where it must pull
  CHECK(check(push.scene, push.scales(), push.answer(), 1.0).newton > exact);
}

TEST_CASE("a planar scene knows bilateral pulls and soft torques") {
  Scene3 scene = slide_along_x(-0.1, true);
  scene.base.planar = true;
  for (std::size_t b = 0; b < 2; ++b) scene.bodies[b].torsion_radius = 0.003;
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  CHECK(push.normal_force(slide_wall) == doctest::Approx(-20.02));
}
