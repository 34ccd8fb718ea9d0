// Other forces that break the same grasp: on other paths of pivots.
#include "support/fixture_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

desktop::BreakReport broken(const desktop::SceneFile& file, const std::string& pusher) {
  Index b = 0;
  while (file.body_name(b) != pusher) ++b;
  return desktop::Push(file).find_breaking(b, {});
}

// Two rods without friction turn two patches of 40 points: the scene is its own half-turned image.
desktop::SceneFile couple(const std::string& law, const std::string& shape, int facets) {
  std::string text = with(scene_text("two_pushers.toml"), "\"ring\"", '"' + shape + '"');
  text = with(text, "facets = 16", "facets = " + std::to_string(facets));
  text = with(text, "\ntitle", "\npressure = \"" + law + "\"\ntitle");
  return desktop::parse_scene(with(text, "points = 8", "points = 40"), "test.toml");
}

} // namespace

TEST_CASE(
    "[T.10] rigid patches leave their pressure open: another force breaks the grasp as well") {
  for (const char* shape : {"disc", "ring"}) {
    CAPTURE(shape);
    const desktop::BreakReport own = broken(couple("rigid", shape, 8), "upper");
    REQUIRE(own.status == Status::solved);
    CHECK(own.unique_force == Uniqueness::no);
    REQUIRE(own.other_force);
    CHECK(std::abs(*own.other_force - own.breaking.break_force) > 0.0025);
  }
}

TEST_CASE("[T.10] where one force breaks the grasp other paths know no other") {
  for (const char* name : {"straight_slide.toml", "ground.toml", "tipping.toml", "lever.toml",
                           "rolling.toml", "three_finger_hand.toml"}) {
    CAPTURE(name);
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), "test.toml");
    const desktop::BreakReport report =
        desktop::Push(file).find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
    CHECK(report.unique_force == Uniqueness::none_other_found);
    CHECK(report.unique_motion == Uniqueness::none_other_found);
    CHECK(report.others.empty());
  }
}

TEST_CASE("[T.10] pads under round friction go on from push to push: a break takes few rounds") {
  // A box is pushed against its weight's direction: the wall bears the weight, the pads slide.
  const double mu = 0.764, F = 7.366;
  const desktop::SceneFile file = desktop::parse_scene(R"(
gravity = [0, -9.81, 0]
[object]
mass = 0.088
box = ["66 mm", "36.6 mm", "112.5 mm"]
[[finger]]
name = "left"
shape = "disc"
on = "+z"
radius = "3.6 mm"
friction = 0.764
grip_force = 7.366
points = 12
[[finger]]
name = "right"
shape = "disc"
on = "-z"
radius = "3.6 mm"
friction = 0.764
grip_force = 7.366
points = 12
[[pusher]]
name = "wall"
shape = "line"
on = "+x"
along = "y"
length = "53 mm"
friction = 0.8
velocity = [-0.01, 0, 0]
)",
                                                       "test.toml");
  const desktop::BreakReport report = broken(file, "wall");
  REQUIRE(report.status == Status::solved);
  CHECK(report.breaking.break_force == doctest::Approx(2 * mu * F).epsilon(1e-6));
  CHECK(report.run.rounds < 40); // each push from nothing: over a hundred
}
