// The set of answers: analytic sets, other covers' answers, mirrors, and what must not be claimed.
#include "support/fixture_push.hpp"

#include <cmath>

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/spread.hpp"
#include "support/grasp_families.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Enumeration;
using desktop::Interval;
using desktop::SpreadReport;
using desktop::SpreadVerdict;

namespace {

SpreadReport spread_of(const std::string& text, Enumeration enumeration = Enumeration::none) {
  const desktop::SceneFile file = desktop::parse_scene(text, "test.toml");
  desktop::SpreadOptions options;
  options.enumeration = enumeration;
  return desktop::find_spread(file, options);
}

void check_interval(const Interval& interval, double low, double high, double unit) {
  CHECK(std::abs(interval.low - low) <= 1e-7 * unit);
  CHECK(std::abs(interval.high - high) <= 1e-7 * unit);
}

bool contains(const Interval& interval, double x, double slack) {
  return x >= interval.low - slack && x <= interval.high + slack;
}

// Two frictional fingers on one line through the centre, a frictionless rod through it: 2 mu F + m
// a.
const std::string point_fingers =
    table("", "facets = 4") + table("[object]", "mass = 0.2; box = [0.1, 0.03, 0.01]") +
    finger("left", "point",
           "center = [0, 0, 0.005]; normal = [0, 0, -1]; friction = 0.5; grip_force = 10") +
    finger("right", "point",
           "center = [0, 0, -0.005]; normal = [0, 0, 1]; friction = 0.5; grip_force = 10") +
    pusher("rod", "point",
           "center = [-0.05, 0, 0]; normal = [1, 0, 0]; friction = 0; acceleration = [0.1, 0, 0]");

// theory 8: a cylinder on a sheet, planar and with single points; mu_s (1 + mu_f) > 1 and
// m g <= 2 mu_f F < T*: turning and held are both answers.
std::string bistable(double grip) {
  return bistable_push("mass = 0.3; cylinder_length = 0.02", 0.02,
                       "friction = 0.3; grip_force = " + std::to_string(grip),
                       "friction = 0.8; acceleration = [0.2, 0, 0]");
}

} // namespace

TEST_CASE("[T.15] point fingers and a frictionless rod: one answer, by enumeration too") {
  for (const Enumeration enumeration : {Enumeration::none, Enumeration::if_small}) {
    const SpreadReport report = spread_of(point_fingers, enumeration);
    REQUIRE(report.status == Status::solved);
    CHECK(report.verdict == SpreadVerdict::unique);
    CHECK(report.failures == 0);
    CHECK(report.complete == (enumeration == Enumeration::if_small));
    check_interval(report.pushers[0].force, 10.02, 10.02, 1);
    check_interval(report.twist[0], 0.1, 0.1, 1);
    check_interval(report.contacts[0].normal, 10, 10, 1);
  }
}

TEST_CASE(
    "[T.15] four-point patches leave the push of a straight slide open, from 2 mu F + m a down") {
  // With the force of a finger on one of its points the weight's moment decides how much of the
  // friction goes against the push; with even pressure all of it does.
  std::string text =
      in_pyramids(with(scene_text("straight_slide.toml"), "grip_force = 20", "grip_force = 10"));
  text = with(text, "along = \"y\"", "along = \"y\"\nlength = \"20 mm\"");
  const SpreadReport report = spread_of(text);
  REQUIRE(report.status == Status::solved);
  CHECK(report.failures == 0);
  CHECK(report.faces_left == 0);
  CHECK(report.verdict == SpreadVerdict::ambiguous);
  const Interval push = report.pushers[0].force;
  CHECK(push.high >= 10.02 - 1e-6); // more where the bar turns: its middle is faster then
  CHECK(push.high < 10.03);
  CHECK(push.low < 9.8);
  CHECK(report.residual <= 1e-9);
  // Answers of covers that took no part lie within, and several differ.
  const desktop::SceneFile file =
      desktop::parse_scene(with(text, "\ntitle", "\npressure = \"rigid\"\ntitle"), "test.toml");
  desktop::Push solver(file);
  Interval reached;
  for (Index cover = 0; cover < 60; ++cover) {
    desktop::PushOptions options;
    options.other_paths = 0;
    options.study_existence = false;
    options.lemke.first_cover = 1000 + 10 * cover;
    const desktop::PushReport answer = solver.solve(options);
    REQUIRE(answer.status == Status::solved);
    reached.include(normal_sum(answer.answer, file.bodies.back()));
  }
  CHECK(reached.low >= push.low - 1e-6);
  CHECK(reached.high <= push.high + 1e-6);
  CHECK(reached.width() > 0.05);
}

TEST_CASE("[T.15] the vise: every squeeze from none to without end, held and falling") {
  const SpreadReport report = spread_of(scene_text("vise.toml"), Enumeration::thorough);
  REQUIRE(report.status == Status::solved);
  CHECK(report.complete);
  CHECK(report.verdict == SpreadVerdict::ambiguous);
  check_interval(report.twist[1], -9.81, 0, 1);
  for (const desktop::ContactSpread& contact : report.contacts) {
    CHECK(contact.normal.low == doctest::Approx(0));
    CHECK(std::isinf(contact.normal.high));
    check_interval(contact.tangential[0], 0, 0.2 * 9.81 / 2, 1); // by symmetry half the weight each
  }
}

