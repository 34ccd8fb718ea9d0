// A push from scene to report on the desktop: owns the memory, asks the core, collects the answer.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/final_basis.hpp"
#include "lcpush/desktop/jam.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/statements.hpp"
#include "lcpush/desktop/watcher.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/study/motion.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"

namespace lcpush::desktop {

struct NamedValue {
  std::string name;
  double value;
  Index unknown = -1; ///< of the layout
};

/// "left.3": point 3 (counted from 1) of body "left".
std::string point_name(const SceneFile& file, Index point);
/// "+x" or "-z" along an axis, else "(0.707, 0.707, 0)".
std::string direction_text(const Vector3<double>& direction);
/// " along +x"; of a soft point " along +x times 0.866 and twisting by 0.5", positive about its
/// normal; " twisting by 1" for a pure torque.
std::string generator_text(const Generator<double>& generator, double torsion_radius);
/// Sweeps end at their own scaled residual; the laws, in SI units, are to pass theirs as well.
constexpr SweepOptions<double> strict_sweeps() {
  SweepOptions<double> options;
  options.tolerance /= 32;
  return options;
}

/// The literal laws' residuals after a number of sweeps.
struct SweepRecord {
  Index sweep; ///< of all rounds together
  Residuals<double> residuals;
};

struct PushOptions {
  Solver solver = Solver::lemke;
  LemkeOptions<double> lemke{};
  SweepOptions<double> sweeps = strict_sweeps();
  bool record_history = false; ///< PushReport::history; costs a check of the laws each time
  Index other_covers = 3;      ///< covers tried in search of another answer
  bool explain_jams = true;    ///< solve again with each change that might free a jam
  bool dense = false;          ///< pivots on the whole dictionary, whatever the size
  bool study_existence = true; ///< ask the existence lemma's conditions: two linear programs
  Watcher* watcher = nullptr;  ///< told of all pivots and sweeps of the answer; not of the search
                               ///< for others
};

struct PushReport {
  Status status = Status::bad_input;
  std::string reason; ///< a sentence, empty when solved
  Solver solver = Solver::lemke;
  PressureRun run;
  Scales<double> scales{};
  Answer<double> answer{}; ///< views into the Push: valid until it is asked again
  Residuals<double> residuals;
  Motion<double> motion;
  Uniqueness unique_motion = Uniqueness::not_tested;
  Uniqueness unique_wrench = Uniqueness::not_tested;
  Index covers_compared = 0; ///< other covers that led to an answer
  FinalBasis final_basis;    ///< other answers next to this one
  std::string undetermined;  ///< a point or body with friction and no known normal force, or empty
  ExistenceFound existence;  ///< does a theorem promise an answer?
  std::vector<SweepRecord> history;
  std::vector<NamedValue> ray; ///< entries that are not zero, largest 1
  Jam jam;                     ///< the ray, read
};

/// Does the grasp hold the object's weight with the pushers absent?
struct HoldReport {
  Status status = Status::bad_input;
  bool holds = false;
  Vector6<double> acceleration = Vector6<double>::Zero(); ///< without a push
  double length = 1; ///< m, the size of the grasp, for telling rounding from motion
};

struct BreakReport {
  Status status = Status::bad_input;
  std::string reason;
  Index pusher = -1; ///< body that pushes
  Solver solver = Solver::lemke;
  PressureRun run;
  Breaking<double> breaking;
  Motion<double> motion;                             ///< per unit push
  std::vector<SweepRecord> history;                  ///< of its pushes, one after the other
  Uniqueness unique_motion = Uniqueness::not_tested; ///< one other cover compared
  Uniqueness unique_force = Uniqueness::not_tested;
  std::vector<NamedValue> ray; ///< as in PushReport
  Jam jam;
  Scales<double> scales{};
};

/// The scene as it is solved: a file's scene, spread evenly if it says so.
template <class S> struct EvenSceneOf {
  std::vector<Body<S>> bodies;
  std::vector<Actuator<S>> actuators;
  std::vector<Drive<S>> drives;
  Scene<S> scene; ///< over these arrays, and over the given scene's

  explicit EvenSceneOf(const Scene<S>& given) {
    const EvenSize size = even_size(given);
    bodies.resize(static_cast<std::size_t>(size.bodies));
    actuators.resize(static_cast<std::size_t>(size.actuators));
    drives.resize(static_cast<std::size_t>(size.drives));
    const EvenMemory<S> memory{{bodies.data(), size.bodies},
                               {actuators.data(), size.actuators},
                               {drives.data(), size.drives}};
    // A file whose actuators drive several bodies is refused when it is read.
    if (spread_evenly(given, memory, scene) != Status::solved) scene = given;
  }
};
using EvenScene = EvenSceneOf<double>;

class Push {
public:
  /// `file` must outlive the Push. Memory: see push_bytes.
  explicit Push(const SceneFile& file);
  explicit Push(SceneFile&& file) = delete; // it would be gone at the end of the line
  Push(const Push&) = delete;               // the views inside would point into the other one
  Push& operator=(const Push&) = delete;

