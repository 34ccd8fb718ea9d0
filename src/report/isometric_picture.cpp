#include "report/isometric_painter.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

// Lengths in pixels.
constexpr double object_width = 235, object_height = 165;
constexpr double least_finger = 9, widest_finger = 17;
constexpr double plate_margin = 10, table_margin = 26, plate_thickness = 7;
constexpr double ghost_distance = 26, least_ghost = 2, longest_arrow = 84, fastest_arrow = 50;
constexpr double most_ghost_turn = 0.5; // rad

/// A cylinder that turns about its own axis looks as it did.
bool is_same(const Frame& a, const Frame& b) {
  return std::max({std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right),
                   std::abs(a.bottom - b.bottom)}) < least_ghost;
}

/// Seen from above, from the right of a front view; all three axes equally long.
View isometric_view(const View& front) {
  const Vector3<double> right = (front.right - front.toward) / std::sqrt(2.0);
  const Vector3<double> toward = (front.right + front.up + front.toward) / std::sqrt(3.0);
  const Vector3<double> up = (2 * front.up - front.right - front.toward) / std::sqrt(6.0);
  return {"isometric", "Isometric view", right, up, toward};
}

} // namespace

IsometricPainter::IsometricPainter(const SceneFile& file, const PushReport& report)
    : file_(file), scene_(file.view()), report_(report),
      view_(isometric_view(chosen_views(file)[0])), positions_(drawn_positions(file)),
      object_(object_prism(file)), scales_(picture_scales(file, report)), places_(width, height) {
  std::vector<Pixel> shown;
  for (const auto& corner : corners_of(object_)) shown.push_back(view_.flat(corner));
  for (const auto& position : positions_) shown.push_back(view_.flat(position));
  frame_ = bounds(shown);
  scales_.meters = std::min(object_width / std::max(frame_.width(), 1e-9),
                            object_height / std::max(frame_.height(), 1e-9));
  if (!scales_.shows_forces) return;
  double most = (file.object.mass * file.gravity).norm();
  for (const Body<double>& body : scene_.bodies)
    most = std::max({most, std::abs(normal_sum(report_.answer, body)), friction_of(body).norm()});
  scales_.newtons = most > 0 ? longest_arrow / round_above(most) : 0;
  scales_.accelerations *= fastest_arrow / fastest;
}

std::string IsometricPainter::prism_elements(const Prism& prism, const std::string& kind) {
  const PrismPicture picture =
      picture_of(prism, view_, [this](const Vector3<double>& at) { return place(at); });
  std::string text = polygon_element(kind, picture.outline);
  for (const auto& face : picture.faces) text += polygon_element("face", face);
  places_.bar_edges(picture.outline);
  return text;
}

/// A rod with round ends, as wide as the contact.
std::string IsometricPainter::finger(const Body<double>& body, const std::string& kind) {
  const Vector3<double> tip = middle_of(positions_, body);
  double reach = 0;
  for (const Index i : points_of(body))
    reach = std::max(reach, (positions_[static_cast<std::size_t>(i)] - tip).norm());
  const double thick = std::clamp(scales_.meters * reach + 3, least_finger, widest_finger);
  const auto center = [&](double back) {
    return Pixel(place(tip) - back * view_.flat(body.normal));
  };
  std::vector<Pixel> around;
  for (const double back : {thick, finger_length})
    for (int k = 0; k < 24; ++k)
      around.emplace_back(center(back) + thick * Pixel(std::cos(k * 0.2618), std::sin(k * 0.2618)));
  const std::vector<Pixel> outline = hull(around);
  places_.bar_edges(outline);
  return polygon_element(kind, outline);
}

std::string IsometricPainter::plate(const Body<double>& body, double margin, bool carries_object,
                                    const std::string& kind) {
  std::vector<Vector3<double>> carried;
  for (const Index i : points_of(body)) carried.push_back(positions_[static_cast<std::size_t>(i)]);
  if (carries_object)
    for (const auto& corner : corners_of(object_)) {
      const double above = body.normal.dot(corner - carried.front());
      carried.emplace_back(corner - above * body.normal);
    }
  return prism_elements(slab_prism(carried, body.normal, body.tangent, margin / scales_.meters,
                                   plate_thickness / scales_.meters),
                        kind);
}

