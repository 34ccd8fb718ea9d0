// Motions of scene files: closed forms, events, strokes, the control of steps, and what ends them.
#include "lcpush/desktop/move.hpp"

#include "formats/json_reader.hpp"
#include "support/fixture_push.hpp"
#include "support/scene_text.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

SceneFile scene_of(const std::string& text) { return parse_scene(text, "s.toml", Strokes::all); }

MotionReport moved_to(const SceneFile& file, double time, std::optional<double> step = {},
                      std::optional<double> tolerance = {}) {
  MoveOptions options;
  options.time = time;
  options.step = step;
  options.tolerance = tolerance;
  options.frames = 11;
  return move(file, options);
}

const Pose<double>& last_pose(const MotionReport& report) { return report.frames.back().pose; }
double turned_z(const MotionReport& report) {
  const Matrix3<double>& R = last_pose(report).rotation;
  return std::atan2(R(1, 0), R(0, 0));
}

/// A bar in two four-point pads; gravity across the push.
std::string gripped_bar(double grip_force, const std::string& more) {
  const std::string pad =
      "radius = 0.005; points = 4; friction = 0.7; grip_force = " + std::to_string(grip_force) +
      "; ";
  return test::table("", "gravity = [0, -9.81, 0]") +
         test::table("[object]", "mass = 0.045; box = [0.1, 0.03, 0.01]") +
         test::finger("left", "ring", pad + "center = [0.02, 0, 0.005]; normal = [0, 0, -1]") +
         test::finger("right", "ring", pad + "center = [0.02, 0, -0.005]; normal = [0, 0, 1]") +
         more;
}

const std::string wall =
    test::pusher("wall", "line",
                 "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]; normal = [1, 0, 0]; "
                 "friction = 0.3; velocity = [0.01, 0, 0]");

/// A bar that turns about a pin, two points without torsion, pushed up at x = -0.04.
const std::string pinned =
    test::table("", "planar = true") +
    test::table("[object]", "mass = 0.2; box = [0.1, 0.03, 0.01]") +
    test::finger("left", "point",
                 "center = [0, 0, 0.005]; normal = [0, 0, -1]; friction = 0.9; grip_force = 30") +
    test::finger("right", "point",
                 "center = [0, 0, -0.005]; normal = [0, 0, 1]; friction = 0.9; grip_force = 30") +
    test::pusher("pin", "point",
                 "center = [-0.04, -0.015, 0]; normal = [0, 1, 0]; friction = 0; "
                 "velocity = [0, 0.02, 0]");

} // namespace

TEST_CASE("a grasp that holds does not creep in ten seconds") {
  for (const double grip_force : {12.0, 60.0}) {
    const SceneFile file = scene_of(gripped_bar(grip_force, ""));
    const MotionReport report = moved_to(file, 10, 0.02);
    REQUIRE(report.status == Status::solved);
    CHECK(report.end == MoveEnd::time);
    CHECK(report.steps == 500);
    for (const Vector3<double>& p : file.points)
      CHECK((last_pose(report).at(p) - p).norm() <= 1e-12);
    REQUIRE(report.phases.size() == 1);
    CHECK(report.phases[0].kind == MotionKind::rest);
    CHECK(report.events.empty());
  }
}

TEST_CASE("a fixed step is as long as was asked, however many frames are kept") {
  const SceneFile file = scene_of(gripped_bar(20, wall));
  MoveOptions options;
  options.time = 1;
  options.step = 0.1;
  const MotionReport report = move(file, options);
  CHECK(report.steps == 10);
  REQUIRE(report.frames.size() == 11);
  for (std::size_t k = 1; k < report.frames.size(); ++k) {
    CHECK(report.frames[k].step == doctest::Approx(0.1));
    CHECK(report.frames[k].time == doctest::Approx(0.1 * static_cast<double>(k)));
  }
  options.frames = 4; // their ends are not at thirds of the time: the next ones are kept
  const MotionReport few = move(file, options);
  CHECK(few.steps == 10);
  REQUIRE(few.frames.size() == 4);
  CHECK(few.frames[1].time == doctest::Approx(0.4));
  CHECK(few.frames[3].time == doctest::Approx(1));
}