  PushReport solve(const PushOptions& options);
  /// The fingers alone, with the actuators that drive one.
  HoldReport holds_without_push(const PushOptions& options);
  BreakReport find_breaking(Index pusher, const PushOptions& options);

  /// Unknown i of layout(): "normal of left.3", "pull of wall.1", "friction of left.3 along +y",
  /// "slip of left.3", "closing of left".
  std::string variable_name(Index i) const;

  const SceneFile& file() const { return file_; }
  /// Under even pressure an actuator is one point's share of the file's, named after the point.
  std::string actuator_name(Index actuator) const;
  const Scene<double>& scene() const { return scene_; } ///< as solved: even pressure is spread
  const Layout<double>& layout() const { return assembly_.layout(); }
  Assembly<double>& assembly() { return assembly_; }
  const Assembly<double>& assembly() const { return assembly_; }

private:
  const SceneFile& file_;
  EvenScene even_;
  const Scene<double>& scene_; // as solved: even_.scene
  std::vector<unsigned char> bytes_;
  Workspace<double> work_;
  Assembly<double> assembly_;
  std::vector<double> pivot_scalars_; // see pivots()
  std::vector<int> pivot_integers_;
  Lemke<double> lemke_{{}, {}};
  std::vector<double> structured_scalars_; // see structured_pivots()
  std::vector<int> structured_integers_;
  StructuredLemke<double> structured_{{}, {}};
  bool last_structured_ = false; ///< did they pivot last?
  std::vector<SweepRecord> history_;
  Index swept_before_ = 0; // in the rounds that are over
  BlockGaussSeidel<double> sweeps_;

  class Listener;
  struct Meter;
  Lemke<double>& pivots();
  StructuredLemke<double>& structured_pivots();
  bool takes_structure(const PushOptions& options) const;
  const double* ray() const { return last_structured_ ? structured_.ray() : lemke_.ray(); }
  void record(Index sweep, const double* z);
  template <class Use> Status with_rounds(const PushOptions& options, const Use& use);
  template <class Observer, class Pivots, class Use>
  Status with_pivots(const PushOptions& options, Pivots& pivots, Observer&& observer,
                     const Use& use);
  Status run(const PushOptions& options, double sigma, PressureRun& run);
  void name_file_bodies();
  Outcome<double> outcome() const;
  std::string explain(Status status, const PressureRun& run) const;
  std::vector<NamedValue> named_ray() const;
  Jam read_jam(const PushOptions& options) const;
  void compare_covers(const PushOptions& options, BreakReport& report);
  void search_others(const PushOptions& options, PushReport& report);
  static void conclude(PushReport& report, bool proved, bool same_motion, bool same_wrench);
};

} // namespace lcpush::desktop
