// The paper's three primitives, as fixtures/scenes has them, held to what their comments say.
#include "support/fixture_push.hpp"

using namespace lcpush;
using namespace lcpush::test;
using doctest::Approx;

TEST_CASE("straight slide: an edge pushes with 2 mu F + m a and the bar does not turn") {
  for (const std::string law : {"pad", "rigid"}) {
    CAPTURE(law);
    const Pushed slide(
        with(scene_text("straight_slide.toml"), "\ntitle", "\npressure = \"" + law + "\"\ntitle"));
    CHECK(slide.normal_of("wall") == Approx(20.02).epsilon(1e-9));
    CHECK(slide.report.motion.kind == MotionKind::slide);
    CHECK(slide.linear(0) == Approx(0.1).epsilon(1e-9));
    for (int k = 0; k < 3; ++k) CHECK(std::abs(slide.angular(k)) < 1e-9);
  }
}

TEST_CASE("straight slide: the edge's two ends carry the weight's moment as a couple") {
  const Pushed slide(scene_text("straight_slide.toml"));
  const Span<ContactAnswer<double>>& contacts = slide.report.answer.contacts;
  const double lower = contacts[8].normal_force, upper = contacts[9].normal_force;
  CHECK((lower - upper) * 0.015 == Approx(0.05 * 0.2 * 9.81).epsilon(1e-9));
}

TEST_CASE("straight slide: a point pusher turns the bar, one way or the other by its height") {
  const std::string level = scene_text("straight_slide_point.toml");
  CHECK(Pushed(level).angular(2) < -0.1);
  CHECK(Pushed(with(level, "center = [-0.05, 0, 0]", "center = [-0.05, -0.006, 0]")).angular(2) >
        0.1);
}

TEST_CASE("straight slide: at one height below the centre a point pusher keeps the bar straight") {
  const Pushed low(scene_text("straight_slide_point_low.toml"));
  CHECK(low.report.motion.kind == MotionKind::slide);
  CHECK(low.normal_of("wall") == Approx(20.02).epsilon(1e-9));
}

TEST_CASE("pivoting: far from the grip the bar turns about an axis through the fingertips") {
  const Pushed pivot(scene_text("pivot.toml"));
  CHECK(pivot.report.motion.kind == MotionKind::pivot);
  CHECK(pivot.angular(2) < 0);
}

TEST_CASE("pivoting: the push falls with the distance, and slip gives way to rotation") {
  const std::string text = scene_text("pivot.toml");
  double last_force = 1e9, last_slip = 1e9, first_slip = 0;
  for (const std::string distance : {"-0.005", "-0.01", "-0.02", "-0.03", "-0.04", "-0.05"}) {
    CAPTURE(distance);
    const std::string scene = with(text, "-0.04,", distance + ",");
    const double force = break_force(scene);
    CHECK(force < last_force);
    last_force = force;
    const Pushed pushed(scene);
    const double slip = std::abs(pushed.linear(1)) / std::abs(pushed.angular(2));
    // A pyramid's instantaneous centre may stay where it is while the distance grows.
    CHECK(slip <= last_slip * (1 + 1e-9));
    last_slip = slip;
    if (first_slip == 0) first_slip = slip;
  }
  CHECK(last_slip < first_slip / 2);
}

TEST_CASE(
    "pivoting: a frictionless push balances the patches' largest torque about its own centre") {
  // Every patch point slips about the instantaneous centre, so the push does exactly the work that
  // friction takes: N v_push = sum_i mu lambda_i |v_i|_g, with |.|_g the largest of the pyramid's
  // generators along the slip.
  const Pushed pivot(with(scene_text("pivot.toml"), "friction = 0.3", "friction = 0"));
  double friction_power = 0;
  for (Index i = 0; i < 8; ++i) {
    const ContactAnswer<double>& contact = pivot.report.answer.contacts[i];
    friction_power -= contact.friction_force.dot(contact.acceleration);
    const double largest = 0.5 * contact.normal_force * contact.slip;
    CHECK(-contact.friction_force.dot(contact.acceleration) == Approx(largest).epsilon(1e-9));
  }
  const Vector6<double>& a = pivot.report.answer.acceleration;
  const double inertia_power =
      0.2 * a.head<3>().squaredNorm() + a.tail<3>().dot(pivot.file.object.inertia * a.tail<3>());
  CHECK(pivot.normal_of("edge") * 0.1 == Approx(friction_power + inertia_power).epsilon(1e-9));
}

TEST_CASE("rolling: high friction at the sheet rolls the cylinder without slipping") {
  const Pushed rolling(scene_text("rolling.toml"));
  CHECK(rolling.report.motion.kind == MotionKind::roll);
  CHECK(rolling.angular(2) == Approx(5).epsilon(1e-9));
  CHECK(std::abs(rolling.linear(0)) < 1e-9);
  CHECK(rolling.mode_of("sheet.1") == Mode::stick);
}

TEST_CASE("rolling: a slippery sheet, or a harder grip, leaves the cylinder at rest") {
  for (const std::string name : {"rolling_low_friction.toml", "rolling_hard_grip.toml"}) {
    CAPTURE(name);
    const Pushed sliding(scene_text(name));
    CHECK(sliding.report.motion.kind == MotionKind::rest);
    CHECK(sliding.mode_of("sheet.1") == Mode::slide);
  }
}

TEST_CASE("rolling: the threshold F* separates rolling from sliding where it is sharp") {
  const double m = 0.5, mu_s = 0.5, mu_f = 0.3, a = 0.1;
  const double threshold = (mu_s * m * 9.81 / (1 - mu_s * mu_f) - 0.5 * m * a) / (2 * mu_f);
  const std::string text = scene_text("rolling.toml");
  for (const double factor : {0.5, 0.999, 1.001, 1.1}) {
    CAPTURE(factor);
    std::ostringstream force;
    force.precision(17);
    force << "grip_force = " << factor * threshold;
    const Pushed pushed(with(text, "grip_force = 4", force.str()));
    const double rolled = pushed.angular(2) * 0.02 / a;
    if (factor < 1)
      CHECK(rolled == Approx(1).epsilon(1e-9));
    else
      CHECK(rolled < 0.99);
  }
}

TEST_CASE("rolling: independent fingers drift along with the sheet") {
  const Pushed drifting(with(scene_text("rolling.toml"), "\"parallel\"", "\"independent\""));
  CHECK(drifting.linear(0) > 0.01);
}
