// Numbers of a scene file by their paths.
#include <doctest/doctest.h>

#include <algorithm>

#include "fixture_push.hpp"
#include "lcpush/host/input_error.hpp"
#include "lcpush/host/varied_scene.hpp"

using namespace lcpush;
using namespace lcpush::host;
using lcpush::test::scene_text;

namespace {

const VariedScene& slide() {
  static const VariedScene scene =
      VariedScene::parse(scene_text("straight_slide.toml"), "slide.toml");
  return scene;
}

SceneFile slide_with(const std::string& path, double value) {
  return slide().at({slide().find(path)}, {value});
}

std::string refusal(const std::string& path) {
  try {
    (void)slide().find(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "found";
}

} // namespace

TEST_CASE("a path names one number of the file") {
  CHECK(slide_with("object.mass", 0.7).object.mass == 0.7);
  CHECK(slide_with("gravity[1]", -1.5).gravity == Vector3<double>(0, -1.5, 0));
  CHECK(slide_with("right.grip_force", 7).actuators[1].force == 7);
  CHECK(slide_with("right.grip_force", 7).actuators[0].force == 20);
  CHECK(slide_with("wall.ends[1][2]", 0.001).positions[9][2] == 0.001);
  CHECK(slide_with("wall.acceleration[1]", 0.3).bodies[2].acceleration[1] == 0.3);
  CHECK(slide().find("left.grip_force").value == 20);
  CHECK(slide().find("left.grip_force").unit == "N");
}

TEST_CASE("* names the same number of every body that has it") {
  const SceneFile gripped = slide_with("*.grip_force", 3), rough = slide_with("*.friction", 0.9);
  for (const Actuator<double>& actuator : gripped.actuators) CHECK(actuator.force == 3);
  for (const Body<double>& body : rough.bodies) CHECK(body.friction == 0.9);
}

TEST_CASE("vectors that the file leaves out are zero, and vary") {
  CHECK(slide_with("wall.angular_acceleration[2]", 2).bodies[2].acceleration[5] == 2);
  CHECK(slide_with("object.center_of_mass[0]", 0.01).object.center_of_mass[0] == 0.01);
  const VariedScene pivot = VariedScene::parse(scene_text("pivot.toml"), "pivot.toml");
  CHECK(pivot.at({pivot.find("gravity[1]")}, {-9.81}).gravity[1] == -9.81);
}

TEST_CASE("shift moves every point of a body, and nothing else") {
  const SceneFile given = slide().as_given();
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
    CHECK(slide().find(path).linear);
  for (const char* path : {"object.mass", "*.friction", "wall.shift[0]", "wall.turn",
                           "object.box[0]", "wall.ends[0][0]"})
    CHECK_FALSE(slide().find(path).linear);
}

TEST_CASE("what a path finds is what paths() lists") {
  for (const std::string& path : slide().paths()) CHECK(slide().find(path).path == path);
  const std::vector<std::string> paths = slide().paths();
  CHECK(std::find(paths.begin(), paths.end(), "facets") == paths.end());
}

TEST_CASE("an unknown path is refused with what is possible, and with the nearest") {
  CHECK(refusal("wall.fricton").find("(did you mean \"wall.friction\"?)") != std::string::npos);
  CHECK(refusal("gravty[1]").find("(did you mean \"gravity[1]\"?)") != std::string::npos);
  const std::string message = refusal("nonsense.altogether");
  for (const char* part : {"slide.toml: nothing to vary is called \"nonsense.altogether\"",
                           "gravity[..]", "wall.  ends[..]", "turn", "*.  "}) {
    CAPTURE(message);
    CHECK(message.find(part) != std::string::npos);
  }
  for (const char* path : {"", "gravity", "gravity[3]", "facets", "left.points", "*.mass"})
    CHECK(refusal(path).find("nothing to vary") != std::string::npos);
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