TEST_CASE("a slide of 30 mm under gravity drops nothing, and a patch that runs out says when") {
  for (const double place : {0.0, 0.02}) {
    std::string text = gripped_bar(20, wall);
    for (int finger = 0; finger < 2 && place == 0; ++finger)
      text = with(text, "center = [0.02, 0,", "center = [0, 0,");
    const SceneFile file = scene_of(text);
    const MotionReport slide = moved_to(file, 3, 0.01);
    REQUIRE(slide.status == Status::solved);
    const Vector3<double> way(0.03, 0, 0);
    for (const Vector3<double>& p : file.points)
      CHECK((last_pose(slide).at(p) - p - way).norm() <= 1e-12);
    CHECK(slide.penetration <= 1e-9);
    REQUIRE(slide.phases.size() == 1);
    CHECK(slide.phases[0].kind == MotionKind::slide);
    CHECK(slide.phases[0].path == doctest::Approx(0.03));
  }
  const SceneFile file = scene_of("facets = 8\n" + gripped_bar(20, wall));
  // The object's rear edge passes the points at 15 mm, 20 mm and 25 mm of the hand.
  const MotionReport lost = moved_to(file, 10);
  CHECK(lost.end == MoveEnd::lost);
  CHECK(lost.status == Status::does_not_hold);
  REQUIRE(lost.body >= 0);
  const bool is_finger = lost.body < 2; // both let go there, and rounding says which of them first
  CHECK(is_finger);
  // From 7 s on one point a finger is left, a hinge that the wall pushes ahead of itself: when it
  // gives way is rounding's to say.
  CHECK(lost.frames.back().time >= 7.1);
  CHECK(lost.frames.back().time <= 7.51);
  REQUIRE(!lost.phases.empty());
  CHECK(lost.phases[0].kind == MotionKind::slide);
  REQUIRE(!lost.events.empty());
  CHECK(lost.events[0].to == Touch::beside);
  CHECK(std::abs(lost.events[0].time - 6.5) <= 10.0 / 4096 + lost.events[0].within);
}

TEST_CASE("a bar about a pin follows the push in closed form, however it is stepped") {
  const SceneFile file = scene_of(pinned);
  for (const std::optional<double> step : {std::optional<double>(), std::optional<double>(0.01)}) {
    const MotionReport report = moved_to(file, 0.3, step); // later it spins freely
    REQUIRE(report.status == Status::solved);
    // The face at -b from the pin goes through (-d, -b + s): d sin t + (b - s) cos t = b.
    const double d = 0.04, b = 0.015, s = 0.006, t = -turned_z(report);
    CHECK(t > 0.14);
    CHECK(std::abs(d * std::sin(t) + (b - s) * std::cos(t) - b) <= 1e-9);
    CHECK(report.penetration <= 1e-9);
    REQUIRE(report.phases.size() == 1);
    CHECK(report.phases[0].kind == MotionKind::pivot);
    CHECK(std::abs(report.phases[0].turn.z() + t) <= 1e-6);
  }
}

TEST_CASE("a cylinder in a parallel jaw rolls by s / R") {
  const SceneFile file = read_scene(LCPUSH_SOURCE_DIR "/fixtures/scenes/rolling.toml");
  const double radius = file.shape.size[(file.shape.axis + 1) % 3] / 2;
  const MotionReport report = moved_to(file, 0.8, 0.002);
  REQUIRE(report.status == Status::solved);
  double way = 0; // of the sheet, from rest
  for (const Body<double>& body : file.bodies)
    if (body.role == Role::pusher) way = body.acceleration.head<3>().norm() * 0.8 * 0.8 / 2;
  CHECK(std::abs(turned_z(report) - way / radius) <= 1e-9);
  CHECK(report.phases[0].kind == MotionKind::roll);
  CHECK(report.penetration <= 1e-9);
}

