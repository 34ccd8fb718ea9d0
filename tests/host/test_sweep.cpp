// Sweeps against closed forms and against fresh solves.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>

#include "fixture_push.hpp"
#include "lcpush/host/input_error.hpp"
#include "lcpush/host/sweep.hpp"
#include "support/random_grasp.hpp"

using namespace lcpush;
using namespace lcpush::host;
using lcpush::test::Random;
using lcpush::test::scene_text;

namespace {

std::string rigid(const std::string& text) { return "pressure = \"rigid\"\n" + text; }

Sweep swept(const VariedScene& scene, const std::string& path, double from, double to,
            ParameterSweepOptions options = {}) {
  return sweep_parameter(scene, {{scene.find(path), from, to}}, options);
}
Sweep swept(const std::string& text, const std::string& path, double from, double to,
            const ParameterSweepOptions& options = {}) {
  return swept(VariedScene::parse(text, "test.toml"), path, from, to, options);
}

void check_covers(const Sweep& sweep) {
  REQUIRE(!sweep.segments.empty());
  CHECK(sweep.segments.front().from == sweep.variations[0].from);
  CHECK(sweep.segments.back().to == sweep.variations[0].to);
  CHECK(sweep.segments.back().change.empty());
  for (std::size_t i = 1; i < sweep.segments.size(); ++i) {
    CHECK(sweep.segments[i].from == sweep.segments[i - 1].to);
    CHECK(!sweep.segments[i - 1].change.empty());
  }
}

double breakpoint_near(const Sweep& sweep, double value) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < sweep.segments.size(); ++i)
    if (std::abs(sweep.segments[i].to - value) < std::abs(best - value))
      best = sweep.segments[i].to;
  return best;
}

/// What a segment says at a value of the parameter.
struct Line {
  double break_force;
  Vector3<double> force;
  Vector6<double> twist;
};
Line line_at(const SweepSegment& segment, double value) {
  const double share = (value - segment.from) / (segment.to - segment.from);
  const SweepValue &a = segment.at_from, &b = segment.at_to;
  return {a.break_force + share * (b.break_force - a.break_force),
          a.force + share * (b.force - a.force), a.twist + share * (b.twist - a.twist)};
}

/// Fresh solves by the commands' own functions, cold and with their own choice of cover.
void check_against_fresh(const VariedScene& scene, const Sweep& sweep, double value,
                         const SweepSegment& segment, double tolerance) {
  CAPTURE(sweep.variations[0].parameter.path);
  CAPTURE(value);
  const SceneFile file = scene.at({sweep.variations[0].parameter}, {value});
  Push push(file);
  PushOptions options;
  options.other_covers = 0;
  const Index pusher = static_cast<Index>(file.bodies.size()) - 1;
  const Line line = line_at(segment, value);
  const BreakReport broken = push.find_breaking(pusher, options);
  CHECK(broken.status == segment.at_from.breaking);
  if (broken.status == Status::solved)
    CHECK(std::abs(broken.breaking.break_force - line.break_force) <=
          tolerance * broken.scales.force);
  const PushReport solved = push.solve(options);
  REQUIRE(solved.status == Status::solved);
  const Vector6<double> wrench =
      body_wrench(file.view(), solved.answer, file.bodies[static_cast<std::size_t>(pusher)]);
  CHECK((wrench.head<3>() - line.force).norm() <= tolerance * solved.scales.force);
  CHECK((solved.answer.acceleration - line.twist).head<3>().norm() <=
        tolerance * solved.scales.acceleration);
}

void check_segments(const VariedScene& scene, const Sweep& sweep, Index points, double tolerance) {
  check_covers(sweep);
  Random random(7);
  for (const SweepSegment& segment : sweep.segments) {
    const double length = segment.to - segment.from;
    for (Index k = 0; k < points; ++k)
      check_against_fresh(scene, sweep, segment.from + random.uniform(0, 1) * length, segment,
                          tolerance);
    for (const double share : {1e-4, 1 - 1e-4}) // either side of every breakpoint
      check_against_fresh(scene, sweep, segment.from + share * length, segment, tolerance);
  }
}

