#include "lcpush/desktop/trajectory.hpp"

#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "move/motion_run.hpp"
#include "verify/settings.hpp"
#include "verify/trajectory_forces.hpp"
#include "verify/trajectory_steps.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

/// m/s over a step: the largest difference of a contact point's place on the object.
double speed_between(const SceneFile& file, const Pose<double>& a, const Pose<double>& b,
                     double h) {
  double most = 0;
  for (const Vector3<double>& p : file.points) most = std::max(most, (a.at(p) - b.at(p)).norm());
  return std::max(0.0, most - Settings::digits * object_size(file)) / h;
}

/// How many times the grip that holds the scene's grip is.
std::optional<double> held_times(const SceneFile& file) {
  Push push(file);
  PushOptions options;
  const HoldReport hold = push.holds_without_push(options);
  if (!hold.holds) return std::nullopt;
  const GripReport grip = find_smallest_grip(file, hold, BreakReport(), options);
  if (!(grip.alone.factor > 0)) return std::nullopt;
  return 1 / grip.alone.factor;
}

class TrajectoryJudge {
public:
  TrajectoryJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& given)
      : file_(file), given_(given), seen_(file, given), run_(file) {}

  TrajectoryReport judge(double tolerance) {
    report_.tolerance = tolerance;
    report_.status = run_.start();
    if (report_.status == Status::running) report_.status = Status::solved;
    for (std::size_t k = 1; k < given_.size() && report_.status == Status::solved; ++k) step(k);
    const double span = given_.back().time - given_.front().time;
    report_.creep = speed_between(file_, given_.front().pose, given_.back().pose, span);
    if (report_.steps > 0) report_.mean /= static_cast<double>(report_.steps);
    report_.forces = judge_forces(file_, given_);
    decide();
    return report_;
  }

