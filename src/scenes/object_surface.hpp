// The surface of the object: how far a point is from it, and what faces it there.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <vector>

namespace lcpush::desktop {

// A contact belongs to the surface if it is off by less than this part of the object's size: models
// round edges off and leave grooves out.
constexpr double surface_slack = 0.05;

struct SurfacePoint {
  double distance;                      ///< m, positive outside
  Vector3<double> at;                   ///< the nearest point of the surface, scene's frame
  std::vector<Vector3<double>> outward; ///< unit normals of the faces that meet there
};

/// Needs a shape that is known. `reach` (m): faces within it of the nearest point count as met.
SurfacePoint nearest_on_surface(const SceneFile& file, const Vector3<double>& position,
                                double reach);

} // namespace lcpush::desktop
