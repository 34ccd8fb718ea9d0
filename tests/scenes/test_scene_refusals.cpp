#include "support/scene_text.hpp"

using namespace lcpush::desktop;

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

TEST_CASE("a planar scene refuses a body that moves into the object out of the plane") {
  const std::string above = "[[pusher]]\nname = \"lid\"\nshape = \"point\"\n"
                            "center = [0, 0, 0.005]\nnormal = [0, 0, -1]\nfriction = 0.3\n";
  const std::string planar = "planar = true\n" + object_table;
  check_says(planar + above + "acceleration = [0, 0, -0.1]\n", "5: \"lid\": moves into the object");
  CHECK(parsed(planar + above + "acceleration = [0, 0, 0.1]\n").planar);
  CHECK(parsed(planar + above + "acceleration = [0.1, 0, 0]\n").planar);
  CHECK_FALSE(parsed(object_table + above + "acceleration = [0, 0, -0.1]\n").planar);
}

TEST_CASE("what contradicts itself is refused, each at its key") {
  const std::string parallel = "[gripper]\njaws = \"parallel\"\n";
  check_refusal("pressure = \"even\"\n" + object_table + parallel + finger_table,
                "6: gripper: parallel jaws share one force over both fingers, so no point's even "
                "share of it is known; use jaws = \"independent\" or another pressure than "
                "\"even\"");
  const std::string shared = "[[actuator]]\nname = \"tendon\"\nbodies = [\"left\", \"right\"]\n"
                             "twists = [[0, 0, -1, 0, 0, 0], [0, 0, -1, 0, 0, 0]]\nforce = 2\n";
  const std::string two = object_table + finger_table + named(finger_table, "right");
  check_says("pressure = \"even\"\n" + two + shared, "19: actuator \"tendon\": an actuator of "
                                                     "several bodies shares one force");
  CHECK(parsed(two + shared).actuators.size() == 1);
  const std::string idle = "[[actuator]]\nname = \"tendon\"\nbodies = [\"left\"]\n"
                           "twists = [[0, 0, -1, 0, 0, 0]]\nforce = 0\n";
  check_says(with_finger("") + idle,
             "14: actuator \"tendon\": an actuator without force and inertia");
  CHECK(parsed(with_finger("") + idle + "inertia = 0.1\n").actuators.size() == 1);
  check_refusal(with_pusher("normal_force = 3\nfollow = \"bilateral\""),
                "11: pusher \"wall\": follow = \"bilateral\" holds the pusher's normal motion, "
                "normal_force its force; remove one of the two");
}

TEST_CASE("even pressure, soft points and bilateral pushers are read") {
  CHECK(parsed("pressure = \"even\"\n" + with_finger("")).pressure == lcpush::Pressure::even);
  CHECK(parsed(with_finger("torsion_radius = 0.001")).bodies[0].torsion_radius == 0.001);
  const std::string wall = "acceleration = [0, 0, 0]\nfollow = ";
  CHECK(parsed(with_pusher(wall + "\"bilateral\"")).bodies[0].bilateral);
  CHECK_FALSE(parsed(with_pusher(wall + "\"unilateral\"")).bodies[0].bilateral);
}

TEST_CASE("an unknown key is refused with the nearest known one") {
  check_refusal(with_finger("friction", "fricton"),
                "9: finger \"left\": unknown key \"fricton\" (did you mean \"friction\"?)");
  check_says("gravty = [0, 0, 0]\n" + with_finger(""), "1: unknown key \"gravty\"");
  check_says(with_finger("zzzzzzzz = 1"), "the keys here are name, friction");
  check_says(with_finger("acceleration = [0, 0, 0]"), "; it goes with [[pusher]] or [[actuator]]");
  check_says(with_finger("gravity = [0, 0, 0]"), "; it stands at the top, before the first table");
  check_says(with_finger("mu = 0.5"), "(did you mean \"friction\"?)");
  check_says(with_finger("grip = 20"), "(did you mean \"grip_force\"?)");
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
