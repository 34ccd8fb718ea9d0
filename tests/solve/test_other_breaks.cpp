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

// Two rods without friction turn two patches of 40 points: the scene is its own half-turned image.
desktop::SceneFile couple(const std::string& law, const std::string& shape, int facets) {
  std::string text = with(scene_text("two_pushers.toml"), "\"ring\"", '"' + shape + '"');
  text = with(text, "facets = 16", "facets = " + std::to_string(facets));
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
  struct Case {
    const char *law, *shape;
    int facets;
  };
  for (const Case& at :
       {Case{"pad", "disc", 16}, Case{"rigid", "disc", 8}, Case{"rigid", "ring", 8}}) {
    CAPTURE(at.law);
    CAPTURE(at.shape);
    const desktop::SceneFile file = couple(at.law, at.shape, at.facets);
    const desktop::BreakReport own = broken(file, "upper");
    REQUIRE(own.status == Status::solved);
    if (file.pressure == Pressure::rigid) { // which leaves a patch's pressure open
      CHECK(own.unique_force == Uniqueness::no);
      REQUIRE(own.other_force);
      CHECK(std::abs(*own.other_force - own.breaking.break_force) > 0.0025);
    }
    for (const desktop::SceneImage& image : desktop::scene_images(file)) {
      const desktop::SceneFile mirrored = image.of(file);
      const desktop::BreakReport seen = broken(mirrored, "upper");
      REQUIRE(seen.status == Status::solved);
      if (std::abs(seen.breaking.break_force - own.breaking.break_force) > 1e-3)
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
  }
}

TEST_CASE("[T.10] a patch that is its own image keeps its points' order; a turn's sense changes") {
  const desktop::SceneFile file = couple("pad", "ring", 8);
  const auto images = desktop::scene_images(file);
  CHECK(images.size() == 7);
  const desktop::SceneImage half_turn(Vector3<double>(-1, -1, 1));
  const desktop::SceneFile turned = half_turn.of(file);
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    const bool is_rod = i + 2 >= file.points.size();
    const Vector3<double> there = is_rod ? half_turn.of_vector(file.points[i]) : file.points[i];
    CHECK((turned.points[i] - there).norm() <= 1e-15);
  }
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    CHECK(std::abs(turned.bodies[b].tangent.dot(file.bodies[b].tangent)) == doctest::Approx(1));
  const desktop::SceneImage across_x(Vector3<double>(-1, 1, 1));
  CHECK(across_x.of_turn(Vector3<double>(0, 0, 1)) == Vector3<double>(0, 0, -1));
  CHECK(across_x.of_turn(Vector3<double>(1, 0, 0)) == Vector3<double>(1, 0, 0));
}
