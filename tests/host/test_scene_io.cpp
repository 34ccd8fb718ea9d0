#include "lcpush/host/input_error.hpp"
#include "lcpush/host/scene_io.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <string>

using namespace lcpush;
using namespace lcpush::host;

namespace {

using Vec3 = Vector3<double>;

const std::string object_table = "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n";
const std::string finger_table = "[[finger]]\nname = \"left\"\nshape = \"point\"\n"
                                 "center = [0, 0, 0.005]\nnormal = [0, 0, -2]\nfriction = 0.5\n";
const std::string pusher_table = "[[pusher]]\nname = \"wall\"\nshape = \"point\"\n"
                                 "center = [-0.05, 0, 0]\nnormal = [1, 0, 0]\nfriction = 0.3\n";

/// The pusher comes first, to show that the order within the file does not matter.
const std::string whole_scene = R"(title = "Straight slide, line pusher"
gravity = [0, -9.81, 0]
facets = 12
pressure = "rigid"
planar = false

[object]
mass = 0.2
box = [0.1, 0.03, 0.01]
center_of_mass = [0.01, 0.02, 0.03]

[[pusher]]
name = "wall"
shape = "line"
ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]
normal = [1, 0, 0]
friction = 0
acceleration = [0.1, 0, 0]
angular_acceleration = [0, 0, 2]
about = [0.01, 0, 0]
follow = "unilateral"

[[finger]]
name = "left"
shape = "disc"
center = [0, 0, 0.005]
normal = [0, 0, -3]
radius = 0.005
friction = 0.5
grip_force = 20

[[finger]]
name = "right"
shape = "rectangle"
center = [0, 0, -0.005]
size = [0.01, 0.02]
points = [3, 2]
normal = [0, 0, 1]
tangent = [0, 5, 1]
friction = 0.6
)";

SceneFile parsed(const std::string& text) { return parse_scene(text, "s.toml"); }

std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// The tables' line with `from` replaced by `to`; `from` must occur.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string with_finger(const std::string& from, const std::string& to) {
  return object_table + with(finger_table, from, to);
}
std::string with_finger(const std::string& more) { return object_table + finger_table + more; }
std::string with_pusher(const std::string& more) { return object_table + pusher_table + more; }
std::string with_object(const std::string& shape) {
  return "[object]\nmass = 2\n" + shape + "\n" + finger_table;
}
std::string named(const std::string& table, const std::string& name) {
  const std::size_t at = table.find("name = \"") + 8;
  return std::string(table).replace(at, table.find('"', at) - at, name);
}

void check_refusal(const std::string& text, const std::string& message) {
  CAPTURE(text);
  CHECK(refusal(text) == "s.toml:" + message);
}
void check_says(const std::string& text, const std::string& part) {
  const std::string message = refusal(text);
  CAPTURE(text);
  CAPTURE(message);
  CHECK(message.rfind("s.toml:", 0) == 0);
  CHECK(message.find(part) != std::string::npos);
}

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
  CHECK(scene.bodies[0].point_count == 8);
  CHECK(scene.bodies[1].first_point == 8);
  CHECK(scene.bodies[1].point_count == 6);
  CHECK(scene.bodies[2].first_point == 14);
  CHECK(scene.bodies[2].point_count == 2);
  CHECK(scene.bodies[1].friction == 0.6);
  CHECK(scene.bodies[2].friction == 0);
}

TEST_CASE("normals are normalised, tangents default or are projected") {
  const SceneFile scene = parsed(whole_scene);
  CHECK(scene.bodies[0].normal == Vec3(0, 0, -1));
  CHECK(scene.bodies[0].tangent == Vec3(1, 0, 0));
  CHECK((scene.bodies[1].tangent - Vec3(0, 1, 0)).norm() <= 1e-15);
}

