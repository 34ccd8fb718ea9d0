#include "cone/pusher_cone.hpp"

#include "draw/view.hpp"

#include <algorithm>
#include <limits>

namespace lcpush::desktop {
namespace {

/// How much of a point's friction can act along the plane: a pyramid's corners may lie beside it.
double planar_friction(const SceneFile& file, const Body<double>& body,
                       const Vector3<double>& along) {
  if (!(body.friction > 0) || file.is_round) return body.friction;
  double most = 0;
  for (Index k = 0; k < file.facets; ++k)
    most = std::max(most, generator(body, k, file.facets).force.dot(along));
  return body.friction * most;
}

} // namespace

double PusherCone::room(const Vector3<double>& wrench) const {
  double least = std::numeric_limits<double>::infinity();
  for (const ConeFace& face : faces)
    least = std::min(least, face.inward.dot(wrench) / wrench.norm());
  return least;
}

PusherCone pusher_cone(const SceneFile& file, Index pusher, double length) {
  const Body<double>& body = file.body(pusher);
  PusherCone cone;
  cone.along = cross<double>(Vector3<double>::UnitZ(), body.normal);
  const double mu = planar_friction(file, body, cone.along);
  std::vector<ExtremeWrench> all;
  std::vector<Pixel> flat; // (friction, torque) of a unit normal force
  for (const Index i : points_of(body))
    for (const double side : {1.0, -1.0}) {
      const Vector3<double> force = body.normal + side * mu * cone.along;
      const Vector6<double> w =
          wrench_column<double>(file.points[static_cast<std::size_t>(i)], force);
      all.push_back({i, side, planar_wrench(w, length), force});
      flat.push_back({side * mu, w[5] / length});
    }
  for (const std::size_t k : hull_corners(flat)) cone.edges.push_back(all[k]);
  const std::size_t count = cone.edges.size();
  if (count < 3) return cone;
  Vector3<double> middle = Vector3<double>::Zero();
  for (const ExtremeWrench& edge : cone.edges) middle += edge.wrench;
  for (std::size_t k = 0; k < count; ++k) {
    const ExtremeWrench &a = cone.edges[k], &b = cone.edges[(k + 1) % count];
    Vector3<double> inward = cross<double>(a.wrench, b.wrench).normalized();
    if (inward.dot(middle) < 0) inward = -inward;
    cone.faces.push_back({k, (k + 1) % count, inward, a.side == b.side});
  }
  return cone;
}

} // namespace lcpush::desktop
