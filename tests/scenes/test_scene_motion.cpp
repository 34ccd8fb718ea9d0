// What a scene file says about a motion: velocities, strokes, who carries the points, faces.
#include "lcpush/desktop/varied_scene.hpp"
#include "support/scene_text.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

const std::string going = "velocity = [0.02, 0, 0]\n";

std::string with_face(const std::string& corners) {
  return with_finger("[[face]]\ncorners = " + corners + "\n");
}

SceneFile all_strokes(const std::string& text) { return parse_scene(text, "s.toml", Strokes::all); }

} // namespace

TEST_CASE("a velocity is the push's direction, at the centre of mass, and keeps its kind") {
  const SceneFile fast = parsed(
      with_pusher("velocity = [0.02, 0, 0]\nangular_velocity = [0, 0, 3]\nabout = [0, 0.1, 0]\n"));
  const SceneFile pushed = parsed(with_pusher(
      "acceleration = [0.02, 0, 0]\nangular_acceleration = [0, 0, 3]\nabout = [0, 0.1, 0]\n"));
  CHECK(fast.bodies[0].acceleration == pushed.bodies[0].acceleration);
  CHECK(fast.strokes[0].is_velocity);
  CHECK_FALSE(pushed.strokes[0].is_velocity);
  CHECK(fast.lines.bodies[0].motion == 10);
  check_says(with_pusher(going + "acceleration = [1, 0, 0]\n"),
             "11: pusher \"wall\": a pusher has a velocity or speeds up from rest");
  check_says(with_pusher(going + "angular_acceleration = [0, 0, 1]\n"), "keep one");
  check_says(with_pusher("velocity = [0, 0, 0]\nabout = [0, 0, 0]\n"), "about goes with");
  check_says(with_pusher("normal_force = 5\nvelocity = [0.1, 0.2, 0]\n"),
             "velocity must have no part along it");
  check_says(with_finger("velocity = [0, 0, 0]\n"), "it goes with [object] or [[pusher]]");
  check_says(with_pusher("speed = [1, 0, 0]\n"), "did you mean \"velocity\"");
}

TEST_CASE("the pushers of the first stroke are those that are there at the start") {
  const std::string second = named(pusher_table, "second") + going + "from = 2\nuntil = 3.5\n";
  const std::string text = with_pusher(going + "until = 2\n") + second;
  CHECK(parsed(text).body_names == std::vector<std::string>{"wall"});
  const SceneFile all = all_strokes(text);
  REQUIRE(all.strokes.size() == 2);
  CHECK(all.strokes[0].until == 2);
  CHECK(all.strokes[1].from == 2);
  CHECK(all.strokes[1].until == 3.5);
  CHECK(all.bodies[1].first_point == 1);
  check_says(with_pusher(going + "from = 2\nuntil = 2\n"),
             "12: pusher \"wall\": until must be later than from");
  check_says(with_pusher(going + "from = -1\n"), "from must be >= 0");
  check_says(with_pusher(going + "start = 1\n"), "did you mean \"from\"");
  // A fault of a later stroke is found by whoever reads the file.
  check_says(with_pusher(going) + with(second, "friction = 0.3", "friction = -1"), "friction");
  check_says(object_table + second, "nothing touches the object");
  check_says(with_pusher("normal_force = 3\nuntil = 2\n"),
             "11: pusher \"wall\": normal_force presses all the time; remove until");
  check_says(with_pusher(going + "until = 2\n") +
                 "[[actuator]]\nname = \"a\"\nbodies = [\"wall\"]\n"
                 "twists = [[1, 0, 0, 0, 0, 0]]\nforce = 2\n",
             "an actuator moves its bodies all the time; remove from and until of \"wall\"");
}

TEST_CASE("points ride on the body, or on the object") {
  CHECK_FALSE(parsed(with_finger("")).strokes[0].rides_on_object);
  CHECK_FALSE(parsed(with_finger("points_on = \"body\"\n")).strokes[0].rides_on_object);
  CHECK(parsed(with_finger("points_on = \"object\"\n")).strokes[0].rides_on_object);
  check_says(with_finger("points_on = \"table\"\n"), R"(must be "body" or "object", got "table")");
}

TEST_CASE("a face is flat, convex and looks out of the object, whichever way it is walked") {
  for (const char* corners :
       {"[[-1, -1, 2], [1, -1, 2], [0, 1, 2]]", "[[0, 1, 2], [1, -1, 2], [-1, -1, 2]]"}) {
    const SceneFile scene = parsed(with_face(corners));
    REQUIRE(scene.faces.size() == 1);
    CHECK(scene.faces[0].normal.isApprox(Vector3<double>::UnitZ(), 1e-15));
    CHECK(scene.faces[0].corners.size() == 3);
  }
  check_says(with_face("[[0, 0, 0], [1, 0, 0]]"), "11: face 1: a face needs three corners");
  check_says(with_face("[[0, 0, 0], [1, 0, 0], [2, 0, 0]]"), "lie on one line");
  check_says(with_face("[[0, 0, 0], [1, 0, 0], [1, 1, 0.2], [0, 1, 0]]"),
             "beside the plane of the others");
  check_says(with_face("[[0, 0, 0], [1, 0, 0], [0.1, 0.1, 0], [0, 1, 0]]"),
             "the face is dented at corner 3");
  check_says(with_face("[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 0.9, 0]]"), "in their order");
  check_says(with_finger("[face]\ncorners = [[0, 0, 0]]\n"), "write [[face]]");
}

TEST_CASE("a velocity varies as an acceleration does, and turns") {
  const VariedScene scene = VariedScene::parse(with_pusher(going), "s.toml");
  const Parameter along = scene.find("wall.velocity[1]");
  CHECK(along.linear);
  CHECK(scene.at({along}, {0.5}).bodies[0].acceleration[1] == 0.5);
  CHECK(scene.at({scene.find("wall.turn")}, {90}).bodies[0].acceleration[1] == 0.02);
  CHECK_THROWS_AS(scene.find("wall.acceleration[0]"), InputError);
}
