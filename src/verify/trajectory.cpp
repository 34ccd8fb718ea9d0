#include "lcpush/desktop/trajectory.hpp"

#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "text/format.hpp"
#include "verify/followed_motion.hpp"
#include "verify/settings.hpp"
#include "verify/trajectory_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

/// m/s over a step: the largest difference of a telling point's place.
double speed_between(const TellingPoints& telling, const Pose<double>& a, const Pose<double>& b,
                     double h) {
  double most = 0;
  for (const Vector3<double>& p : telling.points) most = std::max(most, (a.at(p) - b.at(p)).norm());
  return std::max(0.0, most - Settings::digits * telling.size) / h;
}

/// The same to the nearest place from a on through b to the limit of ever more steps: what steps of
/// unequal lengths make lies there.
double speed_from_between(const TellingPoints& telling, const Pose<double>& a,
                          const Pose<double>& b, const Pose<double>& to, double h) {
  double along = 0, square = 0;
  for (const Vector3<double>& p : telling.points) {
    const Vector3<double> way = b.at(p) - a.at(p);
    along += way.dot(to.at(p) - a.at(p));
    square += way.squaredNorm();
  }
  const double part = square > 0 ? std::clamp(along / square, 0.0, Settings::limit) : 0.0;
  const auto between = [part](const auto& x, const auto& y) { return (x + part * (y - x)).eval(); };
  return speed_between(telling, {between(a.position, b.position), between(a.rotation, b.rotation)},
                       to, h);
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

/// Where the motion begins, if it is not where the scene has the object: positions of another
/// origin, as a simulator's world. A motion that begins later may be anywhere.
std::optional<Vector3<double>> first_offset(const SceneFile& file,
                                            const std::vector<TrajectoryFrame>& frames) {
  const Pose<double>&first = frames[0].pose, &second = frames[1].pose;
  const double size = object_size(file), since = frames[0].time;
  const double moves = since > 0
                           ? 2 * (second.position - first.position).norm() + Settings::start * size
                           : Settings::digits * size;
  const bool is_turned = (first.rotation - Matrix3<double>::Identity()).norm() > Settings::start;
  const bool is_start = since <= Settings::first_frame * (frames[1].time - since);
  if (!is_start || !(first.position.norm() > moves || (since == 0 && is_turned)))
    return std::nullopt;
  return first.position;
}

class TrajectoryJudge {
public:
  TrajectoryJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& given)
      : file_(file), given_(given), laws_(file, given) {}

  TrajectoryReport judge(double tolerance) {
    report_.tolerance = tolerance;
    report_.has_rotation = given_.front().has_rotation;
    report_.status = run_.start();
    if (report_.status == Status::running) report_.status = Status::solved;
    for (std::size_t k = 1; k < given_.size() && report_.status == Status::solved; ++k) step(k);
    if (report_.status == Status::solved) report_.missed = judge_changes(file_, given_, allowed());
    report_.overlap = find_overlap(file_, given_);
    const double span = given_.back().time - given_.front().time;
    report_.creep = speed_between(laws_.telling(), given_.front().pose, given_.back().pose, span);
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
    bool jumps = false;    ///< its velocity changes by much
    bool is_far = false;   ///< one step goes too far to be one
    bool is_smooth = true; ///< made of equal steps, and no contact does something else on the way
    MotionRun::Saved saved;
  };

  StepEnd step_in(const TrajectoryFrame& to, double h, int parts) {
    StepEnd step;
    step.status = Status::solved;
    std::vector<Touch> before;
    for (int k = 0; k < parts && step.status == Status::solved; ++k) {
      bool is_halved = false;
      step.status = laws_.advance(h / parts, is_halved, Settings::part_halvings);
      std::vector<Touch> touches = run_.touches();
      step.is_far = step.is_far || (parts == 1 && is_halved);
      const bool goes_on = (k == 0 || touches == before) && !run_.leaves();
      step.is_smooth = step.is_smooth && goes_on && !is_halved;
      before = std::move(touches);
    }
    if (step.status != Status::solved) return step;
    step.end = run_.stepper().pose();
    step.off = speed_between(laws_.telling(), step.end, to.pose, h);
    step.saved = run_.save();
    return step;
  }

  /// Nobody says in how many steps the other motion went from frame to frame, and implicit Euler's
  /// error is in proportion to them: the laws' own end is the one that comes nearest.
  StepEnd nearest_end(const TrajectoryFrame& to, double h) {
    const MotionRun::Saved before = run_.save();
    StepEnd nearest = step_in(to, h, 1), last = nearest;
    // A jump is over before a frame is: until steps are as short, all of them step over it.
    const Vector6<double> jump = run_.stepper().velocity() - before.moment.velocity;
    const bool jumps = laws_.telling().fastest(to.pose, jump) > Settings::jump * report_.fastest;
    const auto told = [jumps, is_far = nearest.is_far](StepEnd end) {
      end.jumps = jumps;
      end.is_far = is_far;
      return end;
    };
    const double settles = jumps ? Settings::most_parts : Settings::settling_parts;
    // Who says how short its steps are may have made many; and a jump is wherever it is.
    const double said = jumps                     ? Settings::most_jump_parts
                        : to.step && *to.step > 0 ? h / *to.step
                                                  : 0;
    // Of a motion that is wrong in many places more parts only take time.
    const double most = wrong_ >= Settings::wrong_frames
                            ? 1
                            : std::clamp(said, Settings::most_parts, Settings::most_stated_parts);
    for (int parts = 2; parts <= most; parts *= 2) {
      const bool is_solved = last.status == Status::solved;
      if (is_solved && nearest.off <= report_.tolerance * report_.fastest) break;
      run_.restore(before);
      StepEnd finer = step_in(to, h, parts);
      // Yet finer ones change the end by about as much again, unless something happens on the way
      // whose moment they find: can that be enough?
      const bool is_settling = parts >= settles && is_solved && finer.status == Status::solved &&
                               last.is_smooth && finer.is_smooth;
      const bool is_hopeless =
          is_settling && finer.off > 2 * speed_between(laws_.telling(), last.end, finer.end, h) +
                                         report_.tolerance * report_.fastest;
      const bool is_nearer =
          finer.status == Status::solved &&
          (nearest.status != Status::solved || finer.off < Settings::nearer * nearest.off);
      if (is_nearer) nearest = finer;
      if (is_solved && finer.status == Status::solved)
        nearest.off = std::min(
            nearest.off, speed_from_between(laws_.telling(), last.end, finer.end, to.pose, h));
      last = std::move(finer);
      if (is_hopeless) break;
    }
    if (nearest.status == Status::solved) run_.restore(nearest.saved);
    return told(std::move(nearest));
  }

  /// Where velocities are given they change as well as the places: m/s, by which the laws' own is
  /// off, in as many parts as is best.
  double velocity_off(const MotionRun::Saved& before, const StepEnd& own, const TrajectoryFrame& to,
                      double h) {
    // A coarse step's own is off by a part of what it changes.
    const double slack =
        Settings::of_change *
        laws_.telling().fastest(to.pose, run_.stepper().velocity() - before.moment.velocity);
    const auto off = [&](const Vector6<double>& velocity) {
      return std::max(0.0, laws_.telling().fastest(to.pose, velocity - *to.twist) - slack);
    };
    double nearest = off(run_.stepper().velocity());
    std::optional<Vector6<double>> last;
    for (int parts = 1; parts <= Settings::most_parts && nearest > allowed(); parts *= 2) {
      run_.restore(before);
      if (step_in(to, h, parts).status != Status::solved) break;
      const Vector6<double> velocity = run_.stepper().velocity();
      nearest = std::min(nearest, off(velocity));
      if (last) {
        const Vector6<double> way = velocity - *last;
        nearest = std::min(nearest, off(*last + part_of(way, *to.twist - *last) * way));
      }
      last = velocity;
    }
    run_.restore(own.saved);
    return nearest;
  }

  /// With which a step to frame k begins. Places alone say the mean since the frame before, which
  /// was half that interval ago: a step at the acceleration of its end is right from there if it is
  /// as long; one that is not begins later by half of what it is shorter.
  Vector6<double> velocity_before(std::size_t k) const {
    const Vector6<double> velocity = velocity_at(given_, k - 1);
    if (given_[k - 1].twist || k < 2) return velocity;
    const double before = given_[k - 1].time - given_[k - 2].time;
    const double h = given_[k].time - given_[k - 1].time;
    if (std::abs(before - h) <= Settings::interval * h) return velocity;
    const Vector6<double> next = mean_twist(given_[k - 1].pose, given_[k].pose, h);
    return velocity + (before - h) / (before + h) * (next - velocity);
  }

  /// From frame k - 1 to frame k, by the laws and as given.
  void step(std::size_t k) {
    const TrajectoryFrame &from = given_[k - 1], &to = given_[k];
    const double h = to.time - from.time;
    // Its speed, before it has moved; unless it is the scene's, which says one.
    const bool is_start = k == 1 && starts_as_scene(file_, from);
    const bool is_unknown = !from.twist && k == 1 && !is_start;
    laws_.begin_at(k - 1, is_start ? file_.start : velocity_before(k));
    if (is_unknown) { // where that leads is not judged
      bool is_halved = false;
      (void)laws_.advance(h, is_halved, Settings::part_halvings);
      return;
    }
    for (Index b = 0; b < run_.scene().bodies.size; ++b)
      for (const Index i : points_of(run_.scene().bodies[b]))
        report_.fastest =
            std::max(report_.fastest,
                     acceleration_at(run_.scene().points[i], run_.prescribed(b, to.time)).norm());
    goes_ = std::max(goes_, speed_between(laws_.telling(), from.pose, to.pose, h));
    report_.fastest = std::max(report_.fastest, goes_);
    const MotionRun::Saved before = run_.save();
    StepEnd own = nearest_end(to, h);
    report_.status = own.status;
    if (report_.status != Status::solved) {
      report_.worst_time = to.time;
      return;
    }
    if (to.twist && (from.twist || is_start) && !own.jumps)
      own.off = std::max(own.off, velocity_off(before, own, to, h));
    if (own.is_far && !from.twist && own.off > allowed()) {
      report_.is_coarse = true;
      report_.status = Status::not_settled;
      report_.worst_time = to.time;
      return;
    }
    own_ = std::max(own_, speed_between(laws_.telling(), from.pose, own.end, h));
    wrong_ += own.off > allowed() ? 1 : 0;
    if (own.off > (1 + Settings::same_speed) * report_.worst)
      report_.worst_time = to.time; // the first of equals
    report_.worst = std::max(report_.worst, own.off);
    report_.mean += own.off;
    ++report_.steps;
  }

  bool has_wrong_force() const {
    return report_.forces && report_.forces->broken(report_.tolerance) != nullptr;
  }

  double allowed() const { return report_.tolerance * report_.fastest; }

  /// m, of a telling point from the first frame.
  double farthest() const {
    double most = 0;
    for (const TrajectoryFrame& frame : given_)
      most = std::max(most, speed_between(laws_.telling(), given_.front().pose, frame.pose, 1));
    return most;
  }

  void decide() {
    const double allowed = report_.tolerance * report_.fastest;
    const bool is_near = report_.worst <= allowed && report_.missed.speed <= allowed &&
                         report_.overlap.speed <= allowed;
    // A point deeper than that is none to the laws: what they hold without it says nothing.
    const bool is_seen = report_.overlap.speed <= allowed ||
                         report_.overlap.depth <= Settings::pushed_out * laws_.telling().size;
    const bool goes_on = report_.status == Status::solved;
    // Nor does what is rounding of places that stay.
    const bool stays = goes_on && own_ <= Settings::at_rest * goes_ && is_seen &&
                       farthest() <= Settings::stays * laws_.telling().size;
    if (is_near || stays)
      report_.verdict = !goes_on            ? TrajectoryVerdict::stopped
                        : has_wrong_force() ? TrajectoryVerdict::wrong_forces
                                            : TrajectoryVerdict::follows;
    else if (goes_on && is_seen && own_ <= Settings::at_rest * goes_)
      report_.verdict = TrajectoryVerdict::creeps;
    if (report_.verdict == TrajectoryVerdict::creeps) report_.held = held_times(file_);
  }

  const SceneFile& file_;
  const std::vector<TrajectoryFrame>& given_;
  FollowedMotion laws_;
  MotionRun& run_ = laws_.run();
  TrajectoryReport report_;
  int wrong_ = 0;             ///< steps
  double goes_ = 0, own_ = 0; ///< m/s, the fastest step as given and by the laws
};

