// Scenes of many points: solved on the structured basis, as on the dictionary.
#include <doctest/doctest.h>

#include <string>

#include "lcpush/desktop/push.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

std::string disc(const std::string& name, const char* z, const char* normal, int points = 25) {
  return "[[finger]]\nname = \"" + name + "\"\nshape = \"disc\"\ncenter = [0.01, 0.002, " + z +
         "]\nnormal = [0, 0, " + normal + "]\nradius = 0.006\npoints = " + std::to_string(points) +
         "\nfriction = 0.5\ngrip_force = 20\n";
}

std::string wall(const std::string& acceleration) {
  return "[[pusher]]\nname = \"wall\"\nshape = \"line\"\n"
         "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]\nnormal = [1, 0, 0]\n"
         "friction = 0.3\nacceleration = " +
         acceleration + "\n";
}

SceneFile wide_scene() {
  return parse_scene("[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n" +
                         disc("left", "0.005", "-1") + disc("right", "-0.005", "1") +
                         wall("[0.1, 0.03, 0]"),
                     "wide.toml");
}

struct Counter : Watcher {
  Index structured = 0, dense = 0;
  void stepped(const Lemke<double>&) override { ++dense; }
  void progressed(Index, Index) override { ++structured; }
};

} // namespace

TEST_CASE("many points: the structured basis is taken, and finds what the dictionary finds") {
  const SceneFile file = wide_scene();
  Counter counter, dense_counter;
  PushOptions options;
  options.other_covers = 0;
  options.watcher = &counter;
  Push push(file);
  (void)push.holds_without_push({}); // a smaller problem first: the memory has to grow
  const PushReport report = push.solve(options);
  REQUIRE(report.status == Status::solved);
  CHECK(report.residuals.max() <= 1e-9);
  CHECK(counter.structured > 0); // few: the modes of a slide are predicted
  CHECK(counter.dense == 0);
  options.dense = true;
  options.watcher = &dense_counter;
  Push whole(file);
  const PushReport second = whole.solve(options);
  REQUIRE(second.status == Status::solved);
  CHECK(dense_counter.dense > 20);
  CHECK(dense_counter.structured == 0);
  const Vector6<double> difference = report.answer.acceleration - second.answer.acceleration;
  CHECK(difference.norm() <= 1e-6 * second.answer.acceleration.norm());
}

TEST_CASE("fine pyramids: the slides turn to the pads' motion at once, not by a pivot a point") {
  const SceneFile file = parse_scene(
      "facets = 256\ngravity = [0, -9.81, 0]\n[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n"
      "[gripper]\njaws = \"parallel\"\n" +
          disc("left", "0.005", "-1", 60) + disc("right", "-0.005", "1", 60) + wall("[0.1, 0, 0]"),
      "fine.toml");
  PushOptions options;
  options.other_covers = 0;
  Push push(file);
  const PushReport report = push.solve(options);
  REQUIRE(report.status == Status::solved);
  CHECK(report.residuals.max() <= 1e-9);
  CHECK(report.run.pivots < 120); // a point would be one; without turns there are 569
}
