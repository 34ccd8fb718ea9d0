// What a motion needs more than its first instant does.
#include "lcpush/desktop/move.hpp"

#include <doctest/doctest.h>

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
