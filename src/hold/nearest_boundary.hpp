// The point of a convex set's boundary that is nearest to its inside's origin, from nothing but its
// support: a polytope of boundary points grows inside the set where it is thinnest.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// Where the set ends along a direction.
struct SupportPoint {
  Vector3<double> point;
  double height; ///< no point of the set is higher along it
};

struct NearestBoundary {
  Vector3<double> direction = Vector3<double>::Zero();    ///< unit, outward: the set ends there at
  double lower = 0;                                       ///< at least this
  double upper = std::numeric_limits<double>::infinity(); ///< and at most that, from the origin
};

using SupportQuestion = std::function<std::optional<SupportPoint>(const Vector3<double>& along)>;
/// How near a plane is: of its unit normal and its height, growing with the height. `lower` and
/// `upper` are such numbers.
using Nearness = std::function<double(const Vector3<double>& normal, double height)>;

/// Of a set that contains the origin, to a bracket of that, relative, or as near as it was when
/// `is_used_up`. None: a question failed before anything was known.
std::optional<NearestBoundary> nearest_boundary(const SupportQuestion& support,
                                                const Nearness& nearness, double bracket,
                                                const std::function<bool()>& is_used_up);

} // namespace lcpush::desktop
