// What the reports say about other answers, on scenes where theory knows.
#include "support/fixture_push.hpp"

#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

desktop::PushReport report_of(const std::string& name, const std::string& law = "pad") {
  const desktop::SceneFile file = desktop::parse_scene(
      in_pyramids(with(scene_text(name), "\ntitle", "\npressure = \"" + law + "\"\ntitle")),
      "test.toml");
  desktop::Push push(file);
  desktop::PushReport report = push.solve({});
  REQUIRE(report.status == Status::solved);
  report.answer = {}; // its arrays go with the Push
  return report;
}

} // namespace

TEST_CASE("[T.9] where no contact is between two modes the final basis isolates the answer") {
  for (const char* name : {"straight_slide.toml", "ground.toml", "tipping.toml", "rolling.toml"}) {
    CAPTURE(name);
    const desktop::PushReport report = report_of(name);
    CHECK(report.final_basis.motion_isolated());
    CHECK(report.final_basis.wrench_isolated());
    CHECK(report.unique_motion == Uniqueness::none_other_found);
    CHECK(report.paths_compared == 3);
  }
}

TEST_CASE("[T.9] a held cylinder's push is open within the bounds of theory 8, its motion is not") {
  const desktop::PushReport report = report_of("rolling_hard_grip.toml");
  CHECK(report.final_basis.wrench_open);
  CHECK_FALSE(report.final_basis.motion_open);
  CHECK(report.unique_wrench == Uniqueness::no);
  CHECK(report.unique_motion == Uniqueness::none_other_found);
}

TEST_CASE("[T.9] under rigid a patch's open pressure shows as tied contacts or other answers") {
  for (const char* name : {"pivot.toml", "two_pushers.toml"}) {
    CAPTURE(name);
    const desktop::PushReport report = report_of(name, "rigid");
    CHECK(report.unique_motion == Uniqueness::no);
    CHECK(report.final_basis.tied_contacts > 0);
  }
}

TEST_CASE("[T.9] proved motions are called proved, and the final basis never contradicts a proof") {
  const std::string text = with(scene_text("soft_fingers.toml"), "[object]",
                                "[gripper]\njaws = \"independent\"\n\n[object]");
  CHECK(Pushed(text).report.unique_motion == Uniqueness::yes);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    SolvedPush<double> push(determined_grasp(seed));
    REQUIRE(push.solve() == Status::solved);
    const desktop::FinalBasis basis = desktop::study_final_basis(push.assembly, push.answer());
    CHECK(basis.studied);
    CHECK_FALSE(basis.motion_open);
  }
}

TEST_CASE("[T.9] a thousand points are studied as few are") {
  for (const char* points : {"20", "500"}) {
    CAPTURE(points);
    for (const bool slips : {false, true}) {
      const std::string body = "shape = \"disc\"\nradius = 0.01\npoints = " + std::string(points) +
                               "\ngrip_force = 20\nfriction = " + (slips ? "0.01" : "0.5");
      const Pushed push(
          "facets = 8\npressure = \"pad\"\ngravity = [0, -9.81, 0]\n"
          "[object]\nmass = 0.2\nbox = [0.1, 0.1, 0.05]\n"
          "[[finger]]\nname = \"left\"\ncenter = [-0.05, 0, 0]\nnormal = [1, 0, 0]\n" +
          body + "\n[[finger]]\nname = \"right\"\ncenter = [0.05, 0, 0]\nnormal = [-1, 0, 0]\n" +
          body + "\n");
      REQUIRE(push.report.status == Status::solved);
      const desktop::FinalBasis& basis = push.report.final_basis;
      CHECK(basis.studied);
      CHECK_FALSE(basis.motion_open);
    }
  }
}

TEST_CASE("[T.9] the vise: found falling, called neither unique nor isolated") {
  const desktop::PushReport report = report_of("vise.toml");
  CHECK(report.unique_motion != Uniqueness::yes);
  CHECK_FALSE(report.final_basis.motion_isolated());
}

