#include "hold/load_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hold/settings.hpp"

namespace lcpush::desktop {

using Ending = StaticsProgram::Ending;

LoadSet::LoadSet(const GripStatics& statics, const Eigen::MatrixXd& columns,
                 const std::vector<ForceRay>& rays, std::optional<double> size)
    : moves_(statics.displacement().cols()), size_(size) {
  for (Index k = 0; k < columns.cols(); ++k)
    if (!columns.col(k).isZero(0)) axes_.push_back(k);
  const auto count = static_cast<Index>(axes_.size());
  // x_k + s = size and x_k - s = -size, the slacks s not negative.
  const Index rows = statics.rows(), sides = size ? 2 * count : 0;
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(rows + sides, moves_ + count + sides);
  if (moves_ > 0) D.topLeftCorner(rows, moves_) = statics.displacement();
  Eigen::VectorXd b(rows + sides);
  b.head(rows) = statics.load(1);
  for (Index k = 0; k < count; ++k) {
    D.col(moves_ + k).head(rows) = columns.col(axes_[static_cast<std::size_t>(k)]);
    for (Index side = 0; size && side < 2; ++side) {
      const Index row = rows + 2 * k + side;
      const double sign = side == 0 ? 1 : -1;
      D(row, moves_ + k) = 1;
      D(row, moves_ + count + 2 * k + side) = sign;
      b[row] = sign * *size;
    }
  }
  program_.emplace(statics, D, moves_ + count, b, rays);
  if (count == 0 || program_->find_point() != Ending::found) program_.reset();
}

std::optional<SupportPoint> LoadSet::end(const Vector3<double>& along) {
  if (!program_) return std::nullopt;
  SupportPoint there{Vector3<double>::Zero(), 0};
  const auto count = static_cast<Index>(axes_.size());
  Eigen::VectorXd costs = Eigen::VectorXd::Zero(moves_ + count);
  for (Index k = 0; k < count; ++k) costs[moves_ + k] = -along[axes_[static_cast<std::size_t>(k)]];
  if (costs.cwiseAbs().maxCoeff() > 0) {
    const auto found = program_->minimise(costs);
    if (found.x.size() == 0) return std::nullopt;
    for (Index k = 0; k < count; ++k)
      there.point[axes_[static_cast<std::size_t>(k)]] = found.x[moves_ + k];
    there.height = -found.bound;
  }
  for (Index k = 0; size_ && k < 3; ++k) {
    if (std::find(axes_.begin(), axes_.end(), k) != axes_.end()) continue;
    there.point[k] = along[k] < 0 ? -*size_ : *size_;
    there.height += std::abs(along[k]) * *size_;
  }
  return there;
}

std::optional<double> LoadSet::least_along_axes() {
  double least = std::numeric_limits<double>::infinity();
  for (const Index axis : axes_)
    for (const double sign : {1.0, -1.0}) {
      const auto there = end(sign * Vector3<double>(Vector3<double>::Unit(axis)));
      if (!there) return std::nullopt;
      least = std::min(least, there->height);
    }
  return least;
}

std::optional<NearestBoundary> LoadSet::nearest(const Nearness& nearness) {
  const auto support = [this](const Vector3<double>& along) { return end(along); };
  const auto is_used_up = [this] {
    return program_ && program_->work() > hold_settings.nearest_work;
  };
  const bool has_pads = moves_ > 0;
  return nearest_boundary(support, nearness, has_pads ? hold_settings.law : hold_settings.bracket,
                          is_used_up);
}

} // namespace lcpush::desktop
