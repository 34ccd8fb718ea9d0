// The referee of mechanics/: each law's residual reacts to its own numbers and to no others.
#include <doctest/doctest.h>

#include <limits>

#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double passes = 1e-9;
using LawResidual = double Residuals<double>::*;
constexpr LawResidual newton = &Residuals<double>::newton, normal = &Residuals<double>::normal,
                      dissipation = &Residuals<double>::dissipation,
                      cone = &Residuals<double>::cone, grip = &Residuals<double>::grip,
                      rigidity = &Residuals<double>::rigidity, pusher = &Residuals<double>::pusher;
constexpr LawResidual families[] = {newton, normal, dissipation, cone, grip, rigidity, pusher};

/// A slide with four-point pads: every family has something to say.
struct Slid : SolvedPush<double> {
  Slid() : SolvedPush<double>(scene_with_pads()) { REQUIRE(solve() == Status::solved); }
  static Scene3 scene_with_pads() {
    Slide slide;
    slide.pads = ring(4, 0.005);
    return straight_slide(slide);
  }
  Answer<double>& mutable_answer() { return memory.work.answer; }
  Residuals<double> judge() { return check(scene, scales(), answer(), 1.0); }
  double force() const { return scales().force; }
  double unit() const { return scales().acceleration; }
};

/// Exactly the named families exceed the tolerance.
void check_families(const Residuals<double>& residuals,
                    std::initializer_list<LawResidual> expected) {
  for (std::size_t k = 0; k < std::size(families); ++k) {
    CAPTURE(k);
    bool wanted = false;
    for (const LawResidual family : expected) wanted = wanted || family == families[k];
    CHECK((residuals.*families[k] > passes) == wanted);
  }
  CHECK((residuals.max() > passes) == (expected.size() > 0));
}

} // namespace

TEST_CASE("a solved push passes in every family") {
  Slid slid;
  check_families(slid.judge(), {});
}

TEST_CASE("a friction force that no generator carries is seen by Newton and the cone") {
  Slid slid;
  slid.mutable_answer().contacts[2].friction_force[1] += 1e-5 * slid.force();
  check_families(slid.judge(), {newton, cone});
}

TEST_CASE("the grip force alone reacts to what the actuator should hold") {
  Slid slid;
  slid.owned.actuators[0].force *= 1 + 1e-5;
  check_families(slid.judge(), {grip});
}

TEST_CASE("the cone and dissipation react to slip and to the generators' forces") {
  Slid slid;
  // Point 0 slides along x: one generator takes all the friction, xi is its slip.
  slid.mutable_answer().contacts[0].slip -= 1e-5 * slid.unit();
  CHECK(slid.judge().dissipation > passes);
  slid.mutable_answer().contacts[0].slip += 2e-5 * slid.unit();
  CHECK(slid.judge().dissipation > passes); // the force no longer opposes the slip
  Slid other;
  Index strongest = 0;
  for (Index j = 1; j < 8; ++j)
    if (other.answer().friction[j] > other.answer().friction[strongest]) strongest = j;
  other.mutable_answer().friction[strongest] *= 1 - 1e-4;
  const Residuals<double> residuals = other.judge();
  CHECK(residuals.cone > passes); // sliding, yet not at the cone's limit
  CHECK(!(residuals.grip > passes));
  CHECK(!(residuals.rigidity > passes));
}

TEST_CASE("a contact acceleration that does not follow from the twists is a matter of rigidity") {
  Slid slid;
  slid.mutable_answer().contacts[1].acceleration[0] += 1e-5 * slid.unit();
  slid.mutable_answer().contacts[1].acceleration[1] += 1e-5 * slid.unit();
  check_families(slid.judge(), {rigidity});
}