TEST_CASE("[T.9] pads that leave a push open say so, in the scene and in its mirror image") {
  for (const std::string side : {"", "-"}) {
    CAPTURE(side);
    const std::string pad = ", \"0 mm\", \"30 mm\"], [",
                      end = ", \"" + side + "20 mm\", \"30 mm\"]]";
    const std::string grips = "; friction = 0.7; grip_force = \"80 N\"; normal = ";
    const Pushed push(
        table("", "gravity = [0, 0, 9.81]") +
        table("[object]", "mass = \"500 g\"; box = \"50 x 60 x 140 mm\"") +
        finger("left", "line",
               "ends = [[\"25 mm\"" + pad + "\"25 mm\"" + end + grips + "[-1, 0, 0]") +
        finger("right", "line",
               "ends = [[\"-25 mm\"" + pad + "\"-25 mm\"" + end + grips + "[1, 0, 0]") +
        pusher("tip", "point",
               "center = [\"5 mm\", \"" + std::string(side.empty() ? "-" : "") +
                   "20 mm\", \"70 mm\"]; normal = [0, 0, -1]; friction = 0.6; acceleration = [0, " +
                   std::string(side.empty() ? "-" : "") + "0.1, -0.1]"));
    CHECK(push.report.status == Status::solved);
    CHECK(push.report.unique_motion == Uniqueness::no);
    CHECK(push.report.unique_wrench == Uniqueness::no);
  }
}

TEST_CASE("[T.9] what rests where friction does not lift it is told to: a jaw, a wall, a table") {
  // The jaw's friction may lift the box off what the table's friction needs; nothing makes it.
  for (const bool planar : {false, true}) {
    CAPTURE(planar);
    const std::string depth = planar ? "planar = true; " : "";
    const std::string text =
        table("", depth + "gravity = [0, \"-9.81 m/s^2\", 0]") +
        table("[object]",
              "mass = \"500 g\"; box = \"60 x 30 x 40 mm\"; force = [\"30.8 N\", 0, 0]") +
        finger("jaw", "point", "on = \"+x\"; friction = 0.4; grip_force = \"30 N\"") +
        finger("wall", "line", "on = \"-x\"; along = \"y\"; friction = 0.3") +
        finger("table", "line", "on = \"-y\"; along = \"x\"; friction = 0.2");
    const Pushed push(text);
    REQUIRE(push.report.other);
    CHECK(push.report.other->acceleration.isZero(0));
    CHECK(push.report.unique_motion == Uniqueness::no);
    const desktop::SceneFile file = desktop::parse_scene(text, "test.toml");
    CHECK(desktop::Push(file).holds_without_push({}).holds);
    const desktop::SceneFile more = desktop::parse_scene(with(text, "30.8", "31"), "test.toml");
    CHECK_FALSE(desktop::Push(more).holds_without_push({}).holds); // 30 + 0.2 * 4.905 N
  }
}

TEST_CASE(
    "rigid may hold more than pad: a vertex on the line of the push resists with all it has") {
  const std::string bar = table("", "planar = true; facets = 16") +
                          table("[gripper]", "jaws = \"independent\"") +
                          table("[object]", "mass = 0.2; box = [0.1, 0.03, 0.01]") +
                          finger("left", "ring",
                                 "center = [0, 0, 0.005]; radius = 0.005; normal = [0, 0, -1]; "
                                 "friction = 0.5; grip_force = 20") +
                          finger("right", "ring",
                                 "center = [0, 0, -0.005]; radius = 0.005; normal = [0, 0, 1]; "
                                 "friction = 0.5; grip_force = 20") +
                          pusher("rod", "point",
                                 "center = [-0.05, -0.004, 0]; normal = [1, 0, 0]; friction = 0; "
                                 "acceleration = [0.1, 0, 0]");
  const double pad = break_force("pressure = \"pad\"\n" + bar);
  CHECK(pad == doctest::Approx(13.9648).epsilon(1e-5));
  CHECK(break_force("pressure = \"even\"\n" + bar) == doctest::Approx(pad).epsilon(1e-6));
  CHECK(break_force("pressure = \"rigid\"\n" + bar) > 1.2 * pad);
}