/// m: the last digit of all places, a power of ten; 0: they have many, or are all smaller.
double last_digit(const std::vector<TrajectoryFrame>& frames) {
  double farthest = 0;
  for (const TrajectoryFrame& frame : frames)
    farthest = std::max(farthest, frame.pose.position.cwiseAbs().maxCoeff());
  for (double digit = Settings::coarsest_digit; digit >= Settings::finest_digit;
       digit /= Settings::decade) {
    if (farthest < digit / 2) continue;
    const auto has_more = [digit](const TrajectoryFrame& frame) {
      const Vector3<double> digits = frame.pose.position / digit;
      return (digits - digits.array().round().matrix()).cwiseAbs().maxCoeff() > Settings::rounded;
    };
    if (std::none_of(frames.begin(), frames.end(), has_more)) return digit;
  }
  return 0;
}

/// What the digits of places leave open of a speed between two frames, if that may be all that is
/// wrong.
std::string digits_hint(const std::vector<TrajectoryFrame>& frames,
                        const TrajectoryReport& report) {
  double h = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < frames.size(); ++k)
    h = std::min(h, frames[k].time - frames[k - 1].time);
  const double digit = last_digit(frames), open = 2 * digit / h;
  const double allowed = report.tolerance * report.fastest;
  if (report.verdict != TrajectoryVerdict::differs || report.overlap.speed > allowed ||
      report.missed.speed > allowed || report.worst > 2 * open)
    return "";
  return "Places end at " + millimetres(digit) + " and frames are " + brief(h) +
         " s apart, which leaves speeds open by " + millimetres(open) +
         "/s: give more digits, or fewer frames.";
}

