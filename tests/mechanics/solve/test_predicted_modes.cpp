// Lemke's pivots from predicted modes, and from guesses that are wrong.
#include <doctest/doctest.h>

#include "bench/wide_grasp.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A push solved by rounds that start from a guess.
template <class S, class Pivots> struct GuessedPush : SolvedPush<S, Pivots> {
  using Base = SolvedPush<S, Pivots>;
  using Base::Base;
  using Cold = LemkeRounds<S, const Unwatched, Pivots>;

  template <class Rounds> Status by(const Rounds& rounds) {
    this->status = solve_pressure(this->assembly, rounds, this->memory.work.pressure, this->options,
                                  this->run);
    if (this->status != Status::solved) return this->status;
    read_answer(this->assembly, this->memory.work.pressure.z.data, this->memory.work.answer, S(1));
    this->residuals = check(this->scene, this->scales(), this->answer(), S(1));
    return this->status;
  }
  Status predicted() {
    return by(PredictedRounds<S, const Unwatched, Pivots>{this->assembly, Cold{this->lemke}});
  }
};

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

template <class A, class B> bool same_motion(const A& a, const B& b) {
  Vector6<double> size = a.answer().acceleration, off = size - b.answer().acceleration;
  size.template tail<3>() *= a.scales().length;
  off.template tail<3>() *= a.scales().length;
  return off.norm() <= 1e-5 * std::max(a.scales().acceleration, size.norm());
}

/// The columns of ExpectedForces, for all to see.
struct OpenColumns : lcpush::detail::ForceColumns<double> {
  using lcpush::detail::ForceColumns<double>::ForceColumns;
  using lcpush::detail::ForceColumns<double>::column;
  using lcpush::detail::ForceColumns<double>::seen_by;
};

using Dense = Lemke<double>;
using Structured = StructuredLemke<double>;

} // namespace

TEST_CASE_TEMPLATE("from predicted modes every random grasp is solved to 1e-9", Pivots, Dense,
                   Structured) {
  for (const Pressure pressure : {Pressure::rigid, Pressure::pad})
    for (std::uint64_t seed = 0; seed < seeds(250); ++seed) {
      CAPTURE(seed);
      GuessedPush<double, Pivots> push(grasp_under(pressure, Family::plain, seed));
      REQUIRE(push.predicted() == Status::solved);
      CHECK(push.residuals.max() <= 1e-9);
    }
}

TEST_CASE_TEMPLATE("from predicted modes the other kinds of grasps are solved too", Pivots, Dense,
                   Structured) {
  for (const Family family : {Family::soft, Family::parallel, Family::even, Family::jacobian})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      CAPTURE(static_cast<int>(family));
      CAPTURE(seed);
      const Pressure pressure = family == Family::even ? Pressure::even : Pressure::pad;
      GuessedPush<double, Pivots> push(grasp_under(pressure, family, seed));
      REQUIRE(push.predicted() == Status::solved);
      CHECK(push.residuals.max() <= 1e-9);
    }
}

TEST_CASE_TEMPLATE("from predicted modes bilateral pushers have no promise but few failures",
                   Pivots, Dense, Structured) {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    GuessedPush<double, Pivots> push(grasp_under(Pressure::pad, Family::bilateral, seed));
    if (push.predicted() != Status::solved) continue;
    ++solved;
    CHECK(push.residuals.max() <= 1e-9);
  }
  CHECK(solved >= 38);
}

TEST_CASE("predicted or cold, on either basis: the same motion, with fewer pivots") {
  int agree = 0;
  Index cold_pivots = 0, predicted_pivots = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const OwnedScene<double> scene = grasp_under(Pressure::pad, Family::plain, seed);
    SolvedPush<double> cold(scene);
    GuessedPush<double, Dense> dense(scene);
    GuessedPush<double, Structured> structured(scene);
    REQUIRE(cold.solve() == Status::solved);
    REQUIRE(dense.predicted() == Status::solved);
    REQUIRE(structured.predicted() == Status::solved);
    if (same_motion(cold, dense) && same_motion(cold, structured)) ++agree;
    cold_pivots += cold.run.pivots;
    predicted_pivots += dense.run.pivots;
  }
  CHECK(agree >= 97); // some literal problems have several answers
  CHECK(predicted_pivots < cold_pivots * 9 / 10);
}

