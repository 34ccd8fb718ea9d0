// A small load beside a large one: it is answered, or the answer says that it cannot be told; it is
// never lost in a residual that the large one makes small.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/report.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <string>

using namespace lcpush;
using namespace lcpush::test;
using doctest::Approx;

namespace {

struct Hand {
  double squeeze = 1e6, grip = 3e-4;
  bool actuators = false;
  std::string pressure = "pad";
};

/// A cube of 0.1 g: two smooth fingers squeeze it along x, two rough ones grip it along y; a rod
/// lifts it.
desktop::SceneFile cube(const Hand& hand, double lift = 1) {
  std::string text = "gravity = [0, 0, -9.81]\npressure = \"" + hand.pressure +
                     "\"\n[object]\nmass = 1e-4\nbox = [0.01, 0.01, 0.01]\n";
  if (!hand.actuators) text += "[gripper]\njaws = \"independent\"\n";
  std::string actuators;
  const auto finger = [&](const std::string& name, const std::string& center,
                          const std::string& normal, const std::string& friction, double force) {
    text += "[[finger]]\nname = \"" + name + "\"\nshape = \"point\"\ncenter = [" + center +
            "]\nnormal = [" + normal + "]\nfriction = " + friction + "\n";
    const std::string value = std::to_string(force * 1e9) + "e-9\n";
    if (hand.actuators)
      actuators += "[[actuator]]\nname = \"m_" + name + "\"\nbodies = [\"" + name +
                   "\"]\ntwists = [[" + normal + ", 0, 0, 0]]\nforce = " + value;
    else
      text += "grip_force = " + value;
  };
  finger("right", "0.005, 0, 0", "-1, 0, 0", "0", hand.squeeze);
  finger("left", "-0.005, 0, 0", "1, 0, 0", "0", hand.squeeze);
  finger("front", "0, -0.005, 0", "0, 1, 0", "0.5", hand.grip);
  finger("back", "0, 0.005, 0", "0, -1, 0", "0.5", hand.grip);
  text += actuators;
  if (lift > 0)
    text += "[[pusher]]\nname = \"rod\"\nshape = \"point\"\ncenter = [0, 0, -0.005]\n"
            "normal = [0, 0, 1]\nfriction = 0\nacceleration = [0, 0, " +
            std::to_string(lift) + "]\n";
  return desktop::parse_scene(text, "cube.toml");
}

constexpr desktop::Solver solvers[] = {desktop::Solver::lemke, desktop::Solver::hybrid,
                                       desktop::Solver::gauss_seidel};

/// Solved, then with the small grip's friction and the push it takes; or it says that it cannot.
void check_small_grip(const desktop::SceneFile& file, const Hand& hand, desktop::Solver solver) {
  desktop::PushOptions options;
  options.solver = solver;
  desktop::Push push(file); // the report's answer is its memory
  const desktop::PushReport report = push.solve(options);
  CAPTURE(report.reason);
  if (report.status != Status::solved) {
    CHECK(solver != desktop::Solver::lemke);
    CHECK(!report.reason.empty());
    return;
  }
  CHECK(report.answer.contacts[2].normal_force == Approx(hand.grip).epsilon(1e-4));
  CHECK(report.answer.contacts[2].friction_force[2] == Approx(-hand.grip / 2).epsilon(1e-4));
  CHECK(report.answer.contacts[4].normal_force ==
        Approx(1e-4 * (9.81 + 1) + hand.grip).epsilon(1e-4));
}

} // namespace

TEST_CASE("a grip of 0.0003 N beside one of 1e6 N is answered by every solver that ends") {
  for (const Hand& hand : {Hand{}, Hand{1e6, 3e-4, true}, Hand{1e6, 3e-4, false, "rigid"},
                           Hand{1e5, 1e-4, false, "pad"}, Hand{1e3, 1, true, "rigid"}})
    for (const desktop::Solver solver : solvers) {
      CAPTURE(hand.squeeze);
      CAPTURE(hand.actuators);
      CAPTURE(static_cast<int>(solver));
      check_small_grip(cube(hand), hand, solver);
    }
}

