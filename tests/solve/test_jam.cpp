// Rays in words: who squeezes whom, and remedies that were tried.
#include "support/fixture_push.hpp"

#include "support/scene_text.hpp"

#include <algorithm>

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// The jam of a scene that must end in a ray.
struct Jammed {
  desktop::SceneFile file;
  desktop::Jam jam;
  std::string words;

  explicit Jammed(const std::string& text) : file(desktop::parse_scene(text, "test.toml")) {
    desktop::Push push(file);
    const desktop::PushReport report = push.solve({});
    REQUIRE(report.status == Status::ray);
    jam = report.jam;
    for (const std::string& sentence : desktop::jam_sentences(file, jam)) words += sentence + "\n";
  }
  bool says(const std::string& part) const { return words.find(part) != std::string::npos; }
  const desktop::JamBody* body(const std::string& name) const {
    for (const desktop::JamBody& candidate : jam.bodies)
      if (file.body_names[static_cast<std::size_t>(candidate.body)] == name) return &candidate;
    return nullptr;
  }
};

/// The words for a ray written by hand: entries by their unknowns' names, all others zero.
struct RayByHand {
  desktop::SceneFile file;
  desktop::Push push;
  desktop::Jam jam;
  std::string words;

  RayByHand(const std::string& text, const std::vector<desktop::NamedValue>& entries)
      : file(desktop::parse_scene(text, "test.toml")), push(file) {
    std::vector<double> v(static_cast<std::size_t>(push.layout().size));
    for (const desktop::NamedValue& entry : entries) v[unknown(entry.name)] = entry.value;
    jam = desktop::explain_jam(file, push.assembly(), v.data());
    for (const std::string& sentence : desktop::jam_sentences(file, jam)) words += sentence + "\n";
  }
  bool says(const std::string& part) const { return words.find(part) != std::string::npos; }

private:
  std::size_t unknown(const std::string& name) const {
    Index i = 0;
    while (i < push.layout().size && push.variable_name(i) != name) ++i;
    REQUIRE(i < push.layout().size);
    return static_cast<std::size_t>(i);
  }
};

/// A point that touches the box's side x = +-0.05.
std::string side_point(const std::string& role, const std::string& name, int side,
                       const std::string& more = "") {
  const std::string sign = side > 0 ? "" : "-", normal = side > 0 ? "-" : "";
  return "[[" + role + "]]\nname = \"" + name + "\"\nshape = \"point\"\ncenter = [" + sign +
         "0.05, 0, 0]\nnormal = [" + normal + "1, 0, 0]\ntangent = [0, 1, 0]\nfriction = 0.2\n" +
         more;
}

std::string stop_and_wall(const std::string& motion) {
  return desktop::object_table + side_point("finger", "stop", 1) +
         side_point("pusher", "wall", -1, "acceleration = " + motion + "\n");
}

const std::vector<desktop::NamedValue> oblique = {{"normal of stop.1", 1},
                                                  {"friction of stop.1 along -y", 0.1},
                                                  {"normal of wall.1", 1},
                                                  {"friction of wall.1 along +y", 0.1}};

} // namespace

TEST_CASE(
    "a jam names the pusher that squeezes, the stop that it squeezes against, and no finger") {
  for (const char* law : {"pad", "rigid", "even"}) {
    CAPTURE(law);
    const Jammed jammed(with(scene_text("jam.toml"), "\ntitle",
                             std::string("\npressure = \"") + law + "\"\ntitle"));
    CHECK(jammed.says("A jam: wall (moves as prescribed) at wall."));
    CHECK(jammed.says(" squeezes the object against stop (fixed) at stop."));
    CHECK(jammed.says("and nothing gives way."));
    CHECK(jammed.says("No friction takes part, so there is no answer"));
    CHECK(jammed.jam.no_answer);
    CHECK_FALSE(jammed.says("left"));
    REQUIRE(jammed.jam.bodies.size() == 2);
    CHECK(jammed.body("wall")->power > 0);
    CHECK(jammed.body("stop")->power == 0);
    CHECK(jammed.body("stop")->normal == doctest::Approx(jammed.body("wall")->normal));
  }
}

TEST_CASE("every remedy for the jam was tried: a force on either side, or a push across") {
  const Jammed jammed(scene_text("jam.toml"));
  REQUIRE(jammed.jam.remedies.size() == 3);
  for (const desktop::Remedy& remedy : jammed.jam.remedies) {
    CHECK(remedy.tried);
    CHECK(remedy.works);
  }
  CHECK(jammed.says("stop held by a force instead of fixed (grip_force): tried, it does"));
  CHECK(jammed.says("acceleration (0, 0.1, 0): tried, it does"));
}

TEST_CASE("a remedy that does not help says so: two walls close on the part, one stop is freed") {
  const std::string wall = "\n[[pusher]]\nname = \"other\"\nshape = \"point\"\n"
                           "center = [0.05, 0, 0]\nnormal = [-1, 0, 0]\nfriction = 0.2\n"
                           "acceleration = [-0.1, 0, 0]\n";
  const Jammed jammed(scene_text("jam.toml") + wall);
  bool some_do_not = false;
  for (const desktop::Remedy& remedy : jammed.jam.remedies)
    some_do_not = some_do_not || (remedy.tried && !remedy.works);
  CHECK(some_do_not);
  CHECK(jammed.says("tried, not by itself"));
}

