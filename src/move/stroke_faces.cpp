#include "move/stroke_faces.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/owned.hpp"
#include "move/settings.hpp"
#include "scenes/facing.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

using Settings = MoveSettings;

/// A face of the object before it is known who touches it.
struct Surface {
  Face<double> face;
  std::vector<Vector3<double>> corners;
};

Surface flat(const Vector3<double>& normal, std::vector<Vector3<double>> corners) {
  Surface surface;
  surface.face.normal = normal;
  for (const Vector3<double>& corner : corners)
    surface.face.point += corner / static_cast<double>(corners.size());
  surface.corners = std::move(corners);
  return surface;
}

std::vector<Surface> box_faces(const Vector3<double>& size) {
  std::vector<Surface> faces;
  for (Index axis = 0; axis < 3; ++axis)
    for (const double side : {1.0, -1.0}) {
      const Vector3<double> n = side * Vector3<double>::Unit(axis);
      const Vector3<double> a = size[(axis + 1) % 3] / 2 * Vector3<double>::Unit((axis + 1) % 3);
      const Vector3<double> b = size[(axis + 2) % 3] / 2 * Vector3<double>::Unit((axis + 2) % 3);
      const Vector3<double> middle = size[axis] / 2 * n;
      faces.push_back(flat(n, {middle - a - b, middle + a - b, middle + a + b, middle - a + b}));
    }
  return faces;
}

std::vector<Surface> cylinder_ends(const ObjectShape& shape) {
  std::vector<Surface> faces(2);
  for (std::size_t end = 0; end < 2; ++end) {
    Face<double>& face = faces[end].face;
    face.normal = (end == 0 ? 1.0 : -1.0) * Vector3<double>::Unit(shape.axis);
    face.point = shape.size[shape.axis] / 2 * face.normal;
    face.radius = shape.size[(shape.axis + 1) % 3] / 2;
  }
  return faces;
}

/// About the centre of mass.
std::vector<Surface> object_surfaces(const SceneFile& file) {
  std::vector<Surface> faces;
  for (const ObjectFace& face : file.faces) {
    std::vector<Vector3<double>> corners = face.corners;
    for (Vector3<double>& corner : corners) corner -= file.object.center_of_mass;
    faces.push_back(flat(face.normal, corners));
  }
  if (!faces.empty()) return faces;
  if (file.shape.kind == ObjectShape::Kind::box) return box_faces(file.shape.size);
  if (file.shape.kind == ObjectShape::Kind::cylinder) return cylinder_ends(file.shape);
  return {};
}

class FaceFinder {
public:
  explicit FaceFinder(const SceneFile& file) : file_(file), surfaces_(object_surfaces(file)) {
    length_ = file.shape.size.maxCoeff();
    for (const Vector3<double>& p : file.points) length_ = std::max(length_, p.norm());
  }

  /// Of a stroke that begins now, when the object has turned.
  void find_again(Index b, const Matrix3<double>& turned, ContactFaces& found) const {
    const Touching& touching = found.touching[static_cast<std::size_t>(b)];
    if (touching.riding != Riding::on_body || touching.face < 0) return;
    const Vector3<double> normal = turned.transpose() * file_.body(b).normal;
    const Surface& surface = nearest(normal);
    if ((surface.face.normal + normal).norm() > Settings::turned_face) refuse_edge(b);
    const auto k = static_cast<std::size_t>(touching.face);
    found.faces[k] = surface.face;
    found.corners[k] = surface.corners;
    found.faces[k].corners = span_of(std::as_const(found.corners[k]));
  }

  ContactFaces find() {
    for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b)
      found_.touching.push_back(touching(b));
    found_.absent.assign(file_.bodies.size(), 0);
    return std::move(found_);
  }

