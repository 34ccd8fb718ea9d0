#include "plan/plan_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lcpush::desktop {
namespace {

constexpr double typed_direction = 1e-3;
constexpr double kept_from_corners = 5e-3; // of the face's width

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Of the face with this outward normal along a direction, about the centre of mass.
std::optional<Range> face_range(const SceneFile& file, const Vector3<double>& outward,
                                const Vector3<double>& along) {
  Range range;
  for (const ObjectFace& face : file.faces)
    if ((face.normal - outward).norm() <= typed_direction)
      for (const Vector3<double>& corner : face.corners)
        range.take((corner - file.object.center_of_mass).dot(along));
  if (file.faces.empty() && file.shape.kind == ObjectShape::Kind::box)
    for (Index axis = 0; axis < 2; ++axis) {
      if (std::abs(outward[axis]) < 1 - typed_direction) continue;
      const double half = file.shape.size[1 - axis] / 2;
      range.take(-half);
      range.take(half);
    }
  if (!(range.low < range.high)) return std::nullopt;
  return range;
}

} // namespace

SceneFile along_faces(SceneFile file) {
  for (const Body<double>& body : file.bodies) {
    if (body.role != Role::pusher) continue;
    const Vector3<double> along = cross<double>(Vector3<double>::UnitZ(), body.normal);
    const std::optional<Range> face = face_range(file, -body.normal, along);
    if (!face) continue;
    const double kept = kept_from_corners * (face->high - face->low);
    const double low = face->low + kept, high = face->high - kept;
    Range pressed;
    for (const Index i : points_of(body))
      pressed.take(file.points[static_cast<std::size_t>(i)].dot(along));
    if (pressed.low >= high || pressed.high <= low) continue; // beside it altogether: refused
    // Its points stay apart: they are all drawn together.
    const double from = std::max(pressed.low, low), to = std::min(pressed.high, high);
    const double share =
        pressed.high > pressed.low ? (to - from) / (pressed.high - pressed.low) : 0;
    for (const Index i : points_of(body)) {
      const auto k = static_cast<std::size_t>(i);
      const double at = file.points[k].dot(along);
      const double by = from + share * (at - pressed.low) - at;
      file.points[k] += by * along;
      file.positions[k] += by * along;
    }
  }
  return file;
}

} // namespace lcpush::desktop
