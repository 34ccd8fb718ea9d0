// Even pressure: every point of a driven patch becomes a force-controlled pad of its own.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// How many bodies the spread scene has, and drives; every drive has its actuator.
struct EvenSize {
  Index bodies = 0, drives = 0;
};

/// Arrays of at least even_size's lengths; the caller's, and the spread scene lives in them.
template <class S> struct EvenMemory {
  Span<Body<S>> bodies;
  Span<Actuator<S>> actuators;
  Span<Drive<S>> drives;
};

template <class S> EvenSize even_size(const Scene<S>& scene) {
  EvenSize size;
  for (Index b = 0; b < scene.bodies.size; ++b)
    size.bodies += is_driven(scene, b) ? scene.bodies[b].point_count : 1;
  for (const Drive<S>& drive : scene.drives) size.drives += scene.bodies[drive.body].point_count;
  return size;
}

/// Is there something to spread? A driven point is a pad of its own already.
template <class S> bool has_driven_patch(const Scene<S>& scene) {
  return even_size(scene).bodies > scene.bodies.size;
}

/// Does an actuator drive several bodies? Then no point's share of its force is known.
template <class S> bool shares_an_actuator(const Scene<S>& scene) {
  for (const Drive<S>& drive : scene.drives)
    if (drive_count(scene, drive.actuator) > 1) return true;
  return false;
}

/// [T.7] Even: a driven body of k points becomes k bodies of one point each; each of its actuators
/// becomes k, with their points' shares of its force and inertia and the same twist. Other bodies
/// stay. A scene of another pressure law comes back as it is. Points keep their order, bodies get
/// new indices. Post: solved; or bad_input if the memory is too small or shares_an_actuator(scene).
/// `spread` may be the scene itself. Cost: O(bodies drives + points).
template <class S>
[[nodiscard]] Status spread_evenly(const Scene<S>& scene, const EvenMemory<S>& memory,
                                   Scene<S>& spread) {
  spread = scene;
  if (!presses_evenly(scene)) return Status::solved;
  const EvenSize size = even_size(scene);
  if (shares_an_actuator(scene) || memory.bodies.size < size.bodies ||
      memory.actuators.size < size.drives || memory.drives.size < size.drives)
    return Status::bad_input;
  Index bodies = 0, drives = 0;
  for (Index b = 0; b < scene.bodies.size; ++b) {
    const Index k = scene.bodies[b].point_count;
    if (!is_driven(scene, b)) {
      memory.bodies[bodies++] = scene.bodies[b];
      continue;
    }
    for (Index i = 0; i < k; ++i) {
      Body<S>& pad = memory.bodies[bodies++];
      pad = scene.bodies[b];
      pad.first_point += i;
      pad.point_count = 1;
      for (const Drive<S>& drive : scene.drives) {
        if (drive.body != b) continue;
        const Actuator<S>& whole = scene.actuators[drive.actuator];
        const S share = weight_of(scene, scene.bodies[b], pad.first_point);
        memory.actuators[drives] = {whole.force * share, whole.inertia * share};
        memory.drives[drives] = {bodies - 1, drives, drive.twist};
        ++drives;
      }
    }
  }
  spread.bodies = {memory.bodies.data, bodies};
  spread.actuators = {memory.actuators.data, drives};
  spread.drives = {memory.drives.data, drives};
  spread.weights = {}; // no patch shares a force any more
  return Status::solved;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template Status spread_evenly<double>(const Scene<double>&, const EvenMemory<double>&,
                                             Scene<double>&);
#endif

} // namespace lcpush
