#include "solve/told_force.hpp"

#include <algorithm>
#include <limits>

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush::desktop {

namespace {

constexpr double left_of_force = 64 * std::numeric_limits<double>::epsilon();

/// N: what the actuator asks of its points.
double held_force(const Scene<double>& scene, Index actuator) {
  double reach = 0;
  for (const Drive<double>& drive : scene.drives) {
    if (drive.actuator != actuator) continue;
    for (const Index i : points_of(scene.bodies[drive.body]))
      reach = std::max(reach, acceleration_at(scene.points[i], drive.twist).norm());
  }
  return std::abs(scene.actuators[actuator].force) / (reach > 0 ? reach : 1.0);
}

/// F, at most a thousand times the smallest load.
double by_smallest_load(const SceneFile& file, const Scales<double>& scales) {
  const Scene<double> scene = file.view();
  double smallest = scales.force;
  const auto note = [&](double load) {
    if (load > 0) smallest = std::min(smallest, load);
  };
  note(file.object.mass * file.gravity.norm());
  note(file.object.wrench.head<3>().norm());
  note(file.object.wrench.tail<3>().norm() / scales.length);
  for (Index a = 0; a < scene.actuators.size; ++a) note(held_force(scene, a));
  return std::min(scales.force, 1000 * smallest);
}

} // namespace

double told_force(const SceneFile& file, const Scales<double>& scales) {
  constexpr double least_part = 1.5e-5; // a thousand millionth of it is 64 eps of F
  return std::max(least_part * scales.force, by_smallest_load(file, scales));
}

double shown_as_nothing(const SceneFile& file, const Scales<double>& scales) {
  return std::max(left_of_force * scales.force, 1e-6 * by_smallest_load(file, scales));
}

Index lost_actuator(const SceneFile& file, const Scales<double>& scales) {
  const Scene<double> scene = file.view();
  for (Index a = 0; a < scene.actuators.size; ++a) {
    const double force = held_force(scene, a);
    if (force > 0 && force <= left_of_force * scales.force) return a;
  }
  return -1;
}

bool is_lost(double push, const Scales<double>& scales, double beside) {
  const double noise = scales.acceleration * std::max(10 * left_of_force, 1e5 * beside);
  return push > 0 && !(push >= noise);
}

} // namespace lcpush::desktop
