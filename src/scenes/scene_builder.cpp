#include "scenes/scene_builder.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "scenes/exact_frame.hpp"
#include "scenes/object_pose.hpp"
#include "scenes/object_surface.hpp"
#include "scenes/on_face.hpp"
#include "scenes/scene_ranges.hpp"
#include "scenes/scene_schema.hpp"
#include "scenes/scene_tables.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>

namespace lcpush::desktop {
namespace {

// Rounding of a normal that no decimal number can give exactly.
constexpr double direction_slack = 1e-9;

/// The first body of a planar scene that moves where nothing in the plane gives way: across the
/// plane along its face, or into the object where its normal force does not move that in the plane.
/// Pressing on would be a jam of one contact. -1 if there is none.
template <class S> Index moves_out_of_plane(const SceneOf<S>& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body<S>& body = scene.bodies[b];
    for (const Index i : points_of(body)) {
      const Vector3<S>& p = scene.points[static_cast<std::size_t>(i)];
      const Vector6<S> column = wrench_column<S>(p, body.normal);
      const double in_plane = std::hypot(as_double(column[0]), as_double(column[1]));
      const double turning = std::abs(as_double(column[5]));
      const bool moves_it =
          in_plane > direction_slack || turning > direction_slack * as_doubles(p).norm();
      const S closing = column.dot(body.acceleration);
      const Vector3<double> motion = as_doubles<S>(acceleration_at(p, body.acceleration));
      const bool slips_across = body.in_plane && body.friction > S(0) &&
                                std::abs(motion[2]) > direction_slack * motion.norm();
      if (slips_across || (!moves_it && (body.bilateral ? closing != S(0) : closing > S(0))))
        return static_cast<Index>(b);
    }
  }
  return -1;
}

template <class S> class SceneBuilder {
public:
  /// `cuts`: does what lies beside the object's box not belong to its contacts?
  SceneBuilder(const TomlDocument& document, std::optional<Hand> unsaid_hand, Strokes strokes,
               bool cuts = false)
      : document_(document), unsaid_hand_(unsaid_hand), strokes_(strokes), cuts_(cuts) {}

  /// Call once.
  SceneOf<S> build() {
    read_settings();
    scene_.object = read_object<S>(reader("object"), scene_.shape);
    read_start();
    if (reader("object").has("box"))
      box_.emplace(ObjectBox<S>{scene_.object.center_of_mass,
                                reader("object").template vector3<S>("box") / S(2)});
    scene_.lines = {document_.file,
                    reader("").line_of({"gravity"}),
                    reader("object").line(),
                    reader("object").line_of({"center_of_mass"}),
                    reader("").has("facets") ? reader("").line_of({"facets"}) : 0,
                    false,
                    {},
                    0,
                    ""};
    for (std::size_t i = 0; i < count("finger"); ++i) read_body(Role::finger, reader("finger", i));
    read_pushers();
    if (scene_.bodies.empty())
      throw InputError(document_.file, 1,
                       "nothing touches the object; add at least one [[finger]] or [[pusher]]");
    drive_fingers();
    for (std::size_t i = 0; i < count("actuator"); ++i) read_actuator(reader("actuator", i));
    for (std::size_t i = 0; i < pushers_.size(); ++i)
      drive_pusher(pushers_[i], static_cast<Index>(count("finger") + i));
    for (std::size_t i = 0; i < count("face"); ++i)
      scene_.faces.push_back(
          read_face(reader("face", i), as_doubles<S>(scene_.object.center_of_mass)));
    if (scene_.planar) refuse_motions_out_of_plane();
    scene_.is_round = scene_.is_round && scene_.has_cones();
    return std::move(scene_);
  }

  /// Does a line or rectangle reach well beyond the box' face that it lies on?
  bool reaches_beyond() const { return reaches_beyond_; }

private:
  /// How many tables there are of [[section]].
  std::size_t count(const std::string& section) const {
    const TomlSection* const found = document_.find(section);
    return found != nullptr ? found->tables.size() : 0;
  }

  TableReader reader(const std::string& section, std::size_t index = 0) const {
    const TomlSection* const found = document_.find(section);
    const TomlTable& table = found != nullptr ? found->tables[index] : document_.root;
    return TableReader(document_.file, table, found != nullptr ? table_label(*found, index) : "",
                       schema_of(section));
  }

  std::string claim_name(const TableReader& table) {
    const std::string name = table.text("name");
    const auto [first, is_new] = name_lines_.emplace(name, table.line());
    if (!is_new)
      table.fail("name", "the name " + quoted(name) + " is taken by the table on line " +
                             std::to_string(first->second) + "; names must be unique");
    return name;
  }

  void read_settings() {
    const TableReader root = reader("");
    if (root.has("title")) scene_.title = root.text("title");
    if (root.has("gravity")) scene_.gravity = root.vector3<S>("gravity");
    scene_.is_round = !root.has("facets") || root.is_text("facets");
    if (root.is_text("facets") && root.text("facets") != "round")
      root.fail("facets", "facets must be a whole number from 4 to 256, or \"round\", got " +
                              quoted(root.text("facets")));
    if (root.has("facets") && !scene_.is_round) scene_.facets = root.whole("facets", 4, 256);
    if (scene_.facets % 2 != 0)
      root.fail("facets", "facets must be even, got " + std::to_string(scene_.facets));
    if (root.has("pressure"))
      scene_.pressure = static_cast<Pressure>(root.choice("pressure", pressure_names()));
    if (root.has("planar")) scene_.planar = root.boolean("planar");
  }

  /// How the object moves when a motion begins.
  void read_start() {
    const TableReader object = reader("object");
    Vector3<double> linear = Vector3<double>::Zero(), angular = linear;
    if (object.has("velocity")) linear = object.vector3<double>("velocity");
    if (object.has("angular_velocity")) angular = object.vector3<double>("angular_velocity");
    scene_.start << linear, angular;
    const bool leaves_plane = linear[2] != 0 || angular[0] != 0 || angular[1] != 0;
    if (scene_.planar && leaves_plane)
      object.fail(linear[2] != 0 ? "velocity" : "angular_velocity",
                  "this takes the object out of the x-y plane; remove it, or planar");
  }

  /// Of the strokes that are meant.
  void read_pushers() {
    for (std::size_t i = 0; i < count("pusher"); ++i) {
      const TableReader table = reader("pusher", i);
      if (strokes_ == Strokes::first && read_stroke(table).from > 0) {
        scene_.later.push_back(claim_name(table));
        continue;
      }
      read_body(Role::pusher, table);
      pushers_.push_back(table);
    }
  }

  /// Not on a cylinder's flat end, nor as far inside as points that stand for what lies below.
  bool is_on_round_side(const Patch<S>& patch) const {
    const ObjectShape& shape = scene_.shape;
    Vector3<S> n = patch.normal, p = patch.positions.front() - scene_.object.center_of_mass;
    if (shape.kind == ObjectShape::Kind::cylinder)
      n[shape.axis] = p[shape.axis] = S(0);
    else if (shape.kind != ObjectShape::Kind::ball)
      return false;
    const S radius(shape.size[(shape.axis + 1) % 3] / 2);
    return n.dot(n) > S(1) / S(2) && p.dot(p) > radius * radius / S(4);
  }

  void read_body(Role role, const TableReader& table) {
    if (scene_.bodies.size() == limits::scene_bodies)
      table.fail("", "more than " + std::to_string(limits::scene_bodies) +
                         " bodies in the scene; use fewer");
    if (table.has("frame")) (void)table.choice("frame", {"object", "scene"}); // see in_object_frame
    scene_.strokes.push_back(read_stroke(table));
    scene_.body_names.push_back(claim_name(table));
    Vector3<S> shift = Vector3<S>::Zero();
    if (table.has("shift")) shift = table.vector3<S>("shift");
    std::optional<ObjectBox<S>> box = box_;
    if (box) box->middle -= shift; // as the patch has it before the shift
    const double least = surface_slack * scene_.shape.size.maxCoeff();
    Patch<S> patch = read_patch<S>(table, box ? &*box : nullptr,
                                   cuts_ ? least : std::numeric_limits<double>::infinity());
    for (Vector3<S>& position : patch.positions) position += shift;
    reaches_beyond_ = reaches_beyond_ || patch.overhang > least;
    if (cuts_) scene_.overhang.push_back(patch.overhang > least ? patch.overhang : 0);
    Body<S> body{};
    body.role = role;
    body.normal = patch.normal;
    body.tangent = patch.tangent;
    if (scene_.strokes.back().rides_on_object && is_on_round_side(patch))
      table.fail("points_on", "a contact moves over a round side as the object rolls, and does not "
                              "go with it; remove points_on");
    body.friction = table.number<S>("friction", Sign::not_negative);
    body.first_point = static_cast<Index>(scene_.points.size());
    body.point_count = static_cast<Index>(patch.positions.size());
    body.acceleration = role == Role::pusher ? prescribed_twist(table) : Vector6<S>::Zero();
    if (table.has("torsion_radius")) {
      body.torsion_radius = table.number<S>("torsion_radius", Sign::positive);
      if (body.point_count != 1)
        table.fail("torsion_radius",
                   "torsion_radius goes with a single point only; this patch has " +
                       std::to_string(body.point_count));
    }
    lie_in_plane(body, scene_.planar);
    if (table.has("follow"))
      body.bilateral = table.choice("follow", {"unilateral", "bilateral"}) == 1;
    if (body.bilateral && table.has("normal_force"))
      table.fail("follow", "follow = \"bilateral\" holds the pusher's normal motion, normal_force "
                           "its force; remove one of the two");
    scene_.bodies.push_back(body);
    scene_.patches.push_back(patch.shape);
    scene_.lines.bodies.push_back(
        {table.line_of({"center", "ends", "points"}), table.line_of({"normal"}),
         table.line_of({"friction"}),
         table.line_of({"velocity", "angular_velocity", "acceleration", "angular_acceleration"})});
    if (scene_.points.size() + patch.positions.size() > limits::scene_points)
      table.fail("points", "more than " + std::to_string(limits::scene_points) +
                               " contact points in the scene; use fewer");
    for (const Vector3<S>& position : patch.positions) {
      scene_.positions.push_back(position);
      scene_.points.push_back(position - scene_.object.center_of_mass);
    }
    scene_.weights.insert(scene_.weights.end(), patch.weights.begin(), patch.weights.end());
    if constexpr (!std::is_same_v<S, double>)
      scene_.inexact.insert(scene_.inexact.end(), patch.inexact.begin(), patch.inexact.end());
    for (const char* key : {"angular_velocity", "angular_acceleration"}) note_degrees(table, key);
  }

  void note_degrees(const TableReader& table, const std::string& key) {
    if constexpr (!std::is_same_v<S, double>)
      if (table.is_irrational(key))
        scene_.inexact.push_back("the " + key + " of " + table.label() +
                                 " is irrational: a fraction within 1e-12 of it is used");
  }

  Vector6<S> prescribed_twist(const TableReader& table) const {
    const auto optional = [&table](const std::string& key) {
      return table.has(key) ? table.vector3<S>(key) : Vector3<S>(Vector3<S>::Zero());
    };
    const MotionKeys keys = motion_keys(table);
    return twist_at(optional(keys.linear), optional(keys.angular), optional("about"));
  }

  void drive_fingers() {
    HandTables tables;
    if (document_.find("gripper")) tables.gripper.emplace(reader("gripper"));
    for (std::size_t i = 0; i < count("finger"); ++i) tables.fingers.push_back(reader("finger", i));
    if (const TomlSection* const actuator = document_.find("actuator"))
      tables.actuator_line = actuator->tables.front().line;
    drive_hand(tables, unsaid_hand_, scene_);
  }

  void drive_pusher(const TableReader& table, Index body) {
    if (!table.has("normal_force")) return;
    const S force = table.number<S>("normal_force", Sign::positive);
    const std::string key = motion_keys(table).linear;
    if (table.has(key)) {
      const Vector3<S> motion = table.vector3<S>(key);
      const double along = as_double(motion.dot(scene_.body(body).normal));
      if (std::abs(along) > direction_slack * as_doubles(motion).norm())
        table.fail(key, "normal_force decides the motion along the normal; " + key +
                            " must have no part along it, got " + shown(along));
    }
    drive_along_normal(scene_, body, add_actuator<S>(scene_, scene_.body_name(body), force, S(0)));
  }

  /// A rigid motion that moves `at` with `linear`, taken at the centre of mass.
  Vector6<S> twist_at(const Vector3<S>& linear, const Vector3<S>& angular,
                      const Vector3<S>& at) const {
    Vector6<S> twist;
    twist << linear + cross<S>(angular, scene_.object.center_of_mass - at), angular;
    return twist;
  }

  void read_actuator(const TableReader& table) {
    const std::string name = claim_name(table);
    const std::vector<std::string> bodies = table.texts("bodies", scene_.bodies.size());
    const std::vector<std::vector<S>> twists = table.rows<S>("twists", 6, scene_.bodies.size());
    if (twists.size() != bodies.size())
      table.fail("twists", "twists must have one entry for each of the " +
                               std::to_string(bodies.size()) + " bodies, got " +
                               std::to_string(twists.size()));
    if (table.has("force") == table.has("acceleration"))
      table.fail("acceleration", "an actuator has either a force or an acceleration; give one");
    const bool is_prescribed = table.has("acceleration");
    if (!is_prescribed && bodies.size() > 1 && scene_.pressure == Pressure::even)
      table.fail("bodies", "an actuator of several bodies shares one force over them, so no "
                           "point's even share of it is known; use another pressure than \"even\"");
    if (is_prescribed && table.has("inertia"))
      table.fail("inertia", "inertia goes with force; remove it");
    const S amount = table.number<S>(is_prescribed ? "acceleration" : "force",
                                     is_prescribed ? Sign::any : Sign::not_negative);
    note_degrees(table, "acceleration");
    const S inertia = table.has("inertia") ? table.number<S>("inertia", Sign::not_negative) : S(0);
    if (!is_prescribed && amount == S(0) && inertia == S(0))
      table.fail("force", "an actuator without force and inertia holds nothing; give it one of "
                          "them, or remove it and its bodies");
    const Index actuator = is_prescribed ? 0 : add_actuator<S>(scene_, name, amount, inertia);
    const std::vector<std::string>& known = scene_.body_names;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const auto found = std::find(known.begin(), known.end(), bodies[i]);
      if (found == known.end())
        table.fail("bodies",
                   "no body is called " + quoted(bodies[i]) + suggestion(bodies[i], known));
      if (std::count(bodies.begin(), bodies.end(), bodies[i]) > 1)
        table.fail("bodies", "the body " + quoted(bodies[i]) + " is listed twice; remove one");
      const std::vector<S>& t = twists[i]; // at the origin
      const Vector6<S> twist = twist_at({t[0], t[1], t[2]}, {t[3], t[4], t[5]}, Vector3<S>::Zero());
      if (twist == Vector6<S>(Vector6<S>::Zero()))
        table.fail("twists", "the twist of " + quoted(bodies[i]) + " is zero");
      const auto body = found - known.begin();
      if (scene_.strokes[static_cast<std::size_t>(body)].is_limited())
        table.fail("bodies",
                   "an actuator moves its bodies all the time; remove from and until of " +
                       quoted(bodies[i]));
      if (is_prescribed) {
        scene_.bodies[static_cast<std::size_t>(body)].acceleration += amount * twist;
        scene_.prescribed.push_back({name, body, amount, twist});
      } else {
        scene_.drives.push_back({body, actuator, twist});
      }
    }
  }

