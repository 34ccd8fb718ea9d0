// What a motion needs more than its first instant does.
#include "lcpush/desktop/move.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

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
  const auto finger = [](const std::string& name, const std::string& z, const std::string& n) {
    return "[[finger]]\nname = \"" + name + "\"\nshape = \"ring\"\ncenter = [0, 0, " + z +
           "]\nradius = 0.005\npoints = 40\nnormal = [0, 0, " + n +
           "]\nfriction = 0.5\ngrip_force = 20\n";
  };
  const SceneFile file =
      parse_scene("pressure = \"even\"\ngravity = [0, -9.81, 0]\n[object]\n"
                  "mass = 0.2\nbox = [0.1, 0.03, 0.01]\n" +
                      finger("left", "0.005", "-1") + finger("right", "-0.005", "1") +
                      "[[pusher]]\nname = \"rod\"\nshape = \"point\"\n"
                      "center = [-0.05, 0.005, 0.002]\nnormal = [1, 0, 0]\n"
                      "friction = 0.3\nvelocity = [0.01, 0, 0]\n",
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
