// A push from scene to report on the desktop: owns the memory, asks the core, collects the answer.
#pragma once

#include <functional>
#include <optional>

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/push_reports.hpp"
#include "lcpush/desktop/stop.hpp"
#include "lcpush/desktop/watcher.hpp"
#include "lcpush/lcp/sweeps/judged_sweeps.hpp"

namespace lcpush::desktop {

/// Sweeps end at their own scaled residual; the laws, in SI units, are to pass theirs as well.
constexpr SweepOptions<double> strict_sweeps() {
  SweepOptions<double> options;
  options.tolerance /= 32;
  return options;
}

/// How a push is to be solved.
struct PushOptions {
  Solver solver = Solver::lemke;
  LemkeOptions<double> lemke{};
  SweepOptions<double> sweeps = strict_sweeps();
  bool record_history = false; ///< RunReport::history; costs a check of the laws each time
  Index other_paths = 3;       ///< of pivots, tried in search of another answer
  Index max_pivots = 0;        ///< of all proximal iterations together; 0: the solver's limits
  bool explain_jams = true;    ///< solve again with each change that might free a jam
  bool dense = false;          ///< pivots on the whole dictionary, whatever the size
  bool study_existence = true; ///< ask the existence lemma's conditions: two linear programs
  /// For PushReport::sensitivity: find_sensitivity. A page that never asks does not carry it.
  decltype(&find_sensitivity) study_commands = nullptr;
  Watcher* watcher = nullptr;   ///< told of all pivots and sweeps of the answer
  Watcher* searching = nullptr; ///< told of those of the search for other answers
  StopCheck stop;               ///< asked before each search for what stands beside the answer
};

/// Is there no time for another search beside the answer, which may take as long as that took?
bool is_late(const PushOptions& options);

class AnyRounds;
struct OtherPath;

class Push {
public:
  /// `file` must outlive the Push. Memory: see push_bytes.
  explicit Push(const SceneFile& file);
  explicit Push(SceneFile&& file) = delete; // it would be gone at the end of the line
  Push(const Push&) = delete;               // the views inside would point into the other one
  Push& operator=(const Push&) = delete;

  PushReport solve(const PushOptions& options) &;
  PushReport solve(const PushOptions& options) && = delete; // the report looks into the Push
  /// The fingers alone, with the actuators that drive one.
  HoldReport holds_without_push(const PushOptions& options);
  BreakReport find_breaking(Index pusher, const PushOptions& options);
  /// The object's motion before any push, pushers in place; solved, or the solver's failure.
  Status solve_at_rest(const PushOptions& options, Vector6<double>& acceleration);

  /// Of round friction: turns the pyramids of assembly() to these forces, one a point in its
  /// friction space (LinearizedCone), so that an answer with them is one of its problem. A solve
  /// turns them anew.
  void linearize_cones(const std::vector<Vector3<double>>& forces);

  /// Unknown i of layout(): "normal of left.3", "pull of wall.1", "friction of left.3 along +y",
  /// "slip of left.3", "closing of left".
  std::string variable_name(Index i) const;
  /// What row i says: "separation of left.3", "approach of wall.1", "slip of left.3 minus the
  /// motion along -y", "friction left unused in the cone of left.3", "force of left beyond its set
  /// force".
  std::string row_name(Index i) const;
  /// generator_text of `sign` times the generator of a friction unknown.
  std::string along(const Name& name, double sign) const;

  const SceneFile& file() const { return file_; }
  /// Under even pressure an actuator is one point's share of the file's, named after the point.
  std::string actuator_name(Index actuator) const;
  const Scene<double>& scene() const { return scene_; } ///< as solved: even pressure is spread
  const Layout<double>& layout() const { return assembly_.layout(); }
  /// Of the last question; of find_breaking without other paths, at its small push.
  const Answer<double>& last_answer() const { return work_.answer; }
  Assembly<double>& assembly() { return assembly_; }
  const Assembly<double>& assembly() const { return assembly_; }

private:
  const SceneFile& file_;
  AssembledScene assembled_;
  const Scene<double>& scene_ = assembled_.scene;
  Workspace<double>& work_ = assembled_.work;
  Assembly<double>& assembly_ = assembled_.assembly;
  std::optional<OwnedLemke<double>> lemke_;                  // see pivots()
  std::optional<Owned<StructuredLemke<double>>> structured_; // see structured_pivots()
  bool last_structured_ = false;                             // did they pivot last?
  std::vector<SweepRecord> history_;
  Index swept_before_ = 0; // in the rounds that are over
  BlockGaussSeidel<double> sweeps_;

  class PassingWatcher;
  Lemke<double>& pivots();
  StructuredLemke<double>& structured_pivots();
  bool takes_structure(const PushOptions& options) const;
  const double* ray() const { return last_structured_ ? structured_->ray() : lemke_->ray(); }
  void begin(const PushOptions& options, RunReport& report);
  void record(Index sweep, const double* z);
  template <class Use> Status with_rounds(const PushOptions& options, const Use& use);
  template <class Pivots>
  AnyRounds rounds_by(Pivots& pivots, const PushOptions& options, Watcher& watcher);
  double fastest_motion(double sigma) const;
  /// Until the rounds leave `part` of what they usually do.
  Status run(const PushOptions& options, double sigma, PressureRun& run, double part = 1);
  Status with_friction(RunReport& report, const std::function<Status()>& run_once);
  Status rest(const PushOptions& options);
  HoldReport rest_alone(const SceneFile& alone, const PushOptions& options);
  Status break_grasp(const PushOptions& options, Index pusher, Breaking<double>& breaking,
                     PressureRun& run);
  Push& on(const OtherPath& path, std::optional<Push>& turned);
  void name_file_bodies();
  Outcome<double> outcome() const;
  std::vector<NamedValue> closings(double unit) const;
  std::string explain(Status status, const PressureRun& run) const;
  void find_reason(RunReport& report) const;
  std::string why_refused(const PushReport& report) const;
  void read_ray(const PushOptions& options, RunReport& report) const;
  void compare_others(const PushOptions& options, BreakReport& report);
  void search_others(const PushOptions& options, PushReport& report);
  std::optional<Outcome<double>> answer_by_less_friction(const PushOptions& options) const;
  void look_for_rest(PushReport& report) const;
};

/// Does a plain solve of the scene end in an answer?
bool has_answer(const SceneFile& file);

} // namespace lcpush::desktop
