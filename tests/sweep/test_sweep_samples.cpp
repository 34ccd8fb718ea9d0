// Sweeps in samples, their zeros, their maps.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/input_error.hpp"
#include "support/swept.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;

TEST_CASE("a motion that changes its sign jumps where it is zero, and breaks on either side") {
  const Sweep sweep = swept(rigid(scene_text("rolling.toml")), "sheet.acceleration[0]", -1, 1);
  REQUIRE(sweep.segments.size() == 2);
  CHECK(std::abs(sweep.segments[0].to) <= 1e-12);
  CHECK(sweep.segments[0].change.jumps);
  CHECK(sweep.segments[0].at_from.push.force[0] ==
        doctest::Approx(-sweep.segments[1].at_to.push.force[0]));
  for (const SweepSegment& segment : sweep.segments)
    CHECK(segment.at_from.breaking.status == Status::solved);
}

TEST_CASE("samples: warm and cold agree, and few solves are cold") {
  for (const char* law : {"rigid", "pad"}) {
    CAPTURE(law);
    const std::string text =
        "pressure = \"" + std::string(law) + "\"\n" + scene_text("straight_slide.toml");
    ParameterSweepOptions options;
    options.steps = 60;
    options.both_ways = false;
    const Sweep warm = swept(text, "*.friction", 0.25, 0.9, options);
    options.warm = false;
    const Sweep cold = swept(text, "*.friction", 0.25, 0.9, options);
    // Pads break from nothing, once a point.
    CHECK(warm.cold <= 6 + (std::string(law) == "pad" ? 61 : 0));
    CHECK(cold.warm == 0);
    REQUIRE(warm.points.size() == cold.points.size());
    for (std::size_t i = 0; i < warm.points.size(); ++i) {
      const SweepValue &a = warm.points[i].at, &b = cold.points[i].at;
      CHECK(a.breaking.normal == doctest::Approx(b.breaking.normal).epsilon(1e-6));
      CHECK((a.push.force - b.push.force).norm() <= 1e-6 * b.push.force.norm());
    }
  }
}

TEST_CASE("a force that breaks nothing does not tell two ways apart") {
  ParameterSweepOptions options;
  options.steps = 40;
  const Sweep sweep =
      swept(scene_text("rolling_two_answers.toml"), "*.friction", 0.15, 0.6, options);
  CHECK(std::all_of(sweep.points.begin(), sweep.points.end(),
                    [](const SweepPoint& point) { return !point.at.breaking.breaks; }));
  CHECK(sweep.bistable.empty());
}

TEST_CASE("samples are refined to 1e-6 of the range where modes change") {
  // Over the friction of all bodies the wall starts to stick where 2 mu F mu >= m g.
  ParameterSweepOptions options;
  options.steps = 5;
  const Sweep sweep =
      swept(rigid(scene_text("straight_slide.toml")), "*.friction", 0.1, 0.9, options);
  const double sticks = std::sqrt(1.962 / 40);
  double before = 0, after = 1;
  for (const SweepPoint& point : sweep.points)
    (point.value < sticks ? before : after) =
        point.value < sticks ? std::max(before, point.value) : std::min(after, point.value);
  CHECK(after - before <= 1e-6);
  bool told = false;
  for (const SweepPoint& point : sweep.points)
    told = told || change_text(sweep, point).find("wall sticks") != std::string::npos;
  CHECK(told);
  CHECK(sweep.points.front().modes.size() == sweep.scene.points.size());
}

TEST_CASE("two parameters make a map, row by row") {
  const VariedScene scene = VariedScene::parse(scene_text("pivot.toml"), "test.toml");
  ParameterSweepOptions options;
  options.steps = 3;
  const Sweep sweep = sweep_parameter(
      scene, {{scene.find("edge.shift[0]"), 0, 0.02}, {scene.find("*.grip_force"), 10, 20}},
      options);
  REQUIRE(sweep.points.size() == 9);
  CHECK(sweep.points[1].value == 0.01);
  CHECK(*sweep.points[1].second == 10);
  CHECK(*sweep.points[3].second == 15);
  // Without weight everything is in proportion to the grip.
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(sweep.points[6 + i].at.breaking.normal ==
          doctest::Approx(2 * sweep.points[i].at.breaking.normal).epsilon(1e-6));
}