/// Point fingers and a pusher without friction: the motion is unique.
std::string determined_scene(Random& random) {
  const auto number = [&](double from, double to) {
    return std::to_string(random.uniform(from, to));
  };
  std::string text = "pressure = \"rigid\"\ngravity = [" + number(-9, 9) + ", " + number(-9, 9) +
                     ", " + number(-9, 9) + "]\n[object]\nmass = 0.2\nbox = [0.1, 0.05, 0.02]\n";
  for (const int side : {1, -1})
    text += std::string("[[finger]]\nname = \"f") + (side > 0 ? "1" : "2") +
            "\"\nshape = \"point\"\ncenter = [" + number(-0.02, 0.02) + ", " + number(-0.01, 0.01) +
            ", " + (side > 0 ? "0.01" : "-0.01") + "]\nnormal = [0, 0, " + std::to_string(-side) +
            "]\nfriction = " + number(0.2, 1) + "\ngrip_force = " + number(5, 30) + "\n";
  return text + "[[pusher]]\nname = \"rod\"\nshape = \"point\"\ncenter = [-0.05, " +
         number(-0.02, 0.02) + ", 0]\nnormal = [1, 0, 0]\nfriction = 0\nacceleration = [1, " +
         number(-1, 1) + ", 0]\n";
}

} // namespace

TEST_CASE("straight slide over the grip force: slope 2 mu and breakpoints to 1e-9") {
  // The wall carries the weight of 1.962 N by friction 0.3 N from 2 mu F = 6.54 N on; under a push
  // of 0.1 m/s^2 the inertia of 0.02 N helps.
  const Sweep sweep = swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 2, 30);
  check_covers(sweep);
  const SweepSegment& last = sweep.segments.back();
  CHECK(last.kind == SegmentKind::exact);
  CHECK(std::abs(last.from - 6.54) <= 1e-9);
  CHECK(std::abs(breakpoint_near(sweep, 6.52) - 6.52) <= 1e-9);
  const double slope = (last.at_to.break_force - last.at_from.break_force) / (last.to - last.from);
  CHECK(std::abs(slope - 1) <= 1e-9);
  CHECK(std::abs(last.at_to.break_force - slope * last.to) <= 1e-8);
  CHECK(std::abs(last.at_to.force[0] - 30.02) <= 1e-8);
  CHECK(sweep.segments[sweep.segments.size() - 2].change == "at breaking: wall sticks");
  CHECK(sweep.bistable.empty());
  CHECK(sweep.complete);
}

TEST_CASE("the slope is 2 mu for every friction, aligned with a facet") {
  for (const double mu : {0.2, 0.7}) {
    const VariedScene scene =
        VariedScene::parse(rigid(scene_text("straight_slide.toml")), "test.toml");
    const SceneFile file = scene.at({scene.find("*.friction")}, {mu});
    std::string text = lcpush::test::with(rigid(scene_text("straight_slide.toml")),
                                          "friction = 0.5", "friction = " + std::to_string(mu));
    const Sweep sweep = swept(text, "*.grip_force", 60, 100);
    REQUIRE(sweep.segments.size() == 1);
    CHECK(std::abs(sweep.segments[0].at_from.break_force - 2 * mu * 60) <= 1e-8);
    CHECK(std::abs(sweep.segments[0].at_to.break_force - 2 * mu * 100) <= 1e-8);
  }
}

TEST_CASE("tipping over the tip's force: (m g + F) / 3, one segment under every law") {
  for (const char* law : {"rigid", "pad"}) {
    CAPTURE(law);
    const Sweep sweep =
        swept("pressure = \"" + std::string(law) + "\"\n" + scene_text("tipping.toml"),
              "tip.grip_force", 1, 30);
    REQUIRE(sweep.segments.size() == 1);
    const bool exact = std::string(law) == "rigid";
    CHECK((sweep.segments[0].kind == SegmentKind::exact) == exact);
    const double tolerance = exact ? 1e-9 : 1e-6;
    CHECK(std::abs(sweep.segments[0].at_from.break_force - (4.905 + 1) / 3) <= tolerance);
    CHECK(std::abs(sweep.segments[0].at_to.break_force - (4.905 + 30) / 3) <= 10 * tolerance);
  }
}

TEST_CASE("segments agree with fresh solves at 100 points in each and beside every breakpoint") {
  const VariedScene scene =
      VariedScene::parse(rigid(scene_text("straight_slide.toml")), "test.toml");
  check_segments(scene, swept(scene, "*.grip_force", 2, 30), 100, 1e-9);
  check_segments(scene, swept(scene, "*.grip_force", 30, 2), 20, 1e-9); // downwards
  check_segments(scene, swept(scene, "gravity[1]", -20, 5), 100, 1e-9);
}

namespace {
/// 10 random points a segment; LCPUSH_POINTS_A_SEGMENT=100 for more.
Index points_a_segment() {
  const char* const text = std::getenv("LCPUSH_POINTS_A_SEGMENT");
  return text != nullptr ? std::atoi(text) : 10;
}
} // namespace

