// The C interface where flash is little: compiled, with the interface itself, for
// LCPUSH_LITTLE_FLASH.
#include "support/c_grasp.hpp"

using namespace lcpush;
using namespace lcpush::test;

static_assert(little_flash, "what is tested is another build");

namespace {

/// A push in memory of its own, of exactly the bytes that the macro says.
struct LittlePush {
  std::vector<double> memory;
  lcpushf_push* push;

  explicit LittlePush(const CGrasp& grasp) {
    const lcpushf_scene& scene = grasp.scene;
    const lcpush_size size{scene.body_count,     scene.point_count, 8,
                           scene.actuator_count, scene.drive_count, 0};
    const std::size_t bytes =
        LCPUSH_BYTES(float, size.bodies, size.points, size.facets, size.actuators, size.drives);
    memory.resize(bytes / sizeof(double) + 1);
    push = lcpushf_make(memory.data(), bytes, &size);
    REQUIRE(push != nullptr);
  }
};

} // namespace

TEST_CASE("a thousand grasps in float with little flash: at least 995 solved, none of them wrong") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid})
    for (const Index facets : {4, 8}) check_a_thousand(pressure, facets);
}

TEST_CASE("what little flash leaves out is refused, and the next scene is solved") {
  OwnedScene<float> owned = grasp_of<float>(Family::even, 1);
  CGrasp grasp(owned);
  LittlePush little(grasp);
  grasp.scene.pressure = LCPUSH_EVEN;
  CHECK(lcpushf_describe(little.push, &grasp.scene) == LCPUSH_BAD_INPUT);
  CHECK(lcpushf_why(little.push) == LCPUSH_UNSUPPORTED);
  grasp.scene.pressure = LCPUSH_PAD;
  grasp.scene.facets = LCPUSH_ROUND;
  CHECK(lcpushf_describe(little.push, &grasp.scene) == LCPUSH_BAD_INPUT);
  CHECK(lcpushf_why(little.push) == LCPUSH_UNSUPPORTED);
  CHECK(lcpushf_solve(little.push) == LCPUSH_BAD_INPUT);
  grasp.scene.facets = 8;
  CHECK(lcpushf_describe(little.push, &grasp.scene) == LCPUSH_RUNNING);
  CHECK(lcpushf_solve(little.push) == LCPUSH_SOLVED);
}

TEST_CASE("with little flash, too, a grasp breaks or does not hold") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) check_breaks(pressure);
}

TEST_CASE("with little flash a command goes on from the last basis, to the answer of a new scene") {
  int compared = 0, quicker = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    OwnedScene<float> owned = grasp_of<float>(Family::plain, seed);
    if (owned.points.size() > 12) continue;
    CAPTURE(seed);
    owned.base.facets = 4;
    CGrasp grasp(owned);
    LittlePush commanded(grasp), anew(grasp);
    REQUIRE(lcpushf_describe(commanded.push, &grasp.scene) == LCPUSH_RUNNING);
    if (lcpushf_solve(commanded.push) != LCPUSH_SOLVED) continue;
    std::vector<float> forces;
    for (lcpushf_actuator& actuator : grasp.actuators) forces.push_back(actuator.force *= 1.01F);
    REQUIRE(lcpushf_command(commanded.push, forces.data(), nullptr) == LCPUSH_RUNNING);
    REQUIRE(lcpushf_describe(anew.push, &grasp.scene) == LCPUSH_RUNNING);
    if (lcpushf_solve(anew.push) != LCPUSH_SOLVED) continue;
    CHECK(lcpushf_solve(commanded.push) == LCPUSH_SOLVED);
    CHECK(violation(grasp, commanded.push) <= 2e-4);
    quicker += lcpushf_pivots(commanded.push) * 2 < lcpushf_pivots(anew.push) ? 1 : 0;
    ++compared;
  }
  CHECK(compared >= 20);
  CHECK(quicker * 10 >= compared * 7);
}
