// Sweeps against closed forms.
#include <doctest/doctest.h>

#include <cmath>

#include "lcpush/desktop/input_error.hpp"
#include "support/swept.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

TEST_CASE("straight slide over the grip force: slope 2 mu and breakpoints to 1e-9") {
  // The wall carries the weight of 1.962 N by friction 0.3 N from 2 mu F = 6.54 N on; under a push
  // of 0.1 m/s^2 the inertia of 0.02 N helps.
  const Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 2, 30);
  check_covers(sweep);
  const SweepSegment& last = sweep.segments.back();
  CHECK(last.kind == SegmentKind::exact);
  CHECK(std::abs(last.from - 6.54) <= 1e-9);
  CHECK(std::abs(breakpoint_near(sweep, 6.52) - 6.52) <= 1e-9);
  const double slope =
      (last.at_to.breaking.normal - last.at_from.breaking.normal) / (last.to - last.from);
  CHECK(std::abs(slope - 1) <= 1e-9);
  CHECK(std::abs(last.at_to.breaking.normal - slope * last.to) <= 1e-8);
  CHECK(std::abs(last.at_to.push.force[0] - 30.02) <= 1e-8);
  CHECK(change_text(sweep, sweep.segments[sweep.segments.size() - 2]) ==
        "at breaking: wall sticks");
  CHECK(sweep.bistable.empty());
  CHECK(sweep.complete);
}

TEST_CASE("tipping over the tip's force: (m g + F) / 3, one segment or as many samples") {
  const auto tipping = [](const std::string& law) {
    return swept("pressure = \"" + law + "\"\n" + scene_text("tipping.toml"), "tip.grip_force", 1,
                 30);
  };
  const Sweep exact = tipping("rigid"), sampled = tipping("pad");
  REQUIRE(exact.segments.size() == 1);
  CHECK(exact.segments[0].kind == SegmentKind::exact);
  CHECK(std::abs(exact.segments[0].at_from.breaking.normal - (4.905 + 1) / 3) <= 1e-9);
  CHECK(std::abs(exact.segments[0].at_to.breaking.normal - (4.905 + 30) / 3) <= 1e-8);
  CHECK(sampled.segments.empty());
  for (const SweepPoint& point : sampled.points)
    CHECK(std::abs(point.at.breaking.normal - (4.905 + point.value) / 3) <= 1e-5);
}

TEST_CASE("a grasp that drops its load below some grip force says so, segment by segment") {
  // Fingers alone carry 2 mu F; nothing else touches the weight.
  const std::string text = rigid(
      lcpush::test::with(scene_text("straight_slide.toml"), "friction = 0.3", "friction = 0"));
  const Sweep sweep = swept(text, "*.grip_force", 1, 4);
  CHECK(sweep.segments.front().at_from.breaking.status == Status::does_not_hold);
  CHECK(sweep.segments.back().at_from.breaking.status == Status::solved);
  bool told = false;
  for (const SweepSegment& segment : sweep.segments)
    told = told || change_text(sweep, segment).find("the grasp holds the box") != std::string::npos;
  CHECK(told);
  CHECK(std::abs(breakpoint_near(sweep, 1.962) - 1.962) <= 1e-9);
}

TEST_CASE("rolling over the grip force: sharp at F*, and bistable where both motions are exact") {
  const std::string text = rigid(scene_text("rolling.toml"));
  const Sweep sharp = swept(text, "*.grip_force", 3, 4.8);
  const double g = 4.905, inertia = 0.5 * 0.5 * 0.1; // m g and I a / R^2
  const double rolls_to = (0.5 * g / (1 - 0.5 * 0.3) - inertia) / 0.6;
  CHECK(std::abs(breakpoint_near(sharp, rolls_to) - rolls_to) <= 1e-9);
  CHECK(change_text(sharp, sharp.segments.front()) ==
        "as prescribed: sheet begins to slip along -x");

  // At a sheet of 0.8 rolling goes on to F*, sliding begins earlier: the way back shows it.
  const Sweep two = swept(rigid(scene_text("rolling_two_answers.toml")), "*.grip_force", 7, 10);
  const double up_to = (0.8 * g / (1 - 0.8 * 0.3) - inertia) / 0.6;
  CHECK(std::abs(breakpoint_near(two, up_to) - up_to) <= 1e-9);
  REQUIRE(two.bistable.size() >= 1);
  CHECK(two.bistable.front().from < up_to);
  REQUIRE(!two.back.empty());
  CHECK(two.back.front().from == 10);
  CHECK(change_text(two, two.back.front()).find("the solution path turns back here") !=
        std::string::npos);
  CHECK(two.back.front().change.push.front().path == PathBreak::turned_back);
  CHECK(two.back.front().change.jumps);
}

TEST_CASE("where no pusher moves there is a push to report, and no breaking") {
  const std::string text = lcpush::test::with(
      rigid(scene_text("tipping.toml")), "acceleration = [0.1, 0, 0]", "acceleration = [0, 0, 0]");
  const Sweep sweep = swept(text, "tip.grip_force", 5, 10);
  CHECK(sweep.segments[0].at_from.breaking.status == Status::bad_input); // nothing moves: not asked
  CHECK(sweep.segments[0].at_from.push.status == Status::solved);
  CHECK(sweep.complete);
}

TEST_CASE("a range that leaves what is a scene is refused before anything is solved") {
  CHECK_THROWS_AS(swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 5, -5),
                  InputError);
}
