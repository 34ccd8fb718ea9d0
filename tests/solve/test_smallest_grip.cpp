// Rest is judged beside the load, and the smallest grip by what it says of more and of whom.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/report.hpp"

using namespace lcpush;
using namespace lcpush::test;
using doctest::Approx;

namespace {

constexpr desktop::Solver all_solvers[] = {desktop::Solver::lemke, desktop::Solver::hybrid,
                                           desktop::Solver::gauss_seidel};

/// Two points pinch a block of 1 g, which a rod touches at its side.
desktop::SceneFile pinch(double friction, double grip, double gravity, Pressure pressure,
                         const std::string& gripper = "[gripper]\njaws = \"independent\"\n") {
  const std::string tip = "friction = 0; grip_force = 1; ";
  desktop::SceneFile file = desktop::parse_scene(
      table("[object]", "mass = 0.001; box = [0.1, 0.03, 0.01]") +
          finger("left", "point", tip + "center = [0, 0, 0.005]; normal = [0, 0, -1]") +
          finger("right", "point", tip + "center = [0, 0, -0.005]; normal = [0, 0, 1]") + gripper +
          pusher("rod", "point",
                 "center = [-0.05, 0, 0]; normal = [1, 0, 0]; friction = 0; "
                 "acceleration = [0.1, 0, 0]"),
      "test.toml");
  file.gravity = {0, -gravity, 0};
  file.pressure = pressure;
  for (std::size_t b = 0; b < 2; ++b) file.bodies[b].friction = friction;
  for (Actuator<double>& actuator : file.actuators) actuator.force *= grip;
  return file;
}

desktop::PushOptions by(desktop::Solver solver) {
  desktop::PushOptions options;
  options.solver = solver;
  return options;
}

desktop::GripReport grip_of(const desktop::SceneFile& file) {
  desktop::Push push(file);
  const desktop::HoldReport hold = push.holds_without_push({});
  const desktop::BreakReport broken =
      push.find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
  return desktop::find_smallest_grip(file, hold, broken, {});
}

desktop::SceneFile fixture(const std::string& name) {
  return desktop::parse_scene(scene_text(name), "test.toml");
}

} // namespace

TEST_CASE("[T.10] a fall is no rest because the grip is huge beside it") {
  for (const Pressure pressure : {Pressure::pad, Pressure::even, Pressure::rigid})
    for (const desktop::Solver solver : all_solvers)
      for (const double grip : {10.0, 100.0, 3000.0}) {
        CAPTURE(static_cast<int>(pressure));
        CAPTURE(static_cast<int>(solver));
        CAPTURE(grip);
        const desktop::SceneFile file = pinch(0, grip, 0.09, pressure);
        desktop::Push push(file);
        const desktop::HoldReport hold = push.holds_without_push(by(solver));
        REQUIRE(hold.status == Status::solved);
        CHECK_FALSE(hold.holds);
        CHECK(hold.acceleration[1] == Approx(-0.09));
        const desktop::BreakReport broken = push.find_breaking(2, by(solver));
        CHECK(broken.status == Status::does_not_hold);
        CHECK_FALSE(broken.reason.empty());
      }
}

TEST_CASE("[T.10] with friction the same grip holds") {
  for (const Pressure pressure : {Pressure::pad, Pressure::even, Pressure::rigid})
    for (const double grip : {10.0, 100.0, 3000.0}) {
      CAPTURE(grip);
      const desktop::SceneFile file = pinch(0.5, grip, 0.09, pressure);
      desktop::Push push(file);
      const desktop::HoldReport hold = push.holds_without_push({});
      CHECK(hold.status == Status::solved);
      CHECK(hold.holds);
      CHECK(push.find_breaking(2, {}).status == Status::solved);
    }
}

TEST_CASE("[T.10] where a fall would drown in rounding nothing is said of holding") {
  const desktop::SceneFile drowned = pinch(0.5, 1e4, 1e-6, Pressure::pad);
  CHECK(desktop::Push(drowned).holds_without_push({}).status == Status::numerical_breakdown);
  const desktop::SceneFile nothing_to_hold = pinch(0.5, 1e4, 0, Pressure::pad);
  const desktop::HoldReport hold = desktop::Push(nothing_to_hold).holds_without_push({});
  CHECK(hold.status == Status::solved);
  CHECK(hold.holds);
}

TEST_CASE("[T.10] pushes that are all far stronger than the load prove no fall") {
  desktop::SceneFile file =
      desktop::parse_scene(in_pyramids(scene_text("straight_slide_point.toml")), "test.toml");
  for (Actuator<double>& actuator : file.actuators) actuator.force *= 1e5;
  desktop::Push push(file);
  const desktop::BreakReport broken = push.find_breaking(2, {});
  // The extrapolated motion looks like a fall, but statics could hold it.
  CHECK(broken.breaking.rest.norm() > 1);
  CHECK(broken.status == Status::solved);
}

