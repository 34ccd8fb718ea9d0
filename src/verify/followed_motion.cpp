#include "verify/followed_motion.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

using Settings = VerifySettings;

class ChangeJudge {
public:
  ChangeJudge(const SceneFile& file, const std::vector<TrajectoryFrame>& given, double allowed)
      : given_(given), allowed_(allowed), laws_(file, given) {}

  MissedChange judge(double enough, double fastest) {
    MissedChange worst;
    if (laws_.run().start() != Status::running) return worst;
    std::size_t from = 0;
    if (!given_[0].twist) { // its speed is not known before it has moved
      if (!led_astray(0, 1, 1)) return worst;
      from = 1;
    }
    std::vector<MissedChange> found;
    for (std::size_t to = from + 1; to < given_.size(); ++to) {
      if (turns_far(to)) { // between two frames: steps in proportion do not tell where it leads
        from = to;
        continue;
      }
      const double changed = laws_.telling().fastest(
          given_[to].pose, velocity_at(given_, to) - velocity_at(given_, from));
      const bool is_last = to + 1 == given_.size();
      const std::size_t frames = to - from;
      const bool shows = changed >= enough && frames >= Settings::least_change_frames;
      if (!shows && !(is_last && found.empty()) && frames < Settings::change_frames) continue;
      std::optional<double> missed = missed_change(from, to);
      // Of a long way the laws' own may have no answer, or one that leaps: then of its first half.
      while ((!missed || *missed > fastest) && to - from >= 2 * Settings::least_change_frames) {
        to = from + (to - from) / 2;
        missed = missed_change(from, to);
      }
      if (!missed || *missed > fastest) break; // its steps have been judged
      found.push_back({*missed, given_[from].time, given_[to].time});
      from = to;
    }
    if (found.size() == 1) return found[0];
    // An event may be missed by once; what is wrong with the dynamics lasts.
    for (std::size_t k = 1; k < found.size(); ++k) {
      const MissedChange& less = found[k - 1].speed < found[k].speed ? found[k - 1] : found[k];
      if (less.speed > worst.speed) worst = less;
    }
    return worst;
  }

private:
  bool turns_far(std::size_t k) const {
    const Vector6<double> step = mean_twist(given_[k - 1].pose, given_[k].pose, 1);
    return step.tail<3>().norm() > Settings::far_turn;
  }

  const std::vector<TrajectoryFrame>& given_;
  double allowed_;
  FollowedMotion laws_;

  /// By how much the laws lead the telling points elsewhere, m, interval for interval, summed
  /// up: each in so many steps from the given place, at the velocity to which they have led before.
  std::optional<Eigen::VectorXd> led_astray(std::size_t from, std::size_t to, int parts) {
    const std::vector<Vector3<double>>& points = laws_.telling().points;
    Eigen::VectorXd astray = Eigen::VectorXd::Zero(3 * static_cast<Index>(points.size()));
    Vector6<double> velocity = velocity_at(given_, from);
    for (std::size_t k = from + 1; k <= to; ++k) {
      laws_.begin_at(k - 1, velocity);
      const double h = (given_[k].time - given_[k - 1].time) / parts;
      bool is_halved = false;
      for (int part = 0; part < parts; ++part)
        if (laws_.advance(h, is_halved, Settings::part_halvings) != Status::solved)
          return std::nullopt;
      const MotionRun::Stepper& end = laws_.run().stepper();
      velocity = end.velocity();
      for (std::size_t i = 0; i < points.size(); ++i)
        astray.segment<3>(3 * static_cast<Index>(i)) +=
            end.pose().at(points[i]) - given_[k].pose.at(points[i]);
    }
    return astray;
  }

  /// m/s on average; of several numbers of steps, and of what steps of unequal lengths make, the
  /// least. While more steps still lead elsewhere by as much, the laws say nothing: 0.
  std::optional<double> missed_change(std::size_t from, std::size_t to) {
    const double time = given_[to].time - given_[from].time;
    const auto speed = [time](const Eigen::VectorXd& astray) {
      double most = 0;
      for (Index i = 0; i < astray.size(); i += 3)
        most = std::max(most, astray.segment<3>(i).norm() / time);
      return most;
    };
    laws_.begin_at(from, velocity_at(given_, from)); // it may have gone on to a later end
    const MotionRun::Saved before = laws_.run().save();
    std::optional<Eigen::VectorXd> last = led_astray(from, to, 1);
    if (!last) return std::nullopt;
    double off = speed(*last), gained = off; // by the last doubling
    for (int parts = 2; parts <= Settings::change_parts && off > allowed_; parts *= 2) {
      laws_.run().restore(before);
      const std::optional<Eigen::VectorXd> finer = led_astray(from, to, parts);
      if (!finer) return std::nullopt;
      const Eigen::VectorXd way = *finer - *last;
      off = std::min(off, speed(*last + part_of(way, -*last) * way));
      gained = speed(way);
      if (off > 2 * gained + allowed_) return off;
      last = finer;
    }
    return off > allowed_ && off < Settings::settled * gained ? 0 : off;
  }
};

} // namespace

void FollowedMotion::begin_at(std::size_t k, const Vector6<double>& twist) {
  if (k == 0) run_.begin_strokes(); // those of the scene's start, where a motion begins late
  const auto closings = seen_.closings_at(k), speeds = seen_.speeds_at(k);
  for (std::size_t a = 0; a < closings.size(); ++a)
    if (closings[a]) run_.close(static_cast<Index>(a), *closings[a], speeds[a].value_or(0));
  for (Index b = 0; b < run_.scene().bodies.size; ++b) {
    if (k == 0 && !is_driven(run_.scene(), b)) run_.put(b, seen_.stroke_pose(b, given_[k].time));
    if (const std::optional<Pose<double>> pose = seen_.driven_pose(b, k)) run_.put(b, *pose);
  }
  run_.begin_at(given_[k].time, given_[k].pose, twist);
  run_.begin_strokes();
}

Status FollowedMotion::advance(double h, bool& is_halved, int halvings) {
  const Status status = run_.advance(h);
  if (status == Status::solved || halvings == 0 || run_.stepper().run().lost) return status;
  is_halved = true;
  const Status half = advance(h / 2, is_halved, halvings - 1);
  return half == Status::solved ? advance(h / 2, is_halved, halvings - 1) : half;
}

MissedChange judge_changes(const SceneFile& file, const std::vector<TrajectoryFrame>& given,
                           double allowed, double fastest) {
  return ChangeJudge(file, given, allowed).judge(Settings::changes * allowed, fastest);
}

} // namespace lcpush::desktop
