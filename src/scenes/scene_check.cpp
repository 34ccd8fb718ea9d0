#include "lcpush/desktop/scene_check.hpp"

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/laws.hpp"
#include "scenes/object_surface.hpp"
#include "scenes/unit_doubts.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

// A contact lies no deeper than this part of the object's thinnest edge: beyond, another face would
// be as near.
constexpr double depth_slack = 0.15;
// Around another middle than the file's they lie on the object to this part of its longest edge.
constexpr double middle_slack = 0.01;
// Beyond so many sizes, a place is a slip of the unit or of a digit.
constexpr double far_sizes = 3;
// The cosine between a normal and the face that it should point into. Less, and it lies along it.
constexpr double least_into = 0.05;
// Directions typed with three digits.
constexpr double typed_slack = 1e-3;
// Independent fingers drift if this part of a push goes along their normals.
constexpr double least_along = 0.1;

std::string shape_name(const SceneFile& file) {
  return file.shape.kind == ObjectShape::Kind::box    ? "the box"
         : file.shape.kind == ObjectShape::Kind::ball ? "the ball"
                                                      : "the cylinder";
}

std::string typed(const Vector3<double>& v) {
  const auto digits = [](double x) { return printed("%.4g", std::abs(x) < 1e-15 ? 0 : x); };
  return "[" + digits(v[0]) + ", " + digits(v[1]) + ", " + digits(v[2]) + "]";
}

class SceneChecker {
public:
  explicit SceneChecker(const SceneFile& file)
      : file_(file),
        has_surface_(file.shape.kind != ObjectShape::Kind::unknown && !is_particle(file)),
        size_(file.shape.size.maxCoeff()) {}

  std::vector<SceneDoubt> check() {
    doubts_ = unit_doubts(file_);
    const bool may_be_moved = has_surface_ && doubts_.empty() && !file_.lines.all_on_faces;
    const bool is_moved = may_be_moved && check_middle();
    for (std::size_t b = 0; b < file_.bodies.size(); ++b) {
      if (file_.strokes[b].from > 0) continue; // it comes to an object that has moved
      if (is_moved || (check_place(b) && check_normal(b))) check_motion(b);
    }
    for (std::size_t b = 0; b < file_.overhang.size(); ++b)
      if (file_.overhang[b] > 0)
        doubt(Doubt::overhang, file_.lines.bodies[b].place,
              body_label(file_, b) + "it reaches " + length_text(file_.overhang[b]) +
                  " beyond the box; what lies beside it does not press");
    check_jaws();
    check_opposed();
    check_table();
    check_load();
    if (file_.planar) check_plane();
    check_across();
    if (doubts_.empty()) check_sides();
    if (file_.lines.all_on_faces && !file_.object.center_of_mass.isZero(0))
      doubt(
          Doubt::center_of_mass, file_.lines.center_of_mass,
          "object: it lies around its center_of_mass, and its faces with all contacts on them, so "
          "this moves nothing; to hold it beside its centre of mass shift the contacts on "
          "their faces, such as center = [\"-40 mm\", 0], or give center and normal, not on");
    if (file_.lines.ranges > 0)
      doubt(Doubt::middle, file_.lines.ranges,
            "the middle of the ranges is taken, " + file_.lines.middle +
                "; hold, cone and plan answer for every value");
    std::stable_sort(doubts_.begin(), doubts_.end(),
                     [](const SceneDoubt& a, const SceneDoubt& b) { return a.line < b.line; });
    return std::move(doubts_);
  }

private:
  void doubt(Doubt doubt, int line, const std::string& text) {
    doubts_.push_back({doubt, file_.lines.file, line, text});
  }

  const Vector3<double>& position(Index point) const {
    return file_.positions[static_cast<std::size_t>(point)];
  }

  bool is_on_surface(const SurfacePoint& surface, double slack = surface_slack) const {
    return surface.distance <= slack * size_ &&
           surface.distance >= -depth_slack * file_.shape.size.minCoeff();
  }

  bool points_into(const Body<double>& body, const SurfacePoint& surface) const {
    return std::any_of(
        surface.outward.begin(), surface.outward.end(),
        [&](const Vector3<double>& outward) { return -body.normal.dot(outward) >= least_into; });
  }

