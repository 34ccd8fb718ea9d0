// A squeeze by normal forces alone, found before any pivot, proves that there is no answer.
#include <doctest/doctest.h>

#include "support/grasp_families.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"
#include "support/swept.hpp"
#include "sweep/proven_jam.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

TEST_CASE("no grasp that has an answer is a proved jam, whatever its friction could squeeze") {
  int solved = 0;
  for (const Family family : {Family::plain, Family::bilateral, Family::two_pushers, Family::stop})
    for (const Pressure pressure : {Pressure::rigid, Pressure::pad})
      for (std::uint64_t seed = 1; seed <= seeds(120); ++seed) {
        CAPTURE(static_cast<int>(family));
        CAPTURE(seed);
        OwnedScene<double> scene = grasp_of<double>(family, seed);
        scene.base.pressure = pressure;
        SolvedPush<double> push(scene);
        const bool is_solved = push.solve() == Status::solved;
        const bool is_jam = is_proven_jam(push.assembly);
        CHECK_FALSE((is_solved && is_jam));
        solved += is_solved ? 1 : 0;
      }
  CHECK(solved >= static_cast<int>(seeds(900)));
}

TEST_CASE("a wall against a stop is a proved jam at every step; one that moves away is not") {
  ParameterSweepOptions options;
  options.steps = 41;
  options.both_ways = false;
  for (const char* law : {"rigid", "pad", "even"}) {
    CAPTURE(law);
    const std::string text = "pressure = \"" + std::string(law) + "\"\n" + scene_text("jam.toml");
    const Sweep sweep = swept(text, "object.mass", 0.1, 0.4, options);
    CHECK_FALSE(sweep.complete);
    REQUIRE(sweep.points.size() == 41);
    for (const SweepPoint& point : sweep.points) {
      CHECK(point.at.push.status == Status::ray);
      CHECK(point.at.breaking.status == Status::ray);
    }
    // From across the stop on nothing jams.
    const Sweep turned = swept(text, "wall.turn", 0, 180, options);
    for (const SweepPoint& point : turned.points)
      CHECK((point.at.push.status == Status::solved) == (point.value > 89.99999));
  }
}
