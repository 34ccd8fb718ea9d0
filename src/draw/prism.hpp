// Boxes, cylinders and slabs in space, as prisms.
#pragma once

#include <vector>

#include "draw/view.hpp"

namespace lcpush::desktop {

/// A plane polygon, and the edge that extrudes it.
struct Prism {
  std::vector<Vector3<double>> base;
  Vector3<double> along;
};

/// The corners of both ends.
std::vector<Vector3<double>> corners_of(const Prism& prism);

Prism box_prism(const Vector3<double>& center, const Vector3<double>& size);
/// About axis 0, 1 or 2; `size` is what encloses it.
Prism cylinder_prism(const Vector3<double>& center, const Vector3<double>& size, Index axis);
/// As points all over it, without an edge to extrude them: their hull is round from anywhere.
Prism ball_prism(const Vector3<double>& center, double radius);
/// A slab of this thickness behind what it carries: its face, across `normal`, reaches `margin`
/// beyond all of them.
Prism slab_prism(const std::vector<Vector3<double>>& carried, const Vector3<double>& normal,
                 const Vector3<double>& tangent, double margin, double thickness);

/// Behind points of a plane across `normal`: a prism `length` long, whose face reaches `margin`
/// beyond each of them.
Prism rounded_prism(const std::vector<Vector3<double>>& points, const Vector3<double>& normal,
                    const Vector3<double>& tangent, double margin, double length);

/// How far a point lies below the prism's surface along a direction: 0 on it or outside.
double depth_below_surface(const Prism& prism, const Vector3<double>& point,
                           const Vector3<double>& along);

/// Where points are drawn: one that is taken at the object's centre stands on its surface, where
/// its body (anything with points and a normal) comes from.
template <class Body>
std::vector<Vector3<double>> positions_beside(const Prism& object, const Vector3<double>& center,
                                              std::vector<Vector3<double>> positions,
                                              const std::vector<Body>& bodies) {
  const double near = 1e-6 * (object.base[0] - center).norm();
  for (const Body& body : bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      Vector3<double>& at = positions[static_cast<std::size_t>(i)];
      if ((at - center).norm() > near) continue;
      const Vector3<double> back = -body.normal;
      at += depth_below_surface(object, at, back) * back;
    }
  return positions;
}

/// As drawn: what encloses it, and of the faces that the viewer sees the ends and, of a few-sided
/// prism, the sides.
struct PrismPicture {
  std::vector<Pixel> outline;
  std::vector<std::vector<Pixel>> faces;
};
/// The loops of the faces whose outer side is turned to the viewer.
std::vector<std::vector<Vector3<double>>> faces_toward(const Prism& prism,
                                                       const Vector3<double>& toward);

/// `place` maps points to pixels.
template <class Place>
PrismPicture picture_of(const Prism& prism, const View& view, const Place& place) {
  PrismPicture picture;
  std::vector<Pixel> corners;
  for (const auto& corner : corners_of(prism)) corners.push_back(place(corner));
  picture.outline = hull(corners);
  for (const auto& loop : faces_toward(prism, view.toward)) {
    picture.faces.emplace_back();
    for (const auto& corner : loop) picture.faces.back().push_back(place(corner));
  }
  return picture;
}

} // namespace lcpush::desktop