  void refuse_motions_out_of_plane() const {
    const Index moving = moves_out_of_plane(scene_);
    if (moving < 0) return;
    const std::string& name = scene_.body_name(moving);
    const Body<S>& body = scene_.body(moving);
    const std::string how =
        body.in_plane
            ? "moves across the plane, where planar = true has no friction"
            : (body.bilateral ? std::string("moves ") : std::string("moves into ")) +
                  "the object out of the plane, where planar = true lets nothing give way";
    throw InputError(document_.file, name_lines_.at(name),
                     quoted(name) + ": " + how + "; move it in the x-y plane or remove planar");
  }

  const TomlDocument& document_;
  const std::optional<Hand> unsaid_hand_;
  const Strokes strokes_;
  const bool cuts_;
  bool reaches_beyond_ = false;
  std::optional<ObjectBox<S>> box_;  ///< of an object that is one
  std::vector<TableReader> pushers_; ///< of the scene's pushers
  SceneOf<S> scene_;
  std::map<std::string, int> name_lines_; ///< of bodies and [[actuator]]s
};

void note_ranges(const TomlDocument& document, SceneLines& lines) {
  RangeNote note = range_note(document);
  lines.ranges = note.line;
  lines.middle = std::move(note.text);
}

/// Is it not the object's middle or its size that is a slip? A cut would hide that.
bool is_well_placed(const TomlDocument& document, std::optional<Hand> unsaid_hand) {
  const SceneFile file = SceneBuilder<double>(document, unsaid_hand, Strokes::all).build();
  const std::vector<SceneDoubt> doubts = check_scene(file);
  return std::none_of(doubts.begin(), doubts.end(), [](const SceneDoubt& found) {
    return found.doubt == Doubt::center_of_mass || found.doubt == Doubt::density;
  });
}

