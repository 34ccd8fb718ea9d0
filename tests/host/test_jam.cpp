// Rays in words: who squeezes whom, and remedies that were tried.
#include "fixture_push.hpp"

#include "scene_text.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// The jam of a scene that must end in a ray.
struct Jammed {
  host::SceneFile file;
  host::Jam jam;
  std::string words;

  explicit Jammed(const std::string& text) : file(host::parse_scene(text, "test.toml")) {
    host::Push push(file);
    const host::PushReport report = push.solve({});
    REQUIRE(report.status == Status::ray);
    jam = report.jam;
    for (const std::string& sentence : host::jam_sentences(file, jam)) words += sentence + "\n";
  }
  bool says(const std::string& part) const { return words.find(part) != std::string::npos; }
  const host::JamBody* body(const std::string& name) const {
    for (const host::JamBody& candidate : jam.bodies)
      if (file.body_names[static_cast<std::size_t>(candidate.body)] == name) return &candidate;
    return nullptr;
  }
};

} // namespace

TEST_CASE(
    "a jam names the pusher that squeezes, the stop that it squeezes against, and no finger") {
  for (const char* law : {"pad", "rigid", "even"}) {
    CAPTURE(law);
    const Jammed jammed(with(scene_text("jam.toml"), "\ntitle",
                             std::string("\npressure = \"") + law + "\"\ntitle"));
    CHECK(jammed.says("A jam: wall (moves as prescribed) at wall."));
    CHECK(jammed.says(" squeezes the object against stop (fixed) at stop."));
    CHECK(jammed.says("No friction takes part"));
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
  for (const host::Remedy& remedy : jammed.jam.remedies) {
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
  for (const host::Remedy& remedy : jammed.jam.remedies)
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
      host::object_table + wall("stop", "[0, 0.015, 0]", "[0, -1, 0]", "finger", "") +
      wall("wall", "[-0.015, 0, 0]", "[1, 0, 0]", "pusher", "acceleration = [0.1, 0.1, 0]\n"));
  CHECK(jammed.jam.uses_friction);
  CHECK(jammed.says("no proof"));
}

TEST_CASE("an actuator that closes on nothing runs away, and nothing is called squeezed") {
  const std::string actuator = "[[actuator]]\nname = \"drag\"\nbodies = [\"left\"]\n"
                               "twists = [[1, 0, 0, 0, 0, 0]]\nforce = 4\n";
  const Jammed jammed(host::object_table + host::finger_table + actuator);
  CHECK(jammed.jam.bodies.empty());
  REQUIRE(jammed.jam.running_away.size() == 1);
  CHECK(jammed.says("the actuator of left closes without end"));
}
