// The complementary cones of two pairs, in the plane of q.
#pragma once

#include <string>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

using Plane = Eigen::Vector2d;

/// What q is a sum of: the columns of w1, w2, z1 and z2, which are I's and -M's.
struct ConeColumns {
  std::vector<Plane> columns;
  std::vector<std::string> names;
};

/// From the plane of q to the pixels of a square picture: the origin and these points in sight.
class ConeView {
public:
  static constexpr double side = 480, edge = 46; ///< of the picture, and about what is shown

  explicit ConeView(const std::vector<Plane>& shown);
  Pixel operator()(const Plane& p) const {
    return {side / 2 + unit_ * (p.x() - middle_.x()), side / 2 - unit_ * (p.y() - middle_.y())};
  }
  /// Where a ray from the origin leaves the picture, less a `margin`.
  Pixel end_of(const Plane& ray, double margin) const;
  /// So far away that it is out of sight.
  double far() const { return 4 * side / unit_; }

private:
  Plane middle_;
  double unit_;
};

/// The cones with their names, and their borders. They look as cone_style() says.
std::string cone_elements(const ConeColumns& cones, const ConeView& view);
std::string cone_style();

} // namespace lcpush::desktop