/// The same of a document whose contacts stand at places; `is_well`: on the object's faces, as was
/// typed.
template <class S>
SceneOf<S> build_placed(const TomlDocument& document, std::optional<Hand> unsaid_hand,
                        Strokes strokes, bool is_well) {
  if (has_turned_object(document)) {
    SceneOf<S> scene = build_placed<S>(in_object_frame(document), unsaid_hand, strokes, is_well);
    if constexpr (!std::is_same_v<S, double>)
      scene.inexact.push_back(
          "the rotation of the object is irrational: a fraction within 1e-12 of "
          "it is used");
    return scene;
  }
  SceneBuilder<S> builder(document, unsaid_hand, Strokes::all);
  SceneOf<S> scene = builder.build();
  if (strokes == Strokes::first) {
    const bool has_later = std::any_of(scene.strokes.begin(), scene.strokes.end(),
                                       [](const Stroke& stroke) { return stroke.from > 0; });
    const bool cuts =
        builder.reaches_beyond() && (is_well || is_well_placed(document, unsaid_hand));
    if (has_later || cuts) scene = SceneBuilder<S>(document, unsaid_hand, strokes, cuts).build();
  }
  return scene;
}

} // namespace

template <class S>
SceneOf<S> build_scene(const TomlDocument& document, std::optional<Hand> unsaid_hand,
                       Strokes strokes) {
  const bool all_on_faces = are_all_on_faces(document);
  SceneOf<S> scene =
      has_contacts_on_faces(document)
          ? build_placed<S>(with_typed_places(document), unsaid_hand, strokes, all_on_faces)
          : build_placed<S>(document, unsaid_hand, strokes, false);
  scene.lines.all_on_faces = all_on_faces;
  note_ranges(document, scene.lines);
  return scene;
}
template SceneOf<double> build_scene(const TomlDocument& document, std::optional<Hand> unsaid_hand,
                                     Strokes strokes);
template SceneOf<Rational> build_scene(const TomlDocument& document,
                                       std::optional<Hand> unsaid_hand, Strokes strokes);

} // namespace lcpush::desktop
