// Other forces that break the same grasp: by other covers and in mirrors.
#include "support/fixture_push.hpp"

#include "solve/scene_image.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

desktop::BreakReport broken(const desktop::SceneFile& file, const std::string& pusher) {
  Index b = 0;
  while (file.body_name(b) != pusher) ++b;
  return desktop::Push(file).find_breaking(b, {});
}

// Two rods without friction turn two discs of 40 points: on paper their own half-turned image.
desktop::SceneFile couple(const std::string& law = "pad") {
  std::string text = with(scene_text("two_pushers.toml"), "\"ring\"", "\"disc\"");
  text = with(text, "\ntitle", "\npressure = \"" + law + "\"\ntitle");
  return desktop::parse_scene(with(text, "points = 8", "points = 40"), "test.toml");
}

bool found(const desktop::BreakReport& report, double force) {
  if (std::abs(report.breaking.break_force - force) <= 1e-6) return true;
  return std::any_of(report.others.begin(), report.others.end(), [&](const auto& other) {
    return std::abs(other.break_force - force) <= 1e-6;
  });
}

} // namespace

TEST_CASE("[T.10] a scene and its image in a mirror are told of each other's breaking force") {
  for (const char* law : {"pad", "rigid"}) { // the literal laws: another force in every mirror
    CAPTURE(law);
    const desktop::SceneFile file = couple(law);
    const desktop::BreakReport own = broken(file, "upper");
    REQUIRE(own.status == Status::solved);
    CHECK(own.unique_force == Uniqueness::no);
    CHECK(own.largest_force() - own.least_force() > 0.005);
    for (const desktop::SceneImage& image : desktop::scene_images(file)) {
      const desktop::SceneFile mirrored = image.of(file);
      const desktop::BreakReport seen = broken(mirrored, "upper");
      REQUIRE(seen.status == Status::solved);
      CHECK(seen.unique_force == Uniqueness::no);
      CHECK(found(own, seen.breaking.break_force));
      CHECK(found(seen, own.breaking.break_force));
    }
  }
}

TEST_CASE("[T.10] where one force breaks the grasp its images know no other, in any direction") {
  for (const char* name : {"straight_slide.toml", "ground.toml", "tipping.toml", "lever.toml",
                           "rolling.toml", "three_finger_hand.toml"}) {
    CAPTURE(name);
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), "test.toml");
    const desktop::BreakReport report =
        desktop::Push(file).find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
    CHECK(report.unique_force == Uniqueness::none_other_found);
    CHECK(report.unique_motion == Uniqueness::none_other_found);
    CHECK(report.others.empty());
    CHECK(report.least_force() == report.breaking.break_force);
  }
}

TEST_CASE("[T.10] an image of an image is the scene, and a turn's mirror has the other sense") {
  const desktop::SceneFile file = couple();
  const auto images = desktop::scene_images(file);
  CHECK(images.size() == 7);
  for (const desktop::SceneImage& image : images) {
    const desktop::SceneFile back = image.of(image.of(file));
    for (std::size_t i = 0; i < file.points.size(); ++i)
      CHECK((back.points[i] - file.points[i]).norm() == 0);
  }
  const desktop::SceneImage across_x(Vector3<double>(-1, 1, 1));
  CHECK(across_x.of_turn(Vector3<double>(0, 0, 1)) == Vector3<double>(0, 0, -1));
  CHECK(across_x.of_turn(Vector3<double>(1, 0, 0)) == Vector3<double>(1, 0, 0));
}
