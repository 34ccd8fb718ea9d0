// Numbers of a scene file by their paths.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/varied_scene.hpp"
#include "support/fixture_push.hpp"

using namespace lcpush;
using namespace lcpush::desktop;
using lcpush::test::scene_text;

namespace {

/// With the ends of the wall as numbers.
const std::string& slide_text() {
  static const std::string text = lcpush::test::with(
      scene_text("straight_slide.toml"), "on = \"-x\"\nalong = \"y\"\npoints = 2",
      "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]\npoints = 2\nnormal = [1, 0, 0]");
  return text;
}

const VariedScene& varied_slide() {
  static const VariedScene scene = VariedScene::parse(slide_text(), "slide.toml");
  return scene;
}

SceneFile slide_with(const std::string& path, double value) {
  return varied_slide().at({varied_slide().find(path)}, {value});
}

std::string refusal_of_value(const std::string& path) {
  try {
    (void)varied_slide().find(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "found";
}

/// As read once and as numbers that may vary: the same scene?
void is_the_same(const std::string& text) {
  CAPTURE(text);
  const SceneFile read = parse_scene(text, "s.toml");
  const SceneFile varied = VariedScene::parse(text, "s.toml").as_given();
  REQUIRE(read.positions.size() == varied.positions.size());
  for (std::size_t i = 0; i < read.positions.size(); ++i)
    CHECK(read.positions[i] == varied.positions[i]);
  CHECK(read.weights == varied.weights);
  CHECK(read.overhang == varied.overhang);
  CHECK(read.gravity == varied.gravity);
  CHECK(read.object.wrench == varied.object.wrench);
  CHECK(read.object.center_of_mass == varied.object.center_of_mass);
  REQUIRE(read.bodies.size() == varied.bodies.size());
  for (std::size_t b = 0; b < read.bodies.size(); ++b) {
    CHECK(read.bodies[b].normal == varied.bodies[b].normal);
    CHECK(read.bodies[b].tangent == varied.bodies[b].tangent);
    CHECK(read.bodies[b].acceleration == varied.bodies[b].acceleration);
    CHECK(read.bodies[b].preload == varied.bodies[b].preload);
  }
}

} // namespace

TEST_CASE("what may vary and does not is the scene as it is read") {
  for (const char* const folder : {"scenes", "canonical", "regressions"})
    for (const auto& entry :
         std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/" + std::string(folder)))
      if (entry.path().extension() == ".toml")
        is_the_same(scene_text(entry.path().filename().string(), folder));
  // Pads that reach beyond their face, in the middle of it and beside.
  for (const char* const shape :
       {"shape = \"line\"; along = \"x\"; length = 0.04",
        "shape = \"rectangle\"; size = [0.04, 0.01]", "shape = \"disc\"; radius = 0.01"})
    for (const char* const center : {"0, 0", "0.013, 0", "-0.018, 0.04", "0.0186, -0.004"}) {
      const std::string place = std::string(shape) + "; center = [" + center + "]";
      is_the_same(
          lcpush::test::table("[object]", "mass = 0.7; box = [0.038, 0.09, 0.13]") +
          lcpush::test::table("[[finger]]", "name = \"left\"; on = \"+z\"; friction = 0.5; "
                                            "grip_force = 14; " +
                                                place) +
          lcpush::test::table("[[finger]]", "name = \"right\"; on = \"-z\"; friction = 0.5; "
                                            "grip_force = 14; " +
                                                place));
    }
}

TEST_CASE("a path names one number of the file") {
  CHECK(slide_with("object.mass", 0.7).object.mass == 0.7);
  CHECK(slide_with("gravity[1]", -1.5).gravity == Vector3<double>(0, -1.5, 0));
  CHECK(slide_with("right.friction", 0.7).bodies[1].friction == 0.7);
  CHECK(slide_with("right.friction", 0.7).bodies[0].friction == 0.5);
  CHECK(slide_with("wall.ends[1][2]", 0.001).positions[9][2] == 0.001);
  CHECK(slide_with("wall.acceleration[1]", 0.3).bodies[2].acceleration[1] == 0.3);
  CHECK(varied_slide().find("left.grip_force").value == 20);
  CHECK(varied_slide().find("left.grip_force").unit == "N");
}

TEST_CASE("* names the same number of every body that has it") {
  const SceneFile gripped = slide_with("*.grip_force", 3), rough = slide_with("*.friction", 0.9);
  REQUIRE(gripped.actuators.size() == 1); // of a jaw
  CHECK(gripped.actuators[0].force == 6);
  for (const Body<double>& body : rough.bodies) CHECK(body.friction == 0.9);
}

TEST_CASE("vectors that the file leaves out are zero, and vary") {
  CHECK(slide_with("wall.angular_acceleration[2]", 2).bodies[2].acceleration[5] == 2);
  CHECK(slide_with("object.center_of_mass[0]", 0.01).object.center_of_mass[0] == 0.01);
  const VariedScene pivot = VariedScene::parse(scene_text("pivot.toml"), "pivot.toml");
  CHECK(pivot.at({pivot.find("gravity[1]")}, {-9.81}).gravity[1] == -9.81);
}

TEST_CASE("units are those of the table: an actuator's inertia is a mass, the object's is none") {
  const std::string text = lcpush::test::with(scene_text("three_finger_hand.toml"), "force = 12",
                                              "force = 12\ninertia = 0.05");
  CHECK(VariedScene::parse(text, "hand.toml").find("motor.inertia").unit == "kg");
  const std::string object =
      lcpush::test::with(slide_text(), "box = [0.1, 0.03, 0.01]", "inertia = [1e-4, 2e-4, 2e-4]");
  CHECK(VariedScene::parse(object, "slide.toml").find("object.inertia[0]").unit == "kg m^2");
}

TEST_CASE("shift moves every point of a body, and nothing else") {
  const SceneFile given = varied_slide().as_given();
  for (Index axis = 0; axis < 3; ++axis) {
    const SceneFile moved = slide_with("left.shift[" + std::to_string(axis) + "]", 0.002);
    for (std::size_t i = 0; i < given.positions.size(); ++i) {
      Vector3<double> by = moved.positions[i] - given.positions[i];
      if (i < 4) by[axis] -= 0.002;
      CHECK(by.norm() <= 1e-17);
    }
  }
  const SceneFile wall = slide_with("wall.shift[1]", 0.01);
  CHECK(wall.positions[8][1] == doctest::Approx(-0.005));
  CHECK(wall.bodies[2].acceleration == given.bodies[2].acceleration);
}

TEST_CASE("turn turns the acceleration in the x-y plane, quarters exactly") {
  const auto turned = [](double degrees) {
    return Vector3<double>(slide_with("wall.turn", degrees).bodies[2].acceleration.head<3>());
  };
  CHECK(turned(90) == Vector3<double>(0, 0.1, 0));
  CHECK(turned(-90) == Vector3<double>(0, -0.1, 0));
  CHECK(turned(180) == Vector3<double>(-0.1, 0, 0));
  CHECK(turned(450) == turned(90));
  CHECK((turned(30) - Vector3<double>(0.1 * std::sqrt(0.75), 0.05, 0)).norm() <= 1e-16);
}

TEST_CASE("forces and accelerations are linear; mass, friction and places are not") {
  for (const char* path :
       {"*.grip_force", "gravity[0]", "wall.acceleration[2]", "wall.angular_acceleration[0]"})
    CHECK(varied_slide().find(path).linear);
  for (const char* path : {"object.mass", "*.friction", "wall.shift[0]", "wall.turn",
                           "object.box[0]", "wall.ends[0][0]"})
    CHECK_FALSE(varied_slide().find(path).linear);
}

TEST_CASE("what counts something is whole; facets vary even where the file leaves them out") {
  CHECK(varied_slide().find("facets").whole);
  CHECK(varied_slide().find("facets").value == 8);
  CHECK(slide_with("facets", 16).facets == 16);
  CHECK_FALSE(varied_slide().find("left.points[0][1]").whole); // a list of points is no count
  const VariedScene plate = VariedScene::parse(scene_text("planar_pusher.toml"), "plate.toml");
  CHECK(plate.find("*.points").whole);
  CHECK(plate.find("plate.points[1]").whole);
  CHECK(plate.find("*.points").unit.empty());
  CHECK(plate.at({plate.find("*.points")}, {12}).points.size() == 2 * 12 + 4);
  CHECK(plate.at({plate.find("plate.points[0]")}, {5}).points.size() == 2 * 6 + 10);
  CHECK_THROWS_AS((void)plate.at({plate.find("*.points")}, {2.5}), InputError);
  CHECK_THROWS_AS((void)plate.at({plate.find("facets")}, {7}), InputError);
}

TEST_CASE("tangent_turn turns the first generator about the normal") {
  const SceneFile given = varied_slide().as_given();
  const auto turned = [](const std::string& path, double degrees, std::size_t body) {
    return slide_with(path, degrees).bodies[body].tangent;
  };
  for (std::size_t b = 0; b < 3; ++b) {
    const Vector3<double> t = given.bodies[b].tangent, n = given.bodies[b].normal;
    const Vector3<double> quarter = turned("*.tangent_turn", 90, b);
    CHECK(quarter == cross<double>(n, t));
    const Vector3<double> some = turned("*.tangent_turn", 30, b);
    CHECK(some.dot(t) == doctest::Approx(std::sqrt(0.75)));
    CHECK(cross<double>(some, t).dot(n) == doctest::Approx(-0.5));
    CHECK(std::abs(some.dot(n)) <= 1e-16);
  }
  CHECK(turned("left.tangent_turn", 30, 1) == given.bodies[1].tangent);
  // On top of a tangent that the file gives.
  const VariedScene plate = VariedScene::parse(scene_text("planar_pusher.toml"), "plate.toml");
  CHECK(plate.at({plate.find("plate.tangent_turn")}, {90}).bodies[2].tangent ==
        Vector3<double>(0, 0, 1));
}

TEST_CASE("with() changes a number for good") {
  const VariedScene rough = varied_slide().with({varied_slide().find("*.friction")}, {0.9});
  CHECK(rough.find("left.friction").value == 0.9);
  CHECK(rough.at({rough.find("left.friction")}, {0.1}).bodies[1].friction == 0.9);
  CHECK(varied_slide().as_given().bodies[0].friction == 0.5);
  CHECK_THROWS_AS((void)varied_slide().with({varied_slide().find("*.friction")}, {-1}), InputError);
}

TEST_CASE("an unknown path is refused with what is possible, and with the nearest") {
  CHECK(refusal_of_value("wall.fricton").find("(did you mean \"wall.friction\"?)") !=
        std::string::npos);
  CHECK(refusal_of_value("gravty[1]").find("(did you mean \"gravity[1]\"?)") != std::string::npos);
  const std::string message = refusal_of_value("nonsense.altogether");
  for (const char* part : {"slide.toml: nothing to vary is called \"nonsense.altogether\"",
                           "gravity[..]", "wall.  ends[..]", "turn", "*.  "}) {
    CAPTURE(message);
    CHECK(message.find(part) != std::string::npos);
  }
  for (const char* path : {"", "gravity", "gravity[3]", "facets[0]", "left.points", "*.mass"})
    CHECK(refusal_of_value(path).find("nothing to vary") != std::string::npos);
}

TEST_CASE("a value that is no scene is refused with line and value") {
  try {
    (void)slide_with("left.friction", -0.5);
    FAIL("accepted");
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.rfind("slide.toml:", 0) == 0);
    CHECK(message.find("friction must be") != std::string::npos);
    CHECK(message.find("(at left.friction = -0.5)") != std::string::npos);
  }
}
