#include "report/scene_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {

std::vector<View> chosen_views(const SceneFile& file) {
  const Vector3<double> pull = file.gravity.cwiseAbs();
  if (pull.z() > std::max(pull.x(), pull.y())) {
    const double up = file.gravity.z() < 0 ? 1 : -1;
    return {{"front", "Front view, x and z", 0, 2, 1, up},
            {"top", "View from above, x and y", 0, 1, 1, up}};
  }
  const View front{"front", "Front view, x and y", 0, 1, 1, 1};
  double along_x = 0;
  for (const Body<double>& body : file.bodies)
    along_x = std::max(along_x, std::abs(body.normal.x()));
  if (along_x > 0.5 || file.shape.size.x() >= file.shape.size.y())
    return {front, {"top", "Top view, x and z", 0, 2, 1, -1}};
  return {front, {"side", "Side view, z and y", 2, 1, -1, 1}};
}

std::vector<Pixel> hull(std::vector<Pixel> points) {
  std::sort(points.begin(), points.end(), [](const Pixel& a, const Pixel& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  if (points.size() < 3) return points;
  const auto turn = [](const Pixel& o, const Pixel& a, const Pixel& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
  };
  std::vector<Pixel> all;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = all.size();
    for (const Pixel& p : points) {
      while (all.size() > first + 1 && turn(all[all.size() - 2], all.back(), p) <= 0)
        all.pop_back();
      all.push_back(p);
    }
    all.pop_back(); // it begins the other half
    std::reverse(points.begin(), points.end());
  }
  return all;
}

double round_below(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double k : {5.0, 2.0})
    if (k * power <= x * (1 + 1e-12)) return k * power;
  return power;
}

double round_above(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double k : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
    if (k * power >= x * (1 - 1e-9)) return k * power;
  return 10 * power;
}

std::vector<Vector3<double>> object_corners(const SceneFile& file) {
  std::vector<Vector3<double>> corners;
  for (int k = 0; k < 8; ++k) {
    Vector3<double> corner = file.object.center_of_mass;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] += ((k >> axis & 1) != 0 ? 0.5 : -0.5) * file.shape.size[axis];
    corners.push_back(corner);
  }
  return corners;
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

std::optional<std::pair<Pixel, Pixel>> clipped_line(const Pixel& at, const Pixel& along,
                                                    double width, double height) {
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  const Pixel size(width, height);
  for (int k = 0; k < 2; ++k) {
    if (along[k] == 0) {
      if (at[k] < 0 || at[k] > size[k]) return std::nullopt;
      continue;
    }
    const double a = -at[k] / along[k], b = (size[k] - at[k]) / along[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to)) return std::nullopt;
  return std::pair(Pixel(at + from * along), Pixel(at + to * along));
}

} // namespace lcpush::desktop