  /// With the object around `middle`: does every contact lie on it and point into it?
  bool fits_around(const Vector3<double>& middle, double slack) const {
    SceneFile moved = file_;
    moved.object.center_of_mass = middle;
    return std::all_of(file_.bodies.begin(), file_.bodies.end(), [&](const Body<double>& body) {
      const Indices points = points_of(body);
      return std::all_of(points.begin(), points.end(), [&](Index i) {
        const SurfacePoint surface = nearest_on_surface(moved, position(i), surface_slack * size_);
        return is_on_surface(surface, slack) && points_into(body, surface);
      });
    });
  }

  /// Do the contacts fit the object around another middle than the file's: the scene's origin, or
  /// where the origin is a corner, an edge or a face of it?
  bool check_middle() {
    if (fits_around(file_.object.center_of_mass, surface_slack)) return false;
    for (int side = 0; side < 27; ++side) {
      const Vector3<double> sides(side % 3, side / 3 % 3, side / 9); // 0, 0, 0: the origin itself
      const Vector3<double> middle = sides.unaryExpr([](double s) { return s > 1 ? -0.5 : s / 2; })
                                         .cwiseProduct(file_.shape.size);
      if (!fits_around(middle, middle_slack)) continue;
      doubt(Doubt::center_of_mass, file_.lines.center_of_mass,
            "object: the contacts lie on " + shape_name(file_) + " around " + typed(middle) +
                ", but its middle, the centre of mass, is at " +
                typed(file_.object.center_of_mass) +
                "; change center_of_mass, or give inertia instead of the shape if the two differ");
      return true;
    }
    return false;
  }

  /// Is every point of the body where the object is? Names the worst one.
  bool check_place(std::size_t b) {
    const Body<double>& body = file_.bodies[b];
    Index worst = body.first_point;
    const auto off = [&](Index point) {
      return has_surface_ ? nearest_on_surface(file_, position(point), 0).distance
                          : (position(point) - file_.object.center_of_mass).norm();
    };
    for (const Index i : points_of(body))
      if (std::abs(off(i)) > std::abs(off(worst))) worst = i;
    const double distance = off(worst);
    const std::string which = body_label(file_, b) +
                              (body.point_count > 1 ? "its point " : "its place ") +
                              typed(position(worst)) + " ";
    if (distance > far_sizes * std::max(size_, file_.shape.size.norm())) {
      doubt(Doubt::far_from_object, file_.lines.bodies[b].place,
            which + "is " + length_text(distance) + " away from an object of " +
                length_text(size_) + "; positions are in m, in the scene's frame");
      return false;
    }
    if (!has_surface_) return true;
    const SurfacePoint surface = nearest_on_surface(file_, position(worst), 0);
    if (is_on_surface(surface)) return true;
    doubt(Doubt::outside_object, file_.lines.bodies[b].place,
          which + "lies " + length_text(std::abs(distance)) +
              (distance > 0 ? " outside of " : " inside of ") + shape_name(file_) +
              "; its nearest surface point is " + typed(surface.at));
    return false;
  }

