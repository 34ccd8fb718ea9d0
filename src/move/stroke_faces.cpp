#include "move/stroke_faces.hpp"

#include "scenes/facing.hpp"

#include <algorithm>

namespace lcpush::desktop {

StrokeFaces::StrokeFaces(const SceneFile& file)
    : file_(file), faces_(contact_faces(file)), bodies_(file.bodies),
      has_begun_(file.bodies.size()) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    has_begun_[b] = file.strokes[b].from == 0;
    face_object(b, Matrix3<double>::Identity());
  }
  place_strokes(0);
}

/// A normal turns with the face that it points into. One that is given for a later stroke, when the
/// object has turned, is that of the face as it was at first.
void StrokeFaces::face_object(std::size_t b, const Matrix3<double>& turned) {
  const Touching& touching = faces_.touching[b];
  if (touching.riding != Riding::on_body || touching.face < 0) return;
  const Vector3<double> n = -faces_.faces[static_cast<std::size_t>(touching.face)].normal;
  if (n == file_.bodies[b].normal) return;
  Body<double> given = file_.bodies[b];
  given.normal = turned.transpose() * given.normal;
  given.tangent = turned.transpose() * given.tangent;
  bodies_[b] = facing(given, n);
}

void StrokeFaces::begin_strokes(double time, const Matrix3<double>& turned) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (has_begun_[b] != 0 || file_.strokes[b].from > time) continue;
    has_begun_[b] = 1;
    begin_stroke(file_, static_cast<Index>(b), turned, faces_);
    face_object(b, turned);
  }
}

void StrokeFaces::place_strokes(double middle) {
  for (std::size_t b = 0; b < file_.strokes.size(); ++b)
    faces_.absent[b] = middle < file_.strokes[b].from || middle >= file_.strokes[b].until;
}

Vector6<double> StrokeFaces::prescribed(Index body, double time) const {
  const Stroke& stroke = file_.strokes[static_cast<std::size_t>(body)];
  const double since = std::clamp(time, stroke.from, stroke.until) - stroke.from;
  // A step that ends with the stroke may end a rounding error after it.
  const double rounding = 1e-12 * time;
  const bool is_over = time < stroke.from - rounding || time > stroke.until + rounding;
  return (is_over ? 0.0 : stroke.is_velocity ? 1.0 : since) * file_.body(body).acceleration;
}

} // namespace lcpush::desktop
