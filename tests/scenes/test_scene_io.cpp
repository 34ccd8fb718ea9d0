#include "support/fixture_push.hpp"
#include "support/scene_text.hpp"

#include <cstdio>
#include <fstream>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

using Vec3 = Vector3<double>;

/// The pusher comes first, to show that the order within the file does not matter.
const std::string whole_scene =
    test::table("", "title = \"Straight slide, line pusher\"; gravity = [0, -9.81, 0]; facets = "
                    "12; pressure = \"rigid\"; planar = false") +
    test::table("[object]",
                "mass = 0.2; box = [0.1, 0.03, 0.01]; center_of_mass = [0.01, 0.02, 0.03]") +
    test::pusher("wall", "line",
                 "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]; normal = [1, 0, 0]; friction = "
                 "0; acceleration = [0.1, 0, 0]; angular_acceleration = [0, 0, 2]; about = [0.01, "
                 "0, 0]; follow = \"unilateral\"") +
    test::finger("left", "disc",
                 "center = [0, 0, 0.005]; normal = [0, 0, -3]; radius = 0.005; friction = 0.5; "
                 "grip_force = 20") +
    test::finger("right", "rectangle",
                 "center = [0, 0, -0.005]; size = [0.01, 0.02]; points = [3, 2]; normal = [0, 0, "
                 "1]; tangent = [0, 5, 1]; friction = 0.6");

Vector6<double> twist(double x, double y, double z, double rx, double ry, double rz) {
  Vector6<double> result;
  result << x, y, z, rx, ry, rz;
  return result;
}

} // namespace

TEST_CASE("a whole scene is read: settings, object, fingers before pushers") {
  const SceneFile scene = parsed(whole_scene);
  CHECK(scene.title == "Straight slide, line pusher");
  CHECK(scene.gravity == Vec3(0, -9.81, 0));
  CHECK(scene.facets == 12);
  CHECK(scene.pressure == Pressure::rigid);
  CHECK_FALSE(scene.planar);
  CHECK(scene.object.mass == 0.2);
  CHECK(scene.object.center_of_mass == Vec3(0.01, 0.02, 0.03));
  REQUIRE(scene.bodies.size() == 3);
  CHECK(scene.body_names == std::vector<std::string>{"left", "right", "wall"});
  CHECK(scene.bodies[0].role == Role::finger);
  CHECK(scene.bodies[2].role == Role::pusher);
  CHECK(scene.bodies[0].point_count == 12);
  CHECK(scene.bodies[1].first_point == 12);
  CHECK(scene.bodies[1].point_count == 6);
  CHECK(scene.bodies[2].first_point == 18);
  CHECK(scene.bodies[2].point_count == 4);
  CHECK(scene.bodies[1].friction == 0.6);
  CHECK(scene.bodies[2].friction == 0);
}

TEST_CASE("normals are normalised, tangents default or are projected") {
  const SceneFile scene = parsed(whole_scene);
  CHECK(scene.bodies[0].normal == Vec3(0, 0, -1));
  CHECK(scene.bodies[0].tangent == Vec3(1, 0, 0));
  CHECK((scene.bodies[1].tangent - Vec3(0, 1, 0)).norm() <= 1e-15);
}

TEST_CASE("a pusher's twist is taken at the centre of mass: v = a + alpha x (com - about)") {
  CHECK(
      (parsed(whole_scene).bodies[2].acceleration - twist(0.1 - 2 * 0.02, 0, 0, 0, 0, 2)).norm() <=
      1e-15);
}

TEST_CASE("optional keys have their defaults") {
  const SceneFile scene = parsed(with_finger(""));
  CHECK(scene.title.empty());
  CHECK(scene.gravity == Vec3(0, 0, 0));
  CHECK(scene.facets == 8);
  CHECK(scene.pressure == Pressure::pad);
  CHECK(scene.object.center_of_mass == Vec3(0, 0, 0));
}

