#include "verify/followed_motion.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

class ChangeJudge {
public:
  /// `parts`: of the laws' own steps between two frames.
  ChangeJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& given, int parts,
              double rim)
      : file_(file), given_(thinned(given)), parts_(parts), laws_(file, given_, rim) {}

  MissedChange judge() {
    if (laws_.run().start() != Status::running) return worst_;
    // Its speed is not known before it has moved, unless it is the scene's.
    const bool is_start = starts_as_scene(file_, given_[0]);
    const std::size_t begin = is_start || given_[0].twist ? 0 : 1;
    if (begin == 1) (void)followed(0, velocity_at(given_, 0)); // what touches at the begin
    for (const std::size_t windows : Settings::change_windows) {
      const std::size_t frames =
          std::max(Settings::least_change_frames, (given_.size() - 1) / windows);
      for (std::size_t from = begin; from + 1 < given_.size(); from += (frames + 1) / 2) {
        const bool is_scenes = is_start && from == 0;
        follow(from, std::min(from + frames, given_.size() - 1),
               is_scenes ? file_.start : velocity_at(given_, from),
               is_scenes || given_[from].twist);
        if (windows == 1) break;
      }
    }
    return worst_;
  }

private:
  const SceneFile& file_;
  const std::vector<TrajectoryFrame> given_;
  const int parts_;
  FollowedMotion laws_;
  MissedChange worst_;

  double seconds(std::size_t k) const { return given_[k].time - given_[k - 1].time; }
  /// Between two frames: then the velocity between them is not their difference.
  bool turns_far(std::size_t k) const {
    const Vector6<double> step = mean_twist(given_[k - 1].pose, given_[k].pose, 1);
    return step.tail<3>().norm() > Settings::far_turn;
  }

  /// By how much the laws change a velocity from frame k to the next; none: they have no answer.
  std::optional<Vector6<double>> followed(std::size_t k, const Vector6<double>& velocity) {
    laws_.begin_at(k, velocity);
    for (int part = 0; part < parts_; ++part) {
      bool is_halved = false;
      if (laws_.advance(seconds(k + 1) / parts_, is_halved, Settings::part_halvings) !=
          Status::solved)
        return std::nullopt;
    }
    return laws_.run().stepper().velocity() - velocity;
  }

  /// Each step from the given place, at the velocity to which the laws have led before; compared
  /// with the mean velocity between two frames, in their middle, or with the given one at the end.
  void follow(std::size_t from, std::size_t to, const Vector6<double>& start, bool is_exact) {
    laws_.begin_at(from, start);
    const MotionRun::Saved before = laws_.run().save();
    Vector6<double> velocity = start, last = Vector6<double>::Zero(), shift = last;
    // What a step changes, for of what is pushed a step's velocity is its mean, of what flies that
    // at its end; and how the changes vary, for they may do so anywhere in a step.
    double step = 0, varies = 0;
    for (std::size_t k = from; k < to && !turns_far(k + 1); ++k) {
      const std::optional<Vector6<double>> change = followed(k, velocity);
      if (!change) break;
      const auto speed = [&](const Vector6<double>& twist) {
        return laws_.telling().fastest(given_[k + 1].pose, twist);
      };
      velocity += *change;
      if (k == from && !is_exact) shift = seconds(k) / (2 * seconds(k + 1)) * *change;
      if (k > from) varies += speed(*change - seconds(k + 1) / seconds(k) * last);
      const Vector6<double> found = velocity_at(given_, k + 1);
      step = std::max({step, speed(*change), speed(found - velocity_at(given_, k))});
      last = *change;
      const bool is_mean = !given_[k + 1].twist;
      const Vector6<double> lawful = velocity + shift - (is_mean ? 0.5 : 0.0) * *change;
      const double unsure = Settings::digits * laws_.telling().size / seconds(k + 1);
      note(from, k + 1, found - start, lawful - start, step + varies + 2 * unsure);
    }
    laws_.run().restore(before);
  }

  /// Velocities since frame `from`.
  void note(std::size_t from, std::size_t k, const Vector6<double>& found,
            const Vector6<double>& lawful, double unsure) {
    const Pose<double>& pose = given_[k].pose;
    const double off = laws_.telling().fastest(pose, found - lawful) - unsure;
    if (!(off > worst_.speed)) return;
    const Vector3<double> point = laws_.telling().fastest_point(pose, found - lawful);
    worst_ = {off, given_[from].time, given_[k].time, acceleration_at(point, found),
              acceleration_at(point, lawful)};
  }
};

} // namespace

