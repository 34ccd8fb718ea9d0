// Segments of sweeps against fresh solves.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/random_grasp.hpp"
#include "support/swept.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using namespace lcpush::test;
using lcpush::test::Random;

namespace {

/// What a segment says at a value of the parameter.
struct Line {
  double break_force;
  Vector3<double> force;
  Vector6<double> twist;
};
Line line_at(const SweepSegment& segment, double value) {
  const double share = (value - segment.from) / (segment.to - segment.from);
  const SweepValue &a = segment.at_from, &b = segment.at_to;
  return {a.breaking.normal + share * (b.breaking.normal - a.breaking.normal),
          a.push.force + share * (b.push.force - a.push.force),
          a.push.twist + share * (b.push.twist - a.push.twist)};
}

/// Fresh solves by the commands' own functions, cold and with their own choice of cover.
void check_against_fresh(const VariedScene& scene, const Sweep& sweep, double value,
                         const SweepSegment& segment, double tolerance) {
  CAPTURE(sweep.variations[0].parameter.path);
  CAPTURE(value);
  const SceneFile file = scene.at({sweep.variations[0].parameter}, {value});
  Push push(file);
  PushOptions options;
  options.other_paths = 0;
  const Index pusher = static_cast<Index>(file.bodies.size()) - 1;
  const Line line = line_at(segment, value);
  const BreakReport broken = push.find_breaking(pusher, options);
  CHECK(broken.status == segment.at_from.breaking.status);
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

/// 10 random points a segment; LCPUSH_POINTS_A_SEGMENT=100 for more.
Index points_a_segment() {
  const char* const text = std::getenv("LCPUSH_POINTS_A_SEGMENT");
  return text != nullptr ? std::atoi(text) : 10;
}

} // namespace

TEST_CASE("segments agree with fresh solves at 100 points in each and beside every breakpoint") {
  const VariedScene scene = with_facets(rigid(scene_text("straight_slide.toml")));
  check_segments(scene, swept(scene, "*.grip_force", 2, 30), 100, 1e-9);
  check_segments(scene, swept(scene, "*.grip_force", 30, 2), 20, 1e-9); // downwards
  check_segments(scene, swept(scene, "gravity[1]", -20, 5), 100, 1e-9);
}

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
    VariedScene scene = with_facets(scene_text(one.scene));
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
    const VariedScene scene = with_facets(determined_scene(random));
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

TEST_CASE("under pad a force is sampled, and its changes are found to a millionth of the range") {
  const Sweep sweep = swept(scene_text("straight_slide.toml"), "*.grip_force", 5, 30);
  CHECK(sweep.segments.empty());
  const auto has_change_at = [&](double value, double slack) {
    return std::any_of(sweep.points.begin(), sweep.points.end(), [&](const SweepPoint& point) {
      return !point.change.is_empty() && std::abs(point.value - value) <= slack;
    });
  };
  CHECK(has_change_at(6.52, 1e-6 * 25));
  CHECK(has_change_at(6.54, 1e-4 * 25));
  CHECK(std::abs(sweep.points.back().at.breaking.normal - 30) <= 1e-6);
}
