// Parallel, independent and locked hands; an applied wrench; pushes that break nothing.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/report.hpp"
#include "lcpush/desktop/varied_scene.hpp"

using namespace lcpush;
using namespace lcpush::test;
using doctest::Approx;

namespace {

std::string disc(const std::string& name, int side, const std::string& force = "20") {
  const std::string z = side > 0 ? "0.005" : "-0.005", inward = side > 0 ? "-1" : "1";
  return finger(name, "disc",
                "center = [0, 0, " + z + "]; radius = 0.005; normal = [0, 0, " + inward +
                    "]; friction = 0.5; grip_force = " + force);
}

std::string rod(const std::string& center, const std::string& normal, const std::string& motion) {
  return pusher("rod", "point",
                "center = " + center + "; normal = " + normal +
                    "; friction = 0; acceleration = " + motion);
}
const std::string along_x = rod("[-0.05, 0, 0]", "[1, 0, 0]", "[0.1, 0, 0]");
const std::string along_z = rod("[0.03, 0, -0.005]", "[0, 0, 1]", "[0, 0, 0.1]");

/// A box of 0.2 kg, 100 mm x 30 mm x 10 mm, between two discs of 20 N with normals along z.
std::string box_text(const std::string& gripper, const std::string& push,
                     const std::string& load = "") {
  return "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n" + load +
         (gripper.empty() ? "" : "[gripper]\njaws = \"" + gripper + "\"\n") + disc("left", 1) +
         disc("right", -1) + push;
}
desktop::SceneFile box(const std::string& gripper, const std::string& push,
                       const std::string& load = "") {
  return desktop::parse_scene(box_text(gripper, push, load), "box.toml");
}

struct Solved {
  desktop::SceneFile file;
  desktop::Push push{file};
  explicit Solved(desktop::SceneFile given) : file(std::move(given)) {}

  desktop::PushReport report() { return push.solve({}); }
  desktop::BreakReport broken() {
    return push.find_breaking(static_cast<Index>(file.bodies.size()) - 1, {});
  }
  double normal_of(Index body) {
    return normal_sum(report().answer, file.bodies[static_cast<std::size_t>(body)]);
  }
};

} // namespace

TEST_CASE("two equal opposed fingers are a parallel jaw unless the scene says otherwise") {
  CHECK(box("", along_x).hand == desktop::Hand::parallel);
  CHECK(box("parallel", along_x).hand == desktop::Hand::parallel);
  CHECK(box("independent", along_x).hand == desktop::Hand::independent);
  CHECK(box("locked", along_x).hand == desktop::Hand::locked);
  const std::string object = "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n";
  const auto hand_of = [&](const std::string& text) {
    return desktop::parse_scene(text, "x.toml").hand;
  };
  CHECK(hand_of(object + disc("left", 1) + disc("right", -1, "15")) == desktop::Hand::independent);
  CHECK(hand_of(object + disc("left", 1)) == desktop::Hand::independent);
  CHECK(hand_of("pressure = \"even\"\n" + object + disc("left", 1) + disc("right", -1)) ==
        desktop::Hand::independent);
  CHECK(hand_of(object + along_x) == desktop::Hand::fixed);
}

TEST_CASE("pushed along its normals a hand gives way at 0 N, at 2 F or not at all") {
  Solved independent(box("independent", along_z));
  CHECK(independent.broken().breaking.break_force == Approx(0).epsilon(1e-9));
  Solved parallel(box("", rod("[0, 0.01, -0.005]", "[0, 0, 1]", "[0, 0, 0.1]")));
  const desktop::BreakReport jaw = parallel.broken();
  REQUIRE(jaw.status == Status::solved);
  CHECK(jaw.breaking.break_force > 1); // it tilts about the fingers before it gives way at 40 N
  CHECK(jaw.breaking.break_force <= 40 + 1e-6);
  Solved locked(box("locked", rod("[0, 0, -0.005]", "[0, 0, 1]", "[0, 0, 0.1]")));
  CHECK(locked.report().status == Status::ray);
}

TEST_CASE("locked jaws answer a load from their preload: what one finger gains the other loses") {
  for (const double load : {0.0, 6.0, 30.0, 50.0}) {
    CAPTURE(load);
    const std::string pull = "force = [0, 0, " + std::to_string(load) + "]\n";
    Solved locked(box("locked", "", pull)), parallel(box("", "", pull));
    REQUIRE(locked.report().status == Status::solved);
    const double left = std::max(20 + load / 2, load), right = std::max(20 - load / 2, 0.0);
    CHECK(locked.normal_of(0) == Approx(left).epsilon(1e-6));
    CHECK(locked.normal_of(1) == Approx(right).epsilon(1e-6));
    CHECK(locked.push.holds_without_push({}).holds);
    if (load < 40) CHECK(parallel.normal_of(0) == Approx(left).epsilon(1e-6));
    CHECK(parallel.push.holds_without_push({}).holds == (load < 40));
  }
}