  /// The face that most of the body's points touch, from outside; of two the one that its normal
  /// is more along.
  Vector3<double> touched_face(const Body<double>& body) const {
    std::vector<Vector3<double>> faces;
    for (const Index i : points_of(body))
      for (const Vector3<double>& outward :
           nearest_on_surface(file_, position(i), surface_slack * size_).outward)
        faces.push_back(outward);
    const auto rank = [&](const Vector3<double>& face) {
      const auto same = std::count_if(faces.begin(), faces.end(), [&](const auto& other) {
        return face.dot(other) > 1 - typed_slack;
      });
      return std::make_pair(same, std::abs(face.dot(body.normal)));
    };
    return *std::max_element(faces.begin(), faces.end(),
                             [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }

  /// Does the normal point into a face that the body touches, at each of its points?
  bool check_normal(std::size_t b) {
    if (!has_surface_) return true;
    const Body<double>& body = file_.bodies[b];
    Index wrong = 0;
    for (const Index i : points_of(body))
      if (!points_into(body, nearest_on_surface(file_, position(i), surface_slack * size_)))
        ++wrong;
    if (wrong == 0) return true;
    if (wrong < body.point_count) {
      doubt(Doubt::normal_along, file_.lines.bodies[b].normal,
            body_label(file_, b) + "its normal " + typed(body.normal) + " points into " +
                shape_name(file_) +
                " at some of its points and not at others; one contact touches "
                "one face, and its normal points into that");
      return false;
    }
    const Vector3<double> outward = touched_face(body);
    doubt(Doubt::normal_outward, file_.lines.bodies[b].normal,
          body_label(file_, b) + "its normal " + typed(body.normal) +
              (body.normal.dot(outward) > least_into ? " points out of "
                                                     : " lies along the surface of ") +
              shape_name(file_) + "; normals point into the object, here " + typed(-outward));
    return false;
  }

  void check_motion(std::size_t b) {
    const Body<double>& body = file_.bodies[b];
    if (body.role != Role::pusher || body.bilateral) return;
    double closing = -1;
    for (const Index i : points_of(body)) {
      const Vector3<double>& p = file_.points[static_cast<std::size_t>(i)];
      const double speed = wrench_column<double>(p, body.normal).dot(body.acceleration);
      const double scale =
          body.acceleration.head<3>().norm() + p.norm() * body.acceleration.tail<3>().norm();
      closing = std::max(closing, scale > 0 ? speed / scale : 0);
    }
    if (closing >= -typed_slack) return;
    doubt(Doubt::moves_away, file_.lines.bodies[b].motion,
          body_label(file_, b) + "moves away from the object, against its normal " +
              typed(body.normal) + "; turn its " +
              (file_.strokes[b].is_velocity ? "velocity" : "acceleration") +
              " round if it is to push");
  }

  /// The single body that an actuator drives along its normal, or none.
  std::vector<Index> bodies_closed_alone() const {
    std::vector<Index> count(file_.actuators.size(), 0), alone;
    for (const Drive<double>& drive : file_.drives)
      ++count[static_cast<std::size_t>(drive.actuator)];
    for (const Drive<double>& drive : file_.drives)
      if (count[static_cast<std::size_t>(drive.actuator)] == 1 &&
          file_.body(drive.body).role == Role::finger)
        alone.push_back(drive.body);
    return alone;
  }

  /// Opposed fingers yield together to a push along their normals: it meets nothing but inertia.
  void check_jaws() {
    const std::vector<Index> alone = bodies_closed_alone();
    for (const Index first : alone)
      for (const Index second : alone) {
        const Vector3<double>& normal = file_.body(first).normal;
        if (second <= first || normal.dot(file_.body(second).normal) > -1 + typed_slack) continue;
        const auto is_along = [&](const Body<double>& body) {
          const Vector3<double> motion = body.acceleration.head<3>();
          return body.role == Role::pusher &&
                 std::abs(motion.dot(normal)) > least_along * motion.norm();
        };
        if (std::none_of(file_.bodies.begin(), file_.bodies.end(), is_along)) continue;
        doubt(Doubt::jaws_independent, file_.lines.bodies[static_cast<std::size_t>(second)].normal,
              body_label(file_, static_cast<std::size_t>(second)) + "it and " +
                  quoted(file_.body_name(first)) +
                  " close independently, so both yield to a push along their normals; write "
                  "[gripper] jaws = \"parallel\" if one drive moves them");
        return;
      }
  }

  /// Driven fingers that press the same way in empty space: no other body and no load meets them.
  void check_opposed() {
    const std::vector<Index> alone = bodies_closed_alone();
    if (alone.empty() || file_.hand != Hand::independent) return;
    const Body<double>& finger = file_.body(alone[0]);
    const Scene<double> scene = file_.view();
    const bool in_plane = !file_.planar || std::abs(finger.normal.z()) < 1 - typed_slack;
    const bool is_met =
        laws::load(scene, {1.0, 1.0, 1.0}).head<3>().dot(finger.normal) < 0 ||
        std::any_of(file_.bodies.begin(), file_.bodies.end(), [&](const auto& other) {
          return other.bilateral || other.normal.dot(finger.normal) < -typed_slack;
        });
    const bool is_one_way = std::all_of(alone.begin(), alone.end(), [&](Index b) {
      return file_.body(b).normal.dot(finger.normal) > 1 - typed_slack;
    });
    if (is_met || !in_plane || !is_one_way) return;
    doubt(Doubt::unopposed, file_.lines.bodies[static_cast<std::size_t>(alone.back())].normal,
          quoted(file_.body_name(alone.back())) +
              " presses and nothing presses against it; a jaw is two fingers on opposite faces");
  }

  /// Fingers that press from both sides, across a plane or along their normals: as hard as each
  /// other, if nothing else meets the rest?
  void check_across() {
    const std::vector<Index> alone = bodies_closed_alone();
    if (alone.size() < 2 || alone.size() != file_.drives.size()) return;
    Vector3<double> across = file_.body(alone[0]).normal;
    if (file_.planar) across = Vector3<double>::UnitZ();
    double left = 0, most = 0;
    bool is_jaw = file_.planar; // in space of what closes along its normal, from both sides
    for (const Drive<double>& drive : file_.drives) {
      const double force = file_.actuators[static_cast<std::size_t>(drive.actuator)].force;
      const double along = file_.body(drive.body).normal.dot(across);
      if (!file_.planar && std::abs(along) < 1 - typed_slack) return;
      is_jaw = is_jaw || (along < 0 && file_.hand == Hand::independent);
      left += force * along;
      most = std::max(most, force);
    }
    if (!is_jaw) return;
    const double load = laws::load(file_.view(), {1.0, 1.0, 1.0}).head<3>().dot(across);
    bool is_met = !file_.planar && load * left < -typed_slack * most * std::abs(left);
    for (Index b = 0; b < static_cast<Index>(file_.bodies.size()); ++b)
      is_met =
          is_met || ((file_.body(b).normal.dot(across) * left < 0 || file_.body(b).bilateral) &&
                     !is_driven(file_.view(), b));
    if (is_met || !(std::abs(left) > typed_slack * most)) return;
    doubt(Doubt::unopposed, file_.lines.bodies[static_cast<std::size_t>(alone.back())].normal,
          "the fingers press with " + shown(std::abs(left)) +
              " N more one way than the other, and nothing meets that; a parallel jaw has the same "
              "grip_force on opposite faces");
  }

  bool is_flat_below(const Vector3<double>& up) const {
    if (file_.shape.kind == ObjectShape::Kind::cylinder)
      return std::abs(up[file_.shape.axis]) > 1 - typed_slack;
    return file_.shape.kind != ObjectShape::Kind::ball;
  }

  /// Friction needs something that presses: weight, a force, a grip, or a push against a finger.
  void check_load() {
    if (!file_.gravity.isZero(0) || !file_.object.wrench.isZero(0) || !file_.drives.empty() ||
        !file_.faces.empty())
      return;
    bool has_finger = false, is_pressed = false;
    for (const Body<double>& finger : file_.bodies) {
      if (finger.role != Role::finger || !(finger.friction > 0)) continue;
      has_finger = true;
      is_pressed = is_pressed || finger.preload > 0;
      for (const Body<double>& pusher : file_.bodies)
        is_pressed = is_pressed || (pusher.role == Role::pusher &&
                                    pusher.acceleration.head<3>().dot(finger.normal) <
                                        -typed_slack * pusher.acceleration.norm());
    }
    if (!has_finger || is_pressed) return;
    doubt(Doubt::no_load, file_.lines.object,
          "nothing presses the object against what it touches, neither gravity nor a force nor a "
          "grip_force; for its weight write gravity = [0, 0, -9.81]");
  }

  /// All that the object lies on, and a push along it: beyond its edge nothing bears the object.
  void check_table() {
    if (file_.patches.empty() || !file_.drives.empty() || file_.body(0).role != Role::finger ||
        file_.bodies.size() < 2 || file_.body(1).role == Role::finger)
      return;
    const Vector3<double>& up = file_.body(0).normal;
    const PatchShape shape = file_.patches[0];
    const bool is_area = shape == PatchShape::disc || shape == PatchShape::rectangle ||
                         (file_.planar && shape == PatchShape::line);
    const bool is_table = is_area && !file_.strokes[0].rides_on_object && is_flat_below(up) &&
                          up.dot(file_.gravity) < -(1 - typed_slack) * file_.gravity.norm();
    const bool is_pushed =
        std::any_of(file_.bodies.begin() + 1, file_.bodies.end(), [&](const Body<double>& body) {
          const Vector3<double> motion = body.acceleration.head<3>();
          return std::abs(motion.dot(up)) < least_along * motion.norm();
        });
    if (!is_table || !is_pushed || file_.gravity.isZero(0)) return;
    doubt(Doubt::small_table, file_.lines.bodies[0].place,
          file_.body_name(0) +
              " stands still and is only as large as its shape: in a motion the object slides "
              "off it; for a table without end write points_on = \"object\"");
  }

  /// What a plane's guides would bear in silence, though a contact should.
  void check_plane() {
    const Scene<double> scene = file_.view();
    const Vector6<double> w = laws::load(scene, {1.0, 1.0, 1.0});
    double across = w[2];
    const bool is_loaded = across != 0; // less what fingers are told to bear of it
    for (const Drive<double>& drive : file_.drives)
      across += is_loaded ? file_.actuators[static_cast<std::size_t>(drive.actuator)].force *
                                file_.body(drive.body).normal[2]
                          : 0;
    const double moment = w.segment<2>(3).norm();
    const bool by_gravity = std::abs(file_.gravity[2]) > 0;
    const int line = by_gravity ? file_.lines.gravity : file_.lines.object;
    if (std::abs(across) > typed_slack * w.head<3>().norm()) {
      const auto below =
          std::find_if(file_.bodies.begin(), file_.bodies.end(), [&](const Body<double>& body) {
            return body.role == Role::finger && body.normal[2] * across < 0 &&
                   std::abs(body.normal[2]) > 1 - typed_slack &&
                   !is_driven(scene, &body - file_.bodies.data());
          });
      doubt(Doubt::left_out, line,
            printed("planar leaves out %.3g N along z; ", std::abs(across)) +
                (below == file_.bodies.end()
                     ? "remove planar if the contacts are to bear it"
                     : "give the finger " + quoted(file_.body_name(below - file_.bodies.begin())) +
                           printed(" grip_force = %.3g for what it bears", std::abs(across))));
    } else if (moment > typed_slack * w.tail<3>().norm()) {
      doubt(Doubt::left_out, line,
            "planar leaves out a moment of " + brief(moment) +
                " N m across the plane; remove planar if the contacts are to bear it");
    }
  }

  void check_sides() {
    if (file_.hand != Hand::parallel && file_.hand != Hand::locked) return;
    std::vector<std::size_t> jaws; // other fingers are stops
    for (std::size_t b = 0; b < file_.bodies.size(); ++b)
      if (file_.bodies[b].preload > 0 || is_driven(file_.view(), static_cast<Index>(b)))
        jaws.push_back(b);
    const std::size_t one = jaws[0], other = jaws[1];
    if (!(file_.bodies[one].normal.dot(file_.bodies[other].normal) > 0)) return;
    doubt(Doubt::jaws_same_side, file_.lines.bodies[other].normal,
          body_label(file_, other) + "it and " + quoted(file_.body_names[one]) +
              " press the same way, though jaws close toward each other; turn one normal round, or "
              "move one finger to the other side");
  }

  const SceneFile& file_;
  bool has_surface_;
  double size_; ///< m, the object's longest edge
  std::vector<SceneDoubt> doubts_;
};

} // namespace

const char* doubt_code(Doubt doubt) {
  constexpr const char* codes[] = {
      "outside_object",   "far_from_object", "normal_outward", "moves_away",    "density",
      "jaws_independent", "center_of_mass",  "normal_along",   "friction",      "gravity",
      "acceleration",     "inertia",         "jaws_same_side", "unknown_shape", "overhang",
      "left_out",         "middle",          "unopposed",      "small_table",   "no_load"};
  return codes[static_cast<int>(doubt)];
}

std::vector<SceneDoubt> check_scene(const SceneFile& file) { return SceneChecker(file).check(); }

std::string doubt_text(const SceneDoubt& doubt) {
  return doubt.file + ":" + std::to_string(doubt.line) + ": " + doubt.text;
}

} // namespace lcpush::desktop
