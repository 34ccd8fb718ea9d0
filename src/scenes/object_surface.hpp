// The surface of the object: how far a point is from it, and what faces it there.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

// The cosine between a normal and the face that it should point into. Less, and it lies along it.
constexpr double least_into = 0.05;
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

/// Is what lies so far (m) from the surface meant to be on it?
bool lies_on_surface(const SceneFile& file, double distance);
/// "the box"
std::string shape_name(const SceneFile& file);
/// "[0.04, 0, 0]"
std::string typed_vector(const Vector3<double>& v);

} // namespace lcpush::desktop