TEST_CASE("inertia follows from a box, a cylinder or the tensor's entries") {
  const auto inertia = [](const std::string& shape) {
    return parsed(with_object(shape)).object.inertia;
  };
  const auto diagonal = [](double x, double y, double z) {
    return Matrix3<double>(Vec3(x, y, z).asDiagonal());
  };
  CHECK(inertia("box = [1, 2, 3]").isApprox(diagonal(13, 10, 5) * 2 / 12, 1e-15));
  CHECK(inertia("cylinder_radius = 2\ncylinder_length = 3").isApprox(diagonal(3.5, 3.5, 4), 1e-15));
  CHECK(inertia("cylinder_radius = 2\ncylinder_length = 3\naxis = \"x\"")
            .isApprox(diagonal(4, 3.5, 3.5), 1e-15));
  CHECK(inertia("inertia = [1, 2, 3]") == diagonal(1, 2, 3));
  Matrix3<double> tensor;
  tensor << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
  CHECK(inertia("inertia = [3, 4, 5, 0.1, 0.2, 0.3]") == tensor);
  CHECK(inertia("inertia = [0.00123, 0.00045, 0.0016804]").allFinite());
}

TEST_CASE("every shape gives its points") {
  const auto count = [](const std::string& shape) {
    const std::string plain = "shape = \"point\"\ncenter = [0, 0, 0.005]\n";
    return parsed(with_finger(plain, shape + "\n")).points.size();
  };
  CHECK(count("shape = \"point\"\ncenter = [0, 0, 0]") == 1);
  CHECK(count("shape = \"line\"\nends = [[0, 0, 0], [1, 0, 0]]") == 4);
  CHECK(count("shape = \"line\"\nends = [[0, 0, 0], [1, 0, 0]]\npoints = 5") == 5);
  CHECK(count("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = 1") == 12);
  CHECK(count("shape = \"ring\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 3") == 3);
  CHECK(count("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 2]") == 16);
  CHECK(count("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 2]\npoints = [2, 5]") == 10);
  CHECK(count("shape = \"points\"\npoints = [[0, 0, 0]]") == 1);
  CHECK(count("shape = \"points\"\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]") == 3);
}

TEST_CASE("weights of points are taken in proportion, and refused where they say nothing") {
  const std::string plain = "shape = \"point\"\ncenter = [0, 0, 0.005]\n";
  const auto points = [&](const std::string& weights) {
    return with_finger(plain, "shape = \"points\"\npoints = [[0, 0, 0], [1, 0, 0]]\n" + weights);
  };
  CHECK(parsed(points("")).weights == std::vector<double>{0.5, 0.5});
  CHECK(parsed(points("weights = [1, 3]\n")).weights == std::vector<double>{0.25, 0.75});
  check_says(points("weights = [1]\n"), "weights");
  check_says(points("weights = [1, 0]\n"), "weights");
  check_says(with_finger(plain, plain + "weights = [1]\n"), "weights does not go with the shape");
}

TEST_CASE("independent fingers: a force-controlled actuator each; without grip_force a stop") {
  const SceneFile scene =
      parsed(object_table + finger_table + "grip_force = 20\n" + named(finger_table, "stop") +
             named(finger_table, "right") + "grip_force = 5\n");
  REQUIRE(scene.actuators.size() == 2);
  REQUIRE(scene.drives.size() == 2);
  CHECK(scene.actuator_names == std::vector<std::string>{"left", "right"});
  CHECK(scene.actuators[0].force == 20);
  CHECK(scene.actuators[0].inertia == 0);
  CHECK(scene.drives[1].body == 2);
  CHECK(scene.drives[1].actuator == 1);
  CHECK(scene.drives[1].twist == twist(0, 0, -1, 0, 0, 0));
}

