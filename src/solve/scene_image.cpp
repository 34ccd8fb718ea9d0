#include "solve/scene_image.hpp"

namespace lcpush::desktop {

Vector6<double> SceneImage::of_twist(const Vector6<double>& twist) const {
  Vector6<double> image;
  image << of_vector(twist.head<3>()), of_turn(twist.tail<3>());
  return image;
}

/// A pyramid's generators come in pairs on both sides of the tangent: the set of directions is its
/// image's, though in another order.
SceneFile SceneImage::of(const SceneFile& file) const {
  SceneFile image = file;
  image.object.inertia = signs_.asDiagonal() * file.object.inertia * signs_.asDiagonal();
  image.object.center_of_mass = of_vector(file.object.center_of_mass);
  image.gravity = of_vector(file.gravity);
  for (Vector3<double>& p : image.points) p = of_vector(p);
  for (Vector3<double>& p : image.positions) p = of_vector(p);
  for (Body<double>& body : image.bodies) {
    body.normal = of_vector(body.normal);
    body.tangent = of_vector(body.tangent);
    body.acceleration = of_twist(body.acceleration);
  }
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
