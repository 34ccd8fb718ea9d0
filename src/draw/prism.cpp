#include "draw/prism.hpp"

#include <limits>

namespace lcpush::desktop {
namespace {

constexpr std::size_t most_drawn_sides = 8; // of more the edges are left out: it is round
constexpr int round_sides = 60;
constexpr double round_step = 2 * 3.14159265358979323846 / round_sides;

Vector3<double> product(const Vector3<double>& a, const Vector3<double>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

Vector3<double> middle_of(const std::vector<Vector3<double>>& points) {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const auto& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// A loop of corners and the outer normal of its plane.
struct Face {
  std::vector<Vector3<double>> loop;
  Vector3<double> outward;
};

/// The two ends, then the sides.
std::vector<Face> faces_of(const Prism& prism) {
  std::vector<Face> faces(2);
  faces[0] = {prism.base, -prism.along};
  faces[1].outward = prism.along;
  for (const auto& corner : prism.base) faces[1].loop.emplace_back(corner + prism.along);
  const Vector3<double> middle = middle_of(prism.base);
  for (std::size_t k = 0; k < prism.base.size(); ++k) {
    const Vector3<double>& a = prism.base[k];
    const Vector3<double>& b = prism.base[(k + 1) % prism.base.size()];
    Vector3<double> outward = product(b - a, prism.along);
    if (outward.dot(a - middle) < 0) outward = -outward;
    faces.push_back({{a, b, b + prism.along, a + prism.along}, outward});
  }
  return faces;
}

} // namespace

std::vector<Vector3<double>> corners_of(const Prism& prism) {
  std::vector<Vector3<double>> corners = prism.base;
  for (const auto& corner : prism.base) corners.emplace_back(corner + prism.along);
  return corners;
}

Prism box_prism(const Vector3<double>& center, const Vector3<double>& size) {
  const Vector3<double> low = center - size / 2;
  Prism prism;
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
    prism.base.emplace_back(low.x() + x * size.x(), low.y() + y * size.y(), low.z());
  prism.along = {0, 0, size.z()};
  return prism;
}

Prism cylinder_prism(const Vector3<double>& center, const Vector3<double>& size, Index axis) {
  const Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  Prism prism;
  prism.along = Vector3<double>::Zero();
  prism.along[axis] = size[axis];
  for (int k = 0; k < round_sides; ++k) {
    Vector3<double> corner = center - prism.along / 2;
    corner[u] += size[u] / 2 * std::cos(k * round_step);
    corner[v] += size[v] / 2 * std::sin(k * round_step);
    prism.base.push_back(corner);
  }
  return prism;
}

Prism ball_prism(const Vector3<double>& center, double radius) {
  Prism ball{{}, Vector3<double>::Zero()};
  for (int ring = 0; ring <= round_sides / 2; ++ring)
    for (int k = 0; k < round_sides; ++k) {
      const double across = std::sin(ring * round_step), along = std::cos(ring * round_step);
      const double x = across * std::cos(k * round_step), y = across * std::sin(k * round_step);
      ball.base.emplace_back(center + radius * Vector3<double>(x, y, along));
    }
  return ball;
}

Prism slab_prism(const std::vector<Vector3<double>>& carried, const Vector3<double>& normal,
                 const Vector3<double>& tangent, double margin, double thickness) {
  const Vector3<double> other = product(normal, tangent);
  constexpr double far = std::numeric_limits<double>::infinity();
  double low[3] = {far, far, far}, high[2] = {-far, -far};
  for (const auto& point : carried) {
    const double at[] = {point.dot(tangent), point.dot(other), point.dot(normal)};
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]);
    for (int k = 0; k < 2; ++k) high[k] = std::max(high[k], at[k]);
  }
  Prism prism;
  for (const auto& [s, t] :
       {std::pair(low[0] - margin, low[1] - margin), std::pair(high[0] + margin, low[1] - margin),
        std::pair(high[0] + margin, high[1] + margin),
        std::pair(low[0] - margin, high[1] + margin)})
    prism.base.emplace_back(s * tangent + t * other + (low[2] - thickness) * normal);
  prism.along = thickness * normal;
  return prism;
}

Prism rounded_prism(const std::vector<Vector3<double>>& points, const Vector3<double>& normal,
                    const Vector3<double>& tangent, double margin, double length) {
  const Vector3<double> other = product(normal, tangent);
  std::vector<Pixel> rim;
  for (const auto& point : points)
    for (int k = 0; k < round_sides; ++k)
      rim.emplace_back(point.dot(tangent) + margin * std::cos(k * round_step),
                       point.dot(other) + margin * std::sin(k * round_step));
  Prism prism{{}, -length * normal};
  for (const Pixel& at : hull(rim))
    prism.base.emplace_back(at.x() * tangent + at.y() * other + points[0].dot(normal) * normal);
  return prism;
}

double depth_below_surface(const Prism& prism, const Vector3<double>& point,
                           const Vector3<double>& along) {
  if (prism.along.isZero()) { // a ball
    const Vector3<double> to = middle_of(prism.base) - point;
    const double there = to.dot(along),
                 room = (prism.base[0] - middle_of(prism.base)).squaredNorm() - to.squaredNorm();
    return room > 0 ? there + std::sqrt(there * there + room) : 0;
  }
  double depth = std::numeric_limits<double>::infinity();
  for (const Face& face : faces_of(prism)) {
    const double below = face.outward.dot(face.loop[0] - point);
    if (below < 0) return 0;
    if (const double rate = face.outward.dot(along); rate > 0)
      depth = std::min(depth, below / rate);
  }
  return depth;
}

std::vector<std::vector<Vector3<double>>> faces_toward(const Prism& prism,
                                                       const Vector3<double>& toward) {
  std::vector<std::vector<Vector3<double>>> loops;
  std::size_t k = 0;
  for (const Face& face : faces_of(prism)) {
    const bool is_drawn = k++ < 2 || prism.base.size() <= most_drawn_sides;
    if (is_drawn && face.outward.dot(toward) > 1e-6 * face.outward.norm())
      loops.push_back(face.loop);
  }
  return loops;
}

} // namespace lcpush::desktop
