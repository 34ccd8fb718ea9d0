// The other scenes of fixtures/scenes, held to what their comments say.
#include "support/fixture_push.hpp"

#include <filesystem>
#include <type_traits>
#include <utility>

using namespace lcpush;
using namespace lcpush::test;
using doctest::Approx;

namespace {

Status status_of(const std::string& text, std::vector<desktop::NamedValue>* ray = nullptr) {
  const desktop::SceneFile file = desktop::parse_scene(text, "test.toml");
  desktop::Push push(file);
  const desktop::PushReport report = push.solve({});
  if (ray != nullptr) *ray = report.ray;
  return report.status;
}

desktop::BreakReport broken(const std::string& text) {
  const desktop::SceneFile file = desktop::parse_scene(text, "test.toml");
  return desktop::Push(file).find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
}

template <class P, class = void> struct Solves : std::false_type {};
template <class P>
struct Solves<P, std::void_t<decltype(std::declval<P>().solve(desktop::PushOptions{}))>>
    : std::true_type {};

} // namespace

TEST_CASE("a report that looks into its push cannot outlive the push's line") {
  CHECK(Solves<desktop::Push&>::value);
  CHECK_FALSE(Solves<desktop::Push>::value);
  CHECK_FALSE(std::is_constructible_v<desktop::Push, desktop::SceneFile>);
}

TEST_CASE("every scene of fixtures/scenes says what it is, and is solved or jams as it says") {
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/scenes")) {
    CAPTURE(entry.path().string());
    const std::string name = entry.path().filename().string(), text = scene_text(name);
    CHECK(text.rfind("# ", 0) == 0);
    CHECK(text.find("\ntitle = ") != std::string::npos);
    CHECK(status_of(text) == (name == "jam.toml" ? Status::ray : Status::solved));
    ++scenes;
  }
  CHECK(scenes >= 18);
}

TEST_CASE("driving a screw: the tip sticks and turns the driver in thumb and middle finger") {
  const std::string text = scene_text("screw_driving.toml");
  const Pushed pushed(text);
  CHECK(pushed.angular(2) == Approx(5));
  CHECK(pushed.normal_of("screw") == Approx(8.4905));
  CHECK(pushed.mode_of("screw.1") == Mode::stick);
  CHECK(pushed.mode_of("thumb.1") == Mode::slide);
  CHECK(pushed.report.motion.kind == MotionKind::pivot);
  const desktop::BreakReport breaking = broken(text);
  CHECK(breaking.breaking.force[5] == Approx(0.018).epsilon(1e-9));
  // Pressed too lightly, the tip cams out and the driver stays where it is.
  const Pushed light(with(text, "grip_force = 8 ", "grip_force = 6 "));
  CHECK(light.mode_of("screw.1") == Mode::slide);
  CHECK(std::abs(light.angular(2)) <= 1e-9);
}

TEST_CASE("pushing against the ground takes 2 mu F + m (g + a), breaking 2 mu F + m g") {
  const std::string text = scene_text("ground.toml");
  const Pushed pushed(text);
  CHECK(pushed.normal_of("ground") == Approx(15.093).epsilon(1e-9));
  CHECK(pushed.linear(1) == Approx(0.5));
  CHECK(break_force(text) == Approx(14.943).epsilon(1e-9));
}

TEST_CASE("a planar pusher holds the bar straight where a line would let it turn") {
  const std::string text = scene_text("planar_pusher.toml");
  const Pushed plate(text);
  CHECK(plate.normal_of("plate") == Approx(20.02).epsilon(1e-9));
  CHECK(plate.report.motion.kind == MotionKind::slide);
  const Pushed narrow(with(text, "size = [0.02, 0.016]", "size = [0.004, 0.016]"));
  CHECK(std::abs(narrow.angular(2)) > 0.05);
}

TEST_CASE("soft fingers break at the vertex of their cone, 2 mu F cos(30 deg); hard ones pivot") {
  const std::string text = scene_text("soft_fingers.toml");
  CHECK(break_force(text) == Approx(20 * std::sqrt(0.75)).epsilon(1e-6));
  CHECK(std::abs(break_force(with(text, "torsion_radius = 0.006", ""))) <= 1e-9);
}

TEST_CASE("a jam names the wall and the stop; a force on either side frees it") {
  const std::string text = scene_text("jam.toml");
  std::vector<desktop::NamedValue> ray;
  CHECK(status_of(text, &ray) == Status::ray);
  bool wall = false, stop = false, finger = false;
  for (const desktop::NamedValue& entry : ray) {
    wall = wall || entry.name.rfind("normal of wall.", 0) == 0;
    stop = stop || entry.name.rfind("normal of stop.", 0) == 0;
    finger = finger || entry.name.find("left") != std::string::npos;
  }
  CHECK(wall);
  CHECK(stop);
  CHECK_FALSE(finger);
  CHECK(status_of(with(text, "name = \"stop\" ", "name = \"stop\"\ngrip_force = 30 ")) ==
        Status::solved);
  CHECK(status_of(with(text, "acceleration = [0.1, 0, 0]", "normal_force = 30")) == Status::solved);
  CHECK(status_of(with(text, "acceleration = [0.1, 0, 0]", "acceleration = [0, 0.1, 0]")) ==
        Status::solved);
}

