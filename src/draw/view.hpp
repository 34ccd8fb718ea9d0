// Orthographic views along three axes, and the geometry of drawings.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

constexpr double longest_force = 72; ///< pixels of a picture's longest force
constexpr double fastest = 46;       ///< pixels of its largest acceleration

struct View {
  std::string name;                  ///< "front", "top" or "side"
  std::string title;                 ///< "Front view, x and y"
  Vector3<double> right, up, toward; ///< along axes; the last at the viewer

  /// As drawn: to the right, and down.
  Pixel flat(const Vector3<double>& v) const { return {right.dot(v), -up.dot(v)}; }
  /// Does a body with this normal touch the far side?
  bool is_behind(const Vector3<double>& normal) const { return toward.dot(normal) > 0.5; }
};

/// A front view with y up, and of the other two the one that shows more of a box of this size and
/// of the bodies that touch it (anything with a normal).
template <class Body>
std::vector<View> views_with_y_up(const Vector3<double>& size, const std::vector<Body>& bodies) {
  const Vector3<double> x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const View front{"front", "Front view, x and y", x, y, z};
  const auto is_along_x = [](const Body& body) { return std::abs(body.normal.x()) > 0.5; };
  if (size.x() >= size.y() || std::any_of(bodies.begin(), bodies.end(), is_along_x))
    return {front, {"top", "Top view, x and z", x, -z, y}};
  return {front, {"side", "Side view, z and y", -z, y, x}};
}

/// What lies behind is drawn first.
template <class Bodies>
std::vector<Index> bodies_back_to_front(const View& view, const Bodies& bodies) {
  std::vector<Index> order(static_cast<std::size_t>(bodies.size));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return view.toward.dot(bodies[a].normal) > view.toward.dot(bodies[b].normal);
  });
  return order;
}

/// The places of the convex hull's corners among `points`, without those on its edges.
std::vector<std::size_t> hull_corners(const std::vector<Pixel>& points);
std::vector<Pixel> hull(const std::vector<Pixel>& points);
/// Precondition: some points.
Frame bounds(const std::vector<Pixel>& points);
std::vector<Vector3<double>> box_corners(const Vector3<double>& center,
                                         const Vector3<double>& size);

/// What a pad has about each of its points, in pixels: a strip behind them, or a patch where it
/// faces the viewer.
std::vector<Pixel> pad_rim(const View& view, const Vector3<double>& normal);
/// Two arrows in the corner of a picture, with the names of the axes.
std::string axes_elements(const View& view);

/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
double round_below(double x);
/// The smallest of a few round numbers that is not below x > 0.
double round_above(double x);

/// The part of the line through `at` along `along` inside [0, width] x [0, height], if any.
std::optional<std::pair<Pixel, Pixel>> clipped_line(const Pixel& at, const Pixel& along,
                                                    double width, double height);

} // namespace lcpush::desktop