TEST_CASE("positions are kept in the scene's frame and from the centre of mass") {
  const SceneFile scene = parsed(whole_scene);
  REQUIRE(scene.points.size() == 16);
  REQUIRE(scene.positions.size() == 16);
  CHECK(scene.positions[14] == Vec3(-0.05, -0.015, 0));
  for (std::size_t i = 0; i < 16; ++i)
    CHECK(scene.points[i] == scene.positions[i] - scene.object.center_of_mass);
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

TEST_CASE("a view spans the file's arrays") {
  const SceneFile file = parsed(whole_scene);
  const Scene<double> scene = file.view();
  CHECK(scene.points.data == file.points.data());
  CHECK(scene.bodies.size == 3);
  CHECK(scene.points.size == 16);
  CHECK(scene.actuators.size == 1);
  CHECK(scene.drives.size == 1);
  CHECK(scene.facets == 12);
  CHECK(scene.gravity == file.gravity);
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

TEST_CASE("an object needs one possible inertia") {
  check_refusal(with_object("inertia = [1, 1, 2.1]"),
                "3: object: inertia belongs to no solid body: the largest principal moment exceeds "
                "the sum of the other two; check its units and order (xx, yy, zz, xy, xz, yz)");
  check_says(with_object("inertia = [1, 1, -1]"), "3: object: inertia must be positive definite");
  check_says(with_object("inertia = [1, 1, 1, 2, 0, 0]"), "inertia must be positive definite");
  check_says(with_object("inertia = [0, 0, 0]"), "no inertia");
  check_refusal(with_object("inertia = [1, 1]"),
                "3: object: inertia must be a list of 3 or 6 numbers, got a list of 2");
  check_says(with_object(""), "1: object: missing the shape of the object");
  check_says(with_object("box = [1, 1, 1]\ninertia = [1, 1, 1]"),
             "4: object: box is given already");
  check_says(with_object("box = [1, 1, 1]\naxis = \"x\""), "axis goes with cylinder_radius only");
  check_says(with_object("cylinder_length = 1"), "1: object: missing key \"cylinder_radius\"");
  check_says(with_object("cylinder_radius = 1"), "missing key \"cylinder_length\"");
  check_refusal(with_object("box = [1, 0, 1]"), "3: object: entry 2 of box must be > 0, got 0");
  check_says(with_object("cylinder_radius = 1\ncylinder_length = 1\naxis = \"w\""),
             R"(axis must be "x", "y" or "z", got "w")");
  check_says(with(with_finger(""), "mass = 0.2", "mass = 0"), "mass must be > 0, got 0");
  check_refusal(with(with_finger(""), "mass = 0.2\n", ""),
                "1: object: missing key \"mass\"; add for example mass = 0.2  # kg");
}

TEST_CASE("every shape gives its points") {
  const auto count = [](const std::string& shape) {
    const std::string plain = "shape = \"point\"\ncenter = [0, 0, 0.005]\n";
    return parsed(with_finger(plain, shape + "\n")).points.size();
  };
  CHECK(count("shape = \"point\"\ncenter = [0, 0, 0]") == 1);
  CHECK(count("shape = \"line\"\nends = [[0, 0, 0], [1, 0, 0]]") == 2);
  CHECK(count("shape = \"line\"\nends = [[0, 0, 0], [1, 0, 0]]\npoints = 5") == 5);
  CHECK(count("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = 1") == 8);
  CHECK(count("shape = \"ring\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 3") == 3);
  CHECK(count("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 2]") == 4);
  CHECK(count("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 2]\npoints = [2, 5]") == 10);
  CHECK(count("shape = \"points\"\npoints = [[0, 0, 0]]") == 1);
  CHECK(count("shape = \"points\"\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]") == 3);
}

TEST_CASE("a shape refuses the keys of another and what it cannot sample") {
  const auto check = [](const std::string& shape, const std::string& part) {
    check_says(with_finger("shape = \"point\"\ncenter = [0, 0, 0.005]", shape), part);
  };
  check("shape = \"point\"\ncenter = [0, 0, 0]\nradius = 1",
        "8: finger \"left\": radius does not go with the shape \"point\", which takes center");
  check("shape = \"line\"\ncenter = [0, 0, 0]", "which takes ends and points");
  check("shape = \"dics\"", "got \"dics\" (did you mean \"disc\"?)");
  check("shape = \"line\"\nends = [[0, 0, 0]]", "ends must be a list of 2 points, got 1");
  check("shape = \"line\"\nends = [[0, 0, 0], [0, 0]]", "entry 2 of ends must be a list of 3");
  check("shape = \"line\"\nends = [[1, 0, 0], [1, 0, 0]]", "points 1 and 2 coincide");
  check("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = -1", "radius must be > 0, got -1");
  check("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 0", "from 1 to 10000, got 0");
  check("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 1e18", "got 1e+18");
  check("shape = \"disc\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 1000000000000000000",
        "from 1 to 10000, got 1000000000000000000");
  check("shape = \"disc\"\ncenter = [1e6, 0, 0]\nradius = 1e-12", "coincide");
  check("shape = \"ring\"\ncenter = [0, 0, 0]\nradius = 1\npoints = 1", "from 2 to 10000");
  check("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 2]\npoints = [1000, 1000]",
        "at most 10000 altogether, got 1000000");
  check("shape = \"rectangle\"\ncenter = [0, 0, 0]\nsize = [1, 0]", "entry 2 of size must be > 0");
  check("shape = \"points\"\npoints = []", "points must not be empty");
  check("shape = \"points\"\npoints = 3", "points must be a list, got 3");
  check("shape = \"points\"\npoints = [[0, 0, 0], [1, 0, 0], [1e-12, 0, 0]]",
        "points 1 and 3 coincide");
}

TEST_CASE("a direction must point somewhere") {
  check_refusal(with_finger("[0, 0, -2]", "[0, 0, 0]"),
                "8: finger \"left\": normal must not be zero; give the direction into the object");
  check_says(with_finger("tangent = [0, 0, 0]"), "neither zero nor parallel");
  check_says(with_finger("tangent = [0, 0, 7]"), "neither zero nor parallel");
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
             "finger \"right\": missing key \"grip_force\"");
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

TEST_CASE("an actuator is complete and drives bodies that exist, once each") {
  const std::string head = "[[actuator]]\nname = \"jaw\"\n", bodies = "bodies = [\"left\"]\n",
                    twists = "twists = [[0, 0, 1, 0, 0, 0]]\n", force = "force = 1\n";
  const auto check = [&](const std::string& table, const std::string& part) {
    check_says(with_finger(table), part);
  };
  CHECK(refusal(with_finger(head + bodies + twists + force)) == "accepted");
  check("[[actuator]]\n" + bodies + twists + force, "10: actuator 1: missing key \"name\"");
  check(head + twists + force, "actuator \"jaw\": missing key \"bodies\"");
  check(head + bodies + force, "missing key \"twists\"");
  check(head + bodies + twists, "either a force or an acceleration");
  check(head + bodies + twists + force + "acceleration = 1", "either a force or an acceleration");
  check(head + bodies + twists + "force = -1", "force must be >= 0, got -1");
  check(head + bodies + twists + "acceleration = 1\ninertia = 1", "inertia goes with force");
  check(head + bodies + "twists = [[0, 0, 1]]\n" + force, "entry 1 of twists must be a list of 6");
  check(head + bodies + "twists = [[0, 0, 0, 0, 0, 0]]\n" + force, "twist of \"left\" is zero");
  check(head + "bodies = [\"lft\"]\n" + twists + force,
        "no body is called \"lft\" (did you mean \"left\"?)");
  check(head + "bodies = [1]\n" + twists + force, "entry 1 of bodies must be a text");
  check(named(head, "left") + bodies + twists + force, "the name \"left\" is taken");
  const std::string two = named(finger_table, "right") + head;
  check(two + "bodies = [\"left\", \"right\"]\n" + twists + force, "one entry for each of the 2");
  check(two + "bodies = [\"left\", \"left\"]\ntwists = [[1, 0, 0, 0, 0, 0], [1, 0, 0, 0, 0, 0]]\n" +
            force,
        "listed twice");
  check("grip_force = 1\n" + head + bodies + twists + force, "grip_force and [[actuator]] exclude");
  check("[gripper]\n" + head + bodies + twists + force,
        "[gripper] and the [[actuator]] on line 11");
}

TEST_CASE("what is read but cannot be solved yet is refused, each at its key") {
  check_refusal("planar = true\n" + with_finger(""), "1: planar = true is not supported yet");
  check_refusal("pressure = \"even\"\n" + with_finger(""),
                "1: pressure = \"even\" is not supported yet");
  check_refusal(with_pusher("acceleration = [0, 0, 0]\nfollow = \"bilateral\""),
                "11: pusher \"wall\": follow = \"bilateral\" is not supported yet");
  check_refusal(with_finger("torsion_radius = 0.001"),
                "10: finger \"left\": torsion_radius is not supported yet");
}

TEST_CASE("a torsion radius goes with a single point") {
  check_says(with_finger("shape = \"point\"", "torsion_radius = 1\nshape = \"disc\"\nradius = 1"),
             "torsion_radius goes with a single point only; this patch has 8");
}

TEST_CASE("an unknown key is refused with the nearest known one") {
  check_refusal(with_finger("friction", "fricton"),
                "9: finger \"left\": unknown key \"fricton\" (did you mean \"friction\"?)");
  check_says("gravty = [0, 0, 0]\n" + with_finger(""), "1: unknown key \"gravty\"");
  check_says(with_finger("zzzzzzzz = 1"), "the keys here are name, friction");
  check_says(with_finger("acceleration = [0, 0, 0]"), "unknown key \"acceleration\"");
}

TEST_CASE("an unknown, single or repeated table is refused") {
  check_refusal(with_finger("[[fingr]]"), "10: unknown table \"fingr\" (did you mean \"finger\"?)");
  check_says(with(with_finger(""), "[[finger]]", "[finger]"),
             "write [[finger]] instead of [finger]");
  check_says(with(with_finger(""), "[object]", "[[object]]"), "there is only one object");
  check_refusal(finger_table,
                "1: missing the table [object]; add [object] with mass and box, for example");
  check_refusal(object_table, "1: nothing touches the object; add at least one [[finger]] or "
                              "[[pusher]]");
  check_says("", "missing the table [object]");
}

TEST_CASE("a missing key is named with its table, line and an example") {
  check_refusal(with_finger("friction = 0.5\n", ""),
                "4: finger \"left\": missing key \"friction\"; add for example friction = 0.5");
  check_refusal(with_finger("name = \"left\"\n", ""),
                "4: finger 1: missing key \"name\"; add for example name = \"left\"");
  for (const char* line :
       {"shape = \"point\"\n", "center = [0, 0, 0.005]\n", "normal = [0, 0, -2]\n"})
    check_says(with_finger(line, ""), "4: finger \"left\": missing key");
}

TEST_CASE("names are unique over fingers, pushers and actuators") {
  check_refusal(
      object_table + finger_table + named(pusher_table, "left") + "acceleration = [0, 0, 0]\n",
      "11: pusher \"left\": the name \"left\" is taken by the table on line 4; names must "
      "be unique");
  check_says(with_finger("\"left\"", "\"\""), "name must not be empty");
  check_says(with_finger("\"left\"", "\"a\\nb\""), "control characters, got \"a\\x0Ab\"");
  check_says(with_finger("\"left\"", "3"), "5: finger 1: name must be a text");
}

TEST_CASE("wrong types, lengths and magnitudes are refused with what was found") {
  check_refusal(with_finger("= 0.5", "= -0.3"),
                "9: finger \"left\": friction must be >= 0, got -0.3");
  check_says(with_finger("= 0.5", "= \"0.5\""), "friction must be a number, got the text \"0.5\"");
  check_says(with_finger("= 0.5", "= true"), "friction must be a number, got true");
  check_says(with_finger("= 0.5", "= [1]"), "friction must be a number, got a list");
  check_says(with_finger("= 0.5", "= 1e13"), "friction must be within 1e12 in SI units, got 1e+13");
  check_says(with_finger("[0, 0, -2]", "[0, 0]"), "normal must be a list of 3 numbers");
  check_says(with_finger("[0, 0, -2]", "1"), "normal must be a list of 3 numbers, got 1");
  check_says(with_finger("[0, 0, -2]", "[0,\n0,\n\"x\"]"),
             "10: finger \"left\": entry 3 of normal");
  check_says(with_finger("grip_force = 0"), "grip_force must be > 0, got 0");
  check_says(with_finger("grip_force = 1e-30"), "grip_force must be >= 1e-24");
  check_says("title = 3\n" + with_finger(""), "title must be a text");
  check_says("planar = 1\n" + with_finger(""), "planar must be true or false, got 1");
  check_says("pressure = \"pads\"\n" + with_finger(""), "did you mean \"pad\"?");
  for (const char* facets : {"2", "258", "8.0", "-8", "\"8\""})
    check_says("facets = " + std::string(facets) + "\n" + with_finger(""),
               "1: facets must be a whole number from 4 to 256");
  check_says("facets = 7\n" + with_finger(""), "1: facets must be even, got 7");
}

TEST_CASE("a scene too large for any solver is refused") {
  std::string many = object_table;
  const std::string disc = with(finger_table, "\"point\"", "\"disc\"\nradius = 1\npoints = 4000");
  for (int i = 0; i < 26; ++i) many += named(disc, std::to_string(i));
  check_says(many, "more than 100000 contact points");
  many = object_table;
  for (int i = 0; i < 1001; ++i) many += named(finger_table, std::to_string(i));
  check_says(many, "more than 1000 bodies");
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
