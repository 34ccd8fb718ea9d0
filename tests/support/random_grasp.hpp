// Seeded random grasps (docs/theory/numerics.md, "Random grasps"): the family that the reliability
// figures speak of. Same seed, same grasp, on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush::test {

/// A scene with its arrays.
template <class S> struct OwnedScene {
  Scene<S> base{};
  std::vector<Body<S>> bodies;
  std::vector<Vector3<S>> points;
  std::vector<Actuator<S>> actuators;
  std::vector<Drive<S>> drives;
  std::vector<S> weights; ///< empty: equal shares

  Scene<S> view() const {
    Scene<S> scene = base;
    scene.bodies = {bodies.data(), static_cast<Index>(bodies.size())};
    scene.points = {points.data(), static_cast<Index>(points.size())};
    scene.actuators = {actuators.data(), static_cast<Index>(actuators.size())};
    scene.drives = {drives.data(), static_cast<Index>(drives.size())};
    scene.weights = {weights.data(), static_cast<Index>(weights.size())};
    return scene;
  }

  /// With a body and an actuator for each point if the pressure is to be even.
  OwnedScene spread() const {
    OwnedScene pads = *this;
    const EvenSize size = even_size(view());
    pads.bodies.resize(static_cast<std::size_t>(size.bodies));
    pads.actuators.resize(static_cast<std::size_t>(size.drives));
    pads.drives.resize(static_cast<std::size_t>(size.drives));
    Scene<S> ignored;
    const EvenMemory<S> memory{{pads.bodies.data(), size.bodies},
                               {pads.actuators.data(), size.drives},
                               {pads.drives.data(), size.drives}};
    const bool spreads =
        base.pressure == Pressure::even && spread_evenly(view(), memory, ignored) == Status::solved;
    pads.weights.clear();
    return spreads ? pads : *this;
  }

  void add_body(Role role, const Vector3<S>& normal, S friction,
                const std::vector<Vector3<S>>& at) {
    Body<S> body{};
    body.role = role;
    body.normal = normal.normalized();
    const Vector3<S> axis =
        std::abs(body.normal[0]) < S(0.9) ? Vector3<S>::UnitX().eval() : Vector3<S>::UnitY().eval();
    body.tangent = (axis - axis.dot(body.normal) * body.normal).normalized();
    body.friction = friction;
    body.first_point = static_cast<Index>(points.size());
    body.point_count = static_cast<Index>(at.size());
    body.acceleration.setZero();
    bodies.push_back(body);
    points.insert(points.end(), at.begin(), at.end());
    if (!weights.empty()) weights.insert(weights.end(), at.size(), S(1) / S(at.size()));
  }

  /// Makes the last body force-controlled along its normal.
  void drive_last_body(S force) {
    Vector6<S> twist = Vector6<S>::Zero();
    twist.template head<3>() = bodies.back().normal;
    drives.push_back(
        {static_cast<Index>(bodies.size()) - 1, static_cast<Index>(actuators.size()), twist});
    actuators.push_back({force, S(0)});
  }
};

class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }
  Index integer(Index low, Index high) {
    return low + static_cast<Index>(next() % static_cast<std::uint64_t>(high - low + 1));
  }

private:
  std::uint64_t state_;
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
};

/// 1-8 points a patch, 1-4 at the pusher, g 4..16, mu 0.1..1.2, weight in any direction.
template <class S> OwnedScene<S> random_grasp(std::uint64_t seed) {
  Random random(seed);
  const auto number = [&](double low, double high) {
    return static_cast<S>(random.uniform(low, high));
  };
  const auto direction = [&] {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 6.283185307179586);
    const double r = std::sqrt(1 - z * z);
    return Vector3<S>(static_cast<S>(r * std::cos(angle)), static_cast<S>(r * std::sin(angle)),
                      static_cast<S>(z));
  };
  OwnedScene<S> scene;
  const S mass = number(0.05, 1), size = number(0.02, 0.1);
  scene.base.object.mass = mass;
  scene.base.object.inertia = Matrix3<S>::Zero();
  for (Index k = 0; k < 3; ++k)
    scene.base.object.inertia(k, k) = mass * size * size * number(0.2, 0.4);
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity = S(9.81) * direction();
  scene.base.facets = 2 * random.integer(2, 8);
  scene.base.pressure = Pressure::pad;

  const S half = size * number(0.1, 0.4);
  S grip = number(2, 40), x = size * number(-0.3, 0.3), y = size * number(-0.3, 0.3);
  for (const S side : {S(1), S(-1)}) {
    const Index k = random.integer(1, 8);
    const S radius = size * number(0.05, 0.3);
    std::vector<Vector3<S>> patch;
    for (Index i = 0; i < k; ++i) {
      const S r = k == 1 ? S(0) : radius;
      // 2 k is even, as circle_cosine needs it: every second of 2 k directions.
      const S c = circle_cosine<S>(2 * i, 2 * k), s = circle_sine<S>(2 * i, 2 * k);
      patch.push_back({x + r * c, y + r * s, side * half});
    }
    scene.add_body(Role::finger, {S(0), S(0), -side}, number(0.1, 1.2), patch);
    scene.drive_last_body(grip);
    // Some fingers squeeze unequally or past each other; in most grasps they do not.
    if (random.integer(0, 3) == 0) grip = number(2, 40);
    if (random.integer(0, 3) == 0) x += size * number(-0.3, 0.3);
  }
  const Index k = random.integer(1, 4);
  std::vector<Vector3<S>> edge;
  for (Index i = 0; i < k; ++i)
    edge.push_back({-size * S(0.5), size * number(-0.5, 0.5), half * number(-1, 1)});
  scene.add_body(Role::pusher, {S(1), S(0), S(0)}, number(0.1, 1.2), edge);
  const Vector3<S> push = Vector3<S>(S(1), S(0), S(0)) + S(0.7) * direction();
  scene.bodies.back().acceleration << number(0.1, 5) * push,
      number(0, 5) / size * S(0.1) * direction();
  return scene;
}

/// A workspace on the heap.
template <class S> struct OwnedWorkspace {
  std::vector<unsigned char> bytes;
  Workspace<S> work;

  explicit OwnedWorkspace(const AssemblySize& size)
      : bytes(static_cast<std::size_t>(push_bytes<S>(size))),
        work(make_workspace<S>({bytes.data(), static_cast<Index>(bytes.size())}, size)) {}
  OwnedWorkspace(const AssemblySize& size, Index shared)
      : bytes(static_cast<std::size_t>(structured_bytes<S>(size, shared))),
        work(make_structured_workspace<S>({bytes.data(), static_cast<Index>(bytes.size())}, size,
                                          shared)) {}
};

/// Memory for one of Lemke's two bases.
template <class Pivots, class S> OwnedWorkspace<S> workspace_for(const Scene<S>& scene) {
  if constexpr (std::is_same_v<Pivots, StructuredLemke<S>>)
    return {size_of(scene), scene.pressure == Pressure::even ? Index(0) : scene.actuators.size};
  else
    return OwnedWorkspace<S>(size_of(scene));
}

} // namespace lcpush::test
