// What studies of a grasp share: their memory, who grips, and the extreme rays of contacts' cones.
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"

namespace lcpush {

/// Of the existence lemma's conditions.
template <class S> struct StudyMemory {
  Span<S> scalars;    ///< ExistenceSize::scalars()
  Span<int> integers; ///< ExistenceSize::integers()
};

/// Does the actuator drive a finger, so that a factor on the grip scales it?
template <class S> bool grips(const Scene<S>& scene, Index actuator) {
  for (const Drive<S>& drive : scene.drives)
    if (drive.actuator == actuator && scene.bodies[drive.body].role == Role::finger) return true;
  return false;
}

namespace detail {

/// Extreme rays of a point's cone: visit(normal, friction), columns of G, equal without friction.
template <class S, class Visit>
void for_each_ray(const ConeGroup<S>& cone, const Visit& visit, bool smooth = false) {
  for (Index normal = cone.force; normal < cone.force + cone.normals; ++normal) {
    if (smooth || cone.generators == 0) visit(normal, normal);
    for (Index j = 0; !smooth && j < cone.generators; ++j)
      visit(normal, cone.force + cone.normals + j);
  }
}

} // namespace detail

} // namespace lcpush
