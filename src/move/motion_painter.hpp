// A motion drawn: the object at each moment, who touches it, forces, and where it came along.
#pragma once

#include "draw/prism.hpp"
#include "draw/view.hpp"
#include "lcpush/desktop/move.hpp"

namespace lcpush::desktop {

class MotionPainter {
public:
  static constexpr double width = 640, height = 420;

  /// Along the axis from which most of the motion is seen.
  MotionPainter(const SceneFile& file, const MotionReport& report);

  /// The object with its bodies and forces at one moment.
  std::string moment(const MotionFrame& frame) const;
  /// Outlines of the object at these frames.
  std::string ghosts(const std::vector<std::size_t>& frames) const;
  /// The path of the centre of mass.
  std::string path() const;
  /// Axes and scales.
  std::string surroundings() const;
  /// "x and z": what runs across and up.
  std::string axes() const { return axes_words(sight_.view); }

private:
  const SceneFile& file_;
  const MotionReport& report_;
  const Prism object_;
  const Sight sight_;
  const View& view_ = sight_.view;
  double newtons_ = 0; ///< pixels per N

  Pixel place(const Vector3<double>& at) const { return sight_.place(at); }
  std::vector<Pixel> outline(const MotionFrame& frame) const;
  struct PlacedName {
    Pixel at;
    std::string text;
    const char* anchor;
    double outward; ///< 1 or -1: down or up the picture, away from the object
  };
  std::string body(const MotionFrame& frame, Index b, std::vector<PlacedName>& names) const;
  static std::string apart(std::vector<PlacedName> names);
};

/// So many of `count`, evenly spread, the last included.
std::vector<std::size_t> spread_out(std::size_t count, std::size_t most);

} // namespace lcpush::desktop
