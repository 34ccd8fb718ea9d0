#include "draw/view.hpp"

#include <cmath>
#include <limits>

namespace lcpush::desktop {

std::vector<std::size_t> hull_corners(const std::vector<Pixel>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&points](std::size_t i, std::size_t j) {
    const Pixel &a = points[i], &b = points[j];
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  if (points.size() < 3) return order;
  const auto turn = [&points](std::size_t o, std::size_t a, std::size_t b) {
    const Pixel u = points[a] - points[o], v = points[b] - points[o];
    return u.x() * v.y() - u.y() * v.x();
  };
  std::vector<std::size_t> all;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = all.size();
    for (const std::size_t p : order) {
      while (all.size() > first + 1 && turn(all[all.size() - 2], all.back(), p) <= 0)
        all.pop_back();
      all.push_back(p);
    }
    all.pop_back(); // it begins the other half
    std::reverse(order.begin(), order.end());
  }
  return all;
}

std::vector<Pixel> hull(const std::vector<Pixel>& points) {
  std::vector<Pixel> corners;
  for (const std::size_t i : hull_corners(points)) corners.push_back(points[i]);
  return corners;
}

Frame bounds(const std::vector<Pixel>& points) {
  Frame frame{points[0].x(), points[0].y(), points[0].x(), points[0].y()};
  for (const Pixel& p : points)
    frame = {std::min(frame.left, p.x()), std::min(frame.top, p.y()), std::max(frame.right, p.x()),
             std::max(frame.bottom, p.y())};
  return frame;
}

std::vector<Vector3<double>> box_corners(const Vector3<double>& center,
                                         const Vector3<double>& size) {
  std::vector<Vector3<double>> corners;
  for (int k = 0; k < 8; ++k) {
    Vector3<double> corner = center;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] += ((k >> axis & 1) != 0 ? 0.5 : -0.5) * size[axis];
    corners.push_back(corner);
  }
  return corners;
}

std::vector<Pixel> pad_rim(const View& view, const Vector3<double>& normal) {
  std::vector<Pixel> rim;
  const Pixel flat = view.flat(normal);
  if (flat.norm() > 0.7) {
    const Pixel n = flat.normalized(), across(-n.y(), n.x());
    for (const double side : {-6.0, 6.0})
      for (const double back : {0.0, 9.0}) rim.emplace_back(side * across - back * n);
    return rim;
  }
  constexpr double step = 3.14159265358979323846 / 6;
  for (int k = 0; k < 12; ++k) rim.emplace_back(9 * std::cos(k * step), 9 * std::sin(k * step));
  return rim;
}

std::string axes_elements(const View& view) {
  const auto name = [](const Vector3<double>& axis) {
    return axis.x() != 0 ? "x" : axis.y() != 0 ? "y" : "z";
  };
  const double across = 24 * view.right.sum(), up = 24 * view.up.sum();
  const Pixel origin(across < 0 ? 42 : 16, up < 0 ? 14 : 42);
  return arrow_element("axis", origin, origin + Pixel(across, 0)) +
         arrow_element("axis", origin, origin - Pixel(0, up)) +
         text_element("quiet", origin + Pixel(1.4 * across, 4), name(view.right), "middle") +
         text_element("quiet", origin + Pixel(9, up > 0 ? -20 : 30), name(view.up));
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