TEST_CASE("locked jaws hold a weight along their plane from the preload that friction asks for") {
  desktop::SceneFile file = box("locked", along_x);
  file.gravity = {0, -9.81, 0};
  Solved locked(file);
  const desktop::HoldReport hold = locked.push.holds_without_push({});
  CHECK(hold.holds);
  const desktop::GripReport grip =
      desktop::find_smallest_grip(locked.file, hold, locked.broken(), {});
  REQUIRE(grip.alone.is_known());
  CHECK(grip.alone.factor * grip.force == Approx(0.2 * 9.81 / 2 / 0.5).epsilon(1e-6));
}

TEST_CASE("a locked hand is refused what it cannot be") {
  const auto refuses = [](const std::string& text, const char* words) {
    CHECK_THROWS_WITH_AS((void)desktop::parse_scene(text, "x.toml"), doctest::Contains(words),
                         desktop::InputError);
  };
  refuses("pressure = \"even\"\n" + box_text("locked", along_x), "no point's even share");
  refuses("pressure = \"rigid\"\n" + box_text("locked", along_x), "under pressure = \"pad\" alone");
  refuses("[object]\nmass = 1\nbox = [0.1, 0.03, 0.01]\n[gripper]\njaws = \"locked\"\n" +
              disc("left", 1) + disc("right", -1, "15"),
          "locked jaws share one grip_force; got 15, but 20");
  refuses("[object]\nmass = 1\nbox = [0.1, 0.03, 0.01]\n[gripper]\njaws = \"locked\"\n" +
              disc("left", 1),
          "locked jaws need exactly two");
}

TEST_CASE("[T.1] an applied force at the centre of mass is a weight, one beside it turns as well") {
  desktop::SceneFile weighed = box("", along_x),
                     pulled = box("", along_x, "force = [0, -1.5, 0]\n");
  weighed.gravity = {0, -7.5, 0};
  Solved a(weighed), b(pulled);
  const desktop::PushReport first = a.report(), second = b.report();
  CHECK((first.answer.acceleration - second.answer.acceleration).norm() <= 1e-12);
  CHECK(second.residuals.max() <= 1e-9);
  const desktop::SceneFile beside =
      box("", along_x, "force = [0, -1.5, 0]\nat = [0.03, 0, 0]\nmoment = [0, 0, 0.1]\n");
  CHECK(beside.object.wrench[5] == Approx(0.1 - 0.045));
  CHECK(beside.object.wrench[1] == -1.5);
  desktop::SceneFile moved = box("", along_x,
                                 "center_of_mass = [0.01, 0, 0]\nforce = [0, -1.5, 0]\n"
                                 "at = [0.03, 0, 0]\n");
  CHECK(moved.object.wrench[5] == Approx(-1.5 * 0.02));
}

TEST_CASE("[T.10] a pusher that moves away or slides along breaks nothing") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid})
    for (const desktop::Solver solver : {desktop::Solver::lemke, desktop::Solver::gauss_seidel}) {
      CAPTURE(static_cast<int>(pressure));
      CAPTURE(static_cast<int>(solver));
      const auto broken = [&](const std::string& motion) {
        desktop::SceneFile file = box("", rod("[-0.05, 0, 0]", "[1, 0, 0]", motion));
        file.pressure = pressure;
        desktop::PushOptions options;
        options.solver = solver;
        desktop::Push push(file);
        const desktop::BreakReport report = push.find_breaking(2, options);
        REQUIRE(report.status == Status::solved);
        return std::pair(report.breaking.breaks, desktop::break_text(file, {}, {}, report));
      };
      CHECK(broken("[0.1, 0, 0]").first);
      CHECK(broken("[0.1, 0.1, 0]").first);
      const auto [away, away_text] = broken("[-0.1, 0, 0]");
      CHECK_FALSE(away);
      CHECK(away_text.find("rod moves away from the box, which does not move") !=
            std::string::npos);
      const auto [along, along_text] = broken("[0, 0.1, 0]");
      CHECK_FALSE(along);
      CHECK(along_text.find("The push does not break the grasp: rod slides along") !=
            std::string::npos);
    }
}
