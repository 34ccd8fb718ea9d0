#include "hold/patch_pressures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lcpush/mechanics/model/assemble.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {
namespace {

/// Twice the area of a triangle; > 0: to the left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  return u[0] * v[1] - u[1] * v[0];
}

Eigen::Vector2d place(const Eigen::MatrixXd& places, Index i) {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  for (Index k = 1; k < places.rows(); ++k) at[k - 1] = places(k, i);
  return at;
}

} // namespace

PatchPlaces patch_places(const Scene<double>& scene, const Body<double>& body) {
  const Index count = body.point_count;
  PatchPlaces patch{Eigen::VectorXd(count), Eigen::MatrixXd::Ones(1, count)};
  for (Index i = 0; i < count; ++i) patch.weights[i] = weight_of(scene, body, body.first_point + i);
  double size = 0;
  for (const Vector3<double>& axis : {body.tangent, cross<double>(body.normal, body.tangent)}) {
    Eigen::RowVectorXd row(count);
    for (Index i = 0; i < count; ++i)
      row[i] = axis.dot(scene.points[body.first_point + i] - scene.points[body.first_point]);
    for (Index k = 0; k < patch.places.rows(); ++k)
      row -= (row * patch.weights.asDiagonal()).dot(patch.places.row(k)) * patch.places.row(k);
    const double spread = std::sqrt((row * patch.weights.asDiagonal()).dot(row));
    size = std::max(size, spread);
    if (!(spread > statics_settings.line * size)) continue;
    patch.places.conservativeResize(patch.places.rows() + 1, Eigen::NoChange);
    patch.places.row(patch.places.rows() - 1) = row / spread;
  }
  return patch;
}

std::vector<Index> rim(const Eigen::MatrixXd& places) {
  std::vector<Index> order(static_cast<std::size_t>(places.cols())), hull;
  std::iota(order.begin(), order.end(), Index(0));
  if (order.size() < 2) return order;
  const auto at = [&](Index i) { return place(places, i); };
  std::sort(order.begin(), order.end(), [&](Index i, Index j) {
    const Eigen::Vector2d a = at(i), b = at(j);
    return std::pair(a[0], a[1]) < std::pair(b[0], b[1]);
  });
  for (int half = 0; half < 2; ++half) { // below from left to right, then back
    const std::size_t begin = hull.size();
    for (const Index i : order) {
      while (hull.size() > begin + 1 &&
             turn(at(hull[hull.size() - 2]), at(hull.back()), at(i)) <= statics_settings.flat)
        hull.pop_back();
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

Eigen::MatrixXd nonnegative_pressures(const Eigen::MatrixXd& places,
                                      const Eigen::VectorXd& weights) {
  const std::vector<Index> corners = rim(places);
  std::vector<Eigen::Vector3d> list; // value at the middle, slopes
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& slope, bool both) {
    for (const double sign : {1.0, -1.0})
      if (both || sign > 0)
        list.emplace_back(-sign * slope.dot(from), sign * slope[0], sign * slope[1]);
  };
  const auto across = [](const Eigen::Vector2d& along) {
    return Eigen::Vector2d(-along[1], along[0]);
  };
  const Eigen::Vector2d first = place(places, corners[0]);
  if (corners.size() == 1) {
    list.emplace_back(1, 0, 0);
    for (Index k = 1; k < places.rows(); ++k) add(first, Eigen::Vector2d::Unit(k - 1), true);
  } else if (corners.size() == 2) {
    const Eigen::Vector2d last = place(places, corners[1]);
    add(first, last - first, false);
    add(last, first - last, false);
    if (places.rows() > 2) add(first, across(last - first), true);
  } else {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Eigen::Vector2d a = place(places, corners[k]);
      add(a, across(place(places, corners[(k + 1) % corners.size()]) - a), false);
    }
  }
  Eigen::MatrixXd pressures(places.rows(), static_cast<Index>(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Eigen::VectorXd P = list[k].head(places.rows());
    const double sum = weights.dot(places.transpose() * P);
    pressures.col(static_cast<Index>(k)) =
        P / (sum > statics_settings.flat * P.norm() ? sum : P.norm());
  }
  return pressures;
}

} // namespace lcpush::desktop