/// Of a motion that breaks the laws: `as_given`, and `judged` from where it begins.
std::string motion_hint(const SceneFile& file, const std::vector<TrajectoryFrame>& as_given,
                        std::vector<TrajectoryFrame> judged, const TrajectoryReport& report) {
  if (report.verdict != TrajectoryVerdict::differs) return "";
  const Matrix3<double> half_turn = Vector3<double>(-1, -1, 1).asDiagonal();
  if ((as_given.front().pose.rotation - half_turn).norm() <= Settings::start)
    return "It begins with half a turn about z: quaternions have w first here, and these look "
           "like x, y, z, w.";
  const auto follows = [&](const std::vector<TrajectoryFrame>& frames) {
    return TrajectoryJudge(file, frames).judge(report.tolerance).verdict ==
           TrajectoryVerdict::follows;
  };
  std::vector<TrajectoryFrame> turned_back = judged;
  double turn = 0;
  for (TrajectoryFrame& frame : turned_back) {
    turn = std::max(turn, (frame.pose.rotation - frame.pose.rotation.transpose()).norm());
    frame.pose.rotation.transposeInPlace();
  }
  if (turn > Settings::start && follows(turned_back))
    return "With every rotation turned back it obeys them: these look like matrices given column "
           "by column, or like conjugate quaternions.";
  double way = 0;
  for (TrajectoryFrame& frame : judged) {
    way = std::max(way, frame.pose.position.norm());
    frame.pose.position /= millimetres_a_metre;
    if (frame.twist) frame.twist->head<3>() /= millimetres_a_metre;
  }
  if (way <= object_size(file) || !follows(judged)) return "";
  return "With all places divided by 1000 it obeys them: these look like millimetres, metres are "
         "asked for.";
}

} // namespace

const char* verdict_text(TrajectoryVerdict verdict) {
  constexpr const char* texts[] = {"follows", "creeps", "differs", "stopped", "wrong_forces"};
  return texts[static_cast<int>(verdict)];
}

TrajectoryReport verify_trajectory(const SceneFile& file, const Trajectory& trajectory,
                                   double tolerance) {
  std::vector<TrajectoryFrame> frames = trajectory.frames;
  const std::optional<Vector3<double>> offset = first_offset(file, frames);
  const Matrix3<double> turned = frames.front().pose.rotation.transpose();
  if (offset)
    for (TrajectoryFrame& frame : frames) {
      frame.pose.position -= *offset;
      frame.pose.rotation *= turned;
    }
  TrajectoryReport report = TrajectoryJudge(file, frames).judge(tolerance);
  report.hint = digits_hint(frames, report);
  if (!report.hint.empty()) {
    report.verdict = TrajectoryVerdict::stopped;
    report.is_coarse = true;
  } else {
    report.hint = motion_hint(file, trajectory.frames, thinned(frames), report);
  }
  report.offset = offset;
  report.unread = trajectory.unread;
  return report;
}

} // namespace lcpush::desktop
