// The limit surface of a grip across the plane: which planar wrenches its friction can resist, and
// in which motion it gives way to each [T.17].
//
// Planar wrenches are (f_x, f_y, torque / L) in N, planar twists (v_x, v_y, omega L): their product
// is a power. Both are taken at the object's centre of mass; L is a length of the scene.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <vector>

namespace lcpush::desktop {

/// (v_x, v_y, omega) as a planar twist, and [f; torque] as a planar wrench.
inline Vector3<double> planar_twist(const Vector6<double>& twist, double length) {
  return {twist[0], twist[1], twist[5] * length};
}
inline Vector3<double> planar_wrench(const Vector6<double>& wrench, double length) {
  return {wrench[0], wrench[1], wrench[5] / length};
}
/// About z.
Vector3<double> turned(const Vector3<double>& v, double angle);
Vector6<double> spatial_twist(const Vector3<double>& twist, double length);
Vector6<double> spatial_wrench(const Vector3<double>& wrench, double length);

/// x of A x = b, by Cramer's rule; not finite where A is singular.
inline Eigen::Vector2d solved(const Eigen::Matrix2d& A, const Eigen::Vector2d& b) {
  const double determinant = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
  return Eigen::Vector2d(b[0] * A(1, 1) - A(0, 1) * b[1], A(0, 0) * b[1] - b[0] * A(1, 0)) /
         determinant;
}

/// A twist or a wrench so near that it differs in nothing but ties: where a point's friction may be
/// either of two generators, or a ray meets an edge, there it is one of the sides.
Vector3<double> beside(const Vector3<double>& v);

/// Where a ray leaves the limit surface.
struct Crossing {
  double force;          ///< k >= 0: the ray's parameter
  Vector3<double> twist; ///< normal of the surface there: its product with the ray's direction is 1
};

/// The fingers' points, before it is known where the object is between them.
class GripPoints {
public:
  /// Of the file's fingers, each with its force. Pre: they press along z, in a planar scene, and
  /// their pressure is no open question (see find_cone).
  explicit GripPoints(const SceneFile& file);

  std::size_t size() const { return points_.size(); }
  /// Scene's frame, from the object's first centre of mass.
  const Vector3<double>& place(std::size_t point) const { return points_[point].place; }

private:
  friend class LimitSurface;
  struct Point {
    Vector3<double> place;
    std::size_t body;
    double limit;                            ///< N: mu lambda while its whole patch touches
    std::vector<Generator<double>> friction; ///< of a round cone its axes; all of them along z
    Vector3<double> normal;
  };
  std::vector<Point> points_;
  bool is_round_;
};

class LimitSurface {
public:
  /// In the object's axes, with its centre of mass at `center` and turned by `angle` about z, as
  /// friction's directions then are (they turn with the face); of each patch the points in
  /// `touches` share the patch's force in the same proportions, all of them if it is empty.
  LimitSurface(const GripPoints& grip, double length,
               const Vector3<double>& center = Vector3<double>::Zero(), double angle = 0,
               const std::vector<bool>& touches = {});

  /// The most power with which a motion can be resisted, and one wrench that does: the fingers'
  /// friction on the object is its negative. [T.17]
  double power(const Vector3<double>& twist) const { return resistance(twist).dot(twist); }
  Vector3<double> resistance(const Vector3<double>& twist) const;

  /// Has each patch a point that touches?
  bool touches_everywhere() const { return touches_everywhere_; }
  /// Is every direction resisted?
  bool is_solid() const;
  /// Does nothing press, so that no direction is resisted?
  bool is_empty() const;
  /// The ray load + k direction from inside. Pre: is_solid, the load is held.
  Crossing crossing(const Vector3<double>& load, const Vector3<double>& direction) const;
  /// By what factor all grip forces may shrink before they do not hold it: 0 for no load.
  double share_of(const Vector3<double>& load) const;
  /// Are the points' cones round? Then the surface is smooth almost everywhere.
  bool is_round() const { return is_round_; }

private:
  /// A point's friction: the wrenches of its generators; of a round cone of its axes.
  struct PointFriction {
    std::size_t first, count;
  };
  std::vector<Vector3<double>> wrenches_; ///< N, times mu lambda
  std::vector<PointFriction> points_;
  bool is_round_, touches_everywhere_ = true;

  void add(const GripPoints::Point& point, double share, double length, const Vector3<double>& at);
  Vector3<double> polished(const Vector3<double>& load, const Vector3<double>& direction,
                           Vector3<double> twist) const;
};

} // namespace lcpush::desktop