TEST_CASE(
    "of a wide patch every point is told against at most 32 before it, all of its own patch") {
  Slide slide;
  slide.pads = ring(40, 0.005);
  SolvedPush<double> push(straight_slide(slide));
  REQUIRE(push.solve() == Status::solved);
  const Scene<double>& scene = push.scene;
  Index told = 0, expected = 0;
  check_rows(scene, push.scales(), push.answer(), 1.0, [&](const Violation<double>& row) {
    if (row.law != Law::rigidity || row.part < 3) return;
    ++told;
    Index first = -1;
    for (const Body<double>& body : scene.bodies)
      if (body.first_point <= row.of) first = body.first_point;
    CHECK(row.part - 3 >= first);
    CHECK(row.part - 3 < row.of);
    CHECK(row.of - (row.part - 3) <= 32);
  });
  for (const Body<double>& body : scene.bodies)
    for (Index k = 0; k < body.point_count; ++k) expected += k < 32 ? k : 32;
  CHECK(told == expected);
}

TEST_CASE("an object that leaves or enters its pusher fails as pusher and normal") {
  Slid slid;
  slid.mutable_answer().acceleration[0] += 1e-5 * slid.unit();
  const Residuals<double> residuals = slid.judge();
  CHECK(residuals.pusher > passes);
  CHECK(residuals.normal > passes);
  CHECK(residuals.newton > passes);
}

TEST_CASE("an actuator's closing moves its finger: the normal law sees it") {
  Slid slid;
  slid.mutable_answer().closing[0] += 1e-5 * slid.unit();
  const Residuals<double> residuals = slid.judge();
  CHECK(residuals.normal > passes);
  CHECK(!(residuals.newton > passes));
  CHECK(!(residuals.pusher > passes));
}

TEST_CASE("sigma scales the prescribed motion, here as in the solve") {
  Slid slid;
  const Residuals<double> residuals = check(slid.scene, slid.scales(), slid.answer(), 0.5);
  CHECK(residuals.pusher > passes);
  REQUIRE(slid.solve(0.5) == Status::solved);
  CHECK(slid.residuals.max() <= passes);
}

TEST_CASE("every normal force and every sliding friction force is watched") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(random_grasp<double>(seed));
    REQUIRE(push.solve() == Status::solved);
    for (ContactAnswer<double>& contact : push.memory.work.answer.contacts) {
      const ContactAnswer<double> right = contact;
      contact.normal_force += 1e-6 * push.scales().force;
      CHECK(check(push.scene, push.scales(), push.answer(), 1.0).max() > passes);
      contact = right;
      contact.friction_force[1] += 1e-6 * push.scales().force;
      CHECK(check(push.scene, push.scales(), push.answer(), 1.0).max() > passes);
      contact = right;
    }
  }
}

TEST_CASE("a friction force that is not the sum of its generators' forces is refused") {
  Slid slid;
  Answer<double>& answer = slid.mutable_answer();
  // Along the line that joins two points of a finger: no net force, no net moment.
  const Vector3<double> between = (slid.scene.points[2] - slid.scene.points[0]).normalized();
  answer.contacts[0].friction_force += 5 * slid.force() * between;
  answer.contacts[2].friction_force -= 5 * slid.force() * between;
  check_families(slid.judge(), {cone});
}

TEST_CASE("NaN never passes, wherever it stands") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](Slid& slid) { CHECK(!(slid.judge().max() <= passes)); };
  for (int which = 0; which < 8; ++which) {
    CAPTURE(which);
    Slid slid;
    Answer<double>& answer = slid.mutable_answer();
    if (which == 0) answer.acceleration[4] = nan;
    if (which == 1) answer.contacts[3].normal_force = nan;
    if (which == 2) answer.contacts[3].friction_force[2] = nan;
    if (which == 3) answer.contacts[3].acceleration[0] = nan;
    if (which == 4) answer.contacts[3].slip = nan;
    if (which == 5) answer.contacts[3].torsion = nan;
    if (which == 6) answer.friction[5] = nan;
    if (which == 7) answer.closing[1] = nan;
    refused(slid);
  }
}
