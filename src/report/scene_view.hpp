// Orthographic views along the scene's axes, and the geometry of drawings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/markup.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

/// Which of the scene's axes point to the right and up on the drawing.
struct View {
  std::string name;  ///< "front", "top" or "side"
  std::string title; ///< "Front view, x and y"
  Index right = 0, up = 1;
  double right_sign = 1, up_sign = 1;

  Index depth() const { return 3 - right - up; }
  /// As drawn: to the right, and down.
  Pixel flat(const Vector3<double>& v) const { return {right_sign * v[right], -up_sign * v[up]}; }
  /// > 0 where a direction points at the viewer.
  double toward_viewer(const Vector3<double>& v) const {
    const double handed = (right + 1) % 3 == up ? 1 : -1;
    return handed * right_sign * up_sign * v[depth()];
  }
};

/// A front view, and of the other two the one that shows more: where gravity points along z, that
/// axis is up.
std::vector<View> chosen_views(const SceneFile& file);

/// The convex hull, without points on its edges.
std::vector<Pixel> hull(std::vector<Pixel> points);

/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
double round_below(double x);
/// The smallest of a few round numbers that is not below x > 0.
double round_above(double x);

/// The corners of the box that encloses the object, in the scene's frame.
std::vector<Vector3<double>> object_corners(const SceneFile& file);

/// How a view shows the axis that an object turns about, in the scene's frame and metres.
struct TurningMark {
  bool is_point = false; ///< the axis points at the viewer: the instantaneous centre
  Vector3<double> at;    ///< a point of the axis, the one nearest to the centre of mass
  Vector3<double> along; ///< unit
  double pitch = 0;      ///< m per rad
  bool is_screw = false; ///< the pitch is not zero
};

/// Nothing if the object does not turn. `length`: the size of the grasp, m.
std::optional<TurningMark> turning_mark(const SceneFile& file, const Motion<double>& motion,
                                        const View& view, double length);

/// The part of the line through `at` along `along` inside [0, width] x [0, height], if any.
std::optional<std::pair<Pixel, Pixel>> clipped_line(const Pixel& at, const Pixel& along,
                                                    double width, double height);

} // namespace lcpush::desktop
