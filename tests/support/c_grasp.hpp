// Random grasps through the C interface, as a device is given them, and what their answers violate.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lcpush/lcpush.h"
#include "support/grasp_families.hpp"

namespace lcpush::test {

/// A grasp as the C interface takes it.
struct CGrasp {
  std::vector<lcpushf_body> bodies;
  std::vector<lcpushf_point> points;
  std::vector<lcpushf_actuator> actuators;
  std::vector<lcpushf_drive> drives;
  lcpushf_scene scene{};

  explicit CGrasp(const OwnedScene<float>& given) {
    for (const Body<float>& from : given.bodies) {
      lcpushf_body body{};
      body.role = from.role == Role::pusher ? LCPUSH_PUSHER : LCPUSH_FINGER;
      std::copy_n(from.normal.data(), 3, body.normal);
      std::copy_n(from.tangent.data(), 3, body.tangent);
      std::copy_n(from.acceleration.data(), 6, body.acceleration);
      body.friction = from.friction;
      body.first_point = static_cast<int>(from.first_point);
      body.point_count = static_cast<int>(from.point_count);
      bodies.push_back(body);
    }
    for (const Vector3<float>& p : given.points) points.push_back({p[0], p[1], p[2]});
    for (const Actuator<float>& a : given.actuators) actuators.push_back({a.force, a.inertia});
    for (const Drive<float>& from : given.drives) {
      lcpushf_drive drive{static_cast<int>(from.body), static_cast<int>(from.actuator), {}};
      std::copy_n(from.twist.data(), 6, drive.twist);
      drives.push_back(drive);
    }
    scene.object.mass = given.base.object.mass;
    const Matrix3<float> inertia = given.base.object.inertia;
    std::copy_n(inertia.data(), 9, scene.object.inertia);
    std::copy_n(given.base.gravity.data(), 3, scene.gravity);
    scene.facets = static_cast<int>(given.base.facets);
    scene.pressure = static_cast<lcpush_pressure>(given.base.pressure);
    scene.planar = given.base.planar ? 1 : 0;
    scene.bodies = bodies.data();
    scene.body_count = static_cast<int>(bodies.size());
    scene.points = points.data();
    scene.point_count = static_cast<int>(points.size());
    scene.actuators = actuators.data();
    scene.actuator_count = static_cast<int>(actuators.size());
    scene.drives = drives.data();
    scene.drive_count = static_cast<int>(drives.size());
  }

  /// N, what forces are measured by.
  double size() const {
    double largest = 9.81 * static_cast<double>(scene.object.mass);
    for (const lcpushf_actuator& a : actuators)
      largest = std::max(largest, static_cast<double>(a.force));
    return largest;
  }
};

inline Eigen::Vector3d vector(const lcpushf_point& p) {
  return Eigen::Vector3f(p.x, p.y, p.z).cast<double>();
}

/// Made in that memory for grasps of up to that size, told of this one and not yet solved.
inline lcpushf_push* described(std::vector<double>& memory, const lcpush_size& most,
                               const CGrasp& grasp) {
  lcpushf_push* const push = lcpushf_make(memory.data(), memory.size() * sizeof(double), &most);
  REQUIRE(push != nullptr);
  REQUIRE(lcpushf_describe(push, &grasp.scene) == LCPUSH_RUNNING);
  return push;
}

struct Violation {
  double newton = 0, cones_and_grip = 0;
};

/// In double, by nothing of the solver's: Newton's law of the object; cones, and what the fingers
/// press with. The worst of each, by the size of forces.
inline Violation violation(const CGrasp& grasp, const lcpushf_push* push) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  double worst = 0;
  std::vector<double> presses(grasp.bodies.size());
  for (int i = 0; i < grasp.scene.point_count; ++i) {
    lcpushf_contact contact;
    lcpushf_contact_at(push, i, &contact);
    const lcpushf_body& body = grasp.bodies[static_cast<std::size_t>(contact.body)];
    const lcpushf_point& at = grasp.points[static_cast<std::size_t>(i)];
    const auto normal = static_cast<double>(contact.normal_force);
    const auto mu = static_cast<double>(body.friction);
    const Eigen::Vector3d friction =
        Eigen::Map<const Eigen::Vector3f>(contact.friction_force).cast<double>();
    const Eigen::Vector3d f =
        normal * Eigen::Map<const Eigen::Vector3f>(body.normal).cast<double>() + friction;
    force += f;
    moment += cross<double>(vector(at), f);
    presses[static_cast<std::size_t>(contact.body)] += normal;
    worst = std::max({worst, -normal, friction.norm() - mu * std::max(normal, 0.0)});
  }
  float a[6];
  lcpushf_acceleration(push, a);
  const Eigen::Matrix<double, 6, 1> motion =
      Eigen::Map<const Eigen::Matrix<float, 6, 1>>(a).cast<double>();
  const auto mass = static_cast<double>(grasp.scene.object.mass);
  const Eigen::Vector3d weight =
      mass * Eigen::Map<const Eigen::Vector3f>(grasp.scene.gravity).cast<double>();
  const Eigen::Matrix3d inertia =
      Eigen::Map<const Eigen::Matrix3f>(grasp.scene.object.inertia).cast<double>();
  double length = 0;
  for (const lcpushf_point& p : grasp.points) length = std::max(length, vector(p).norm());
  Eigen::Vector3d forces = force + weight - mass * motion.head<3>();
  Eigen::Vector3d moments = moment - inertia * motion.tail<3>();
  if (grasp.scene.planar != 0) forces[2] = moments[0] = moments[1] = 0;
  for (const lcpushf_drive& drive : grasp.drives) {
    const lcpushf_actuator& actuator = grasp.actuators[static_cast<std::size_t>(drive.actuator)];
    const auto grip = static_cast<double>(
        actuator.force - actuator.inertia * lcpushf_closing_of(push, drive.actuator));
    worst = std::max(worst, std::abs(presses[static_cast<std::size_t>(drive.body)] - grip));
  }
  return {std::max(forces.norm(), moments.norm() / length) / grasp.size(), worst / grasp.size()};
}

} // namespace lcpush::test
