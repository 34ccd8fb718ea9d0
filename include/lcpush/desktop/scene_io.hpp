// lcpush: a scene file (a strict subset of TOML) becomes a Scene.
#pragma once

#include "lcpush/desktop/rational.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "lcpush/mechanics/model/scene.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lcpush {
/// Of an exact scene's friction directions: with circle_sine a point of the unit circle without any
/// error, within 1e-12 of the angle; docs/check/certificates.md has the rule.
template <> desktop::Rational circle_cosine<desktop::Rational>(Index j, Index g);
template <> desktop::Rational circle_sine<desktop::Rational>(Index j, Index g);
} // namespace lcpush

namespace lcpush::desktop {

/// What the object looks like: pictures draw it, motions touch its surface.
struct ObjectShape {
  enum class Kind {
    box,
    cylinder,
    ball,
    unknown, ///< the file gives the inertia alone: drawn as the box with these principal moments
  };
  Kind kind = Kind::unknown;
  Vector3<double> size = Vector3<double>::Zero(); ///< m, what encloses it, edge by edge
  Index axis = 2;                                 ///< of a cylinder: 0, 1 or 2 for x, y or z
};

/// What moves the fingers; docs/theory/theory.md, "Hands".
enum class Hand {
  fixed,       ///< nothing: no finger, or stops alone
  independent, ///< each finger keeps its own grip force, and yields freely along its normal
  parallel,    ///< one actuator of twice the grip force closes both; it carries the difference
  locked,      ///< the fingers stand still; the grip force is what they pressed with before
  actuators,   ///< as the file's [[actuator]]s say
};

/// As JSON spells it.
constexpr const char* hand_text(Hand hand) {
  constexpr const char* texts[] = {"fixed", "independent", "parallel", "locked", "actuators"};
  return texts[static_cast<int>(hand)];
}

/// What an [[actuator]] with an acceleration does to one body. The body's own acceleration has it.
template <class S> struct PrescribedDrive {
  std::string actuator;
  Index body;
  S acceleration;   ///< m/s^2 or rad/s^2
  Vector6<S> twist; ///< for a unit of it, at the object's centre of mass
};

/// When a body is there and how it moves, for a motion. Its speeds are those of Body::acceleration.
struct Stroke {
  bool is_velocity = false;     ///< m/s and rad/s all the time; else m/s^2 and rad/s^2, from rest
  bool rides_on_object = false; ///< its points are the object's, and press on its plane
  double from = 0;              ///< s; it touches nothing before
  double until = std::numeric_limits<double>::infinity(); ///< s; nor after

