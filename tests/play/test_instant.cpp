// A moment of a motion as a scene: its forces are those of the motion's step.
#include "play/instant.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/push.hpp"
#include "play/answers.hpp"

#include <doctest/doctest.h>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

const std::string scenes = std::string(LCPUSH_SOURCE_DIR) + "/fixtures/scenes/";

MotionFrame frame_after(const SceneFile& file, double seconds) {
  MoveOptions options;
  options.time = seconds;
  options.frames = 2;
  return move(file, options).frames.back();
}

} // namespace

TEST_CASE("the scene at a moment presses as the motion's step does") {
  // They turn and slide, in their plane and out of it; a step is short, not nothing.
  for (const char* name :
       {"pivot", "ground", "rolling", "two_pushers", "rotating_pusher", "tipping"}) {
    CAPTURE(name);
    const SceneFile file =
        parse_scene(read_scene_text(scenes + name + ".toml"), name, Strokes::all);
    const MotionFrame frame = frame_after(file, 0.3);
    const SceneFile now = scene_at(file, frame);
    REQUIRE(now.bodies.size() == file.bodies.size());
    Push push(now);
    REQUIRE(push.solve({}).status == Status::solved);
    for (std::size_t b = 0; b < now.bodies.size(); ++b) {
      double normal = 0;
      for (const Index i : points_of(now.bodies[b]))
        normal += push.last_answer().contacts[i].normal_force;
      CHECK(normal == doctest::Approx(frame.bodies[b].normal_force).epsilon(0.01));
    }
  }
}

TEST_CASE("points beside their face are left out, and bodies without others") {
  // The edge leaves the bar's end before a second is over.
  const SceneFile file = parse_scene(read_scene_text(scenes + "pivot.toml"), "pivot", Strokes::all);
  const MotionFrame frame = frame_after(file, 1);
  const SceneFile now = scene_at(file, frame);
  CHECK(now.points.size() < file.points.size());
  CHECK(now.points.size() == now.positions.size());
  CHECK(now.bodies.size() == now.body_names.size());
  Index next = 0;
  for (const Body<double>& body : now.bodies) {
    CHECK(body.first_point == next);
    next += body.point_count;
  }
  CHECK(next == static_cast<Index>(now.points.size()));
}

TEST_CASE("the page's pivots are those of the moment that is shown") {
  const std::string text = read_scene_text(scenes + "pivot.toml");
  Playground page;
  const std::string first = page.answer_to("pivots", text);
  const std::string later = page.answer_to("pivots 0.3", text);
  CHECK(first == page.answer_to("pivots 0", text));
  CHECK(first != later);
  CHECK(later.find(", after 0.3 s") != std::string::npos);
  CHECK(first.find(", after 0") == std::string::npos);
}