TEST_CASE("parallel jaws: one actuator of twice the force closes both fingers") {
  const std::string jaws = "[gripper]\njaws = \"parallel\"\n";
  const std::string left = finger_table + "grip_force = 20\n", right = named(left, "right");
  const SceneFile scene = parsed(jaws + object_table + left + with(right, "-2", "2"));
  REQUIRE(scene.actuators.size() == 1);
  CHECK(scene.actuators[0].force == 40);
  REQUIRE(scene.drives.size() == 2);
  CHECK(scene.drives[0].twist == twist(0, 0, -1, 0, 0, 0));
  CHECK(scene.drives[1].twist == twist(0, 0, 1, 0, 0, 0));
  CHECK(scene.drives[1].actuator == 0);

  check_says(jaws + object_table + left, "2: gripper: parallel jaws need exactly two");
  check_says(jaws + object_table + left + named(finger_table, "right"),
             "2: gripper: parallel jaws need exactly two [[finger]]s with a grip_force, got 1");
  check_says(jaws + object_table + left + with(right, "= 20", "= 21"),
             "finger \"right\": parallel jaws share one grip_force; got 21, but 20");
  check_says("[gripper]\njaws = \"parallell\"\n" + object_table + left,
             "did you mean \"parallel\"");
  CHECK(parsed("[gripper]\n" + object_table + left).actuators.size() == 1);
}

TEST_CASE("a pusher needs a motion, and angles a centre only if it turns") {
  check_says(with_pusher(""), "4: pusher \"wall\": missing the motion");
  check_says(with_pusher("acceleration = [0, 0, 0]\nabout = [0, 0, 0]"), "about goes with");
  CHECK(parsed(with_pusher("acceleration = [0, 0, 0]")).bodies[0].acceleration.isZero(0));
  CHECK(parsed(with_pusher("angular_acceleration = [0, 0, 1]")).bodies[0].acceleration ==
        twist(0, 0, 0, 0, 0, 1));
}

TEST_CASE("a pusher with normal_force is driven along its normal, and only sideways by the file") {
  const SceneFile scene =
      parsed(with_pusher("normal_force = 5\nacceleration = [0, 0.2, 0]\n") + finger_table);
  REQUIRE(scene.drives.size() == 1);
  CHECK(scene.actuators[0].force == 5);
  CHECK(scene.drives[0].body == 1);
  CHECK(scene.drives[0].twist == twist(1, 0, 0, 0, 0, 0));
  check_says(with_pusher("normal_force = 5\nacceleration = [0.1, 0.2, 0]"),
             "11: pusher \"wall\": normal_force decides the motion along the normal");
}

TEST_CASE("an actuator's twists are moved from the scene's origin to the centre of mass") {
  const std::string off_center = with(object_table, "box", "center_of_mass = [0, 2, 0]\nbox");
  const SceneFile scene =
      parsed(off_center + finger_table + named(finger_table, "right") +
             "[[actuator]]\nname = \"tendon\"\nbodies = [\"right\", \"left\"]\n"
             "twists = [[1, 0, 0, 0, 0, 1], [0, 0, 1, 0, 0, 0]]\nforce = 7\ninertia = 0.5\n");
  REQUIRE(scene.drives.size() == 2);
  CHECK(scene.actuator_names == std::vector<std::string>{"tendon"});
  CHECK(scene.actuators[0].force == 7);
  CHECK(scene.actuators[0].inertia == 0.5);
  CHECK(scene.drives[0].body == 1);
  CHECK(scene.drives[0].twist == twist(1 - 2, 0, 0, 0, 0, 1));
  CHECK(scene.drives[1].twist == twist(0, 0, 1, 0, 0, 0));
}

TEST_CASE("an actuator of known acceleration moves its bodies and adds no unknown") {
  const SceneFile scene =
      parsed(with_finger("[[actuator]]\nname = \"jaw\"\nbodies = [\"left\"]\n"
                         "twists = [[0, 0, 1, 0, 0, 0]]\nacceleration = -0.5\n"));
  CHECK(scene.actuators.empty());
  CHECK(scene.drives.empty());
  CHECK(scene.bodies[0].acceleration == twist(0, 0, -0.5, 0, 0, 0));
}

TEST_CASE("a scene is read from a file, and errors name it") {
  const std::string path = "lcpush_test_scene_io.toml";
  std::ofstream(path) << whole_scene;
  CHECK(read_scene(path).bodies.size() == 3);
  std::ofstream(path) << "x";
  CHECK_THROWS_WITH_AS(read_scene(path),
                       (path + ":1: expected = after \"x\", found the end of the "
                               "file")
                           .c_str(),
                       InputError);
  std::remove(path.c_str());
  CHECK_THROWS_AS(read_scene(path), InputError);
}
