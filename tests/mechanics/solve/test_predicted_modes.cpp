// Lemke's pivots from predicted modes, and from guesses that are wrong.
#include <doctest/doctest.h>

#include "bench/wide_grasp.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "support/engines.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// First rounds from any active set at all.
struct RandomStart {
  Random* random;

  bool propose(const Problem<double>& problem, const PressureMemory<double>& memory, PressureRun&,
               FirstBasis& first) {
    for (Index i = 0; i < problem.size; ++i)
      memory.active[i] = static_cast<unsigned char>(random->integer(0, 1));
    first = {Guess::near, 1, problem.size};
    return true;
  }
  void begins_cold() {}
};

using Predicted = EnginePush<double, Engine::predicted>;

} // namespace

TEST_CASE("a straight push: each finger point is predicted to slide against it, by hand") {
  const Scene3 owned = straight_slide();
  SolvedPush<double> push(owned);
  push.assembly.push_by(1);
  const Span<unsigned char> active = push.memory.work.pressure.active;
  predict_modes(push.assembly, active);
  const Layout<double>& layout = push.assembly.layout();
  for (Index i = 0; i < layout.points; ++i) {
    CAPTURE(i);
    const Body<double>& body = push.scene.bodies[layout.body[i]];
    const bool finger = body.role == Role::finger;
    CHECK(active[layout.normal_index(i)] == 1);
    CHECK(active[layout.slip_index(i)] == (finger ? 1 : 0));
    for (Index j = 0; j < layout.cones[i].generators; ++j) {
      const Generator<double> d = generator(body, j, push.scene.facets);
      // The push goes along +x: friction on the object points to -x.
      const bool opposes = finger && d.force[0] < -0.999;
      const int expected = active[layout.friction_index(i, j)];
      if (finger)
        CHECK(expected == (opposes ? 1 : 0));
      else // the pusher's holds the weight
        CHECK((expected == 0 || d.force.dot(push.scene.gravity) < 0));
    }
  }
  CHECK(active[layout.closing_index(0)] == 1);
}

TEST_CASE(
    "without a pusher that moves rest is predicted: no slip, and no more friction than holds") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) {
    Scene3 owned = straight_slide();
    owned.base.pressure = pressure;
    owned.bodies.back().acceleration.setZero();
    SolvedPush<double> push(owned);
    const Span<unsigned char> active = push.memory.work.pressure.active;
    predict_modes(push.assembly, active);
    Index presses = 0, sticks = 0;
    for (Index i = 0; i < push.scene.points.size; ++i) {
      const ConeGroup<double>& cone = push.assembly.layout().cones[i];
      CHECK(active[cone.slip()] == 0);
      presses += active[cone.variable];
      for (Index k = 1; k < cone.forces(); ++k) sticks += active[cone.variable + k];
    }
    CHECK(presses >= 3);
    CHECK((pressure == Pressure::pad || presses <= 6 + push.assembly.layout().actuators));
    CHECK(sticks >= 1);
    CHECK(sticks <= 6);
    const Predicted solved(owned);
    CHECK(solved.status == Status::solved);
    CHECK(solved.run.pivots <= 12);
  }
}

TEST_CASE("a straight push is predicted whole, its pusher's friction too; a tiny one by pivots") {
  for (const Pressure law : {Pressure::rigid, Pressure::pad})
    for (const Index points : {1, 4, 20, 100}) {
      CAPTURE(pressure_text(law));
      CAPTURE(points);
      const Predicted push(bench::primitive(bench::Primitive::slide, points, 8, law));
      REQUIRE(push.status == Status::solved);
      CHECK(push.residuals.max() <= 1e-9);
      CHECK(push.run.pivots <= (points == 1 ? 12 : 0));
    }
}

TEST_CASE("a random guess costs pivots and no answer") {
  Random random(5);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    using Push = SolvedPush<double, StructuredLemke<double>>;
    Push push(grasp_under(seed % 2 == 0 ? Pressure::rigid : Pressure::pad, Family::plain, seed));
    using Rounds = StartedRounds<double, RandomStart, const Unwatched, StructuredLemke<double>>;
    REQUIRE(solve_pressure(push.assembly, Rounds{{&random}, LemkeRounds{push.lemke}},
                           push.memory.work.pressure, push.options, push.run) == Status::solved);
    read_answer(push.assembly, push.memory.work.pressure.z.data, push.memory.work.answer, 1.0);
    CHECK(check(push.scene, push.scales(), push.answer(), 1.0).max() <= 1e-9);
  }
}
