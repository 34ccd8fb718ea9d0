#include "scenes/object_surface.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// A convex object as slabs: along each direction `along` it ends at `half`.
struct Slab {
  Vector3<double> along; ///< unit, toward the point's side
  double place;          ///< m, of the point along it, >= 0
  double half;           ///< m
};

/// Those of a box are its three axes; those of a cylinder the axis and the radius through `d`, of a
/// ball the latter alone.
std::vector<Slab> slabs_toward(const ObjectShape& shape, const Vector3<double>& d) {
  std::vector<Slab> slabs;
  const auto add = [&](const Vector3<double>& along, double half) {
    const double place = along.dot(d);
    slabs.push_back({place < 0 ? Vector3<double>(-along) : along, std::abs(place), half});
  };
  if (shape.kind == ObjectShape::Kind::box) {
    for (Index i = 0; i < 3; ++i) add(Vector3<double>::Unit(i), shape.size[i] / 2);
    return slabs;
  }
  const bool is_ball = shape.kind == ObjectShape::Kind::ball;
  const Vector3<double> axis = Vector3<double>::Unit(shape.axis);
  const Vector3<double> radial = is_ball ? d : Vector3<double>(d - axis.dot(d) * axis);
  const Index across = (shape.axis + 1) % 3;
  if (!is_ball) add(axis, shape.size[shape.axis] / 2);
  add(radial.norm() > 0 ? Vector3<double>(radial.normalized()) : Vector3<double>::Unit(across),
      shape.size[across] / 2);
  return slabs;
}

} // namespace

SurfacePoint nearest_on_surface(const SceneFile& file, const Vector3<double>& position,
                                double reach) {
  const Vector3<double> d = position - file.object.center_of_mass;
  const std::vector<Slab> slabs = slabs_toward(file.shape, d);
  const auto depth = [](const Slab& slab) { return slab.half - slab.place; };
  const auto nearest =
      std::min_element(slabs.begin(), slabs.end(),
                       [&](const Slab& a, const Slab& b) { return depth(a) < depth(b); });
  SurfacePoint surface{-depth(*nearest), position, {}};
  if (surface.distance <= 0) {
    surface.at += depth(*nearest) * nearest->along;
  } else {
    for (const Slab& slab : slabs) surface.at += std::min(depth(slab), 0.0) * slab.along;
    surface.distance = (position - surface.at).norm();
  }
  for (const Slab& slab : slabs)
    if (std::abs(slab.along.dot(surface.at - file.object.center_of_mass) - slab.half) <= reach)
      surface.outward.push_back(slab.along);
  return surface;
}

} // namespace lcpush::desktop