TEST_CASE("[T.15] steps to neighbouring faces find the held block, which no cover's pivots do") {
  const SpreadReport report = spread_of(scene_text("vise.toml"));
  CHECK_FALSE(report.complete);
  CHECK(report.verdict == SpreadVerdict::ambiguous);
  check_interval(report.twist[1], -9.81, 0, 1);
  CHECK(std::isinf(report.contacts[0].normal.high));
}

TEST_CASE(
    "[T.15] a bistable cylinder: rolling and held are found, as theory 8 says, and all else") {
  constexpr double weight = 0.3 * 9.81;
  const double most = 0.8 * weight / (1 - 0.24); // T*, in units of 2 mu_f F
  const double between = (weight + most) / 2 / 0.6;
  const SpreadReport report = spread_of(bistable(between), Enumeration::thorough);
  REQUIRE(report.status == Status::solved);
  CHECK(report.complete);
  CHECK(report.verdict == SpreadVerdict::ambiguous);
  CHECK(report.twist[5].low == doctest::Approx(0));
  CHECK(report.twist[5].high > 1);
  const SpreadReport turning = spread_of(bistable(0.9 * weight / 0.6), Enumeration::thorough);
  CHECK(turning.complete);
  CHECK(turning.twist[5].low > 1);
  CHECK(turning.twist[5].width() <= 1e-6);
}

TEST_CASE("[T.15] a jam: nothing is reached, and enumeration proves that there is nothing") {
  const SpreadReport report =
      spread_of(scene_text("coin_jammed.toml", "rays"), Enumeration::thorough);
  CHECK(report.status == Status::ray);
  CHECK(report.complete);
  CHECK(report.faces == 0);
  CHECK_FALSE(report.failure.jam.bodies.empty());
  const SpreadReport reached = spread_of(scene_text("jam.toml"));
  CHECK(reached.status == Status::ray);
  CHECK_FALSE(reached.complete);
}

TEST_CASE("[T.15] soft contacts and many points are not enumerated, and it says why") {
  CHECK_FALSE(spread_of(scene_text("soft_fingers.toml"), Enumeration::thorough).complete);
  CHECK(
      spread_of(scene_text("soft_fingers.toml"), Enumeration::thorough).enumeration.find("soft") !=
      std::string::npos);
}

TEST_CASE("[T.15] random grasps: every other cover's answer lies within the intervals") {
  Index outside = 0, answers = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    OwnedScene<double> scene = random_grasp<double>(seed);
    scene.base.pressure = Pressure::rigid;
    scene.base.facets = 4;
    const desktop::SceneFile file = file_of(scene);
    desktop::SpreadOptions options;
    options.enumeration = Enumeration::none;
    options.most_faces = 60;
    const SpreadReport report = desktop::find_spread(file, options);
    REQUIRE(report.status == Status::solved);
    CHECK(report.residual <= 1e-9);
    desktop::Push push(file);
    for (Index cover = 0; cover < 12; ++cover) {
      desktop::PushOptions other;
      other.other_paths = 0;
      other.study_existence = false;
      other.lemke.first_cover = 1000 + 10 * cover;
      const desktop::PushReport answer = push.solve(other);
      if (answer.status != Status::solved) continue;
      ++answers;
      const double force = 1e-6 * answer.scales.force;
      bool inside = true;
      for (Index i = 0; i < answer.answer.contacts.size; ++i)
        inside = inside && contains(report.contacts[static_cast<std::size_t>(i)].normal,
                                    answer.answer.contacts[i].normal_force, force);
      for (Index k = 0; k < 6; ++k)
        inside = inside && contains(report.twist[k], answer.answer.acceleration[k],
                                    1e-6 * report.motion / (k < 3 ? 1 : report.scales.length));
      if (!inside) ++outside;
    }
  }
  MESSAGE(outside << " of " << answers << " answers lie outside");
  CHECK(answers > 100);
  // Faces that no cover and no step reached may hold a few.
  CHECK(outside * 50 <= answers);
}

TEST_CASE("[T.15] the set is about the literal laws whatever law the file names") {
  const std::string text = scene_text("straight_slide_point.toml");
  const SpreadReport pad = spread_of(text);
  const SpreadReport rigid = spread_of(with(text, "\ntitle", "\npressure = \"rigid\"\ntitle"));
  CHECK(pad.pushers[0].force.low == rigid.pushers[0].force.low);
  CHECK(pad.pushers[0].force.high == rigid.pushers[0].force.high);
  // The pad's answer is one of them.
  Pushed pushed(text);
  CHECK(contains(pad.pushers[0].force, pushed.normal_of("wall"), 1e-6));
}

TEST_CASE("[T.15] same input, same bits; a limit of faces is reported, not hidden") {
  const desktop::SceneFile file = desktop::parse_scene(scene_text("pivot.toml"), "test.toml");
  desktop::SpreadOptions options;
  options.enumeration = Enumeration::none;
  options.most_faces = 20;
  const SpreadReport one = desktop::find_spread(file, options),
                     two = desktop::find_spread(file, options);
  CHECK(one.faces == 20);
  CHECK(one.faces_left > 0);
  CHECK(one.pushers[0].force.low == two.pushers[0].force.low);
  CHECK(one.pushers[0].force.high == two.pushers[0].force.high);
  CHECK(desktop::spread_text(file, one).find("known but not studied") != std::string::npos);
  CHECK(desktop::spread_text(file, one).find("every solution") == std::string::npos);
}