TEST_CASE("a wedge by friction is called no proof") {
  // Two walls at a right angle, each within the other's friction cone, close on a corner.
  const auto wall = [](const char* name, const char* center, const char* normal, const char* role,
                       const char* motion) {
    return std::string("[[") + role + "]]\nname = \"" + name +
           "\"\nshape = \"point\"\ncenter = " + center + "\nnormal = " + normal +
           "\nfriction = 1.5\n" + motion;
  };
  const Jammed jammed(
      desktop::object_table + wall("stop", "[0, 0.015, 0]", "[0, -1, 0]", "finger", "") +
      wall("wall", "[-0.015, 0, 0]", "[1, 0, 0]", "pusher", "acceleration = [0.1, 0.1, 0]\n"));
  CHECK(jammed.jam.uses_friction);
  CHECK_FALSE(jammed.jam.no_answer);
  CHECK(jammed.says("It looks like a jam: wall"));
  CHECK(jammed.says("no proof"));
  CHECK_FALSE(jammed.says("nothing gives way"));
}

TEST_CASE("an actuator that closes on nothing runs away, and nothing is called squeezed") {
  const std::string actuator = "[[actuator]]\nname = \"drag\"\nbodies = [\"left\"]\n"
                               "twists = [[1, 0, 0, 0, 0, 0]]\nforce = 4\n";
  const Jammed jammed(desktop::object_table + desktop::finger_table + actuator);
  CHECK(jammed.jam.bodies.empty());
  REQUIRE(jammed.jam.running_away.size() == 1);
  CHECK(jammed.says("the actuator of left closes without end"));
}

TEST_CASE("a squeeze that no motion tightens is called neither a jam nor without an answer") {
  for (const char* motion : {"[0, 0, 0]", "[0, 0.1, 0]", "[1e-13, 0.1, 0]", "[-0.1, 0, 0]"}) {
    CAPTURE(motion);
    const RayByHand ray(stop_and_wall(motion), {{"normal of stop.1", 1}, {"normal of wall.1", 1}});
    CHECK(ray.says("The object is squeezed by stop (fixed) at stop.1 and wall ("));
    CHECK(ray.says("nothing relieves it"));
    CHECK_FALSE(ray.says("jam"));
    CHECK_FALSE(ray.says("so there is no answer"));
  }
}

TEST_CASE("a point that presses and pulls alike is named") {
  const std::string held =
      side_point("pusher", "held", 1, "follow = \"bilateral\"\nacceleration = [0, 0.1, 0]\n");
  const RayByHand ray(desktop::object_table + held +
                          side_point("pusher", "wall", -1, "acceleration = [0.1, 0, 0]\n"),
                      {{"normal of held.1", 1}, {"pull of held.1", 1}, {"normal of wall.1", 1e-3}});
  CHECK(ray.says("against held (moves as prescribed) at held.1."));
  for (const desktop::JamBody& body : ray.jam.bodies) CHECK_FALSE(body.points.empty());
}

TEST_CASE("an actuator that feels the squeeze is not said to be unloaded") {
  const std::string drive = "[[actuator]]\nname = \"a\"\nbodies = [\"stop\"]\ntwists = [[-1, 0, 0, "
                            "0, 0, 0]]\nforce = 4\n";
  const RayByHand ray(stop_and_wall("[0.1, 0, 0]") + drive,
                      {{"normal of stop.1", 1}, {"normal of wall.1", 1}});
  CHECK(ray.says("stop (driven by a force) at stop.1"));
  CHECK_FALSE(ray.jam.no_answer);
}

TEST_CASE("friction in the ray of a wall that slides: no claim that nothing gives way") {
  const RayByHand ray(stop_and_wall("[0, 0.1, 0]"), oblique);
  CHECK(ray.says("It looks like a jam: wall (moves as prescribed) at wall.1 squeezes the object "
                 "against stop (fixed) at stop.1.\n"));
  CHECK(ray.says("These pivots found no answer; friction takes part, so that is a strong sign"));
  CHECK(ray.says("no proof that there is none"));
  CHECK_FALSE(ray.says("nothing gives way"));
}

TEST_CASE("a push across an oblique squeeze leads along the wall's face, never into the object") {
  const RayByHand slides(stop_and_wall("[0, 0.1, 0]"),
                         oblique); // only the other way in the face is left
  CHECK(slides.says("acceleration (0, 0, 0.1)"));
  const RayByHand leans(stop_and_wall("[0.1, 0, 0.05]"), oblique);
  CHECK(leans.says("acceleration (0, 0, 0.111803"));
  const RayByHand planar("planar = true\n" + stop_and_wall("[0.1, 0, 0]"), oblique);
  CHECK(planar.says("acceleration (0, -0.1, 0)")); // in the plane, and it loosens
}