private:
  /// Where the laws lead in one step, or in so many equal ones.
  struct StepEnd {
    Status status = Status::running;
    Pose<double> end;
    double off = 0;        ///< m/s, from where the motion goes
    bool is_smooth = true; ///< made of equal steps, and no contact does something else on the way
    MotionRun::Saved saved;
  };

  /// Where a step is too long for the laws, two of half its length may be there.
  Status advance(double h, int halvings, bool& is_halved) {
    const Status status = run_.advance(h);
    if (status == Status::solved || halvings == 0 || run_.stepper().run().lost) return status;
    is_halved = true;
    const Status half = advance(h / 2, halvings - 1, is_halved);
    return half == Status::solved ? advance(h / 2, halvings - 1, is_halved) : half;
  }

  StepEnd step_in(const TrajectoryFrame& to, double h, int parts) {
    StepEnd step;
    step.status = Status::solved;
    std::vector<Touch> before;
    for (int k = 0; k < parts && step.status == Status::solved; ++k) {
      bool is_halved = false;
      step.status = advance(h / parts, Settings::part_halvings, is_halved);
      std::vector<Touch> touches = run_.touches();
      const bool goes_on = (k == 0 || touches == before) && !run_.leaves();
      step.is_smooth = step.is_smooth && goes_on && !is_halved;
      before = std::move(touches);
    }
    if (step.status != Status::solved) return step;
    step.end = run_.stepper().pose();
    step.off = speed_between(file_, step.end, to.pose, h);
    step.saved = run_.save();
    return step;
  }

  /// Nobody says in how many steps the other motion went from frame to frame, and implicit Euler's
  /// error is in proportion to them: the laws' own end is the one that comes nearest.
  StepEnd nearest_end(const TrajectoryFrame& to, double h) {
    const MotionRun::Saved before = run_.save();
    StepEnd nearest = step_in(to, h, 1), last = nearest;
    // Who says how short its steps are may have made many.
    const double said = to.step && *to.step > 0 ? h / *to.step : 0;
    const double most = std::clamp(said, Settings::most_parts, Settings::most_stated_parts);
    for (int parts = 2; parts <= most; parts *= 2) {
      const bool is_solved = last.status == Status::solved;
      if (is_solved && nearest.off <= report_.tolerance * report_.fastest) break;
      run_.restore(before);
      StepEnd finer = step_in(to, h, parts);
      // Yet finer ones change the end by about as much again, unless something happens on the way
      // whose moment they find: can that be enough?
      const bool is_settling = parts > 2 && is_solved && finer.status == Status::solved &&
                               last.is_smooth && finer.is_smooth;
      const bool is_hopeless =
          is_settling && finer.off > 2 * speed_between(file_, last.end, finer.end, h) +
                                         report_.tolerance * report_.fastest;
      const bool is_nearer =
          finer.status == Status::solved &&
          (nearest.status != Status::solved || finer.off < Settings::nearer * nearest.off);
      if (is_nearer) nearest = finer;
      last = std::move(finer);
      if (is_hopeless) break;
    }
    if (nearest.status == Status::solved) run_.restore(nearest.saved);
    return nearest;
  }

  /// The fingers are where frame k has them, if it says so.
  void close_hand(std::size_t k) {
    const auto closings = seen_.closings_at(k), speeds = seen_.speeds_at(k);
    for (std::size_t a = 0; a < closings.size(); ++a)
      if (closings[a]) run_.close(static_cast<Index>(a), *closings[a], speeds[a].value_or(0));
    for (Index b = 0; b < run_.scene().bodies.size; ++b)
      if (const std::optional<Pose<double>> pose = seen_.driven_pose(b, k)) run_.put(b, *pose);
  }

  /// From frame k - 1 to frame k, by the laws and as given.
  void step(std::size_t k) {
    const TrajectoryFrame &from = given_[k - 1], &to = given_[k];
    const double h = to.time - from.time;
    if (!from.twist && k == 1) { // its speed is not known before it has moved
      run_.begin_at(from.time, from.pose, mean_twist(from.pose, to.pose, h));
      run_.begin_strokes();
      report_.status = run_.advance(h);
      return;
    }
    close_hand(k - 1);
    const double before = k > 1 ? from.time - given_[k - 2].time : h;
    run_.begin_at(from.time, from.pose,
                  from.twist ? *from.twist : mean_twist(given_[k - 2].pose, from.pose, before));
    run_.begin_strokes();
    for (Index b = 0; b < run_.scene().bodies.size; ++b)
      for (const Index i : points_of(run_.scene().bodies[b]))
        report_.fastest =
            std::max(report_.fastest,
                     acceleration_at(run_.scene().points[i], run_.prescribed(b, to.time)).norm());
    goes_ = std::max(goes_, speed_between(file_, from.pose, to.pose, h));
    report_.fastest = std::max(report_.fastest, goes_);
    const StepEnd own = nearest_end(to, h);
    report_.status = own.status;
    if (report_.status != Status::solved) {
      report_.worst_time = to.time;
      return;
    }
    own_ = std::max(own_, speed_between(file_, from.pose, own.end, h));
    if (own.off > (1 + Settings::same_speed) * report_.worst)
      report_.worst_time = to.time; // the first of equals
    report_.worst = std::max(report_.worst, own.off);
    report_.mean += own.off;
    ++report_.steps;
  }

  bool has_wrong_force() const {
    return report_.forces && report_.forces->broken(report_.tolerance) != nullptr;
  }

  void decide() {
    const bool is_near = report_.worst <= report_.tolerance * report_.fastest;
    const bool goes_on = report_.status == Status::solved;
    if (is_near)
      report_.verdict = !goes_on            ? TrajectoryVerdict::stopped
                        : has_wrong_force() ? TrajectoryVerdict::wrong_forces
                                            : TrajectoryVerdict::follows;
    else if (goes_on && own_ <= Settings::at_rest * goes_)
      report_.verdict = TrajectoryVerdict::creeps;
    if (report_.verdict == TrajectoryVerdict::creeps) report_.held = held_times(file_);
  }

  const SceneFile& file_;
  const std::vector<TrajectoryFrame>& given_;
  SeenMotion seen_;
  MotionRun run_;
  TrajectoryReport report_;
  double goes_ = 0, own_ = 0; ///< m/s, the fastest step as given and by the laws
};

} // namespace

const char* verdict_text(TrajectoryVerdict verdict) {
  constexpr const char* texts[] = {"follows", "creeps", "differs", "stopped", "wrong_forces"};
  return texts[static_cast<int>(verdict)];
}

TrajectoryReport verify_trajectory(const SceneFile& file,
                                   const std::vector<TrajectoryFrame>& trajectory,
                                   double tolerance) {
  return TrajectoryJudge(file, trajectory).judge(tolerance);
}

} // namespace lcpush::desktop
