// The scenes of the benchmarks: two round fingers and a line pusher, as wide as one likes, and the
// paper's three primitives with k points a patch.
#pragma once

#include "support/random_grasp.hpp"

namespace lcpush::bench {

inline std::vector<Vector3<double>> disc(Index points, const Vector3<double>& center,
                                         double radius) {
  std::vector<Vector3<double>> all;
  for (Index i = 0; i < points; ++i) {
    constexpr double golden_angle = 2.399963229728653;
    const double r =
        radius * std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(points));
    const double angle = golden_angle * static_cast<double>(i);
    all.push_back(center + Vector3<double>(r * std::cos(angle), r * std::sin(angle), 0));
  }
  return all;
}

inline std::vector<Vector3<double>> line(const Vector3<double>& from, const Vector3<double>& to,
                                         Index points) {
  std::vector<Vector3<double>> all;
  for (Index i = 0; i < points; ++i)
    all.push_back(from + (to - from) * (static_cast<double>(i) / static_cast<double>(points - 1)));
  return all;
}

/// A bar between two discs of `points` each, pushed by a line. Seed 0 is one fixed grasp, others
/// vary friction, grip, weight, place of the fingers and direction of the push.
inline test::OwnedScene<double> disc_grasp(Index points, Index facets, Pressure pressure,
                                           std::uint64_t seed = 0) {
  test::Random random(seed + 1);
  const auto number = [&](double fixed, double low, double high) {
    return seed == 0 ? fixed : random.uniform(low, high);
  };
  test::OwnedScene<double> scene;
  scene.base.object.mass = 0.2;
  scene.base.object.inertia = Vector3<double>(2e-5, 1.7e-4, 1.8e-4).asDiagonal();
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity = {number(0, -5, 5), number(-9.81, -9.81, 9.81), number(0, -5, 5)};
  scene.base.facets = facets;
  scene.base.pressure = pressure;
  const double x = number(0.01, -0.02, 0.02), y = number(0.002, -0.008, 0.008);
  const double grip = number(20, 5, 40), friction = number(0.5, 0.2, 0.9);
  for (const double side : {1.0, -1.0}) {
    scene.add_body(Role::finger, {0, 0, -side}, friction,
                   disc(points, {x, y, side * 0.005}, 0.006));
    scene.drive_last_body(grip);
  }
  scene.add_body(Role::pusher, {1, 0, 0}, number(0.3, 0.1, 0.8),
                 line({-0.05, -0.015, 0}, {-0.05, 0.015, 0}, 2));
  scene.bodies.back().acceleration << number(1, 0.5, 2), number(0.3, -0.5, 0.5), 0, 0, 0,
      number(2, -5, 5);
  return scene;
}

enum class Primitive { slide, pivot, roll };

/// The paper's primitives (fixtures/scenes: straight_slide, pivot, rolling), k points a patch.
inline test::OwnedScene<double> primitive(Primitive which, Index k, Index facets,
                                          Pressure pressure) {
  test::OwnedScene<double> scene;
  scene.base.facets = facets;
  scene.base.pressure = pressure;
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity = {0, -9.81, 0};
  if (which == Primitive::roll) {
    scene.base.object.mass = 0.5;
    scene.base.object.inertia = Vector3<double>(2e-4, 2e-4, 1e-4).asDiagonal();
    for (const double side : {1.0, -1.0})
      scene.add_body(Role::finger, {side, 0, 0}, 0.3,
                     line({-side * 0.02, 0, -0.02}, {-side * 0.02, 0, 0.02}, k));
    // A parallel jaw: one actuator closes both.
    for (const Index finger : {Index(0), Index(1)}) {
      Vector6<double> twist = Vector6<double>::Zero();
      twist[0] = finger == 0 ? 1 : -1;
      scene.drives.push_back({finger, 0, twist});
    }
    scene.actuators.push_back({8.0, 0.0});
    scene.add_body(Role::pusher, {0, 1, 0}, 0.5, line({0, -0.02, -0.02}, {0, -0.02, 0.02}, 2));
    scene.bodies.back().acceleration[0] = 0.1;
    return scene;
  }
  scene.base.object.mass = 0.2;
  scene.base.object.inertia = Vector3<double>(1.7e-5, 1.7e-4, 1.8e-4).asDiagonal();
  if (which == Primitive::pivot) scene.base.gravity.setZero();
  for (const double side : {1.0, -1.0}) {
    scene.add_body(Role::finger, {0, 0, -side}, 0.5, disc(k, {0, 0, side * 0.005}, 0.005));
    scene.drive_last_body(20);
  }
  if (which == Primitive::slide) {
    scene.add_body(Role::pusher, {1, 0, 0}, 0.3, line({-0.05, -0.015, 0}, {-0.05, 0.015, 0}, 2));
    scene.bodies.back().acceleration[0] = 0.1;
  } else {
    scene.add_body(Role::pusher, {0, 1, 0}, 0.3,
                   line({-0.04, -0.015, -0.005}, {-0.04, -0.015, 0.005}, 2));
    scene.bodies.back().acceleration[1] = 0.1;
  }
  return scene;
}

} // namespace lcpush::bench