TEST_CASE("strokes come and go, and what moves is what is there") {
  const std::string up = "[[pusher]]\nname = \"below\"\nshape = \"line\"\n"
                         "ends = [[0.01, -0.02, 0], [0.05, -0.02, 0]]\nnormal = [0, 1, 0]\n"
                         "friction = 0.3\nvelocity = [0, 0.01, 0]\nfrom = 1\nuntil = 2\n";
  const SceneFile file = scene_of(gripped_bar(20, wall + "until = 1\n" + up));
  CHECK(motion_time(file) == 2);
  const MotionReport report = moved_to(file, 2);
  REQUIRE(report.status == Status::solved);
  CHECK(std::abs(last_pose(report).position.x() - 0.01) <= 1e-9);
  // The second comes from 5 mm below: 10 mm less 5.
  CHECK(std::abs(last_pose(report).position.y() - 0.005) <= 1e-6);
  CHECK(report.phases.size() == 3);
  CHECK(report.frames.back().contacts[8].touch == Touch::away);
  // One that begins inside the object is no push.
  const SceneFile inside =
      scene_of(with(gripped_bar(20, wall + "until = 1\n" + up),
                    "[0.01, -0.02, 0], [0.05, -0.02, 0]", "[0.01, -0.01, 0], [0.05, -0.01, 0]"));
  const MotionReport ends = moved_to(inside, 2);
  CHECK(ends.end == MoveEnd::inside);
  REQUIRE(ends.body >= 0);
  CHECK(inside.body_name(ends.body) == "below");
  CHECK(ends.frames.back().time == doctest::Approx(1));
}

TEST_CASE("a way or a number of steps ends the motion, with what there is so far") {
  const SceneFile file = scene_of(gripped_bar(20, wall));
  MoveOptions options;
  options.time = 3;
  options.distance = 0.0123;
  const MotionReport far = move(file, options);
  CHECK(far.end == MoveEnd::distance);
  CHECK(far.status == Status::solved);
  CHECK(std::abs(last_pose(far).position.x() - 0.0123) <= 1e-9);
  options.distance = 1;
  options.most_steps = 20;
  const MotionReport cut = move(file, options);
  CHECK(cut.end == MoveEnd::steps);
  CHECK(cut.status != Status::solved);
  CHECK(cut.frames.size() >= 2);
  CHECK(move_text(file, cut).find("solves go, ") != std::string::npos);
}

TEST_CASE("pushers that squeeze the object end its motion: it does not leap through them") {
  const SceneFile file = read_scene(LCPUSH_SOURCE_DIR "/fixtures/scenes/two_pushers.toml");
  for (const std::optional<double> step :
       {std::optional<double>(), std::optional<double>(2e-3), std::optional<double>(5e-4)}) {
    const MotionReport report = moved_to(file, 1, step);
    CHECK(report.status != Status::solved);
    CHECK((report.end == MoveEnd::leaps || report.end == MoveEnd::failed));
    CHECK(std::abs(report.frames.back().time - 0.7071) <= 0.01);
    CHECK(std::abs(turned_z(report)) <= 1);
  }
}

TEST_CASE("a lever that jams ends there: a bar does not fit between its fulcrum and the plunger") {
  const SceneFile file = read_scene(LCPUSH_SOURCE_DIR "/fixtures/scenes/lever.toml");
  // A bar 4 mm thick between two points 1 mm apart along it, the upper one at 4 mm - t^2 / 2.
  const double jams = std::sqrt(2 * (0.004 - std::sqrt(0.004 * 0.004 - 0.001 * 0.001)));
  for (const std::optional<double> step : {std::optional<double>(), std::optional<double>(1e-4)}) {
    const MotionReport report = moved_to(file, 1, step);
    CHECK(report.end == MoveEnd::leaps);
    CHECK(report.frames.back().time < jams);
    CHECK(report.frames.back().time > jams - 2e-5);
    CHECK(report.penetration <= 1e-9);
    const char* const words = step ? "fulcrum and plunger press on it with"
                                   : "until fulcrum and plunger leave it no room";
    CHECK(move_text(file, report).find(words) != std::string::npos);
  }
}

