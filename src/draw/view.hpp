// Orthographic views, where they stand on a picture, and the geometry of drawings.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
  Vector3<double> right, up, toward; ///< the last at the viewer

  /// As drawn: to the right, and down.
  Pixel flat(const Vector3<double>& v) const { return {right.dot(v), -up.dot(v)}; }
  /// Does a body with this normal touch the far side?
  bool is_behind(const Vector3<double>& normal) const { return toward.dot(normal) > 0.5; }
};

/// Front, top and side view, such that gravity pulls down the front view: the axis that it pulls
/// along most is up or down there; without gravity y is up.
std::vector<View> axis_views(const Vector3<double>& gravity);
/// "x and z": those that run across and up the picture. Precondition: a view along an axis.
std::string axes_words(const View& view);
/// Seen from above, from the right of a front view; all three axes equally long.
View isometric_view(const View& front);

/// The front view, and of the other two the one that shows more of a box of this size and of the
/// bodies that touch it (anything with a normal); with z up the one from above.
template <class Body>
std::vector<View> two_views(const Vector3<double>& gravity, const Vector3<double>& size,
                            const std::vector<Body>& bodies) {
  std::vector<View> views = axis_views(gravity);
  const View& front = views[0];
  const auto shows_across = [&front](const Body& body) {
    return std::abs(body.normal.dot(front.right)) > 0.5;
  };
  const bool shows_top = front.up.z() != 0 ||
                         std::abs(size.dot(front.right)) >= std::abs(size.dot(front.up)) ||
                         std::any_of(bodies.begin(), bodies.end(), shows_across);
  views.erase(views.begin() + (shows_top ? 2 : 1));
  return views;
}

/// From where something is seen, and where it stands on the picture.
struct Sight {
  View view;
  double meters = 1;            ///< pixels a metre
  Pixel center = Pixel::Zero(); ///< where what is flat at `middle` stands
  Pixel middle = Pixel::Zero();

  Pixel place(const Vector3<double>& at) const {
    return center + meters * (view.flat(at) - middle);
  }
};
/// Pixels a metre with which what is shown, in metres of the drawing, fills this room.
double fitting_scale(const Frame& shown, double width, double height);
/// With the middle of what is shown in the middle of a picture of this size.
Sight centered(const View& view, const Frame& shown, double meters, const Pixel& size);

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

/// At the bottom of a picture: how long so many millimetres are, and so many newtons; 0: no force.
std::string scale_bars(double width, double bottom, double meters, double newtons);
/// A path through these places.
std::string polyline_element(const std::string& kind, const std::vector<Pixel>& places);

/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
double round_below(double x);
/// The smallest of a few round numbers that is not below x > 0.
double round_above(double x);

/// The part of the line through `at` along `along` inside the frame, if any; `along`'s multiples
/// from `first` to `last` are on it.
std::optional<std::pair<Pixel, Pixel>>
clipped_line(const Frame& frame, const Pixel& at, const Pixel& along,
             double first = -std::numeric_limits<double>::infinity(),
             double last = std::numeric_limits<double>::infinity());

} // namespace lcpush::desktop
