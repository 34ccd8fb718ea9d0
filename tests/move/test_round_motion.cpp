// Motion under round friction.
#include "lcpush/desktop/move.hpp"
#include "support/fixture_push.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

constexpr double speed = 1e-4, way = 0.01; // m/s: slow, so that inertia is nothing; m
constexpr double radius = 0.01;            // m, the fingers' torsion radius

/// A plate that soft fingers ride on, and a tip that sticks to its side and pushes it off its axis.
SceneFile pushed_plate(const std::string& facets) {
  return parse_scene("facets = " + facets + "\n" + test::scene_text("../canonical/point_push.toml"),
                     "s.toml", Strokes::all);
}

MotionReport moved_plate(const std::string& facets, MoveOptions options) {
  options.time = way / speed;
  MotionReport report = move(pushed_plate(facets), options);
  REQUIRE(report.status == Status::solved);
  return report;
}

double turn_of(const MotionReport& report) {
  const Matrix3<double>& R = report.frames.back().pose.rotation;
  return std::abs(std::atan2(R(1, 0), R(0, 0)));
}

double turned(const std::string& facets, int steps) {
  MoveOptions options;
  options.step = way / speed / steps;
  return turn_of(moved_plate(facets, options));
}

/// By the closed form.
double exact_turn() {
  const double x = 0.005, y = 0.015; // from the tip to the middle
  const double rho = std::hypot(x, y), begin = std::atan2(x, y);
  const double grown = std::exp(rho * way / (radius * radius + rho * rho));
  return 2 * std::atan(std::tan(begin / 2) * grown) - begin;
}

} // namespace

TEST_CASE(
    "[T.16] a point push on soft fingers: tan(theta / 2) grows as exp(rho s / (c^2 + rho^2))") {
  const double exact = exact_turn();
  const double coarse = turned("\"round\"", 100) - exact, fine = turned("\"round\"", 200) - exact;
  CHECK(std::abs(fine) < 1e-2 * exact);
  CHECK(coarse / fine > 1.9);
  CHECK(coarse / fine < 2.1);
  // What eight facets make of it.
  CHECK(std::abs(turned("8", 200) - exact) > 10 * std::abs(fine));
}

TEST_CASE("[T.13] steps that a motion chooses are of second order") {
  MoveOptions options;
  options.tolerance = 2e-6; // m
  const MotionReport chosen = moved_plate("\"round\"", options);
  const double off = std::abs(turn_of(chosen) - exact_turn());
  CHECK(off * 0.05 < 2e-6); // of the corners, m
  const double of_first_order =
      std::abs(turned("\"round\"", static_cast<int>(chosen.steps)) - exact_turn());
  CHECK(off < of_first_order / 100);
}

TEST_CASE("friction settles over the present points alone, after others have left their faces") {
  // Two of three points of either finger run off the plate at 0.95 s.
  const std::string text = test::scene_text("straight_slide_point.toml");
  MoveOptions options;
  options.time = 1;
  options.step = 0.002;
  const MotionReport report =
      move(parse_scene("facets = \"round\"\n" + text, "s.toml", Strokes::all), options);
  CHECK(report.status == Status::solved);
  REQUIRE(report.end == MoveEnd::time);
  Index beside = 0;
  for (const PointState& contact : report.frames.back().contacts)
    beside += contact.touch == Touch::beside ? 1 : 0;
  CHECK(beside > 0);
}
