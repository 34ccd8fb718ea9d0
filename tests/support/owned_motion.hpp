// Motions on the heap: closed forms and random runs.
#pragma once

#include <optional>

#include "lcpush/mechanics/solve/step.hpp"
#include "support/scenes.hpp"

namespace lcpush::test {

/// A motion with its scene, faces and memory.
template <class S> struct OwnedMotion {
  using Stepper = TimeStepper<S, StructuredLemke<S>>;
  OwnedScene<S> owned;
  std::vector<Touching> touching; ///< empty: every point on a plane without end
  std::vector<Face<S>> faces;
  std::vector<std::vector<Vector3<S>>> corners; ///< of the faces, in their order
  std::vector<RoundSide<S>> sides;
  Scene<S> scene{};
  Surroundings<S> around{};
  std::vector<unsigned char> bytes;
  std::optional<Stepper> motion; ///< once begun

  explicit OwnedMotion(const OwnedScene<S>& its_scene) : owned(its_scene) {}
  OwnedMotion(const OwnedMotion&) = delete;

  /// A rectangle on the object or a body.
  void add_face(const Vector3<S>& point, const Vector3<S>& normal, const Vector3<S>& half_a,
                const Vector3<S>& half_b) {
    Face<S> face;
    face.point = point;
    face.normal = normal;
    faces.push_back(face);
    const Vector3<S> both = half_a + half_b, across = half_a - half_b;
    corners.push_back({point - both, point + across, point + both, point - across});
  }

  /// Memory, and the start.
  Status begin() {
    scene = owned.view();
    for (std::size_t k = 0; k < corners.size(); ++k)
      faces[k].corners = {corners[k].data(), static_cast<Index>(corners[k].size())};
    around = {{touching.data(), static_cast<Index>(touching.size())},
              {faces.data(), static_cast<Index>(faces.size())},
              {sides.data(), static_cast<Index>(sides.size())}};
    const MotionSize size = motion_size(scene);
    motion.reset();
    const Index shared = scene.actuators.size;
    bytes.resize(static_cast<std::size_t>(structured_motion_bytes<S>(size, shared)));
    motion.emplace(scene, around, make_structured_motion_memory<S>(block(), size, shared));
    return motion->start();
  }
  Stepper& operator*() { return *motion; }
  Stepper* operator->() { return &*motion; }

private:
  Arena block() { return {bytes.data(), static_cast<Index>(bytes.size())}; }
};

/// A random grasp whose pusher moves at its acceleration times 20 ms. Every second one is a box
/// with faces that end, as large as the grasp's family makes it.
inline void begin_random(OwnedMotion<double>& run, std::uint64_t seed) {
  const Scene3& grasp = run.owned;
  if (seed % 2 == 1) {
    const double half_x = -grasp.points.back()[0], half_z = grasp.points[0][2];
    const Vec3 x(half_x, 0, 0), y(0, half_x, 0), z(0, 0, half_z);
    run.add_face(z, Vec3::UnitZ(), x, y);
    run.add_face(-z, -Vec3::UnitZ(), x, y);
    run.add_face(-x, -Vec3::UnitX(), y, z);
    for (Index b = 0; b < 3; ++b) run.touching.push_back({Riding::on_body, b, 0});
  }
  if (run.begin() != Status::running) return;
  run->prescribed(2) = 0.02 * grasp.bodies[2].acceleration;
}

} // namespace lcpush::test