private:
  const Vector3<double>& point_at(Index i) const {
    return file_.points[static_cast<std::size_t>(i)];
  }
  const Stroke& stroke(Index b) const { return file_.strokes[static_cast<std::size_t>(b)]; }

  Touching touching(Index b) {
    const Body<double>& body = file_.body(b);
    if (is_on_round_side(b)) return round_side(b);
    if (stroke(b).rides_on_object) return {Riding::on_object, -1, 0};
    if (surfaces_.empty()) return {};
    // A later stroke meets an object that may have turned by then: its face is found again.
    if (stroke(b).from > 0) return {Riding::on_body, add(nearest(body.normal), b), 0};
    std::vector<const Surface*> facing;
    for (const Surface& surface : surfaces_)
      if ((surface.face.normal + body.normal).norm() <= Settings::typed_direction)
        facing.push_back(&surface);
    if (facing.empty()) refuse_edge(b);
    for (const Surface* surface : facing)
      if (is_on(*surface, file_.body(b))) return {Riding::on_body, add(*surface, b), 0};
    refuse_place(b, *facing.front());
  }

  /// The same face, at the height where the body's points are: what is typed with few digits, or
  /// taken at the middle of a planar scene, does not begin with a gap.
  Index add(const Surface& surface, Index b) {
    Face<double> face = surface.face;
    const Body<double>& body = file_.body(b);
    const Vector3<double> by =
        stroke(b).from > 0 ? Vector3<double>(Vector3<double>::Zero())
                           : Vector3<double>(face.normal * height(surface, body.first_point));
    if (stroke(b).from == 0) face.normal = -body.normal;
    face.point += by;
    std::vector<Vector3<double>> corners = surface.corners;
    for (Vector3<double>& corner : corners) corner += by;
    found_.faces.push_back(face);
    found_.corners.push_back(corners);
    return static_cast<Index>(found_.faces.size()) - 1;
  }

  double height(const Surface& surface, Index point) const {
    return (point_at(point) - surface.face.point).dot(surface.face.normal);
  }

  const Surface& nearest(const Vector3<double>& normal) const {
    return *std::max_element(surfaces_.begin(), surfaces_.end(),
                             [&](const Surface& one, const Surface& other) {
                               return one.face.normal.dot(normal) > other.face.normal.dot(normal);
                             });
  }
  bool is_on(const Surface& surface, const Body<double>& body) const {
    for (const Index i : points_of(body))
      if (!is_on(surface, i)) return false;
    return true;
  }
  bool is_at_height(const Surface& surface, Index point) const {
    const bool is_flat = file_.planar && std::abs(surface.face.normal.z()) > 0.5;
    return is_flat || std::abs(height(surface, point)) <= Settings::typed_place * length_;
  }
  bool is_on(const Surface& surface, Index point) const {
    Face<double> face = surface.face;
    face.corners = span_of(surface.corners);
    return is_at_height(surface, point) &&
           is_over_face(face, point_at(point), Settings::typed_place * length_);
  }

  bool is_ball() const { return file_.shape.kind == ObjectShape::Kind::ball; }
  /// Of the round side; a ball has none: wherever a plane touches it, it does so at one point.
  Vector3<double> side_axis() const {
    if (is_ball()) return Vector3<double>::Zero();
    return Vector3<double>::Unit(file_.shape.axis);
  }
  bool is_on_round_side(Index b) const {
    if (!is_ball() && file_.shape.kind != ObjectShape::Kind::cylinder) return false;
    return file_.faces.empty() && !stroke(b).rides_on_object &&
           std::abs(side_axis().dot(file_.body(b).normal)) < 0.5;
  }

  Touching round_side(Index b) {
    const Body<double>& body = file_.body(b);
    const double radius = file_.shape.size[(file_.shape.axis + 1) % 3] / 2;
    const Vector3<double> axis = side_axis();
    for (const Index i : points_of(body)) {
      const Vector3<double>& p = point_at(i);
      const Vector3<double> across = p - axis * axis.dot(p);
      if (stroke(b).from > 0) break;
      if ((across + radius * body.normal).norm() > Settings::typed_side * length_) refuse_side(b);
    }
    RoundSide<double> side;
    side.axis = axis;
    side.radius = radius;
    if (stroke(b).from == 0) // as typed: no gap to begin with
      side.radius = -body.normal.dot(point_at(body.first_point));
    found_.sides.push_back(side);
    return {Riding::on_side, -1, static_cast<Index>(found_.sides.size()) - 1};
  }

  [[noreturn]] void refuse(Index b, int line, const std::string& what) const {
    throw InputError(file_.lines.file, line,
                     std::string(file_.body(b).role == Role::pusher ? "pusher " : "finger ") +
                         quoted(file_.body_name(b)) + ": " + what);
  }
  const SceneLines::OfBody& lines(Index b) const {
    return file_.lines.bodies[static_cast<std::size_t>(b)];
  }
  [[noreturn]] void refuse_edge(Index b) const {
    refuse(
        b, lines(b).normal,
        std::string(stroke(b).from > 0 ? "when its stroke begins, " : "") +
            "no face of the object has this normal; a motion of edge against edge is not modelled. "
            "If a corner or an edge of the object presses on a plane of this body, say "
            "points_on = \"object\"; if the object is no box or cylinder, give its [[face]]s");
  }
  [[noreturn]] void refuse_place(Index b, const Surface& surface) const {
    Index i = file_.body(b).first_point;
    while (is_on(surface, i)) ++i;
    const double h = height(surface, i);
    const std::string point = point_name(file_, i) + " lies ";
    const PatchShape shape =
        file_.patches.empty() ? PatchShape::points : file_.patches[static_cast<std::size_t>(b)];
    if (is_at_height(surface, i))
      refuse(b, lines(b).place,
             point +
                 "beside the object's face that its normal points into. A motion takes only "
                 "what touches: " +
                 (shape == PatchShape::points
                      ? "leave out points that do not; or, if corners of the object meet a plane "
                        "of this body, give those and say points_on = \"object\""
                      : "make it no larger than the face; and if it is a plane that goes on beyond "
                        "it, as a table does, say points_on = \"object\" as well"));
    refuse(b, lines(b).place,
           point + millimetres(std::abs(h)) + " " + (h < 0 ? "inside" : "off") +
               " the object, not on the face that its normal points into. A motion needs the "
               "place where they touch: move it there; or, if it is a point of the object that "
               "meets a plane of this body, say points_on = \"object\"");
  }
  [[noreturn]] void refuse_side(Index b) const {
    if (is_ball())
      refuse(b, lines(b).place,
             "a body that touches a ball is a plane, at one point, where the normal points to the "
             "centre. If it is a point of the object that meets a plane of this body, say "
             "points_on = \"object\"");
    Vector3<double> middle = Vector3<double>::Zero();
    for (const Index i : points_of(file_.body(b)))
      middle += point_at(i) / static_cast<double>(file_.body(b).point_count);
    const Vector3<double> across = middle - side_axis() * side_axis().dot(middle);
    const double radius = file_.shape.size[(file_.shape.axis + 1) % 3] / 2;
    if ((across + radius * file_.body(b).normal).norm() < radius / 2)
      refuse(
          b, lines(b).place,
          "a flat body touches a cylinder's side in a line along its axis: give shape = "
          "\"line\", and as ends two points of the side from which the normal points to the axis");
    refuse(b, lines(b).place,
           "this is not on the cylinder's side, where the normal points to the axis. If the object "
           "has another face there, as a handle, give its [[face]]s; if these are points of the "
           "object that meet a plane of this body, say points_on = \"object\"");
  }

  const SceneFile& file_;
  const std::vector<Surface> surfaces_;
  double length_ = 0;
  ContactFaces found_;
};

} // namespace