std::string IsometricPainter::body_elements(Index b) {
  const Body<double>& body = scene_.bodies[b];
  const std::string kind =
      std::string("thing ") + (body.role == Role::pusher ? "pusher" : "finger");
  if (is_table(b)) return plate(body, table_margin, true, kind);
  if (is_driven(b) || body.point_count == 1) return finger(body, kind);
  return plate(body, plate_margin, false, kind);
}

std::string IsometricPainter::axes() const {
  const Pixel origin(44, 50);
  std::string text;
  constexpr const char* names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const Pixel along = view_.flat(Vector3<double>::Unit(k));
    text += arrow_element("axis", origin, origin + 32 * along) +
            text_element("quiet", origin + 42 * along + Pixel(0, 4), names[k], "middle");
  }
  return text;
}

/// The object's outline a moment later, far enough on to be seen.
std::string IsometricPainter::ghost() {
  const Motion<double>& motion = report_.motion;
  if (!scales_.shows_forces || motion.kind == MotionKind::rest) return "";
  Displacement moved;
  if (turns(motion)) {
    moved.point = file_.object.center_of_mass + motion.axis_point;
    moved.axis = motion.axis;
  }
  const auto moved_by = [&](double part) {
    Displacement d = moved;
    d.angle = turns(motion) ? part * motion.rotation : 0;
    d.shift = turns(motion) ? Vector3<double>(part * motion.rotation * motion.pitch * motion.axis)
                            : Vector3<double>(part * motion.translation * motion.direction);
    return d;
  };
  double fastest_corner = 0;
  for (const auto& corner : corners_of(object_)) {
    const Vector3<double> arm = corner - file_.object.center_of_mass;
    fastest_corner =
        std::max(fastest_corner, acceleration_at(arm, report_.answer.acceleration).norm());
  }
  double part = ghost_distance / scales_.meters / fastest_corner;
  if (turns(motion)) part = std::min(part, most_ghost_turn / motion.rotation);
  const auto to_pixel = [this](const Vector3<double>& at) { return place(at); };
  const PrismPicture here = picture_of(object_, view_, to_pixel);
  const PrismPicture picture = picture_of(moved_by(part)(object_), view_, to_pixel);
  if (is_same(bounds(picture.outline), bounds(here.outline))) return "";
  std::string text;
  for (const auto& face : picture.faces) text += polygon_element("ghost inner", face);
  places_.bar_edges(picture.outline);
  return text + polygon_element("ghost", picture.outline);
}

Drawing IsometricPainter::draw() {
  Drawing drawing{view_.name, view_.title, "", width, height, ""};
  const Pixel corner(92, 92); // of the axes
  places_.bar({0, 0, corner.x(), corner.y()});
  std::string behind, before, arrows;
  for (const Index b : bodies_back_to_front(view_, scene_.bodies))
    (view_.toward.dot(scene_.bodies[b].normal) > 0 ? behind : before) += body_elements(b);
  const std::string object = prism_elements(
      object_, file_.shape.kind == ObjectShape::Kind::unknown ? "object guessed" : "object");
  const std::string ghost_elements = ghost();
  for (Index b = 0; b < scene_.bodies.size; ++b) arrows += forces(b) + body_motion(b);
  const std::string motion = object_motion();
  arrows += weight() + motion;
  for (Index b = 0; b < scene_.bodies.size; ++b) label_body(b);
  const std::vector<Frame> words = placed_labels(places_, labels_);
  const Frame used = places_.used(words, corner, 8);
  drawing.top = used.top;
  drawing.height = used.height();
  drawing.elements = shifted(axes(), {0, used.top}) + behind + object + before + ghost_elements +
                     arrows + label_elements(labels_, words);
  drawing.description = scales_.shows_forces
                            ? "The object between the bodies that touch it, the forces on it, and "
                              "dashed where it goes."
                            : "The object between the bodies that touch it.";
  for (const std::string& sentence : words_) drawing.description += " " + sentence;
  return drawing;
}

Drawing isometric_picture(const SceneFile& file, const PushReport& report) {
  return IsometricPainter(file, report).draw();
}

} // namespace lcpush::desktop
