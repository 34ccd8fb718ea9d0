// The set of breaking forces: limits of the sets of finite pushes.
#include "support/fixture_push.hpp"

#include "lcpush/desktop/spread.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Interval;
using desktop::SpreadReport;

namespace {

SpreadReport spread_of(const desktop::SceneFile& file, bool breaking) {
  desktop::SpreadOptions options;
  options.breaking = breaking;
  return desktop::find_spread(file, options);
}

SpreadReport breaking(const std::string& text) {
  return spread_of(desktop::parse_scene(text, "test.toml"), true);
}

/// With all prescribed motions scaled: the fastest point of contact moves at `push` m/s^2.
SpreadReport pushed_by(desktop::SceneFile file, double push) {
  const double scale = push / push_size(file.view());
  for (Body<double>& body : file.bodies) body.acceleration *= scale;
  return spread_of(file, false);
}

/// How far apart; both without end is no difference.
double distance(const Interval& one, const Interval& two) {
  const auto apart = [](double a, double b) { return a == b ? 0.0 : std::abs(a - b); };
  return std::max(apart(one.low, two.low), apart(one.high, two.high));
}

/// Of all forces.
double distance(const SpreadReport& one, const SpreadReport& two) {
  double most = distance(one.pushers[0].force, two.pushers[0].force);
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    most = std::max(most, distance(one.contacts[i].normal, two.contacts[i].normal));
    for (const int k : {0, 1})
      most = std::max(most, distance(one.contacts[i].tangential[k], two.contacts[i].tangential[k]));
  }
  return most;
}

const std::string rolled_or_held =
    bistable_push("mass = 0.8; cylinder_length = 0.06", 0.03, "friction = 0.25; grip_force = 17.5",
                  "friction = 0.9; acceleration = [0.06, 0, 0]");

} // namespace

TEST_CASE("[T.15] three contacts, rolling or held: all of it without being asked to enumerate") {
  const SpreadReport report = spread_of(desktop::parse_scene(rolled_or_held, "test.toml"), false);
  REQUIRE(report.status == Status::solved);
  CHECK(report.complete);
  CHECK(report.verdict == desktop::SpreadVerdict::ambiguous);
  // Rolling, theory 8: N = m g + mu_f T with T = 2 mu_f F + I a / R^2; held, down to no force.
  const double T = 2 * 0.25 * 17.5 + 0.5 * 0.8 * 0.06;
  CHECK(report.pushers[0].force.low == doctest::Approx(0));
  CHECK(report.pushers[0].force.high == doctest::Approx(0.8 * 9.81 + 0.25 * T));
  CHECK(report.twist[5].low == doctest::Approx(0));
  CHECK(report.twist[5].high == doctest::Approx(0.06 / 0.03));
}

TEST_CASE("[T.15] breaking: rolling and held, with the twist per unit push") {
  const SpreadReport report = breaking(rolled_or_held);
  REQUIRE(report.status == Status::solved);
  CHECK(report.complete);
  CHECK_FALSE(report.falls);
  CHECK(report.pushers[0].force.low == doctest::Approx(0));
  CHECK(report.pushers[0].force.high == doctest::Approx(0.8 * 9.81 + 0.25 * 2 * 0.25 * 17.5));
  CHECK(report.twist[5].low == doctest::Approx(0));
  CHECK(report.twist[5].high == doctest::Approx(1 / 0.03));
  CHECK(report.twist[0].high == doctest::Approx(0));
}

TEST_CASE("[T.15] the breaking set is the limit of the sets of smaller and smaller pushes") {
  for (const char* name : {"coin.toml", "lever.toml", "squeeze.toml", "tipping.toml",
                           "rolling.toml", "rolling_hard_grip.toml", "rolling_low_friction.toml",
                           "rolling_two_answers.toml", "three_finger_hand.toml"}) {
    CAPTURE(name);
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), "test.toml");
    const SpreadReport limit = spread_of(file, true);
    REQUIRE(limit.status == Status::solved);
    REQUIRE(limit.complete);
    double before = 0;
    for (const double share : {1e-2, 1e-4, 1e-6}) { // of F / m
      CAPTURE(share);
      const double push = share * limit.scales.acceleration;
      const SpreadReport finite = pushed_by(file, push);
      REQUIRE(finite.complete);
      // Forces differ by what a push of that size adds, so the difference falls with it.
      const double apart = distance(limit, finite);
      if (share < 1e-2) CHECK(apart <= before / 50 + 1e-9 * limit.scales.force);
      before = apart;
      if (share > 1e-3) continue; // modes may differ from those of the limit
      for (Index k = 0; k < 6; ++k) {
        Interval twist = finite.twist[k];
        twist.low /= push;
        twist.high /= push;
        CHECK(distance(limit.twist[k], twist) <= 1e-3 * std::max(1.0, std::abs(twist.high)));
      }
    }
  }
}

TEST_CASE("[T.15] the set holds what break finds, and a grasp that falls has none") {
  for (const char* name : {"pivot.toml", "ground.toml", "soft_fingers.toml"}) {
    CAPTURE(name);
    const desktop::SceneFile file = desktop::parse_scene(scene_text(name), "test.toml");
    const SpreadReport report = spread_of(file, true);
    REQUIRE(report.status == Status::solved);
    const Index pusher = static_cast<Index>(file.bodies.size()) - 1;
    const desktop::BreakReport found = desktop::Push(file).find_breaking(pusher, {});
    CHECK(found.breaking.break_force >= report.pushers[0].force.low - 1e-3);
    CHECK(found.breaking.break_force <= report.pushers[0].force.high + 1e-3);
    for (const desktop::OtherBreak& other : found.others) {
      CHECK(other.break_force >= report.pushers[0].force.low - 1e-3);
      CHECK(other.break_force <= report.pushers[0].force.high + 1e-3);
    }
  }
  CHECK(breaking(scene_text("dropped.toml")).status == Status::does_not_hold);
}
