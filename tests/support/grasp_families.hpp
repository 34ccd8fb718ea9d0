// Variations on the random grasps: the same seeds with soft fingertips, other hands, more pushers.
#pragma once

#include "support/random_grasp.hpp"

namespace lcpush::test {

enum class Family {
  plain,
  planar,      ///< motion in the x-y plane
  even,        ///< planar, every point with its even share
  soft,        ///< one soft point a finger, and now and then at the pusher
  bilateral,   ///< the pusher pulls as well
  parallel,    ///< both fingers on one drive
  two_pushers, ///< a second one, across the first
  stop,        ///< a fixed finger across the push
  jacobian,    ///< fingers driven along and across their normals, with inertia
  weighted,    ///< points with uneven shares, and a wrench on the object
  locked,      ///< fingers that stand still, with a preload; the push goes along their middle plane
};

namespace detail {

/// Every body keeps its first point only, and turns soft with the radius.
template <class S> void make_soft(OwnedScene<S>& scene, Random& random, S size) {
  std::vector<Vector3<S>> points;
  for (Body<S>& body : scene.bodies) {
    points.push_back(scene.points[static_cast<std::size_t>(body.first_point)]);
    body.first_point = static_cast<Index>(points.size()) - 1;
    body.point_count = 1;
    if (body.role == Role::finger || random.integer(0, 1) == 0)
      body.torsion_radius = size * static_cast<S>(random.uniform(0.02, 0.2));
  }
  scene.points = points;
}

/// A line contact above the object, facing down, with or without a motion of its own.
template <class S> void add_across(OwnedScene<S>& scene, Random& random, Role role, S size) {
  const auto within = [&](double low, double high) {
    return size * static_cast<S>(random.uniform(low, high));
  };
  const S x = within(-0.3, 0.3), wide = within(0.05, 0.2);
  scene.add_body(role, {S(0), S(-1), S(0)}, static_cast<S>(random.uniform(0.1, 1.2)),
                 {{x - wide, size / S(2), S(0)}, {x + wide, size / S(2), S(0)}});
  if (role == Role::pusher)
    scene.bodies.back().acceleration[1] = -static_cast<S>(random.uniform(-1, 3));
}

} // namespace detail

template <class S> OwnedScene<S> grasp_of(Family family, std::uint64_t seed) {
  OwnedScene<S> scene = random_grasp<S>(seed);
  Random random(seed + 77);
  const S size = -S(2) * scene.points.back()[0]; // the pusher stands at -size / 2
  const auto drive = [&](Index body, Index actuator, S across) {
    const Body<S>& finger = scene.bodies[static_cast<std::size_t>(body)];
    Vector6<S> twist = Vector6<S>::Zero();
    twist.template head<3>() = finger.normal + across * finger.tangent;
    scene.drives.push_back({body, actuator, twist});
  };
  scene.base.planar = family == Family::planar || family == Family::even;
  if (family == Family::even) scene.base.pressure = Pressure::even;
  if (family == Family::soft) detail::make_soft(scene, random, size);
  if (family == Family::bilateral) scene.bodies.back().bilateral = true;
  if (family == Family::two_pushers) detail::add_across(scene, random, Role::pusher, size);
  if (family == Family::stop) detail::add_across(scene, random, Role::finger, size);
  if (family == Family::parallel) {
    scene.actuators.resize(1);
    scene.actuators[0].force *= S(2);
    scene.drives.clear();
    for (Index body = 0; body < 2; ++body) drive(body, 0, S(0));
  }
  if (family == Family::weighted) {
    for (const Body<S>& body : scene.bodies) {
      S sum(0);
      for (Index i = 0; i < body.point_count; ++i) {
        scene.weights.push_back(static_cast<S>(random.uniform(0.1, 1)));
        sum += scene.weights.back();
      }
      for (Index i = 0; i < body.point_count; ++i)
        scene.weights[static_cast<std::size_t>(body.first_point + i)] /= sum;
    }
    for (Index k = 0; k < 6; ++k)
      scene.base.object.wrench[k] = static_cast<S>(random.uniform(-2, 2)) * (k < 3 ? S(1) : size);
  }
  if (family == Family::locked) {
    for (Index body = 0; body < 2; ++body)
      scene.bodies[static_cast<std::size_t>(body)].preload = scene.actuators[0].force;
    scene.actuators.clear();
    scene.drives.clear();
    Vector6<S>& push = scene.bodies.back().acceleration; // fingers' normals lie along z
    push[2] = push[3] = push[4] = S(0);
    const Body<S>& pusher = scene.bodies.back();
    for (Index i = 0; i < pusher.point_count; ++i)
      scene.points[static_cast<std::size_t>(pusher.first_point + i)][2] = S(0);
  }
  if (family == Family::jacobian) {
    scene.drives.clear();
    for (Index body = 0; body < 2; ++body) {
      // Across by less than friction's angle: steeper drives lock themselves.
      const S mu = scene.bodies[static_cast<std::size_t>(body)].friction;
      drive(body, body, static_cast<S>(random.uniform(-0.8, 0.8)) / (S(1) + mu));
      scene.actuators[static_cast<std::size_t>(body)].inertia =
          static_cast<S>(random.uniform(0, 0.1));
    }
  }
  for (Body<S>& body : scene.bodies) {
    lie_in_plane(body, scene.base.planar);
    if (body.in_plane) body.acceleration.template segment<3>(2).setZero(); // as scene files do
  }
  return scene;
}

inline OwnedScene<double> grasp_under(Pressure pressure, Family family, std::uint64_t seed) {
  OwnedScene<double> scene = grasp_of<double>(family, seed);
  scene.base.pressure = pressure;
  return scene;
}

} // namespace lcpush::test