TEST_CASE("jams are found with 2, 4 and 9 points on each side") {
  const std::string text = scene_text("jam.toml");
  for (const char* points : {"[2, 1]", "[2, 2]", "[3, 3]"})
    for (const char* law : {"pad", "rigid", "even"}) {
      CAPTURE(points);
      CAPTURE(law);
      const std::string sampled = with(text, "points = [2, 2]", std::string("points = ") + points);
      CHECK(status_of(with(sampled, "\ntitle",
                           std::string("\npressure = \"") + law + "\"\ntitle")) == Status::ray);
    }
}

TEST_CASE("two opposite pushers turn a ring against 2 mu F R") {
  const desktop::SceneFile file = desktop::parse_scene(scene_text("two_pushers.toml"), "test.toml");
  desktop::Push push(file);
  for (const Index rod : {2, 3})
    CHECK(push.find_breaking(rod, {}).breaking.break_force == Approx(1.25).epsilon(1e-9));
  CHECK(push.solve({}).motion.kind == MotionKind::pivot);
}

TEST_CASE("a block tips over its far edge at (m g + F) / 3") {
  const std::string text = scene_text("tipping.toml");
  const Pushed tipped(text);
  CHECK(tipped.mode_of("table.1") == Mode::separate);
  CHECK(tipped.mode_of("table.2") == Mode::stick);
  CHECK(break_force(text) == Approx(14.905 / 3).epsilon(1e-9));
  const Pushed slippery(with(text, "friction = 0.8", "friction = 0.1"));
  CHECK(slippery.report.motion.kind == MotionKind::slide);
}

TEST_CASE("a lever of 1 : 98 drives its finger back at 98 times the push") {
  const Pushed lever(scene_text("lever.toml"));
  CHECK(lever.report.answer.contacts[1].closing_acceleration == Approx(-98).epsilon(1e-9));
  CHECK(lever.normal_of("fingertip") == Approx(1).epsilon(1e-9));
  CHECK(break_force(scene_text("lever.toml")) == Approx(98).epsilon(1e-9));
}

TEST_CASE("a vise of two stops: falling is what is found, held an answer too") {
  const std::string text = scene_text("vise.toml");
  const Pushed fallen(text);
  CHECK(fallen.linear(1) == Approx(-9.81));
  // Held: the same laws with the squeeze put in by hand.
  Answer<double> held = fallen.report.answer;
  held.acceleration.setZero();
  const double lift = 0.2 * 9.81 / 2;
  std::vector<double> friction(static_cast<std::size_t>(held.friction.size), 0.0);
  for (Index i = 0; i < 2; ++i) {
    ContactAnswer<double>& contact = held.contacts[i];
    const Body<double>& body = fallen.file.bodies[static_cast<std::size_t>(i)];
    contact.normal_force = 2 * lift / 0.5;
    contact.friction_force = Vector3<double>(0, lift, 0);
    contact.acceleration.setZero();
    contact.slip = 0;
    for (Index j = 0; j < 8; ++j)
      if (generator(body, j, 8).force[1] > 0.999)
        friction[static_cast<std::size_t>(8 * i + j)] = lift;
  }
  held.friction.data = friction.data();
  const Scene<double> scene = fallen.file.view();
  CHECK(check(scene, fallen.report.scales, held, 1.0).max() <= 1e-12);
}

TEST_CASE("a tendon and a motor: three fingers of 12 N each, 3 mu F + m a against the push") {
  const std::string text = scene_text("three_finger_hand.toml");
  const Pushed pushed(text);
  for (const char* finger : {"a", "b", "c"}) CHECK(pushed.normal_of(finger) == Approx(12));
  CHECK(pushed.normal_of("plate") == Approx(18.02).epsilon(1e-9));
  // A tendon far too weak for the motor lets the disc go sideways, against the plate's friction.
  const Pushed pulled(with(text, "force = 24 ", "force = 10 "));
  CHECK(pulled.linear(1) > 1);
}

TEST_CASE("a grasp that drops the part says so before it speaks of pushing") {
  const std::string text = scene_text("dropped.toml");
  const desktop::BreakReport report = broken(text);
  CHECK(report.status == Status::does_not_hold);
  CHECK(report.breaking.rest[1] == Approx(-3.81));
  const Pushed pushed(text);
  // 4 mu N = 1.2 N of friction against the fall, of which the push turns a little aside.
  const double tilt = std::atan2(0.1, -pushed.linear(1));
  CHECK(pushed.linear(1) == Approx(1.2 * std::cos(tilt) / 0.2 - 9.81).epsilon(1e-9));
  CHECK(pushed.normal_of("rod") == Approx(0.02 + 1.2 * std::sin(tilt)).epsilon(1e-9));
}
