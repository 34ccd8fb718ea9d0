// How the push changes with a number of the scene: exactly, segment by segment between the
// breakpoints where a contact changes its mode, and in samples.
#pragma once

#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/desktop/stop.hpp"
#include "lcpush/desktop/telling.hpp"
#include "lcpush/desktop/varied_scene.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/status.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// One parameter and the range that it runs through.
struct Variation {
  Parameter parameter;
  double from = 0, to = 0; ///< different; from may be the larger one
};

/// The two questions of a sweep: the push as prescribed, and the instant of breaking.
enum class Question { push, breaking };
constexpr Question questions[] = {Question::push, Question::breaking};

/// What belongs to the one and to the other.
template <class T> struct OfBoth {
  T push{}, breaking{};

  T& operator[](Question question) { return question == Question::push ? push : breaking; }
  const T& operator[](Question question) const {
    return question == Question::push ? push : breaking;
  }
};

/// The answer to one of the two questions: the push as prescribed, or the instant of breaking.
/// Of an answer that is not solved all but the status is zero.
struct SweepAnswer {
  Status status = Status::bad_input; ///< bad_input: nothing moves, so that there is no question;
                                     ///< does_not_hold: the object moves before it is pushed
  double normal = 0;                 ///< N, the pusher's; of breaking the force of `break`
  Vector3<double> force = Vector3<double>::Zero(); ///< N, the pusher's on the object
  Vector6<double> twist = Vector6<double>::Zero(); ///< the object's acceleration; at breaking that
                                                   ///< of a unit push
  bool breaks = true;     ///< of breaking: does the object move? Otherwise `normal` breaks nothing
  double residual = 0;    ///< the worst law's
  double force_noise = 0; ///< N: what rounding leaves of a force
  double motion_noise = 0, turning_noise = 0; ///< m/s^2, rad/s^2: and of a twist

  double twist_noise(Index component) const { return component < 3 ? motion_noise : turning_noise; }
  bool is_solved() const { return status == Status::solved; }
  bool has_force() const { return is_solved() && breaks; }
  bool is_known() const { return is_solved() || status == Status::does_not_hold; }
};

/// What is known of the scene at one value.
struct SweepValue : OfBoth<SweepAnswer> {
  double residual() const { return std::max(push.residual, breaking.residual); }
};

/// What a contact does from some value of the parameter on that it did not do before.
struct ContactChange {
  Index contact;
  Mode from, to;
  bool was_pressed, is_pressed; ///< neither pair differs: its friction turns
  Vector3<double> slip; ///< from here on: unit vector, or zero if the contact does not slide
};

/// Why the exact path of answers did not simply go on.
enum class PathBreak {
  none,
  jump,        ///< all answers between the two are answers as well
  turned_back, ///< the path returns to values that it came from
  ray,         ///< the path has no next answer
};

/// What happens to one of the two answers: the contacts' modes change, or how they share their
/// forces; or from here on no answer is found; or there is one again.
struct AnswerChange {
  enum class Kind { modes, lost, found };
  Kind kind = Kind::modes;
  Status from = Status::solved, to = Status::solved;
  std::vector<ContactChange> contacts; ///< in the scene's order; none: forces are shared otherwise
  bool jumps = false;
  PathBreak path = PathBreak::none;
};

/// What happens at a value of the parameter. change_text puts it into words.
/// Several of one question only where they are too near to separate.
struct SweepChange : OfBoth<std::vector<AnswerChange>> {
  bool jumps = false; ///< an answer is discontinuous

  bool is_empty() const { return push.empty() && breaking.empty(); }
};

/// How a segment was found.
enum class SegmentKind {
  exact,    ///< one basis holds from end to end, found by parametric pivoting
  unsolved, ///< no answer was found between its ends
};
constexpr const char* segment_kind_text(SegmentKind kind) {
  return kind == SegmentKind::exact ? "exact" : "unsolved";
}

struct SweepSegment {
  double from = 0, to = 0; ///< in the sweep's direction
  SegmentKind kind = SegmentKind::exact;
  SweepValue at_from, at_to; ///< limits from inside
  SweepChange change;        ///< what happens at `to`; empty at the end of the sweep
};

struct SweepPoint {
  double value = 0;
  std::optional<double> second; ///< of the other parameter, in a map
  SweepValue at;
  std::vector<Mode> modes; ///< of every contact under the push as prescribed; empty if not solved
  bool refined = false;    ///< added between two of the steps, where modes change
  bool bistable = false;   ///< of a map: solved from nothing, the object moves in another way
  SweepChange change;      ///< refined: from this point to the next
};

/// A range in which sweeping up and sweeping down end in different answers.
struct BistableRange {
  double from, to;
  bool motion;             ///< the object moves in another way; else the forces alone differ
  double force_difference; ///< N, the largest of a force, in the middle of a stretch between cuts
  double force_share;      ///< the same, of the larger of the two forces
};

/// Where a component of the object's acceleration is zero or changes its sign.
struct SweepZero {
  Index component;           ///< of the twist: 0 to 5
  double from, to;           ///< the same for a single value
  bool jumps;                ///< the sign changes without a zero
  int before = 0, after = 0; ///< its sign on either side, in the sweep's direction; 0: unknown

  bool changes_sign() const { return (jumps || from == to) && before * after < 0; }
};

/// At a value the laws leave open how much friction something has, and with it the breaking force.
struct OpenForce {
  double value = 0;          ///< of the parameter, an end of its range
  double one = 0, other = 0; ///< N, both answers
};

