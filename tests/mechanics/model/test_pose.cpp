// The exponential map: turns, ways, and that rotations stay rotations.
#include <doctest/doctest.h>

#include "lcpush/mechanics/model/pose.hpp"
#include "support/scenes.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {
double bent(const Matrix3<double>& R) {
  return (R.transpose() * R - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
}
} // namespace

TEST_CASE("a turn about an axis, from nothing to several rounds") {
  for (const double angle : {0.0, 1e-300, 1e-9, 1e-3, 0.5, 1.0, 3.0, 25.0}) {
    CAPTURE(angle);
    const Matrix3<double> R = rotation_by<double>(Vec3(0, 0, angle));
    CHECK(R(0, 0) == doctest::Approx(std::cos(angle)).epsilon(1e-14));
    CHECK(std::abs(R(1, 0) - std::sin(angle)) <= 1e-15 * std::max(1.0, angle));
    CHECK(R(2, 2) == doctest::Approx(1).epsilon(1e-15));
    CHECK(bent(R) <= 1e-14);
  }
  CHECK(rotation_by<double>(Vec3::Zero()) == Matrix3<double>::Identity());
  const Vec3 place(0.3, -0.7, 0.2);
  CHECK((rotation_by<double>(place) * rotation_by<double>(-place) - Matrix3<double>::Identity())
            .norm() < 1e-15);
  CHECK((rotation_by<double>(place) * place - place).norm() < 1e-16);
  CHECK((rotation_by<double>(place) * rotation_by<double>(place) - rotation_by<double>(2 * place))
            .norm() < 1e-15);
}

TEST_CASE("a million small turns leave a rotation") {
  Pose<double> pose;
  Vector6<double> twist;
  twist << 0, 0, 0, 1, -2, 3;
  for (Index k = 0; k < 1000000; ++k) pose = moved(pose, twist, 1e-3);
  CHECK(bent(pose.rotation) <= 1e-15);
  const Vec3 all = 1000.0 * twist.tail<3>();
  CHECK((pose.rotation - rotation_by<double>(all)).norm() <= 1e-8);
}

TEST_CASE("a body that turns about an axis stays on its circle, at any step") {
  Vector6<double> twist; // about the point (0.1, 0, 0)
  twist << 0, -0.2, 0, 0, 0, 2;
  for (const double h : {1e-3, 0.1, 3.0}) {
    Pose<double> pose;
    for (double t = 0; t < 9 - h / 2; t += h) {
      pose = moved_about_origin(pose, twist, h);
      CHECK((pose.at({0.1, 0, 0}) - Vec3(0.1, 0, 0)).norm() <= 1e-12);
    }
  }
  Vector6<double> straight = Vector6<double>::Zero();
  straight[0] = 0.3;
  CHECK(moved_about_origin(Pose<double>(), straight, 0.1).position[0] == 0.3 * 0.1);
}

TEST_CASE("back undoes at, and the same twist is read at another point") {
  Vector6<double> twist;
  twist << 0.1, 0.2, -0.3, 0.5, 0.4, -1;
  const Pose<double> pose = moved_about_origin(Pose<double>(), twist, 0.7);
  const Vec3 place(0.02, -0.01, 0.03);
  CHECK((pose.back(pose.at(place)) - place).norm() < 1e-16);
  CHECK((twist_at(twist_at(twist, place), Vec3(-place)) - twist).norm() < 1e-16);
  CHECK((acceleration_at(place, twist) - twist_at(twist, place).head<3>()).norm() == 0);
}
