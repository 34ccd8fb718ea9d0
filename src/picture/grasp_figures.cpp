#include "picture/grasp_figures.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double finger_radius = 9, patch_margin = 3; // about a single point, and about others
constexpr double table_margin = 26, plate_thickness = 7;
constexpr double most_ghost_turn = 0.5; // rad

/// A cylinder that turns about its own axis looks as it did.
bool is_same(const Frame& a, const Frame& b, double least) {
  return std::max({std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right),
                   std::abs(a.bottom - b.bottom)}) < least;
}

} // namespace

Vector3<double> DrawnScene::middle(const Body<double>& body) const {
  Vector3<double> sum = Vector3<double>::Zero();
  for (const Index i : points_of(body)) sum += position(i);
  return sum / static_cast<double>(body.point_count);
}

double DrawnScene::reach() const {
  double reach = file.shape.size.norm() / 2;
  for (const auto& position : positions) reach = std::max(reach, (position - center()).norm());
  return reach;
}

PrismPicture GraspFigures::seen(const Prism& prism) const {
  return picture_of(prism, sight_.view,
                    [this](const Vector3<double>& at) { return sight_.place(at); });
}

Figure GraspFigures::figure_of(const Prism& prism, const std::string& kind) const {
  const PrismPicture picture = seen(prism);
  Figure figure{picture.outline, polygon_element(kind, picture.outline)};
  for (const auto& face : picture.faces) figure.elements += polygon_element("face", face);
  return figure;
}

Prism GraspFigures::moved(const Prism& prism, const Pose<double>& pose) const {
  const Vector3<double>& center = drawn_.center();
  Prism there;
  for (const auto& corner : prism.base) there.base.emplace_back(center + pose.at(corner - center));
  there.along = pose.turned(prism.along);
  return there;
}

Figure GraspFigures::object(const Pose<double>& pose) const {
  const bool is_guessed = drawn_.file.shape.kind == ObjectShape::Kind::unknown;
  return figure_of(moved(drawn_.object, pose), is_guessed ? "object guessed" : "object");
}

bool GraspFigures::is_driven(Index b) const {
  return std::any_of(drawn_.scene.drives.begin(), drawn_.scene.drives.end(),
                     [b](const Drive<double>& drive) { return drive.body == b; });
}

bool GraspFigures::is_table(Index b) const {
  const double weight = drawn_.file.gravity.norm();
  return !is_driven(b) && weight > 0 &&
         drawn_.scene.bodies[b].normal.dot(drawn_.file.gravity) < -0.9 * weight;
}

/// What carries the object is wide; anything else reaches away from its patch, in the patch's own
/// shape.
Prism GraspFigures::thing(Index b) const {
  const Body<double>& body = drawn_.scene.bodies[b];
  std::vector<Vector3<double>> carried;
  for (const Index i : points_of(body)) carried.push_back(drawn_.position(i));
  if (is_table(b)) {
    for (const auto& corner : corners_of(drawn_.object)) {
      const double above = body.normal.dot(corner - carried.front());
      carried.emplace_back(corner - above * body.normal);
    }
    return slab_prism(carried, body.normal, body.tangent, table_margin / sight_.meters,
                      plate_thickness / sight_.meters);
  }
  const double margin = body.point_count == 1 ? finger_radius : patch_margin;
  return rounded_prism(carried, body.normal, body.tangent, margin / sight_.meters,
                       sizes_.finger / sight_.meters);
}

Figure GraspFigures::body(Index b, const std::string& kind, const Pose<double>& pose) const {
  return figure_of(moved(thing(b), pose), kind);
}

Figure GraspFigures::ghost(const PushReport& report) const {
  const Motion<double>& motion = report.motion;
  if (motion.kind == MotionKind::rest) return {};
  Vector6<double> twist = Vector6<double>::Zero();
  if (turns(motion)) {
    const Vector3<double> turn = motion.rotation * motion.axis;
    twist << cross<double>(motion.axis_point, turn) + motion.pitch * turn, turn;
  } else {
    twist.head<3>() = motion.translation * motion.direction;
  }
  double fastest_corner = 0;
  for (const auto& corner : corners_of(drawn_.object)) {
    const Vector3<double> arm = corner - drawn_.center();
    fastest_corner =
        std::max(fastest_corner, acceleration_at(arm, report.answer.acceleration).norm());
  }
  double part = sizes_.ghost / sight_.meters / fastest_corner;
  if (turns(motion)) part = std::min(part, most_ghost_turn / motion.rotation);
  const PrismPicture here = seen(drawn_.object),
                     there =
                         seen(moved(drawn_.object, moved_about_origin<double>({}, twist, part)));
  if (is_same(bounds(there.outline), bounds(here.outline), sizes_.least_ghost)) return {};
  Figure figure{there.outline, ""};
  for (const auto& face : there.faces) figure.elements += polygon_element("ghost inner", face);
  figure.elements += polygon_element("ghost", there.outline);
  return figure;
}

std::string axes_in_space(const View& view, const Pixel& origin, double length) {
  constexpr double least_seen = 0.15;
  std::string text;
  constexpr const char* names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const Pixel along = view.flat(Vector3<double>::Unit(k));
    if (along.norm() < least_seen) continue;
    text += arrow_element("axis", origin, origin + length * along) +
            text_element("quiet", origin + (length + 10) * along + Pixel(0, 4), names[k], "middle");
  }
  return text;
}

} // namespace lcpush::desktop
