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
  TrajectoryJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& given, double rim = 0)
      : file_(file), given_(given), rim_(rim), laws_(file, given, rim) {}

  /// `asks_verdict`: and no more of a motion that breaks a law.
  TrajectoryReport judge(double tolerance, bool asks_verdict = false) {
    report_.tolerance = tolerance;
    report_.has_rotation = given_.front().has_rotation;
    report_.status = run_.start();
    if (report_.status == Status::running) report_.status = Status::solved;
    for (std::size_t k = 1; k < given_.size() && report_.status == Status::solved; ++k) step(k);
    if (report_.status == Status::solved &&
        !(report_.worst > allowed() && (asks_verdict || leaps())))
      report_.missed = judge_changes(file_, given_, allowed(), rim_);
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
    step.off = speed_between(laws_.telling(), step.end, to.pose, interval_);
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
          is_settling &&
          finer.off > 2 * speed_between(laws_.telling(), last.end, finer.end, interval_) +
                          report_.tolerance * report_.fastest;
      const bool is_nearer =
          finer.status == Status::solved &&
          (nearest.status != Status::solved || finer.off < Settings::nearer * nearest.off);
      if (is_nearer) nearest = finer;
      if (is_solved && finer.status == Status::solved)
        nearest.off = std::min(nearest.off, speed_from_between(laws_.telling(), last.end, finer.end,
                                                               to.pose, interval_));
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
    const double most = wrong_ >= Settings::wrong_frames ? 0 : Settings::most_parts;
    for (int parts = 1; parts <= most && nearest > allowed(); parts *= 2) {
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

  /// The same in many parts from frame j on, at this velocity, if that comes nearer. `weight`: of
  /// what it is off then.
  void begin_otherwise(const MotionRun::Saved& at, std::size_t j, const Vector6<double>& velocity,
                       const TrajectoryFrame& to, double weight, StepEnd& own) {
    run_.restore(at);
    run_.begin_at(given_[j].time, given_[j].pose, velocity);
    const double span = to.time - given_[j].time;
    StepEnd other =
        step_in(to, span, static_cast<int>(std::lround(Settings::fine_parts * span / interval_)));
    other.off *= weight;
    const bool is_nearer =
        other.status == Status::solved && (own.status != Status::solved || other.off < own.off);
    if (is_nearer) own = other;
    if (own.status == Status::solved) run_.restore(own.saved);
  }

  /// Places alone say the mean velocity of a step: one within which something stops says neither
  /// that before nor that after, and where it changes fast that of two steps is nearer to the one
  /// between them. (Which knows the step's end already: what it is off by shows half.)
  void begin_otherwise(const MotionRun::Saved& before, std::size_t k, StepEnd& own) {
    if (wrong_ >= Settings::wrong_frames || k < 2) return;
    const TrajectoryFrame& to = given_[k];
    const double both = to.time - given_[k - 2].time;
    begin_otherwise(before, k - 1, mean_twist(given_[k - 2].pose, to.pose, both), to, 2, own);
    if (!before_ || k < 4) return;
    const Vector6<double> velocity = before_->moment.velocity;
    const Vector6<double> then = velocity + (velocity - velocity_at(given_, k - 3)) / 2;
    begin_otherwise(*before_, k - 2, then, to, 1, own);
  }

  /// The same at the frame after k, over both steps in many parts: what touches just before a frame
  /// is stopped before it or after, as the steps fall. A wrong velocity at frame k alone is seen
  /// from there.
  double next_velocity_off(const MotionRun::Saved& before, const StepEnd& own, std::size_t k) {
    if (k + 1 == given_.size() || !given_[k + 1].twist || wrong_ >= Settings::wrong_frames)
      return std::numeric_limits<double>::infinity();
    const TrajectoryFrame& next = given_[k + 1];
    const double h = next.time - given_[k - 1].time;
    run_.restore(before);
    const StepEnd both = step_in(next, h, static_cast<int>(Settings::most_parts));
    double off = std::numeric_limits<double>::infinity();
    if (both.status == Status::solved) {
      const Vector6<double> velocity = run_.stepper().velocity();
      const auto speed = [&](const Vector6<double>& twist) {
        return laws_.telling().fastest(next.pose, twist);
      };
      off = std::max(both.off, speed(velocity - *next.twist) -
                                   Settings::of_landing * speed(velocity - before.moment.velocity));
    }
    run_.restore(own.saved);
    return off;
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
    const double h = interval_ = to.time - from.time;
    // Its speed, before it has moved; unless it is the scene's, which says one.
    const bool is_start = k == 1 && starts_as_scene(file_, from);
    const bool is_unknown = !from.twist && k == 1 && !is_start;
    laws_.begin_at(k - 1, is_start ? file_.start : velocity_before(k));
    if (is_unknown) { // where that leads is not judged, but fingers whose places nobody says follow
      (void)nearest_end(to, h);
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
    const bool is_off = own.status != Status::solved || own.off > allowed();
    const Pose<double> led = own.end; // of what stays other begins would only follow the noise
    if (!from.twist && is_off && !own.is_far) begin_otherwise(before, k, own);
    before_ = before;
    report_.status = own.status;
    if (report_.status != Status::solved) {
      report_.worst_time = to.time;
      return;
    }
    if (to.twist && (from.twist || is_start) && !own.jumps) {
      double off = velocity_off(before, own, to, h);
      if (off > allowed()) off = std::min(off, next_velocity_off(before, own, k));
      own.off = std::max(own.off, off);
    }
    if (own.is_far && !from.twist && own.off > allowed()) {
      report_.is_coarse = true;
      report_.status = Status::not_settled;
      report_.worst_time = to.time;
      return;
    }
    own_ = std::max(own_, speed_between(laws_.telling(), from.pose, led, h));
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

  /// Such steps take the laws long, for one of theirs goes a part of the object's size.
  bool leaps() const { return goes_ * interval_ > Settings::far_frame * laws_.telling().size; }

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
    const bool is_near = report_.worst <= allowed && report_.missed_speed() <= allowed &&
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
  const double rim_;
  FollowedMotion laws_;
  MotionRun& run_ = laws_.run();
  TrajectoryReport report_;
  int wrong_ = 0;             ///< steps
  double goes_ = 0, own_ = 0; ///< m/s, the fastest step as given and by the laws
  double interval_ = 0;       ///< s, of the step: what places are off by is a speed over it
  std::optional<MotionRun::Saved> before_; ///< where the step before began
};

/// What the digits of places and rotations leave open of a speed between two frames, if that may be
/// all that is wrong.
std::string digits_hint(const SceneFile& file, const Trajectory& given,
                        const TrajectoryReport& report) {
  double h = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < given.frames.size(); ++k)
    h = std::min(h, given.frames[k].time - given.frames[k - 1].time);
  const double turned = given.turn_digit * object_size(file),
               open = 2 * std::max(given.place_digit, turned) / h;
  const double allowed = report.tolerance * report.fastest;
  const double off = std::max({report.worst, report.overlap.speed, report.missed_speed()});
  if (report.verdict != TrajectoryVerdict::differs || off <= allowed || off > 2 * open) return "";
  return (turned > given.place_digit ? "Rotations end at " + brief(given.turn_digit)
                                     : "Places end at " + millimetres(given.place_digit)) +
         " and frames are " + brief(h) + " s apart, which leaves speeds open by " +
         millimetres(open) + "/s: give more digits, or fewer frames.";
}

/// Another reading of the numbers, and in which words it is told.
struct Reading {
  std::string hint;
  double length, speed, time; ///< by which places, velocities and times are divided
};

/// Of a motion that breaks the laws: `as_given`, and `judged` from where it begins.
std::string motion_hint(const SceneFile& file, const std::vector<TrajectoryFrame>& as_given,
                        const std::vector<TrajectoryFrame>& judged,
                        const TrajectoryReport& report) {
  const bool is_stopped = report.verdict == TrajectoryVerdict::stopped;
  if (report.verdict != TrajectoryVerdict::differs && !is_stopped) return "";
  const double interval =
      (judged.back().time - judged.front().time) / static_cast<double>(judged.size() - 1);
  const Matrix3<double> half_turn = Vector3<double>(-1, -1, 1).asDiagonal();
  if ((as_given.front().pose.rotation - half_turn).norm() <= Settings::start)
    return "It begins with half a turn about z: quaternions have w first here, and these look "
           "like x, y, z, w.";
  const auto follows = [&](const std::vector<TrajectoryFrame>& frames) {
    return TrajectoryJudge(file, frames).judge(report.tolerance, true).verdict ==
           TrajectoryVerdict::follows;
  };
  std::vector<TrajectoryFrame> turned_back = judged;
  double turn = 0, way = 0;
  for (TrajectoryFrame& frame : turned_back) {
    turn = std::max(turn, (frame.pose.rotation - frame.pose.rotation.transpose()).norm());
    way = std::max(way, frame.pose.position.norm());
    frame.pose.rotation.transposeInPlace();
  }
  if (turn > Settings::start && follows(turned_back))
    return "With every rotation turned back it obeys them: these look like matrices given column "
           "by column, or like conjugate quaternions.";
  constexpr double mm = millimetres_a_metre;
  const std::string places = "With all places divided by 1000 it obeys them: these look like "
                             "millimetres, metres are asked for.";
  const Reading readings[] = {
      {places, mm, mm, 1},
      {places, mm, 1, 1},
      {"With all times divided by 1000 it obeys them: these look like milliseconds, seconds are "
       "asked for.",
       1, 1, mm}};
  for (const Reading& reading : readings) {
    if (reading.length > 1 && way <= object_size(file)) continue;
    if (reading.length > reading.speed && !judged.front().twist) continue;
    // In a thousandth of the time whatever goes evenly obeys.
    if (reading.time > 1 && interval < Settings::seldom) continue;
    std::vector<TrajectoryFrame> read = judged;
    for (TrajectoryFrame& frame : read) {
      frame.time /= reading.time;
      frame.pose.position /= reading.length;
      if (frame.twist) frame.twist->head<3>() /= reading.speed;
      if (frame.step) *frame.step /= reading.time;
    }
    if (follows(read)) return reading.hint;
  }
  return "";
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
  const std::string units = motion_hint(file, trajectory.frames, thinned(frames), report);
  if (report.verdict != TrajectoryVerdict::follows && units.empty()) {
    // Its places may be a hair beside their faces.
    const double rim = Settings::face_rim * object_size(file);
    const TrajectoryReport near = TrajectoryJudge(file, frames, rim).judge(tolerance, true);
    if (near.verdict == TrajectoryVerdict::follows) report = near;
  }
  report.hint = digits_hint(file, trajectory, report);
  if (!report.hint.empty()) {
    report.verdict = TrajectoryVerdict::stopped;
    report.is_coarse = true;
  } else {
    report.hint = units;
  }
  report.offset = offset;
  report.unread = trajectory.unread;
  return report;
}

} // namespace lcpush::desktop
