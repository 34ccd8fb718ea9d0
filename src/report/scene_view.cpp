#include "report/scene_view.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

std::vector<View> chosen_views(const SceneFile& file) {
  const Vector3<double> pull = file.gravity.cwiseAbs();
  if (pull.z() > std::max(pull.x(), pull.y())) {
    const double up = file.gravity.z() < 0 ? 1 : -1;
    const Vector3<double> x(1, 0, 0), y(0, up, 0), z(0, 0, up);
    return {{"front", "Front view, x and z", x, z, -y},
            {"top", "View from above, x and y", x, y, z}};
  }
  return views_with_y_up(file.shape.size, file.bodies);
}

std::optional<TurningMark> turning_mark(const SceneFile& file, const Motion<double>& motion,
                                        const View& view, double length) {
  if (motion.kind == MotionKind::rest || motion.kind == MotionKind::slide) return std::nullopt;
  TurningMark mark;
  mark.at = file.object.center_of_mass + motion.axis_point;
  mark.along = motion.axis;
  mark.pitch = motion.pitch;
  mark.is_screw = std::abs(motion.pitch) > 1e-6 * length;
  mark.is_point = view.flat(motion.axis).norm() <= 1e-6;
  return mark;
}

} // namespace lcpush::desktop