Surroundings<double> ContactFaces::view() {
  for (std::size_t k = 0; k < faces.size(); ++k)
    faces[k].corners = span_of(std::as_const(corners[k]));
  return {span_of(std::as_const(touching)), span_of(std::as_const(faces)),
          span_of(std::as_const(sides)), span_of(std::as_const(absent))};
}

StrokeFaces::StrokeFaces(const SceneFile& file)
    : file_(file), faces_(FaceFinder(file).find()), bodies_(file.bodies),
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
    FaceFinder(file_).find_again(static_cast<Index>(b), turned, faces_);
    face_object(b, turned);
  }
}

void StrokeFaces::widen(double by) {
  for (Face<double>& face : faces_.faces)
    if (face.radius > 0) face.radius += by;
  for (std::vector<Vector3<double>>& corners : faces_.corners) {
    Vector3<double> middle = Vector3<double>::Zero();
    for (const Vector3<double>& corner : corners)
      middle += corner / static_cast<double>(corners.size());
    for (Vector3<double>& corner : corners) corner += 2 * by * (corner - middle).normalized();
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
  const double rounding = MoveSettings::same_time * time;
  const bool is_over = time < stroke.from - rounding || time > stroke.until + rounding;
  return (is_over ? 0.0 : stroke.is_velocity ? 1.0 : since) * file_.body(body).acceleration;
}

Vector6<double> StrokeFaces::path(Index body, double time) const {
  const Stroke& stroke = file_.strokes[static_cast<std::size_t>(body)];
  const double since = std::clamp(time, stroke.from, stroke.until) - stroke.from;
  return (stroke.is_velocity ? since : since * since / 2) * file_.body(body).acceleration;
}

} // namespace lcpush::desktop
