// Scenes of many points: solved on the structured basis, as on the dictionary.
#include <doctest/doctest.h>

#include <string>

#include "lcpush/desktop/push.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

std::string disc(const std::string& name, const char* z, const char* normal, int points) {
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
                         disc("left", "0.005", "-1", 25) + disc("right", "-0.005", "1", 25) +
                         wall("[0.1, 0.03, 0]"),
                     "wide.toml");
}

/// Two discs, one above the other, and a line pusher: scenes of tests/bench/wide_discs.py.
SceneFile tipping(const std::string& object, const std::string& disc, const std::string& pusher) {
  std::string text = "pressure = \"pad\"\nfacets = 8\n" + object;
  for (const bool left : {true, false})
    text += std::string("[[finger]]\nname = \"") + (left ? "left" : "right") +
            "\"\nshape = \"disc\"\nnormal = [0, 0, " + (left ? "-1" : "1") + "]\n" + disc +
            (left ? "0.005]\n" : "-0.005]\n");
  return parse_scene(text + "[[pusher]]\nname = \"wall\"\nshape = \"line\"\nnormal = [1, 0, 0]\n" +
                         pusher,
                     "tipping.toml");
}

void check_solved(const SceneFile& file) {
  PushOptions options;
  options.other_paths = 0;
  Push push(file);
  const PushReport report = push.solve(options);
  REQUIRE(report.status == Status::solved);
  CHECK(report.residuals.max() <= 1e-9);
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
  options.other_paths = 0;
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

TEST_CASE("pads of many points that tip are solved") {
  const SceneFile file =
      tipping("gravity = [0, -9.81, 0]\n[object]\nmass = 0.0257\nbox = [0.1, 0.03, 0.01]\n"
              "[gripper]\njaws = \"parallel\"\n",
              "points = 64\nradius = 0.0043242\nfriction = 0.5771\ngrip_force = 35.958\n"
              "center = [-0.0083998, -0.0048862, ",
              "ends = [[-0.05, -0.0036156, 0], [-0.05, 0.0036156, 0]]\nfriction = 0.09592\n"
              "acceleration = [1.033, 0, 0]\nangular_acceleration = [0, 0.188, 1.215]\n");
  check_solved(file);

  const SceneFile harder =
      tipping("gravity = [0, -9.81, 5.886]\n[object]\nmass = 0.1856\nbox = [0.1, 0.03, 0.01]\n"
              "[gripper]\njaws = \"independent\"\n",
              "points = 80\nradius = 0.0047155\nfriction = 0.9433\ngrip_force = 51.068\n"
              "center = [0.0051141, -0.00091492, ",
              "ends = [[-0.05, -0.013918, 0.002], [-0.05, 0.013918, 0.002]]\nfriction = 0.7943\n"
              "acceleration = [1.332, -0.8669, 0]\nangular_acceleration = [0.534, 2.185, 0]\n");
  check_solved(harder);
}