struct Sweep {
  std::vector<Variation> variations; ///< one, or two for a map
  SceneFile scene;                   ///< as given: the names of its bodies and contacts
  std::string pusher;
  bool asks_breaking = false;         ///< a pusher moves somewhere in the range
  std::vector<SweepSegment> segments; ///< from variations[0].from to .to, without gaps
  std::vector<SweepSegment> back;     ///< the same the other way; only where it differs somewhere
  std::vector<SweepPoint> points;     ///< in the sweep's order; in a map row by row
  std::vector<SweepPoint> points_back;
  std::vector<BistableRange> bistable;
  std::optional<OpenForce> open; ///< not in a map
  std::vector<SweepZero> zeros;  ///< component by component, in the sweep's order; not in a map
  bool complete = true;          ///< every value was solved, or does not hold
  /// What ended it early. Then `variations` end where it has come to, if it has come anywhere.
  Stop stop = Stop::none;
  Index cold = 0, warm = 0; ///< solves from nothing, and from a neighbour's basis

  bool is_map() const { return variations.size() == 2; }
};

/// With every value of what varies in the unit as typed, which texts and pictures tell; data are
/// SI.
Sweep in_typed_units(Sweep sweep);

/// Calls see(SweepValue) for both ends of every segment and for every point, of the way there.
template <class See> void for_each_value(const Sweep& sweep, See see) {
  for (const SweepSegment& segment : sweep.segments) {
    see(segment.at_from);
    see(segment.at_to);
  }
  for (const SweepPoint& point : sweep.points) see(point.at);
}

struct ParameterSweepOptions {
  Index pusher = -1;     ///< body; -1: the only pusher
  Index steps = 0;       ///< points evenly spread, ends included; 0: none where segments are found
  bool both_ways = true; ///< sweep back as well, in search of other answers
  bool warm = true;      ///< start from the neighbour's answer
  std::function<void(double done)> progress; ///< 0 to 1
  StopCheck stop; ///< asked after each round and pivot; ends the sweep with what there is
};

/// Sweeps one parameter, or two for a map. Where `rigid` or `even` pressure and pyramids meet a
/// parameter that is linear (Parameter::linear), there are exact segments; all else is sampled.
/// Every answer has passed the referee (mechanics/model/check.hpp). Throws InputError if a value of
/// the range is no scene, or the scene has no pusher to speak of.
Sweep sweep_parameter(const VariedScene& scene, const std::vector<Variation>& variations,
                      const ParameterSweepOptions& options);

/// One of several sweeps that are shown together, such as one a number of facets.
struct SweepCurve {
  std::string label;             ///< "facets = 8"
  std::string scene;             ///< its title or file
  std::optional<Variation> each; ///< what tells it from the others: from = to = its value
  Sweep sweep;
};

/// The curve, not swept yet, of `scene` with another number at `each`; `mine`: what tells the scene
/// from others, if there are others.
SweepCurve curve_at(const Variation& each, const std::string& scene, const std::string& mine = "");
/// Throws InputError if one of a curve's numbers is overwritten by the next, as when both are one.
void refuse_overwritten(const std::vector<SweepCurve>& curves);
/// Which contacts are beside the object at an end of a range, though not in the scene as given.
std::vector<SceneDoubt> doubts_at_ends(const VariedScene& scene, const Sweep& sweep);
/// For a picture of all of them.
std::string sweep_title(const std::vector<SweepCurve>& curves);
/// That so many samples do not fit into memory; empty if they do.
std::string too_many_samples(double samples, const SceneFile& file);

/// What a picture shows.
struct SweepQuantity {
  enum class Kind { break_force, force, force_component, twist, break_twist };
  Kind kind = Kind::break_force;
  Index component = 0;

  std::string name() const; ///< "twist[5]"
  std::string unit() const;
};
/// "break_force", "force" (its size), "force[0]" to "force[2]", "twist[0]" to "twist[5]",
/// "break_twist[0]" to "break_twist[5]". Throws InputError with what is possible.
SweepQuantity sweep_quantity(const std::string& name);

/// "as prescribed: wall sticks; at breaking: left.2 separates; the answer jumps"; empty if nothing
/// changes there.
std::string change_text(const Sweep& sweep, const SweepSegment& segment);
std::string change_text(const Sweep& sweep, const SweepPoint& point);

// One sweep, or several over the same parameter. Of several, json is {"curves": [..]} and csv has
// one column more. Text has a line a sentence: wrap them as you like.
std::string sweep_text(const std::vector<SweepCurve>& curves, Telling telling = Telling::brief);
std::string sweep_csv(const std::vector<SweepCurve>& curves);
std::string sweep_json(const std::vector<SweepCurve>& curves,
                       const std::vector<SceneDoubt>& warnings = {});
/// The quantities, one panel a unit; none: both forces, of a map the breaking force. A map shows
/// one. Throws InputError where one is not known.
std::string sweep_svg(const std::vector<SweepCurve>& curves, const std::string& title,
                      const std::vector<SweepQuantity>& shown = {});

inline std::string sweep_text(const Sweep& sweep, Telling telling = Telling::full) {
  return sweep_text(std::vector<SweepCurve>{{"", "", std::nullopt, sweep}}, telling);
}
/// The forces, and the turn of an object that turns about one axis.
std::string sweep_svg(const Sweep& sweep, const std::string& title);

} // namespace lcpush::desktop
