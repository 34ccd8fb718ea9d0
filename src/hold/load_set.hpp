// [T.19] The held loads of one kind beside the scene's own, a convex set: how far it reaches.
#pragma once

#include <optional>
#include <vector>

#include "hold/nearest_boundary.hpp"
#include "solve/grip_statics.hpp"

namespace lcpush::desktop {

/// { x : the load and sum_k x_k (column k) are held }, in the scene's force. What a planar scene
/// leaves out has no column, and is held in the box. Of statics under the law of pads: with the
/// points that touch.
class LoadSet {
public:
  /// `columns`: of x, y and z, those that are zero excepted; `size`: half the edge of the box to
  /// which the set is cut; none: it is not.
  LoadSet(const GripStatics& statics, const Eigen::MatrixXd& columns,
          const std::vector<ForceRay>& rays, std::optional<double> size = std::nullopt);

  /// The least height along +-x, +-y, +-z; none: a program failed.
  std::optional<double> least_along_axes();
  /// Pre: it is cut.
  std::optional<NearestBoundary> nearest(const Nearness& nearness);

private:
  std::vector<Index> axes_;
  Index moves_; ///< of pads: unknowns before those of the load
  std::optional<double> size_;
  std::optional<StaticsProgram> program_;

  std::optional<SupportPoint> end(const Vector3<double>& along);
};

} // namespace lcpush::desktop