  bool is_limited() const { return from > 0 || until < std::numeric_limits<double>::infinity(); }
};

/// What a body's points stand for.
enum class PatchShape { points, line, ring, disc, rectangle };

/// A flat part of the object's surface, convex.
struct ObjectFace {
  Vector3<double> normal = Vector3<double>::UnitZ(); ///< unit, out of the object
  std::vector<Vector3<double>> corners;              ///< m, in the scene's frame, in order
};

/// Where a scene file says what: 1-based lines, for messages about what was read.
struct SceneLines {
  struct OfBody {
    int place; ///< center, ends or points
    int normal;
    int friction;
    int motion; ///< velocity or what else moves it; its table's line without one
  };
  std::string file; ///< as messages name it
  int gravity = 0, object = 0, center_of_mass = 0;
  int facets = 0;            ///< 0: the file does not say
  bool all_on_faces = false; ///< every contact is given by `on`, and goes where the object is
  std::vector<OfBody> bodies;
  int ranges = 0;     ///< of the first number that has a range; 0: none
  std::string middle; ///< of the ranges, in words
};

/// The arrays behind a Scene, and the names that the core does not need.
/// Bodies are the file's fingers, then its pushers, each in the file's order.
template <class S> struct SceneOf {
  std::string title; ///< empty if the file has none
  Object<S> object{};
  ObjectShape shape;
  Vector3<S> gravity = Vector3<S>::Zero(); ///< m/s^2
  Index facets = 8;
  /// Coulomb's round cone, [T.16], as a scene says with `facets = "round"` or with no `facets`, and
  /// there are cones: pyramids of `facets` sides are turned until friction is round.
  bool is_round = false;
  Pressure pressure = Pressure::pad;
  bool planar = false;
  Hand hand = Hand::fixed;
  std::vector<Body<S>> bodies;
  std::vector<Vector3<S>> points;    ///< m, from the centre of mass, body by body
  std::vector<Vector3<S>> positions; ///< m, the same points in the scene's frame
  std::vector<S> weights;            ///< of the points, as Scene has them
  std::vector<Actuator<S>> actuators;
  std::vector<Drive<S>> drives;
  std::vector<PrescribedDrive<S>> prescribed; ///< for reading only: nothing is solved with them
  std::vector<Stroke> strokes;                ///< of the bodies
  Vector6<double> start = Vector6<double>::Zero(); ///< the object's twist as a motion begins
  std::vector<ObjectFace> faces;       ///< as the file's [[face]]s say; none: the shape's
  std::vector<std::string> body_names; ///< unique
  std::vector<std::string> later;      ///< pushers that are there only later, and left out: Strokes
  std::vector<std::string>
      actuator_names; ///< of the body or the [[actuator]]; "jaws" of a parallel hand
  SceneLines lines;
  std::vector<PatchShape> patches; ///< of the bodies; none: points
  std::vector<double> overhang;    ///< m, of the bodies: so far each was cut off; empty: none was
  /// Of an exact scene: a sentence for each thing that is irrational, which therefore is not exact.
  std::vector<std::string> inexact;

  // Compiled once: every room copies scenes.
  SceneOf();
  SceneOf(const SceneOf&);
  SceneOf(SceneOf&&) noexcept;
  SceneOf& operator=(const SceneOf&);
  SceneOf& operator=(SceneOf&&) noexcept;
  ~SceneOf();

  /// The scene over these arrays: valid while this object lives unchanged.
  Scene<S> view() const {
    const auto span_of = [](const auto& list) {
      using T = typename std::decay_t<decltype(list)>::value_type;
      return Span<const T>{list.data(), static_cast<Index>(list.size())};
    };
    return {object,          gravity,         facets,          pressure,
            planar,          span_of(bodies), span_of(points), span_of(actuators),
            span_of(drives), span_of(weights)};
  }

  /// Has friction a cone anywhere? Of a body in the plane it has an interval.
  bool has_cones() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body<S>& body) { return body.friction > S(0) && !body.in_plane; });
  }
  const std::string& body_name(Index b) const { return body_names[static_cast<std::size_t>(b)]; }
  const Body<S>& body(Index b) const { return bodies[static_cast<std::size_t>(b)]; }
  /// The body of a point of `points`. Cost: O(bodies).
  Index body_of(Index point) const {
    std::size_t b = 0;
    while (point >= bodies[b].first_point + bodies[b].point_count) ++b;
    return static_cast<Index>(b);
  }
};

using SceneFile = SceneOf<double>;

/// Is the answer the last of several complementarity problems, and no basis' exact one?
inline bool takes_rounds(const SceneFile& file) {
  return file.pressure == Pressure::pad || file.is_round;
}

/// m, what encloses its contact points and, of a known shape, the shape.
double object_size(const SceneFile& file);

/// How a pressure law is spelled, in the order of the enumeration.
inline std::vector<std::string> pressure_names() {
  std::vector<std::string> names;
  for (const Pressure pressure : pressures) names.emplace_back(pressure_text(pressure));
  return names;
}

/// Which of a file's pushers are meant.
enum class Strokes {
  first, ///< those that are there at the start: what `solve` and `break` speak of
  all,
};

/// The text of a scene file; of standard input for "-". Throws InputError if it cannot be read or
/// is far too large for one.
std::string read_scene_text(const std::string& path);
/// As messages name the file.
std::string scene_label(const std::string& path);

/// As read_scene, for a text in memory; `file_name` only names it in messages.
template <class S = double>
SceneOf<S> parse_scene(std::string_view text, const std::string& file_name,
                       Strokes strokes = Strokes::first);

/// Reads the scene file at `path`. Every value of the result is finite and physical: unit normals
/// and tangents, a positive definite inertia, at least one contact point, no coincident points in
/// a patch. Throws InputError, with file and line, on anything else; it guesses nothing.
///
/// S = Rational takes decimals as typed, so that 0.2 is 1/5. What no fraction can say (a normal
/// that takes a root, points of discs, directions of eight facets) is taken as the exact value of
/// its double and named in `inexact`; a number of more than 10,000 digits is refused.
template <class S = double>
SceneOf<S> read_scene(const std::string& path, Strokes strokes = Strokes::first) {
  return parse_scene<S>(read_scene_text(path), scene_label(path), strokes);
}

/// The sentences of `inexact` for the friction directions, which depend on `facets` as it is now.
std::vector<std::string> irrational_directions(const SceneOf<Rational>& scene);

} // namespace lcpush::desktop
