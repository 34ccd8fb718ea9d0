// A scene seen in mirrors: other numbers, the same mechanics. Pivots take another path there, and
// where the laws leave open what happens, they may well end in another answer.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <vector>

namespace lcpush::desktop {

/// Which of the axes x, y, z turn into their opposites: one is a mirror, two are half a turn.
class SceneImage {
public:
  explicit SceneImage(const Vector3<double>& signs) : signs_(signs) {}

  /// A force, a place, an acceleration of a point.
  Vector3<double> of_vector(const Vector3<double>& v) const { return signs_.cwiseProduct(v); }
  /// A turn, a moment.
  Vector3<double> of_turn(const Vector3<double>& v) const {
    return signs_.prod() * signs_.cwiseProduct(v);
  }
  /// [vector; turn], as twists and wrenches are.
  Vector6<double> of_twist(const Vector6<double>& twist) const;
  /// A patch that is its own image keeps the order of its points: the forces on them change places.
  SceneFile of(const SceneFile& file) const;

private:
  Vector3<double> signs_;
};

/// All but the scene itself; a planar one stays in its plane.
std::vector<SceneImage> scene_images(const SceneFile& file);

} // namespace lcpush::desktop
