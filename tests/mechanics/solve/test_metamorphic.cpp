// Turning, mirroring and rescaling a scene turns, mirrors and rescales its answer. On scenes whose
// motion is unique, so that there is one answer to compare.
#include <doctest/doctest.h>

#include <array>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double alike = 1e-9;
using Mat3 = Matrix3<double>;

/// R orthogonal: a vector goes to R v, an axial vector (rotation, moment) to det(R) R v.
Vector6<double> moved(const Mat3& R, const Vector6<double>& twist) {
  Vector6<double> result;
  result << R * twist.head<3>(), R.determinant() * R * twist.tail<3>();
  return result;
}

/// The whole scene under R; tangents are chosen anew, as a scene file would.
Scene3 moved(const Mat3& R, Scene3 scene) {
  scene.base.object.inertia = (R * scene.base.object.inertia * R.transpose()).eval();
  scene.base.gravity = (R * scene.base.gravity).eval();
  for (Vec3& p : scene.points) p = (R * p).eval();
  for (Body<double>& body : scene.bodies) {
    body.normal = (R * body.normal).eval();
    body.tangent = default_tangent<double>(body.normal);
    body.acceleration = moved(R, body.acceleration);
  }
  for (Drive<double>& drive : scene.drives) drive.twist = moved(R, drive.twist);
  return scene;
}

Scene3 rescaled(Scene3 scene, double mass, double length, double time) {
  const double acceleration = length / (time * time);
  scene.base.object.mass *= mass;
  scene.base.object.inertia *= mass * length * length;
  scene.base.gravity *= acceleration;
  for (Vec3& p : scene.points) p *= length;
  for (Body<double>& body : scene.bodies) {
    body.acceleration.head<3>() *= acceleration;
    body.acceleration.tail<3>() /= time * time;
  }
  for (Actuator<double>& actuator : scene.actuators) actuator.force *= mass * acceleration;
  return scene;
}

Vector6<double> acceleration_of(const Scene3& scene) {
  SolvedPush<double> push(scene);
  REQUIRE(push.solve() == Status::solved);
  return push.answer().acceleration;
}

/// The 24 rotations that take axes to axes.
std::vector<Mat3> quarter_turns() {
  std::vector<Mat3> turns;
  const std::array<std::array<Index, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  for (const auto& order : orders)
    for (int signs = 0; signs < 8; ++signs) {
      Mat3 R = Mat3::Zero();
      for (Index k = 0; k < 3; ++k)
        R(k, order[static_cast<std::size_t>(k)]) = (signs >> k) % 2 == 0 ? 1 : -1;
      if (R.determinant() > 0) turns.push_back(R);
    }
  return turns;
}

void check_moved(const Scene3& scene, const Mat3& R) {
  const Vector6<double> a = moved(R, acceleration_of(scene));
  const Vector6<double> b = acceleration_of(moved(R, scene));
  CHECK((a - b).head<3>().norm() <= alike * a.norm());
  CHECK((a - b).tail<3>().norm() <= alike * a.norm());
}

} // namespace

TEST_CASE("the scenes below have a unique motion") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    CHECK(motion_is_determined(determined_grasp(seed).view()));
}

TEST_CASE("any of the 24 quarter turns turns the answer") {
  const std::vector<Mat3> turns = quarter_turns();
  REQUIRE(turns.size() == 24);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    for (const Mat3& R : turns) check_moved(determined_grasp(seed), R);
  }
}

TEST_CASE("a mirrored scene has the mirrored answer") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (Index axis = 0; axis < 3; ++axis) {
      CAPTURE(seed);
      Mat3 R = Mat3::Identity();
      R(axis, axis) = -1;
      check_moved(determined_grasp(seed), R);
    }
}

TEST_CASE("another unit of mass, length or time rescales the answer and nothing else") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Scene3 scene = determined_grasp(seed);
    const Vector6<double> a = acceleration_of(scene);
    for (const auto& [mass, length, time] :
         {std::array<double, 3>{1e3, 1, 1}, std::array<double, 3>{1, 1e3, 1},
          std::array<double, 3>{1, 1, 1e-3}, std::array<double, 3>{3e-5, 0.07, 13}}) {
      const Vector6<double> b = acceleration_of(rescaled(scene, mass, length, time));
      const double unit = length / (time * time);
      CHECK((b.head<3>() / unit - a.head<3>()).norm() <= alike * a.norm());
      CHECK((b.tail<3>() * time * time - a.tail<3>()).norm() <= alike * a.norm());
    }
  }
}

TEST_CASE("the order of bodies does not matter for the motion") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Scene3 scene = determined_grasp(seed);
    Scene3 swapped = scene; // the two fingers change places
    for (Index b : {0, 1}) {
      const auto from = static_cast<std::size_t>(1 - b), to = static_cast<std::size_t>(b);
      swapped.bodies[to] = scene.bodies[from];
      swapped.bodies[to].first_point = b;
      swapped.points[to] = scene.points[from];
      swapped.actuators[to] = scene.actuators[from];
      swapped.drives[to] = scene.drives[from];
      swapped.drives[to].body = swapped.drives[to].actuator = b;
    }
    const Vector6<double> a = acceleration_of(scene), b = acceleration_of(swapped);
    CHECK((a - b).norm() <= alike * a.norm());
  }
}