// 1e-6 is what verify allows, a thousand times what an answer called solved may be off by.
TEST_CASE("an answer without the small grip's force is refused beside any other force") {
  const desktop::SceneFile file = cube({});
  desktop::Push push(file);
  desktop::PushReport report = push.solve({});
  REQUIRE(report.status == Status::solved);
  const double passes = Tolerances<double>().residual;
  REQUIRE(report.residuals.max() <= passes);
  for (const Index finger : {2, 3}) report.answer.contacts[finger].normal_force = 0;
  const Residuals<double> residuals = check(push.scene(), report.scales, report.answer, 1.0);
  CHECK(residuals.grip > 1e-6);
  CHECK(residuals.cone > 1e-6);
}

// However large a force the scene speaks of, what an actuator must hold is not lost in its
// rounding.
TEST_CASE("an actuator whose force is missing is told, and it alone") {
  for (const bool actuators : {false, true})
    for (const double largest : {1e6, 1e15, 1e30}) {
      const desktop::SceneFile file = cube({1e6, 3e-4, actuators});
      desktop::Push push(file);
      desktop::PushReport report = push.solve({});
      REQUIRE(report.status == Status::solved);
      Scales<double> scales = report.scales;
      scales.force = largest;
      for (Index lost = 0; lost < 4; ++lost) {
        CAPTURE(largest);
        double& force = report.answer.contacts[lost].normal_force;
        const double held = force;
        force = 0;
        std::vector<Index> told;
        check_rows(push.scene(), scales, report.answer, 1.0, [&](const Violation<double>& row) {
          if (row.law == Law::grip && std::abs(row.scaled) > 1e-6) told.push_back(row.of);
        });
        CHECK(told == std::vector<Index>{lost});
        force = held;
      }
      CHECK(check(push.scene(), scales, report.answer, 1.0).grip <= Tolerances<double>().residual);
      report.answer.acceleration[2] += 1; // "it weighs less"
      CHECK(check(push.scene(), scales, report.answer, 1.0).newton > 1e-6);
    }
}

TEST_CASE("the weight of a small object is a load that a large grip does not hide") {
  const desktop::SceneFile file = cube({}, 0);
  desktop::Push push(file);
  desktop::PushReport report = push.solve({});
  REQUIRE(report.status == Status::solved);
  CHECK(report.answer.acceleration[2] == Approx(-9.81 + 3).epsilon(1e-6));
  report.answer.acceleration[2] = 0; // "it does not move"
  for (ContactAnswer<double>& contact : report.answer.contacts) contact.acceleration.setZero();
  CHECK(check(push.scene(), report.scales, report.answer, 1.0).newton > 1e-6);
}

TEST_CASE("beside 1e8 N a load is shown; where it cannot be told, every solver says so") {
  for (const double squeeze : {1e8, 1e10, 1e12})
    for (const desktop::Solver solver : solvers) {
      // At 1e12 N the push stands out, the small grip does not.
      const desktop::SceneFile file = cube({squeeze}, squeeze < 1e12 ? 1 : 1e10);
      desktop::PushOptions options;
      options.solver = solver;
      desktop::Push push(file);
      const desktop::PushReport report = push.solve(options);
      CAPTURE(squeeze);
      CAPTURE(report.reason);
      const std::string text = desktop::solve_text(file, {}, report, desktop::Telling::brief);
      CAPTURE(text);
      if (squeeze == 1e8) {
        CHECK(report.status == Status::solved);
        CHECK(text.find("0.0003     0.00015     -z") != std::string::npos);
        CHECK(text.find("sticks   0.00138") != std::string::npos);
        continue;
      }
      CHECK(report.status == Status::numerical_breakdown);
      CHECK(report.reason.find(squeeze < 1e12 ? "too slow beside the grip" : "holds 3e-04, ") !=
            std::string::npos);
    }
}
