// Three roads to the same answer: pivots, sweeps, and sweeps finished by pivots.
#include <doctest/doctest.h>

#include "support/dense_lcp.hpp"
#include "support/grasp_families.hpp"
#include "support/owned_sweeps.hpp"
#include "support/scenes.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A push that can be solved in all three ways.
struct ManyWays : SolvedPush<double> {
  OwnedSweeps<double> owned_sweeps;
  double tolerance = Tolerances<double>().residual / 32;

  explicit ManyWays(const Scene3& given)
      : SolvedPush<double>(given), owned_sweeps(size_of(scene)) {}

  Status by_sweeps() { return by(sweep_rounds(tolerance, 5000)); }
  Status by_both() {
    return by(HybridRounds<double>{sweep_rounds(1e-6, 200), LemkeRounds<double>{lemke}});
  }
  double worst() const { return check(scene, scales(), answer(), 1.0).max(); }
  bool same_motion_as(const ManyWays& other) const {
    const double L = scales().length;
    Vector6<double> mine = answer().acceleration, off = mine - other.answer().acceleration;
    mine.tail<3>() *= L;
    off.tail<3>() *= L;
    return off.norm() <= 1e-5 * std::max(scales().acceleration, mine.norm());
  }

private:
  SweepRounds<double> sweep_rounds(double residual, Index most) {
    SweepRounds<double> rounds{owned_sweeps.sweeps};
    rounds.options.tolerance = residual;
    rounds.options.max_sweeps = most;
    return rounds;
  }
  template <class Rounds> Status by(const Rounds& rounds) {
    status = solve_pressure(assembly, rounds, memory.work.pressure, options, run);
    if (status == Status::solved)
      read_answer(assembly, memory.work.pressure.z.data, memory.work.answer, 1.0);
    return status;
  }
};

} // namespace

TEST_CASE("1,000 random grasps by accelerated sweeps: at least 95 % to 1e-6, none wrong") {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < seeds(1000); ++seed) {
    CAPTURE(seed);
    ManyWays push(grasp_under(Pressure::rigid, Family::plain, seed));
    push.tolerance = 1e-6 / 32;
    if (push.by_sweeps() != Status::solved) continue;
    ++solved;
    CHECK(push.worst() <= 1e-6);
    CHECK(push.run.sweeps <= 5000 + 64); // a Newton step may end a few passes later
  }
  MESSAGE("accelerated sweeps solve " << solved << " of " << seeds(1000) << " to 1e-6");
  CHECK(solved >= static_cast<int>(seeds(950)));
}

TEST_CASE("1,000 random grasps by sweeps and pivots: all of them to 1e-9") {
  for (std::uint64_t seed = 0; seed < seeds(1000); ++seed) {
    CAPTURE(seed);
    ManyWays push(grasp_under(Pressure::rigid, Family::plain, seed));
    REQUIRE(push.by_both() == Status::solved);
    CHECK(push.worst() <= 1e-9);
  }
}

TEST_CASE("under pad sweeps and pivots lead to the same motion") {
  int agree = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    const Scene3 scene = grasp_under(Pressure::pad, Family::plain, seed);
    ManyWays pivots(scene), sweeps(scene), both(scene);
    REQUIRE(pivots.solve() == Status::solved);
    REQUIRE(both.by_both() == Status::solved);
    if (sweeps.by_sweeps() != Status::solved) continue;
    CHECK(both.worst() <= 1e-9);
    if (pivots.same_motion_as(sweeps) && pivots.same_motion_as(both)) ++agree;
  }
  CHECK(agree >= 97); // some literal problems have several answers
}

TEST_CASE("where the motion is proved unique all three find it") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const Scene3 scene = determined_grasp(seed);
    ManyWays pivots(scene), sweeps(scene), both(scene);
    REQUIRE(pivots.solve() == Status::solved);
    REQUIRE(sweeps.by_sweeps() == Status::solved);
    REQUIRE(both.by_both() == Status::solved);
    CHECK(pivots.same_motion_as(sweeps));
    CHECK(pivots.same_motion_as(both));
  }
}

TEST_CASE("soft, bilateral, parallel, even and crookedly driven grasps by sweeps") {
  for (const Family family :
       {Family::soft, Family::bilateral, Family::parallel, Family::even, Family::jacobian}) {
    CAPTURE(static_cast<int>(family));
    int solved = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      ManyWays push(
          grasp_under(family == Family::even ? Pressure::even : Pressure::pad, family, seed));
      if (push.by_sweeps() == Status::solved && push.worst() <= 1e-8) ++solved;
      ManyWays both(push.owned);
      CHECK(both.by_both() == Status::solved);
    }
    CHECK(solved >= 57);
  }
}

TEST_CASE("the same bits on every run, and the breaking force by sweeps") {
  const Scene3 scene = straight_slide();
  ManyWays first(scene), second(scene);
  REQUIRE(first.by_sweeps() == Status::solved);
  REQUIRE(second.by_sweeps() == Status::solved);
  CHECK(first.answer().acceleration == second.answer().acceleration);
  Breaking<double> breaking;
  PressureRun run;
  SweepRounds<double> rounds{first.owned_sweeps.sweeps};
  REQUIRE(find_breaking(first.assembly, rounds, first.memory.work, first.scene.bodies[2], {},
                        breaking, run) == Status::solved);
  CHECK(breaking.break_force == doctest::Approx(20).epsilon(1e-7));
  CHECK(run.pivots == 0);
  CHECK(run.sweeps > 0);
}

TEST_CASE("a jam ends the sweeps without an answer, and they say that forces run away") {
  Scene3 scene = straight_slide();
  scene.add_body(Role::finger, {-1, 0, 0}, 0.2, {{0.05, 0.01, 0}, {0.05, -0.01, 0}});
  scene.base.pressure = Pressure::rigid;
  ManyWays push(scene);
  CHECK(push.by_sweeps() == Status::stagnated);
  CHECK(push.owned_sweeps.sweeps.runs_away());
  CHECK(push.by_both() == Status::ray);
}
