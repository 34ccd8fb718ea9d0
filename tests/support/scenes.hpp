// Scenes with closed forms (docs/theory/theory.md, "Closed forms"), SI units.
#pragma once

#include "support/random_grasp.hpp"

namespace lcpush::test {

using Scene3 = OwnedScene<double>;
using Vec3 = Vector3<double>;

constexpr double exact = 1e-9;     // of a solved answer against its closed form
constexpr double rounding = 1e-12; // of two ways to one matrix
constexpr Index slide_wall = 2;    // the pusher's body, after the two fingers

/// An object with a diagonal inertia, eight facets, no bodies yet.
inline Scene3 bare_scene(double mass, const Vec3& inertia, const Vec3& gravity) {
  Scene3 scene;
  scene.base.object.mass = mass;
  scene.base.object.inertia = inertia.asDiagonal();
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity = gravity;
  scene.base.facets = 8;
  scene.base.pressure = Pressure::pad;
  return scene;
}

/// Two fingers on the faces z = +-h, with the same points (x, y) each and the grip force F each.
inline void add_pinch(Scene3& scene, const std::vector<Vec3>& at, double h, double friction,
                      double F) {
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec3> points = at;
    for (Vec3& p : points) p[2] = side * h;
    scene.add_body(Role::finger, {0, 0, -side}, friction, points);
    scene.drive_last_body(F);
  }
}

inline std::vector<Vec3> ring(Index k, double radius) {
  std::vector<Vec3> points;
  for (Index i = 0; i < k; ++i)
    points.push_back({radius * circle_cosine<double>(2 * i, 2 * k),
                      radius * circle_sine<double>(2 * i, 2 * k), 0});
  return points;
}

struct Slide {
  double mass = 0.2, F = 20, mu = 0.5, wall_friction = 0.3, acceleration = 0.1;
  double half_width = 0.05, half_wall = 0.015;
  Vec3 gravity{0, -9.81, 0};
  std::vector<Vec3> pads{Vec3::Zero()}; // of each finger
};

/// A box pinched at its centre and pushed along x by a line of two points: bodies 0, 1 fingers,
/// 2 the wall. The wall can carry the weight and its moment.
inline Scene3 straight_slide(const Slide& s = {}) {
  const double x = 2 * s.half_width, y = 0.03, z = 0.01;
  const Vec3 inertia = s.mass / 12 * Vec3(y * y + z * z, x * x + z * z, x * x + y * y);
  Scene3 scene = bare_scene(s.mass, inertia, s.gravity);
  add_pinch(scene, s.pads, z / 2, s.mu, s.F);
  scene.add_body(Role::pusher, {1, 0, 0}, s.wall_friction,
                 {{-s.half_width, -s.half_wall, 0}, {-s.half_width, s.half_wall, 0}});
  scene.bodies.back().acceleration[0] = s.acceleration;
  return scene;
}

struct Roll {
  double mass = 0.1, radius = 0.02, F = 1, mu_finger = 0.3, mu_sheet = 0.5, acceleration = 0.2;
  double gravity = 9.81;

  double inertia() const { return 0.5 * mass * radius * radius; }
  /// Below it the cylinder rolls; sharp for mu_sheet (1 + mu_finger) < 1.
  double threshold() const {
    return (mu_sheet * mass * gravity / (1 - mu_sheet * mu_finger) -
            inertia() * acceleration / (radius * radius)) /
           (2 * mu_finger);
  }
};

/// A cylinder (axis z) between two fingers of a parallel jaw on a sheet that moves along x.
inline Scene3 rolling(const Roll& r) {
  const double side = r.mass * r.radius * r.radius;
  Scene3 scene = bare_scene(r.mass, {side, side, r.inertia()}, {0, -r.gravity, 0});
  for (const double left : {1.0, -1.0}) {
    scene.add_body(Role::finger, {left, 0, 0}, r.mu_finger,
                   {{-left * r.radius, 0, -0.01}, {-left * r.radius, 0, 0.01}});
    Vector6<double> twist = Vector6<double>::Zero();
    twist[0] = left;
    scene.drives.push_back({static_cast<Index>(scene.bodies.size()) - 1, 0, twist});
  }
  scene.actuators.push_back({2 * r.F, 0});
  scene.add_body(Role::pusher, {0, 1, 0}, r.mu_sheet,
                 {{0, -r.radius, -0.01}, {0, -r.radius, 0.01}});
  scene.bodies.back().acceleration[0] = r.acceleration;
  return scene;
}

/// A random grasp whose motion is unique: one point a finger, a pusher without friction, normals
/// along axes, four or eight facets.
inline Scene3 determined_grasp(std::uint64_t seed) {
  Random random(seed);
  const double mass = random.uniform(0.05, 1), size = random.uniform(0.02, 0.1);
  const auto anywhere = [&] {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  const Vec3 inertia(random.uniform(0.2, 0.4), random.uniform(0.2, 0.4), random.uniform(0.2, 0.4));
  Scene3 scene = bare_scene(mass, mass * size * size * inertia, 9.81 * anywhere());
  scene.base.facets = 4 * random.integer(1, 2);
  for (const double side : {1.0, -1.0}) {
    const Vec3 p(size * random.uniform(-0.3, 0.3), size * random.uniform(-0.3, 0.3),
                 side * size * 0.25);
    scene.add_body(Role::finger, {0, 0, -side}, random.uniform(0.1, 1.2), {p});
    scene.drive_last_body(random.uniform(2, 40));
  }
  scene.add_body(
      Role::pusher, {1, 0, 0}, 0,
      {{-size / 2, size * random.uniform(-0.5, 0.5), 0.1 * size * random.uniform(-1, 1)}});
  scene.bodies.back().acceleration << random.uniform(0.1, 5) * (Vec3::UnitX() + 0.3 * anywhere()),
      0.1 / size * anywhere();
  return scene;
}

} // namespace lcpush::test