TEST_CASE(
    "every kind of linear parameter, on scenes whose motion is unique, against fresh solves") {
  struct Case {
    const char *scene, *path;
    double from, to;
  };
  const Case cases[] = {
      {"tipping.toml", "tip.grip_force", 1, 30},
      {"tipping.toml", "gravity[1]", -20, -1},
      {"straight_slide.toml", "wall.acceleration[0]", 0.05, 5},
      {"straight_slide.toml", "wall.acceleration[1]", -0.2, 0.2},
      {"rolling.toml", "*.grip_force", 1, 4.75},
      {"rolling.toml", "sheet.acceleration[0]", 0.05, 2},
      {"rolling.toml", "gravity[1]", -20, -9},
      {"lever.toml", "*.grip_force", 1, 30},
      {"coin.toml", "gravity[1]", -20, -1},
      {"squeeze.toml", "*.grip_force", 1, 30},
  };
  Index segments = 0;
  for (const Case& one : cases) {
    CAPTURE(one.scene);
    CAPTURE(one.path);
    VariedScene scene = VariedScene::parse(scene_text(one.scene), one.scene);
    scene.set_pressure("rigid");
    const Sweep sweep = swept(scene, one.path, one.from, one.to);
    for (const BistableRange& range : sweep.bistable) CHECK_FALSE(range.motion);
    for (const SweepSegment& segment : sweep.segments) CHECK(segment.kind == SegmentKind::exact);
    check_segments(scene, sweep, points_a_segment(), 1e-8);
    segments += static_cast<Index>(sweep.segments.size());
  }
  CHECK(segments >= 15);
}

TEST_CASE("random grasps whose motion is unique: every linear parameter, against fresh solves") {
  Index breakpoints = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const VariedScene scene = VariedScene::parse(determined_scene(random), "test.toml");
    const auto check_one = [&](const char* path, double from, double to) {
      const Sweep sweep = swept(scene, path, from, to);
      CHECK(sweep.bistable.empty());
      CHECK(sweep.complete);
      check_segments(scene, sweep, points_a_segment(), 1e-8);
      breakpoints += static_cast<Index>(sweep.segments.size()) - 1;
    };
    check_one("f1.grip_force", 1, 40);
    check_one("*.grip_force", 1, 40);
    check_one("gravity[1]", -20, 20);
    check_one("rod.acceleration[1]", -3, 3);
    check_one("rod.angular_acceleration[2]", -30, 30);
  }
  CHECK(breakpoints >= 50);
}

TEST_CASE("a grasp that drops its load below some grip force says so, segment by segment") {
  // Fingers alone carry 2 mu F; nothing else touches the weight.
  const std::string text = rigid(
      lcpush::test::with(scene_text("straight_slide.toml"), "friction = 0.3", "friction = 0"));
  const Sweep sweep = swept(text, "*.grip_force", 1, 4);
  CHECK(sweep.segments.front().at_from.breaking == Status::does_not_hold);
  CHECK(sweep.segments.back().at_from.breaking == Status::solved);
  bool told = false;
  for (const SweepSegment& segment : sweep.segments)
    told = told || segment.change.find("the grasp holds the object") != std::string::npos;
  CHECK(told);
  CHECK(std::abs(breakpoint_near(sweep, 1.962) - 1.962) <= 1e-9);
}

TEST_CASE("rolling over the grip force: sharp at F*, and bistable where both motions are exact") {
  const std::string text = rigid(scene_text("rolling.toml"));
  const Sweep sharp = swept(text, "*.grip_force", 3, 4.8);
  const double g = 4.905, inertia = 0.5 * 0.5 * 0.1; // m g and I a / R^2
  const double rolls_to = (0.5 * g / (1 - 0.5 * 0.3) - inertia) / 0.6;
  CHECK(std::abs(breakpoint_near(sharp, rolls_to) - rolls_to) <= 1e-9);
  CHECK(sharp.segments.front().change == "as prescribed: sheet starts to slide along -x");

  // At a sheet of 0.8 rolling goes on to F*, sliding begins earlier: the way back shows it.
  const Sweep two = swept(scene_text("rolling_two_answers.toml"), "*.grip_force", 7, 10);
  const double up_to = (0.8 * g / (1 - 0.8 * 0.3) - inertia) / 0.6;
  CHECK(std::abs(breakpoint_near(two, up_to) - up_to) <= 1e-9);
  REQUIRE(two.bistable.size() >= 1);
  CHECK(two.bistable.front().from < up_to);
  REQUIRE(!two.back.empty());
  CHECK(two.back.front().from == 10);
  CHECK(two.back.front().change.find("the solution path turns back here") != std::string::npos);
  CHECK(two.back.front().jumps);
}

