#include "solve/scene_image.hpp"

#include <algorithm>
#include <utility>

namespace lcpush::desktop {
namespace {

/// The points of a patch that is its own image in the order that they had: as a person would write
/// the image down. Places, positions and weights alike.
void restore_order(const SceneFile& file, const Body<double>& body, SceneFile& image) {
  constexpr double slack = 1e-9;
  const Indices points = points_of(body);
  const auto at = [](const SceneFile& scene, Index i) -> const Vector3<double>& {
    return scene.points[static_cast<std::size_t>(i)];
  };
  Vector3<double> shift = Vector3<double>::Zero();
  for (const Index i : points)
    shift += (at(image, i) - at(file, i)) / static_cast<double>(body.point_count);
  SceneFile ordered = image;
  for (const Index i : points) {
    const auto is_there = [&](Index k) {
      return (at(image, k) - at(file, i) - shift).norm() <= slack * at(file, i).norm();
    };
    const auto found = std::find_if(points.begin(), points.end(), is_there);
    if (found == points.end()) return; // another patch: its order says nothing
    const auto here = static_cast<std::size_t>(i), there = static_cast<std::size_t>(*found);
    ordered.points[here] = image.points[there];
    ordered.positions[here] = image.positions[there];
    if (!image.weights.empty()) ordered.weights[here] = image.weights[there];
  }
  image = std::move(ordered);
}

/// A tangent and its opposite have the same generators. A file's own rule takes the one along the
/// world's axis, not against it.
Vector3<double> turned_back(const Vector3<double>& image, const Vector3<double>& tangent) {
  Index axis = 0;
  tangent.cwiseAbs().maxCoeff(&axis);
  return image[axis] * tangent[axis] < 0 ? Vector3<double>(-image) : image;
}

} // namespace

Vector6<double> SceneImage::of_twist(const Vector6<double>& twist) const {
  Vector6<double> image;
  image << of_vector(twist.head<3>()), of_turn(twist.tail<3>());
  return image;
}

/// A pyramid's generators come in pairs on both sides of the tangent: the set of directions is its
/// image's. Their order, and the points', is another, so that pivots take another path.
SceneFile SceneImage::of(const SceneFile& file) const {
  SceneFile image = file;
  image.object.inertia = signs_.asDiagonal() * file.object.inertia * signs_.asDiagonal();
  image.object.center_of_mass = of_vector(file.object.center_of_mass);
  image.object.wrench = of_twist(file.object.wrench);
  image.gravity = of_vector(file.gravity);
  for (Vector3<double>& p : image.points) p = of_vector(p);
  for (Vector3<double>& p : image.positions) p = of_vector(p);
  for (Body<double>& body : image.bodies) {
    body.normal = of_vector(body.normal);
    body.tangent = turned_back(of_vector(body.tangent), body.tangent);
    body.acceleration = of_twist(body.acceleration);
  }
  for (const Body<double>& body : file.bodies) restore_order(file, body, image);
  for (Drive<double>& drive : image.drives) drive.twist = of_twist(drive.twist);
  return image;
}

std::vector<SceneImage> scene_images(const SceneFile& file) {
  std::vector<SceneImage> images;
  for (const double z : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double x : {1.0, -1.0})
        if ((x < 0 || y < 0 || z < 0) && !(file.planar && z < 0))
          images.emplace_back(Vector3<double>(x, y, z));
  return images;
}

} // namespace lcpush::desktop
