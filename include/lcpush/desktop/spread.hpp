// The answer as a set: between which bounds do the push, the motion and the contact forces lie,
// over all answers of the literal laws (pressure = "rigid") that are reached? docs/guide/spread.md.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/stop.hpp"
#include "lcpush/desktop/telling.hpp"

namespace lcpush::desktop {

/// Both ends belong to an answer that has passed the laws' referee. An infinite end: the quantity
/// grows without end along answers, one of which, far out, has passed it. Not every value in
/// between needs to belong to an answer: the set may have gaps.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double width() const { return high - low; }
  void include(double x) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
};

/// How far all assignments of contact modes are gone through, which alone finds every answer.
enum class Enumeration {
  if_small, ///< given up as soon as the end is not in sight
  thorough, ///< as far as forty times that work goes
  none,     ///< only answers that paths of pivots, and steps from them, reach
};

struct SpreadOptions {
  Index covering_vectors = 32; ///< 0, 1, .. of Lemke's method, each a path to an answer
  Enumeration enumeration = Enumeration::if_small;
  bool breaking = false;    ///< the instant of breaking instead of the push as it is
  Index most_faces = 2000;  ///< studied on the way from the paths
  double most_work = 1.3e9; ///< multiplications, about two seconds: after them no further face is
                            ///< begun, and enumeration ends; `thorough`: after forty times that
  bool by_time = false;     ///< as long as `stop` allows instead, whatever the work; then the
                            ///< same input need not give the same bits
  LemkeOptions<double> lemke{};
  Watcher* watcher = nullptr;           ///< told of these paths' pivots
  std::function<void(double)> progress; ///< told from time to time what share is done, 0 to 1
  StopCheck stop;                       ///< ends it with what is found
};

enum class SpreadVerdict {
  unique,      ///< one motion, one set of contact forces
  same_motion, ///< one motion, several sets of forces
  ambiguous,   ///< several motions
};

/// As `verdict` prints it.
constexpr const char* verdict_text(SpreadVerdict verdict) {
  return verdict == SpreadVerdict::unique        ? "unique"
         : verdict == SpreadVerdict::same_motion ? "same_motion"
                                                 : "ambiguous";
}

struct ContactSpread {
  Interval normal;        ///< N
  Interval tangential[2]; ///< N, friction along the body's tangent t and along o = n x t
  Interval torsion;       ///< N m about the normal, soft points
};

struct PusherSpread {
  Index body;     ///< of the scene file
  Interval force; ///< N, sum of its normal forces
};

struct SpreadReport {
  /// solved: a set was found. Else nothing is: as Push::solve ends on the literal laws.
  Status status = Status::bad_input;
  SpreadVerdict verdict = SpreadVerdict::unique;
  bool breaking = false; ///< of the instant of breaking: forces there, twist of a unit push
  std::vector<PusherSpread> pushers;
  /// The object's acceleration, [m/s^2; rad/s^2]; breaking: per unit push (Breaking), [1; rad/m].
  Interval twist[6];
  bool falls = false; ///< breaking: there are answers in which the object moves before the push
  std::vector<ContactSpread> contacts;
  Scales<double> scales{};
  double motion = 0; ///< m/s^2, the largest |acceleration| reached or the push: the scale of `same`
  Noise noise;       ///< what is less is 0; of breaking the acceleration is per unit push
  double residual = 0; ///< the largest of the answers behind the bounds

  Index covering_vectors = 0; ///< tried
  /// That led to an answer; the others ended in a ray or a failure.
  Index covering_vectors_solved = 0;
  Index faces = 0;       ///< studied: bounds over all of it
  Index faces_left = 0;  ///< known, not studied: the limit was reached; their bounds may be wider
  Index programs = 0;    ///< linear programs solved for bounds and points
  Index failures = 0;    ///< bounds or faces that could not be settled: the set may be wider
  Index assignments = 0; ///< of contact modes, whole or in part, that enumeration has looked at
  Enumeration asked = Enumeration::if_small;
  bool complete = false;   ///< every answer lies on a studied face: enumeration ended, no failure
  std::string enumeration; ///< why it is not complete, empty otherwise
  Stop stop = Stop::none;  ///< what ended it before its work was done

  PushReport failure; ///< not solved: how Push::solve ends, with reason, ray and jam
};

/// [T.15] The set of answers under the literal laws, whatever pressure law `file` names. Cost: the
/// pivots of each covering vector, and a linear program for each end of each interval a face, a
/// few pivots long. Pre, with `breaking`: a body moves.
SpreadReport find_spread(const SceneFile& file, const SpreadOptions& options);

/// The interval as one number, if its ends agree to `tolerance`?
inline bool is_single(const Interval& interval, double tolerance) {
  return interval.width() <= tolerance;
}
/// What counts as the same force (N) and the same acceleration (m/s^2).
double same_force(const SpreadReport& report);
double same_acceleration(const SpreadReport& report);

/// A line a sentence: wrap them as you like.
std::string spread_text(const SceneFile& file, const SpreadReport& report,
                        Telling telling = Telling::brief);
std::string spread_json(const SceneFile& file, const SpreadReport& report);

/// "The laws leave open how fl, fr and rl share their load", of feet and rails, or the friction of
/// single points that stick in `answer`; empty where they do not, or where patches press beside
/// them. Cost: four paths of pivots and their faces.
std::string sharing_sentence(const SceneFile& file, const Answer<double>& answer);

} // namespace lcpush::desktop
