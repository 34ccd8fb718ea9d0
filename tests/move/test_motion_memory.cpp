// What a motion needs more than its first instant does.
#include "lcpush/desktop/move.hpp"

#include "support/fixture_push.hpp"

#include <cmath>

using namespace lcpush;
using namespace lcpush::desktop;

TEST_CASE("under even pressure a motion goes on when rounding has tilted the object") {
  // Every point has an actuator, and friction on a face that has turned works on its closing.
  const SceneFile file =
      read_scene(LCPUSH_SOURCE_DIR "/docs/studies/offset_push.toml", Strokes::all);
  MoveOptions options;
  options.time = 0.2;
  options.step = 0.002;
  const MotionReport report = move(file, options);
  CHECK(report.status == Status::solved);
  CHECK(report.end == MoveEnd::time);
  CHECK(std::abs(report.frames.back().pose.position.y() - 0.002) <= 1e-9);
}

TEST_CASE("pads of even pressure follow a face that tilts, however many they are") {
  // Nothing resists the tilt; a pad is a point, and has an actuator of its own.
  const std::string pad = "radius = 0.005; points = 40; friction = 0.5; grip_force = 20; ";
  const SceneFile file = parse_scene(
      test::table("", "pressure = \"even\"; gravity = [0, -9.81, 0]") +
          test::table("[object]", "mass = 0.2; box = [0.1, 0.03, 0.01]") +
          test::finger("left", "ring", pad + "center = [0, 0, 0.005]; normal = [0, 0, -1]") +
          test::finger("right", "ring", pad + "center = [0, 0, -0.005]; normal = [0, 0, 1]") +
          test::pusher("rod", "point",
                       "center = [-0.05, 0.005, 0.002]; normal = [1, 0, 0]; friction = 0.3; "
                       "velocity = [0.01, 0, 0]"),
      "s.toml", Strokes::all);
  MoveOptions options;
  options.time = 0.05;
  options.step = 0.001;
  const MotionReport report = move(file, options);
  CHECK(report.status == Status::solved);
  CHECK(report.penetration <= 1e-9);
  const Matrix3<double>& R = report.frames.back().pose.rotation;
  CHECK(std::acos(R(2, 2)) > 0.01);
}
