#include "solve/told_force.hpp"

#include <algorithm>

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush::desktop {

double told_force(const SceneFile& file, const Scales<double>& scales) {
  constexpr double least_part = 1.5e-5; // a thousand millionth of it is 64 eps of F
  const Scene<double> scene = file.view();
  double smallest = scales.force;
  const auto note = [&](double load) {
    if (load > 0) smallest = std::min(smallest, load);
  };
  note(file.object.mass * file.gravity.norm());
  note(file.object.wrench.head<3>().norm());
  note(file.object.wrench.tail<3>().norm() / scales.length);
  for (Index a = 0; a < scene.actuators.size; ++a) {
    double reach = 0;
    for (const Drive<double>& drive : scene.drives) {
      if (drive.actuator != a) continue;
      const Body<double>& body = scene.bodies[drive.body];
      for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
        reach = std::max(reach, acceleration_at(scene.points[i], drive.twist).norm());
    }
    note(std::abs(scene.actuators[a].force) / (reach > 0 ? reach : 1.0));
  }
  return std::max(least_part * scales.force, std::min(scales.force, 1000 * smallest));
}

} // namespace lcpush::desktop
