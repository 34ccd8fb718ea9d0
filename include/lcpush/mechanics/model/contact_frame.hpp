// The tangent of a contact: the direction of its first friction generator.
#pragma once

#include "lcpush/types.hpp"

#include <cmath>

namespace lcpush {

/// The unit vector along the projection of `direction` onto the plane orthogonal to `normal`.
/// Preconditions: `normal` is a unit vector, `direction` is not parallel to it.
template <class S> Vector3<S> tangent_along(const Vector3<S>& normal, const Vector3<S>& direction) {
  return (direction - normal * normal.dot(direction)).normalized();
}

/// The tangent of a contact that names none: along the projection of the axis (x, y or z) least
/// aligned with `normal`, the first of them on a tie. Precondition: `normal` is a unit vector.
template <class S> Vector3<S> default_tangent(const Vector3<S>& normal) {
  using std::abs;
  Index axis = 0;
  for (Index i = 1; i < 3; ++i)
    if (abs(normal[i]) < abs(normal[axis])) axis = i;
  return tangent_along<S>(normal, Vector3<S>::Unit(axis));
}

} // namespace lcpush
