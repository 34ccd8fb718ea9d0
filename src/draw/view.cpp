#include "draw/view.hpp"

#include <array>
#include <cstdint>

#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

const char* axis_name(const Vector3<double>& axis) {
  return axis.x() != 0 ? "x" : axis.y() != 0 ? "y" : "z";
}

} // namespace

std::vector<View> axis_views(const Vector3<double>& gravity) {
  const Vector3<double> pull = gravity.cwiseAbs();
  const int up = pull.z() > std::max(pull.x(), pull.y())   ? 2
                 : pull.x() > std::max(pull.y(), pull.z()) ? 0
                                                           : 1;
  const double sign = gravity[up] > 0 ? -1 : 1;
  const Vector3<double> x(up == 0 ? sign : 1, 0, 0), y(0, sign, 0), z(0, 0, up == 0 ? 1 : sign);
  const Vector3<double> r = up == 0 ? Vector3<double>(-y) : x,
                        u = up == 0   ? x
                            : up == 1 ? y
                                      : z,
                        t = up == 2 ? Vector3<double>(-y) : z;
  std::vector<View> views{{"front", "Front view", r, u, t},
                          {"top", up == 2 ? "View from above" : "Top view", r, -t, u},
                          {"side", "Side view", -t, u, r}};
  for (View& view : views) view.title += ", " + axes_words(view);
  return views;
}

std::string axes_words(const View& view) {
  return std::string(axis_name(view.right)) + " and " + axis_name(view.up);
}

View isometric_view(const View& front) {
  const Vector3<double> right = (front.right - front.toward) / std::sqrt(2.0);
  const Vector3<double> toward = (front.right + front.up + front.toward) / std::sqrt(3.0);
  const Vector3<double> up = (2 * front.up - front.right - front.toward) / std::sqrt(6.0);
  return {"isometric", "Isometric view", right, up, toward};
}

double fitting_scale(const Frame& shown, double width, double height) {
  constexpr double least = 1e-9; // m, of what is seen as a point
  return std::min(width / std::max(shown.width(), least), height / std::max(shown.height(), least));
}

Sight centered(const View& view, const Frame& shown, double meters, const Pixel& size) {
  const Pixel middle((shown.left + shown.right) / 2, (shown.top + shown.bottom) / 2);
  return {view, meters, size / 2, middle};
}

std::vector<std::size_t> hull_corners(const std::vector<Pixel>& points) {
  // On a grid turns are exact: two corners that rounding has made of one cannot be walked to and
  // fro. Its products stay below 2^62.
  using Cell = std::array<std::int64_t, 2>;
  double across = 0;
  for (const Pixel& p : points) across = std::max(across, (p - points[0]).norm());
  const double cells = across > 0 ? std::ldexp(1, 29) / across : 0;
  std::vector<Cell> at;
  for (const Pixel& p : points)
    at.push_back(
        {std::llround(cells * (p - points[0]).x()), std::llround(cells * (p - points[0]).y())});
  const auto turn = [&at](std::size_t o, std::size_t a, std::size_t b) {
    return (at[a][0] - at[o][0]) * (at[b][1] - at[o][1]) -
           (at[a][1] - at[o][1]) * (at[b][0] - at[o][0]);
  };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return at[i] < at[j]; });
  const auto is_one = [&](std::size_t i, std::size_t j) { return at[i] == at[j]; };
  order.erase(std::unique(order.begin(), order.end(), is_one), order.end());
  if (order.size() < 3) return order;
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
  // Points of a side stand off it by a cell, for which it is no corner.
  for (std::size_t k = 0; k < all.size() && all.size() > 2;) {
    const std::size_t before = all[(k + all.size() - 1) % all.size()],
                      after = all[(k + 1) % all.size()];
    const double side = (points[after] - points[before]).norm() * cells;
    if (static_cast<double>(turn(before, all[k], after)) <= 2 * side)
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(k));
    else
      ++k;
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
  const double across = 24 * view.right.sum(), up = 24 * view.up.sum();
  const Pixel origin(across < 0 ? 42 : 16, up < 0 ? 14 : 42);
  return arrow_element("axis", origin, origin + Pixel(across, 0)) +
         arrow_element("axis", origin, origin - Pixel(0, up)) +
         text_element("quiet", origin + Pixel(1.4 * across, 4), axis_name(view.right), "middle") +
         text_element("quiet", origin + Pixel(9, up > 0 ? -20 : 30), axis_name(view.up));
}

std::string scale_bars(double width, double bottom, double meters, double newtons) {
  constexpr double bar_room = 70;
  const double y = bottom - 14;
  const auto bar = [y](double left, double size) {
    return path_element("scale", move_to({left, y}) + "v6h" + pixels(size) + "v-6");
  };
  const double length = round_below(bar_room / meters), wide = length * meters;
  std::string text =
      bar(12, wide) + text_element("quiet", {18 + wide, y + 7}, number(1000 * length) + " mm");
  if (newtons == 0) return text;
  const double force = round_below(longest_force / newtons), size = force * newtons;
  return text + bar(width - 12 - size, size) +
         text_element("quiet", {width - 18 - size, y + 7}, number(force) + " N", "end");
}

std::string polyline_element(const std::string& kind, const std::vector<Pixel>& places) {
  std::string strokes;
  for (const Pixel& at : places)
    strokes += strokes.empty() ? move_to(at) : "L" + move_to(at).substr(1);
  return path_element(kind, strokes);
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

std::optional<std::pair<Pixel, Pixel>> clipped_line(const Frame& frame, const Pixel& at,
                                                    const Pixel& along, double first, double last) {
  if (!along.allFinite()) return std::nullopt;
  const Pixel low(frame.left, frame.top), high(frame.right, frame.bottom);
  for (int k = 0; k < 2; ++k) {
    if (along[k] == 0) {
      if (at[k] < low[k] || at[k] > high[k]) return std::nullopt;
      continue;
    }
    const double a = (low[k] - at[k]) / along[k], b = (high[k] - at[k]) / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last)) return std::nullopt;
  return std::pair(Pixel(at + first * along), Pixel(at + last * along));
}

} // namespace lcpush::desktop
