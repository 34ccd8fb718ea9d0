// An acceleration in words: what counts as motion at all.
#include <doctest/doctest.h>

#include "lcpush/mechanics/study/motion.hpp"

using namespace lcpush;

namespace {

/// One pusher at (0.1, 0, 0) m; the object accelerates as given, the pusher with `push` m/s^2.
Motion<double> motion_of(const Vector6<double>& acceleration, double push) {
  const Vector3<double> point(0.1, 0, 0);
  Body<double> body;
  body.role = Role::pusher;
  body.point_count = 1;
  ContactAnswer<double> contact;
  Scene<double> scene{};
  scene.bodies = {&body, 1};
  scene.points = {&point, 1};
  Answer<double> answer;
  answer.acceleration = acceleration;
  answer.contacts = {&contact, 1};
  return describe_motion(scene, answer, 0.1, 10.0, push);
}

Vector6<double> twist(double x, double about_x, double about_z) {
  Vector6<double> a = Vector6<double>::Zero();
  a[0] = x;
  a[3] = about_x;
  a[5] = about_z;
  return a;
}

} // namespace

TEST_CASE("a turn below a thousandth of the motion is a slide, not an axis far away") {
  CHECK(motion_of(twist(1, 0, 1e-4), 1).kind == MotionKind::slide);
  CHECK(motion_of(twist(1, 0, 1e-4), 1).axis_point.norm() == 0);
  CHECK(motion_of(twist(1, 0, 1e-1), 1).kind == MotionKind::turn);
}

TEST_CASE("an object that a sliding surface leaves alone does not move, whatever rounding says") {
  CHECK(motion_of(twist(1e-5, 0, 1e-5), 1).kind == MotionKind::rest);
  CHECK(motion_of(twist(1e-5, 0, 0), 1e-5).kind == MotionKind::slide); // of a tiny push it does
}

TEST_CASE("advancing by rounding along the axis makes no screw") {
  CHECK(motion_of(twist(1e-6, 1, 0), 1).pitch == 0);
  CHECK(motion_of(twist(1e-2, 1, 0), 1).pitch == doctest::Approx(1e-2));
}

TEST_CASE("without a push, a fall is a motion and what rounding leaves of the weight is none") {
  CHECK(motion_of(twist(1e-3, 0, 0), 0).kind == MotionKind::slide);
  CHECK(motion_of(twist(1e-6, 0, 0), 0).kind == MotionKind::rest);
}
