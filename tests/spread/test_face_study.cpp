// Single faces: which count at the instant of breaking, and slides between two generators.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/spread.hpp"
#include "spread/face_study.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::ContactMode;
using desktop::FaceStudy;
using desktop::SpreadReport;
using Kind = ContactMode::Kind;

namespace {

// A point finger on each side, which hold 10 N in all, and a rod without friction.
desktop::SceneFile scene(const std::string& gravity, const std::string& normal,
                         const std::string& motion) {
  const auto finger = [](const char* name, const char* z, const char* n) {
    return std::string("[[finger]]\nname = \"") + name + "\"\nshape = \"point\"\ncenter = [0, 0, " +
           z + "]\nnormal = [0, 0, " + n + "]\nfriction = 0.5\ngrip_force = 10\n";
  };
  return desktop::parse_scene(
      "facets = 4\nplanar = true\ngravity = " + gravity + "\n[gripper]\njaws = \"independent\"\n" +
          "[object]\nmass = 1\nbox = [0.1, 0.1, 0.01]\n" + finger("left", "0.005", "-1") +
          finger("right", "-0.005", "1") +
          "[[pusher]]\nname = \"rod\"\nshape = \"point\"\ncenter = [0, 0, 0]\nfriction = 0\n"
          "normal = " +
          normal + "\nacceleration = " + motion + "\n",
      "test.toml");
}

} // namespace

TEST_CASE("[T.15] a face with an answer at rest alone says nothing about breaking") {
  // The rod pushes along x, the fingers' friction, all of it upwards, just carries 10 N: an answer
  // at rest. To slip downwards rather than along x the box would have to fall, which nothing makes
  // it do.
  desktop::LiteralProblem problem(scene("[0, -10, 0]", "[1, 0, 0]", "[0.1, 0, 0]"));
  SpreadReport report;
  report.contacts.resize(3);
  FaceStudy study(problem, report, true);
  std::vector<desktop::Face::Answer> corners;
  const ContactMode rod{Kind::stick, false, {}};
  const double enough = 1e9;
  // +y is generator 3 of the left finger, whose o is -y, and 1 of the right one.
  CHECK(study.study({{Kind::slide, false, {3}}, {Kind::slide, false, {1}}, rod}, enough, corners) ==
        FaceStudy::Result::empty);
  // Between -x and +y it slips down no faster than along x, and a little friction is left for that.
  CHECK(study.study({{Kind::slide, false, {2, 3}}, {Kind::slide, false, {1, 2}}, rod}, enough,
                    corners) == FaceStudy::Result::studied);
}

TEST_CASE("[T.15] a push between two generators slides between them, along neither") {
  // Friction of 10 N, shared between -x and -y alone: 10 / sqrt 2 along the push.
  const desktop::SceneFile file =
      scene("[0, 0, 0]", "[1, 1, 0]", "[0.070710678118654752, 0.070710678118654752, 0]");
  for (const bool breaking : {false, true}) {
    desktop::SpreadOptions options;
    options.breaking = breaking;
    const SpreadReport report = desktop::find_spread(file, options);
    REQUIRE(report.status == Status::solved);
    CHECK(report.complete);
    const double push = 10 / std::sqrt(2.0) + (breaking ? 0 : 0.1);
    CHECK(report.pushers[0].force.low == doctest::Approx(push));
    CHECK(report.pushers[0].force.high == doctest::Approx(push));
  }
}