TEST_CASE("a motion that changes its sign jumps where it is zero, and breaks on either side") {
  const Sweep sweep = swept(rigid(scene_text("rolling.toml")), "sheet.acceleration[0]", -1, 1);
  REQUIRE(sweep.segments.size() == 2);
  CHECK(std::abs(sweep.segments[0].to) <= 1e-12);
  CHECK(sweep.segments[0].jumps);
  CHECK(sweep.segments[0].at_from.force[0] == doctest::Approx(-sweep.segments[1].at_to.force[0]));
  for (const SweepSegment& segment : sweep.segments)
    CHECK(segment.at_from.breaking == Status::solved);
}

TEST_CASE("a jam over the whole range is one unsolved segment that says ray") {
  const Sweep sweep = swept(rigid(scene_text("jam.toml")), "*.grip_force", 1, 9);
  REQUIRE(sweep.segments.size() == 1);
  CHECK(sweep.segments[0].kind == SegmentKind::unsolved);
  CHECK(sweep.segments[0].at_from.push == Status::ray);
  CHECK_FALSE(sweep.complete);
}

TEST_CASE("under pad the segments are bisected, and agree with fresh solves") {
  const VariedScene scene = VariedScene::parse(scene_text("straight_slide.toml"), "test.toml");
  const Sweep sweep = swept(scene, "*.grip_force", 5, 30);
  for (const SweepSegment& segment : sweep.segments) CHECK(segment.kind == SegmentKind::bisected);
  CHECK(std::abs(breakpoint_near(sweep, 6.52) - 6.52) <= 1e-6);
  CHECK(std::abs(breakpoint_near(sweep, 6.54) - 6.54) <= 3e-5 * 25);
  const SweepSegment& last = sweep.segments.back();
  CHECK(std::abs(last.at_to.break_force - 30) <= 1e-6);
  CHECK(std::abs((last.at_to.break_force - last.at_from.break_force) / (last.to - last.from) - 1) <=
        1e-6);
  check_segments(scene, sweep, 10, 1e-4);
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
    CHECK(warm.cold <= 6);
    CHECK(cold.warm == 0);
    REQUIRE(warm.points.size() == cold.points.size());
    for (std::size_t i = 0; i < warm.points.size(); ++i) {
      const SweepValue &a = warm.points[i].at, &b = cold.points[i].at;
      CHECK(a.break_force == doctest::Approx(b.break_force).epsilon(1e-6));
      CHECK((a.force - b.force).norm() <= 1e-6 * b.force.norm());
    }
  }
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
    told = told || point.change.find("wall sticks") != std::string::npos;
  CHECK(told);
  CHECK(sweep.points.front().modes.size() == sweep.contacts.size());
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
    CHECK(sweep.points[6 + i].at.break_force ==
          doctest::Approx(2 * sweep.points[i].at.break_force).epsilon(1e-6));
}

TEST_CASE("where no pusher moves there is a push to report, and no breaking") {
  const std::string text = lcpush::test::with(
      rigid(scene_text("tipping.toml")), "acceleration = [0.1, 0, 0]", "acceleration = [0, 0, 0]");
  const Sweep sweep = swept(text, "tip.grip_force", 5, 10);
  CHECK(sweep.segments[0].at_from.breaking == Status::bad_input); // nothing moves: not asked
  CHECK(sweep.segments[0].at_from.push == Status::solved);
  CHECK(sweep.complete);
}

TEST_CASE("a range that leaves what is a scene is refused before anything is solved") {
  CHECK_THROWS_AS(swept(rigid(scene_text("straight_slide.toml")), "*.grip_force", 5, -5),
                  InputError);
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
  const Sweep two = swept(scene_text("rolling_two_answers.toml"), "*.grip_force", 7, 10);
  REQUIRE(two.bistable.size() == 2);
  CHECK(two.bistable[0].motion);
  CHECK(two.bistable[0].to == doctest::Approx(0.8 * 4.905 / (1 - 0.8 * 0.3) / 0.6));
  CHECK_FALSE(two.bistable[1].motion); // held both ways
}

TEST_CASE("a count takes no range") {
  const VariedScene scene = VariedScene::parse(scene_text("pivot.toml"), "pivot.toml");
  CHECK_THROWS_AS(swept(scene, "facets", 4, 16), InputError);
}
