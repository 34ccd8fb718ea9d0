#include "hold/pad_surfaces.hpp"

#include <algorithm>

#include "hold/settings.hpp"
#include "lcpush/mechanics/model/patch.hpp"

namespace lcpush::desktop {
namespace {

/// A patch in its plane, from its points.
struct Surface {
  Vector3<double> center = Vector3<double>::Zero(), t, o;
  double half_t = 0, half_o = 0, radius = 0; ///< m

  Surface(const SceneFile& hand, const Body<double>& body)
      : t(body.tangent), o(cross<double>(body.normal, body.tangent)) {
    const Scene<double> scene = hand.view();
    for (const Index i : points_of(body)) center += weight_of(scene, body, i) * scene.points[i];
    for (const Index i : points_of(body)) {
      const Vector3<double> off = scene.points[i] - center;
      half_t = std::max(half_t, std::abs(t.dot(off)));
      half_o = std::max(half_o, std::abs(o.dot(off)));
      radius = std::max(radius, off.norm());
    }
  }
};

struct Sampled {
  std::vector<Vector3<double>> points;
  std::vector<double> weights;

  explicit Sampled(Index count)
      : points(static_cast<std::size_t>(count)), weights(static_cast<std::size_t>(count)) {}
  Span<Vector3<double>> places() { return {points.data(), static_cast<Index>(points.size())}; }
  Span<double> shares() { return {weights.data(), static_cast<Index>(weights.size())}; }
};

Sampled as_it_is(const SceneFile& hand, const Body<double>& body) {
  Sampled same(body.point_count);
  const Scene<double> scene = hand.view();
  for (Index i = 0; i < body.point_count; ++i) {
    same.places()[i] = scene.points[body.first_point + i];
    same.shares()[i] = weight_of(scene, body, body.first_point + i);
  }
  return same;
}

Sampled sampled(const SceneFile& hand, std::size_t b) {
  const Body<double>& body = hand.bodies[b];
  const PatchShape shape = b < hand.patches.size() ? hand.patches[b] : PatchShape::points;
  if (shape == PatchShape::points || body.point_count == 1) return as_it_is(hand, body);
  const Surface surface(hand, body);
  const Vector3<double>&c = surface.center, &t = surface.t, &o = surface.o;
  if (shape == PatchShape::line) {
    Sampled along(hold_settings.line_points);
    sample_line<double>(
        hand.points[static_cast<std::size_t>(body.first_point)],
        hand.points[static_cast<std::size_t>(body.first_point + body.point_count - 1)],
        along.places());
    line_weights(along.shares());
    return along;
  }
  if (shape == PatchShape::rectangle) {
    const Index sides_t = surface.half_t > 0 ? hold_settings.side_points : 1;
    const Index sides_o = surface.half_o > 0 ? hold_settings.side_points : 1;
    Sampled grid(sides_t * sides_o);
    sample_rectangle<double>(c, t, o, 2 * surface.half_t, 2 * surface.half_o, sides_t, sides_o,
                             grid.places());
    rectangle_weights(sides_t, sides_o, grid.shares());
    return grid;
  }
  Sampled round(shape == PatchShape::ring ? hold_settings.line_points : hold_settings.disc_points);
  if (shape == PatchShape::ring) {
    sample_ring<double>(c, t, o, surface.radius, round.places());
    equal_weights(round.shares());
    return round;
  }
  // Few points lie on one circle, inside the rim.
  Sampled few(body.point_count);
  sample_disc<double>(Vector3<double>::Zero(), t, o, 1, few.places());
  sample_disc<double>(c, t, o, surface.radius / few.points.back().norm(), round.places());
  disc_weights(round.shares());
  return round;
}

} // namespace

SceneFile with_surfaces(const SceneFile& hand) {
  SceneFile fine = hand;
  if (fine.is_round) fine.facets = hold_settings.unused_facets;
  fine.points.clear();
  fine.positions.clear();
  fine.weights.clear();
  for (std::size_t b = 0; b < hand.bodies.size(); ++b) {
    const Sampled patch = sampled(hand, b);
    fine.bodies[b].first_point = static_cast<Index>(fine.points.size());
    fine.bodies[b].point_count = static_cast<Index>(patch.points.size());
    fine.points.insert(fine.points.end(), patch.points.begin(), patch.points.end());
    fine.weights.insert(fine.weights.end(), patch.weights.begin(), patch.weights.end());
  }
  for (const Vector3<double>& point : fine.points)
    fine.positions.emplace_back(point + hand.object.center_of_mass);
  return fine;
}

std::vector<bool> touching_beside(const SceneFile& hand, const std::vector<bool>& touching,
                                  const SceneFile& other) {
  std::vector<bool> there;
  for (std::size_t b = 0; b < other.bodies.size(); ++b)
    for (const Index i : points_of(other.bodies[b])) {
      const auto off = [&](Index k) {
        return (hand.points[static_cast<std::size_t>(k)] -
                other.points[static_cast<std::size_t>(i)])
            .squaredNorm();
      };
      Index nearest = hand.bodies[b].first_point;
      for (const Index k : points_of(hand.bodies[b]))
        if (off(k) < off(nearest)) nearest = k;
      there.push_back(touching[static_cast<std::size_t>(nearest)]);
    }
  return there;
}

} // namespace lcpush::desktop