TEST_CASE("a pusher that has left the object is told, and a push that falls at once is an event") {
  SceneFile file = read_scene(LCPUSH_SOURCE_DIR "/fixtures/scenes/pivot.toml");
  file.is_round = false;
  const MotionReport report = moved_to(file, 1);
  CHECK(move_text(file, report).find("From 0.976 s on edge") != std::string::npos);
  REQUIRE(report.jumps.size() == 2);
  CHECK(std::abs(report.jumps[0].time - 0.5455) <= 0.005);
  CHECK(report.jumps[0].to < 0.85 * report.jumps[0].from);
  CHECK(report.jumps[1].to == 0);
  const MotionReport before = moved_to(file, 0.5);
  CHECK(before.jumps.empty());
  CHECK(move_text(file, before).find("no more") == std::string::npos);
}

TEST_CASE("who touches no face is refused by name and line") {
  const auto refused = [](const std::string& text) {
    try {
      (void)move(scene_of(text), {});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string tilted = with(pinned, "normal = [0, 1, 0]", "normal = [1, 1, 0]");
  CHECK(refused(tilted).find("s.toml:23: pusher \"pin\": no face of the object has this normal; a "
                             "motion of edge against edge is not modelled") == 0);
  CHECK(refused(tilted + "points_on = \"object\"\n") == "accepted");
  CHECK(refused(with(pinned, "[-0.04, -0.015, 0]", "[-0.06, -0.015, 0]"))
            .find("s.toml:22: pusher \"pin\": pin.1 lies beside the object's face") == 0);
  CHECK(refused(with(pinned, "[-0.04, -0.015, 0]", "[-0.04, -0.013, 0]"))
            .find("s.toml:22: pusher \"pin\": pin.1 lies 2 mm inside the object") == 0);
  // The coin's contacts are taken at its centre: they are the object's, on planes of the bodies.
  const std::string elsewhere = test::scene_text("coin_from_above.toml");
  CHECK(refused(elsewhere).find("finger \"table\": table.1 lies 8 mm inside") != std::string::npos);
  const SceneFile on_planes = scene_of(test::scene_text("coin.toml"));
  CHECK(std::abs(last_pose(moved_to(on_planes, 1)).position.x() - 0.5) <= 1e-9);
  const std::string face = "[[face]]\ncorners = [[-0.05, -0.015, -0.005], [0.05, -0.015, -0.005], "
                           "[0.05, -0.015, 0.005], [-0.05, -0.015, 0.005]]\n";
  CHECK(refused(pinned + face).find("finger \"left\": no face of the object") != std::string::npos);
}

TEST_CASE("frames obey Newton and Euler over their steps, as they are printed") {
  // mass (v' - v) = h sum f over one step of the frames, from the JSON alone.
  const SceneFile file = scene_of(gripped_bar(20, wall));
  MoveOptions options;
  options.time = 0.05;
  options.step = 0.001;
  options.frames = 51;
  const JsonValue json = parse_json(move_json(file, move(file, options)), "json");
  const auto& frames = json.find("frames")->as<JsonArray>()[0];
  REQUIRE(frames.size() == 51);
  for (std::size_t k = 1; k < frames.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double force = axis == 1 ? -9.81 * 0.045 : 0;
      for (const JsonValue& body : frames[k].find("bodies")->as<JsonArray>()[0])
        force += body.find("force")->as<JsonArray>()->at(axis).as<double>()[0];
      const double change = frames[k].find("twist")->as<JsonArray>()->at(axis).as<double>()[0] -
                            frames[k - 1].find("twist")->as<JsonArray>()->at(axis).as<double>()[0];
      CHECK(std::abs(0.045 * change - 0.001 * force) <= 1e-9);
    }
    for (const JsonValue& contact : frames[k].find("contacts")->as<JsonArray>()[0]) {
      double friction = 0;
      for (const JsonValue& f : contact.find("friction_force")->as<JsonArray>()[0])
        friction += f.as<double>()[0] * f.as<double>()[0];
      CHECK(std::sqrt(friction) <= 0.7 * contact.find("normal_force")->as<double>()[0] + 1e-9);
    }
  }
}