TEST_CASE("zeros of the motion: a point pusher keeps the bar straight at one height") {
  // The weight's moment about the point, 50 mm from the grip, against the push of 20.02 N.
  const double height = -0.05 * 1.962 / 20.02;
  for (const char* law : {"rigid", "pad"}) {
    CAPTURE(law);
    const std::string text =
        "pressure = \"" + std::string(law) + "\"\n" + scene_text("straight_slide_point.toml");
    for (const bool downwards : {false, true}) {
      ParameterSweepOptions options;
      options.steps = 7;
      const Sweep sweep = downwards ? swept(text, "wall.shift[1]", 0.003, -0.008, options)
                                    : swept(text, "wall.shift[1]", -0.008, 0.003, options);
      Index found = 0;
      for (const SweepZero& zero : sweep.zeros) {
        if (zero.component != 5 || zero.jumps) continue;
        ++found;
        CHECK(zero.from == zero.to);
        if (std::string(law) == "pad") CHECK(std::abs(zero.from - height) <= 1e-9);
      }
      if (std::string(law) == "pad") CHECK(found == 1);
      for (std::size_t i = 1; i < sweep.points.size(); ++i)
        CHECK((sweep.points[i].value > sweep.points[i - 1].value) != downwards);
    }
  }
}

TEST_CASE("zeros of the motion: exact on segments, ranges where the bar stays straight") {
  const Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 2, 30);
  // From 6.52 N on the wall carries the weight, and the bar no longer slides down.
  bool told = false;
  for (const SweepZero& zero : sweep.zeros)
    if (zero.component == 1) {
      told = true;
      CHECK(std::abs(zero.from - 6.52) <= 1e-9);
      CHECK(zero.to == 30);
    }
  CHECK(told);
  // The sheet's motion changes its sign, and the cylinder's rotation jumps with it.
  const Sweep turned = swept(rigid(scene_text("rolling.toml")), "sheet.acceleration[0]", -1, 1);
  bool crossed = false;
  for (const SweepZero& zero : turned.zeros)
    crossed = crossed || (zero.component == 5 && std::abs(zero.from) <= 1e-12);
  CHECK(crossed);
}

TEST_CASE("bistable: other motions are told from other forces") {
  const Sweep two = swept(rigid(scene_text("rolling_two_answers.toml")), "*.grip_force", 7, 10);
  REQUIRE(two.bistable.size() == 2);
  CHECK(two.bistable[0].motion);
  CHECK(two.bistable[0].to == doctest::Approx(0.8 * 4.905 / (1 - 0.8 * 0.3) / 0.6));
  CHECK_FALSE(two.bistable[1].motion); // held both ways
  CHECK(two.bistable[1].force_share > 0.5);
}

TEST_CASE("bistable: what rounding leaves of a motion that is zero is no other answer") {
  ParameterSweepOptions options;
  options.steps = 9;
  CHECK(swept(rigid(scene_text("rolling.toml")), "*.friction", 0.1, 0.9, options).bistable.empty());
}

TEST_CASE("a sample beside which there is no answer has lost it, whatever its contacts do") {
  ParameterSweepOptions options;
  options.steps = 9;
  const VariedScene scene =
      VariedScene::parse(scene_text("coin_jammed.toml", "rays"), "coin_jammed.toml");
  const Sweep sweep = swept(scene, "*.friction", 0, 0.5, options);
  Index lost = 0;
  for (const SweepPoint& point : sweep.points)
    for (const AnswerChange& change : point.change.push)
      lost += change.kind == AnswerChange::Kind::lost ? 1 : 0;
  CHECK(lost == 1);
}

TEST_CASE("a count takes no range") {
  const VariedScene scene = VariedScene::parse(scene_text("pivot.toml"), "pivot.toml");
  CHECK_THROWS_AS(swept(scene, "facets", 4, 16), InputError);
}
