#include "scenes/mirror.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double mirror_slack = 1e-9; // of the numbers compared

Vector3<double> mirrored(Vector3<double> v, Index axis) {
  v[axis] = -v[axis];
  return v;
}

template <class A, class B> bool are_close(const A& a, const B& b) {
  return (a - b).norm() <= mirror_slack * (1 + a.norm() + b.norm());
}

/// The same drives: forces, inertias and how they move the body, seen in the mirror.
bool drives_match(const SceneFile& file, Index b, Index image, Index axis) {
  const auto has_match = [&](const Drive<double>& drive, Index other) {
    const auto& mine = file.actuators[static_cast<std::size_t>(drive.actuator)];
    return std::any_of(file.drives.begin(), file.drives.end(), [&](const Drive<double>& theirs) {
      const auto& held = file.actuators[static_cast<std::size_t>(theirs.actuator)];
      return theirs.body == other && held.force == mine.force && held.inertia == mine.inertia &&
             are_close(theirs.twist, mirrored_twist(drive.twist, axis));
    });
  };
  return std::all_of(file.drives.begin(), file.drives.end(), [&](const Drive<double>& drive) {
    return (drive.body != b || has_match(drive, image)) &&
           (drive.body != image || has_match(drive, b));
  });
}

bool bodies_match(const SceneFile& file, Index b, Index image, Index axis) {
  const Body<double>&one = file.body(b), &two = file.body(image);
  if (one.role != two.role || one.friction != two.friction ||
      one.torsion_radius != two.torsion_radius || one.bilateral != two.bilateral ||
      one.point_count != two.point_count || !are_close(two.normal, mirrored(one.normal, axis)) ||
      !are_close(two.acceleration, mirrored_twist(one.acceleration, axis)) ||
      !drives_match(file, b, image, axis))
    return false;
  const Scene<double> scene = file.view();
  const auto place = [&](Index i) { return file.points[static_cast<std::size_t>(i)]; };
  const Indices points = points_of(one), images = points_of(two);
  return std::all_of(points.begin(), points.end(), [&](Index i) {
    return std::any_of(images.begin(), images.end(), [&](Index j) {
      return (place(j) - mirrored(place(i), axis)).norm() <= mirror_slack * place(i).norm() &&
             std::abs(weight_of(scene, one, i) - weight_of(scene, two, j)) <= mirror_slack;
    });
  });
}

bool is_mirrored(const SceneFile& file, Index axis) {
  const Matrix3<double>& inertia = file.object.inertia;
  for (Index k = 0; k < 3; ++k)
    if (k != axis && std::abs(inertia(k, axis)) > mirror_slack * inertia.norm()) return false;
  if (file.gravity[axis] != 0 ||
      !are_close(file.object.wrench, mirrored_twist(file.object.wrench, axis)))
    return false;
  const auto count = static_cast<Index>(file.bodies.size());
  for (Index b = 0; b < count; ++b) {
    bool found = false;
    for (Index image = 0; image < count && !found; ++image)
      found = bodies_match(file, b, image, axis);
    if (!found) return false;
  }
  return true;
}

} // namespace

Vector6<double> mirrored_twist(const Vector6<double>& twist, Index axis) {
  Vector6<double> image;
  image << mirrored(twist.head<3>(), axis), -mirrored(twist.tail<3>(), axis);
  return image;
}

std::vector<Index> mirror_axes(const SceneFile& file) {
  std::vector<Index> axes;
  for (Index axis = 0; axis < 3; ++axis)
    if (is_mirrored(file, axis)) axes.push_back(axis);
  return axes;
}

bool is_plane(const SceneFile& file) {
  const auto is_flat = [](const Body<double>& body) {
    const double across = std::abs(body.normal.z());
    return across <= mirror_slack || across >= 1 - mirror_slack;
  };
  return !file.planar && std::all_of(file.bodies.begin(), file.bodies.end(), is_flat) &&
         is_mirrored(file, 2);
}

} // namespace lcpush::desktop