TEST_CASE("where the motion is proved unique every start finds it") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const OwnedScene<double> scene = determined_grasp(seed);
    SolvedPush<double> cold(scene);
    GuessedPush<double, Dense> dense(scene);
    GuessedPush<double, Structured> structured(scene);
    REQUIRE(cold.solve() == Status::solved);
    REQUIRE(dense.predicted() == Status::solved);
    REQUIRE(structured.predicted() == Status::solved);
    CHECK(same_motion(cold, dense));
    CHECK(same_motion(cold, structured));
  }
}

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
    GuessedPush<double, Structured> push(owned);
    const Span<unsigned char> active = push.memory.work.pressure.active;
    predict_modes(push.assembly, active);
    Index presses = 0, rubs = 0;
    for (Index i = 0; i < push.scene.points.size; ++i) {
      const ConeGroup<double>& cone = push.assembly.layout().cones[i];
      CHECK(active[cone.slip()] == 0);
      presses += active[cone.variable];
      for (Index k = 1; k < cone.forces(); ++k) rubs += active[cone.variable + k];
    }
    CHECK(presses >= 3);
    CHECK((pressure == Pressure::pad || presses <= 6 + push.assembly.layout().actuators));
    CHECK(rubs >= 1);
    CHECK(rubs <= 6);
    CHECK(push.predicted() == Status::solved);
    CHECK(push.run.pivots <= 12);
  }
}

TEST_CASE("a wide straight push is predicted whole, its pusher's friction included") {
  for (const Pressure law : {Pressure::rigid, Pressure::pad})
    for (const Index points : {20, 100, 300}) {
      CAPTURE(pressure_text(law));
      CAPTURE(points);
      const OwnedScene<double> scene = bench::primitive(bench::Primitive::slide, points, 8, law);
      GuessedPush<double, Structured> push(scene);
      REQUIRE(push.predicted() == Status::solved);
      CHECK(push.residuals.max() <= 1e-9);
      CHECK(push.run.pivots == 0);
    }
}

TEST_CASE("a grasp of a usual hand's points is predicted whole too; a tiny one by its pivots") {
  for (const Pressure law : {Pressure::rigid, Pressure::pad})
    for (const Index points : {1, 4}) {
      CAPTURE(pressure_text(law));
      CAPTURE(points);
      const OwnedScene<double> scene = bench::primitive(bench::Primitive::slide, points, 8, law);
      GuessedPush<double, Structured> push(scene);
      REQUIRE(push.predicted() == Status::solved);
      CHECK(push.run.pivots <= (points == 1 ? 12 : 0));
    }
}

TEST_CASE("what a rest is worth to a force is its column's product with it") {
  const Family families[] = {Family::plain, Family::parallel, Family::jacobian,
                             Family::two_pushers};
  for (const Family family : families)
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      GuessedPush<double, Structured> push(grasp_under(Pressure::rigid, family, seed));
      const OpenColumns columns(push.assembly);
      lcpush::detail::Balance<double> rest = lcpush::detail::Balance<double>::LinSpaced(1, -3);
      for (Index i = 0; i < push.assembly.layout().points; ++i) {
        const ConeGroup<double>& cone = push.assembly.layout().cones[i];
        const Index b = push.assembly.layout().body[i];
        for (Index k = cone.force; k < cone.force + cone.forces(); ++k)
          CHECK(
              columns.column(b, k).dot(rest) ==
              doctest::Approx(push.assembly.factored().wrenches[k].dot(columns.seen_by(b, rest))));
      }
    }
}

TEST_CASE_TEMPLATE("a random guess costs pivots and no answer", Pivots, Dense, Structured) {
  Random random(5);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const Pressure pressure = seed % 2 == 0 ? Pressure::rigid : Pressure::pad;
    using Push = GuessedPush<double, Pivots>;
    Push push(grasp_under(pressure, Family::plain, seed));
    using Rounds = StartedRounds<double, RandomStart, const Unwatched, Pivots>;
    const typename Push::Cold cold{push.lemke};
    REQUIRE(push.by(Rounds{{&random}, cold}) == Status::solved);
    CHECK(push.residuals.max() <= 1e-9);
  }
}

TEST_CASE("in float what is called solved from predicted modes obeys the laws") {
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    OwnedScene<float> scene = random_grasp<float>(seed);
    scene.base.pressure = Pressure::rigid;
    GuessedPush<float, StructuredLemke<float>> push(scene);
    if (push.predicted() != Status::solved) continue;
    ++solved;
    CHECK(push.residuals.max() <= 4 * Tolerances<float>().residual);
  }
  CHECK(solved >= 90);
}

TEST_CASE("a wedge is a ray from predicted modes too") {
  Scene3 scene = straight_slide();
  scene.add_body(Role::finger, {-1, 0, 0}, 0.2, {{0.05, 0.01, 0}, {0.05, -0.01, 0}});
  scene.base.pressure = Pressure::rigid;
  GuessedPush<double, Structured> push(scene);
  CHECK(push.predicted() == Status::ray);
}