TEST_CASE("[T.10] the hand before a push is at rest and has no pushers") {
  desktop::SceneFile file = fixture("three_finger_hand.toml");
  file.gravity = {0, 0, -9.81};
  file.bodies[1].acceleration[0] = 0.3;
  file.actuators.insert(file.actuators.begin(), {5, 0}); // of the plate alone
  file.actuator_names.insert(file.actuator_names.begin(), "lift");
  for (Drive<double>& drive : file.drives) ++drive.actuator;
  Vector6<double> up = Vector6<double>::Zero();
  up[2] = 1;
  file.drives.push_back({3, 0, up});
  const desktop::SceneFile hand = desktop::hand_at_rest(file);
  REQUIRE(hand.bodies.size() == 3);
  CHECK(hand.points.size() == 3);
  CHECK(hand.positions.size() == 3);
  CHECK(hand.actuator_names == std::vector<std::string>{"tendon", "motor"});
  REQUIRE(hand.drives.size() == 3);
  CHECK(hand.drives[0].actuator == 0);
  CHECK(hand.drives[2].actuator == 1);
  for (const Body<double>& body : hand.bodies) CHECK(body.acceleration.isZero(0));
  const desktop::HoldReport whole = desktop::Push(file).holds_without_push({}),
                            alone = desktop::Push(hand).holds_without_push({});
  CHECK(whole.status == alone.status);
  CHECK(whole.holds);
  CHECK(alone.holds);
  CHECK(whole.acceleration == alone.acceleration); // bit by bit
}

TEST_CASE("[T.12] the force spoken of is per finger for jaws that are parallel, not for a name") {
  const std::string parallel = "[gripper]\njaws = \"parallel\"\n";
  const desktop::SceneFile jaws = pinch(0.5, 1, 9.81, Pressure::pad, parallel);
  CHECK(jaws.hand == desktop::Hand::parallel);
  CHECK(pinch(0.5, 1, 9.81, Pressure::pad).hand == desktop::Hand::independent);
  const desktop::GripReport per_finger = grip_of(jaws);
  CHECK(per_finger.of == "per finger");
  CHECK(per_finger.force == Approx(1));
  CHECK_FALSE(per_finger.of_actuator);
  for (const char* const name : {"tendon", "jaws"}) {
    desktop::SceneFile hand = fixture("three_finger_hand.toml");
    hand.actuator_names[0] = name;
    CHECK(hand.hand == desktop::Hand::actuators);
    const desktop::GripReport report = grip_of(hand);
    CHECK(report.force == 24);
    CHECK(report.of_actuator);
    CHECK(report.of == std::string("of actuator ") + name + ", the others in proportion");
    hand.actuators[0] = {0, 0.1}; // the next one that has a force
    CHECK(grip_of(hand).force == 12);
    CHECK(grip_of(hand).of == "of actuator motor");
  }
}

TEST_CASE("[T.12] 'from' is said only where more holds as well") {
  const desktop::GripReport pinched = grip_of(pinch(0.5, 0.001, 9.81, Pressure::pad));
  CHECK(pinched.alone.factor == Approx(9.81));
  CHECK(pinched.alone.more == desktop::MoreGrip::holds);
  desktop::SceneFile below = pinch(0.5, 0.001, 9.81, Pressure::pad);
  for (std::size_t b = 0; b < 2; ++b) {
    below.bodies[b].normal = {0, 1, 0}; // both from below
    below.bodies[b].tangent = {1, 0, 0};
    below.points[b] = {b == 0 ? -0.01 : 0.01, -0.015, 0};
    below.drives[b].twist << 0, 1, 0, 0, 0, 0;
  }
  const desktop::GripReport carried = grip_of(below);
  CHECK(carried.alone.factor == Approx(9.81 / 2));
  CHECK(carried.alone.more == desktop::MoreGrip::drops);
  CHECK(carried.at_rest.more == desktop::MoreGrip::drops);
  const desktop::GripReport holds = grip_of(pinch(0.5, 1, 9.81, Pressure::pad));
  CHECK(holds.alone.more == desktop::MoreGrip::not_known);
}

TEST_CASE("an answer that took long stands without what was to be searched for beside it") {
  desktop::PushOptions late;
  late.stop = [](double part) {
    CHECK(part < 1); // the rest of the time is for writing it
    return desktop::Stop::time;
  };
  const desktop::SceneFile file = fixture("straight_slide.toml");
  desktop::Push push(file);
  const desktop::HoldReport hold = push.holds_without_push(late);
  const desktop::PushReport solved = push.solve(late);
  CHECK(solved.status == Status::solved);
  CHECK(solved.paths_compared == 0);
  CHECK(push.solve({}).paths_compared > 0);
  const desktop::BreakReport broken =
      push.find_breaking(static_cast<Index>(file.bodies.size()) - 1, late);
  CHECK(broken.status == Status::solved);
  CHECK(broken.unique_force == Uniqueness::not_tested);
  const desktop::GripReport grip = desktop::find_smallest_grip(file, hold, broken, late);
  CHECK(grip.alone.source == desktop::GripSource::not_known);
  CHECK(grip.alone.bound == Approx(1.962 / 20).epsilon(1e-6)); // m g / (2 mu)
}