std::vector<TrajectoryFrame> thinned(const std::vector<TrajectoryFrame>& given) {
  const std::size_t stride = (given.size() - 2) / Settings::change_frames + 1;
  if (stride == 1) return given;
  std::vector<TrajectoryFrame> frames;
  for (std::size_t k = 0; k < given.size(); k += stride) frames.push_back(given[k]);
  return frames;
}

void FollowedMotion::begin_at(std::size_t k, const Vector6<double>& twist) {
  if (k == 0) run_.begin_strokes(); // those of the scene's start, where a motion begins late
  const auto closings = seen_.closings_at(k), speeds = seen_.speeds_at(k);
  for (std::size_t a = 0; a < closings.size(); ++a)
    if (closings[a])
      run_.close(static_cast<Index>(a), *closings[a], speeds[a].value_or(0));
    else
      follow_with(static_cast<Index>(a), given_[k].pose);
  for (Index b = 0; b < run_.scene().bodies.size; ++b) {
    if (!is_driven(run_.scene(), b)) run_.put(b, seen_.stroke_pose(b, given_[k].time));
    if (const std::optional<Pose<double>> pose = seen_.driven_pose(b, k)) run_.put(b, *pose);
  }
  run_.begin_at(given_[k].time, given_[k].pose, twist);
  run_.begin_strokes();
}

/// What an actuator presses with goes with the object from where the laws have led it to `to`, as
/// far as it can.
void FollowedMotion::follow_with(Index actuator, const Pose<double>& to) {
  const Pose<double>& from = run_.stepper().pose();
  const Vector6<double> way = mean_twist(from, to, 1);
  const MotionRun::State now = run_.state();
  const std::vector<Touch> touches = run_.touches();
  for (const Drive<double>& drive : run_.scene().drives) {
    if (drive.actuator != actuator) continue;
    const auto a = static_cast<std::size_t>(actuator), b = static_cast<std::size_t>(drive.body);
    for (const Index i : points_of(run_.scene().bodies[drive.body])) {
      if (touches[static_cast<std::size_t>(i)] > Touch::slips) continue;
      const Vector3<double> place = from.at(run_.scene().points[i]);
      const Vector3<double> closes = acceleration_at(place, drive.twist);
      const double shift =
          closes.dot(acceleration_at<double>(place - from.position, way)) / closes.squaredNorm();
      run_.close(actuator, now.closings[a] + shift, now.speeds[a]);
      run_.put(drive.body,
               moved_about_origin(now.bodies[b], Vector6<double>(shift * drive.twist), 1.0));
      return;
    }
  }
}

Status FollowedMotion::advance(double h, bool& is_halved, int halvings) {
  const Status status = run_.advance(h);
  if (status == Status::solved || halvings == 0 || run_.stepper().run().lost) return status;
  is_halved = true;
  const Status half = advance(h / 2, is_halved, halvings - 1);
  return half == Status::solved ? advance(h / 2, is_halved, halvings - 1) : half;
}

MissedChange judge_changes(const SceneFile& file, const std::vector<TrajectoryFrame>& given,
                           double allowed, double rim) {
  MissedChange least = ChangeJudge(file, given, 1, rim).judge();
  for (const int parts : Settings::change_parts) {
    if (least.speed <= allowed) break;
    const MissedChange finer = ChangeJudge(file, given, parts, rim).judge();
    if (finer.speed < least.speed) least = finer;
  }
  return least;
}

} // namespace lcpush::desktop
