// Pressures that are affine over a patch, as displacements of a pad make them [T.7].
#pragma once

#include <vector>

#include "lcpush/mechanics/model/scene.hpp"
#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// A body's points: their weights, and 1 with up to two coordinates in the contact plane, one
/// column a point, orthonormal under the weights.
struct PatchPlaces {
  Eigen::VectorXd weights;
  Eigen::MatrixXd places;
};
PatchPlaces patch_places(const Scene<double>& scene, const Body<double>& body);

/// Columns P whose sums with factors >= 0 are all the pressures P' places >= 0 at these points: of
/// weighted sum 1, or 0 at every point.
Eigen::MatrixXd nonnegative_pressures(const Eigen::MatrixXd& places,
                                      const Eigen::VectorXd& weights);

/// The corners of the points' hull, around it: what is affine and nowhere positive there is so at
/// all of them.
std::vector<Index> rim(const Eigen::MatrixXd& places);

} // namespace lcpush::desktop
