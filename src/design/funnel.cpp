// Pushes with a flat edge, replayed from many poses by the laws of motion.
#include "lcpush/desktop/funnel.hpp"

#include <algorithm>
#include <cmath>

#include "design/settings.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/varied_scene.hpp"
#include "move/motion_run.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr const DesignSettings& settings = design_settings;
const double right_angle = std::acos(0.0);

/// The edge, in the plane of the hand.
class Edge {
public:
  Edge(const SceneFile& file, Index pusher)
      : file_(file), pusher_(pusher), normal_(file.body(pusher).normal),
        along_(cross<double>(Vector3<double>(Vector3<double>::UnitZ()), normal_)) {
    const auto refuse = [&](const std::string& why) {
      throw InputError(file.lines.file, file.lines.bodies[static_cast<std::size_t>(pusher)].place,
                       "pusher " + quoted(file.body_name(pusher)) + ": " + why);
    };
    if (!file.planar) refuse("it aligns an object in a plane; write planar = true");
    const Vector6<double>& v = file.body(pusher).acceleration;
    speed_ = normal_.dot(v.head<3>());
    if (!file.strokes[static_cast<std::size_t>(pusher)].is_velocity)
      refuse("give it a velocity, at which it meets the object");
    if (!(speed_ > 0) || !((v.head<3>() - speed_ * normal_).norm() <= settings.better * speed_) ||
        !v.tail<3>().isZero(0))
      refuse("it has to move along its normal");
    width_ = 0;
    for (const Index i : points_of(file.body(pusher)))
      for (const Index k : points_of(file.body(pusher)))
        width_ = std::max(width_, along_.dot(point(i) - point(k)));
    if (!(width_ > 0)) refuse("it is a point; an edge is a line along a face of the object");
  }

  double width() const { return width_; }
  double speed() const { return speed_; }
  const Vector3<double>& normal() const { return normal_; }

  Pose<double> pose(const EdgePose& at) const {
    Pose<double> pose;
    pose.position = at[0] * normal_ + at[1] * along_;
    pose.rotation << std::cos(at[2]), -std::sin(at[2]), 0, std::sin(at[2]), std::cos(at[2]), 0, 0,
        0, 1;
    return pose;
  }
  static double angle(const Pose<double>& pose) {
    return std::atan2(pose.rotation(1, 0), pose.rotation(0, 0));
  }
  double along(const Pose<double>& pose) const { return along_.dot(pose.position); }
  /// How far the edge would have to go from its place in the scene to touch; and to touch all.
  std::pair<double, double> reach(const Pose<double>& pose) const {
    double first = HUGE_VAL, last = -HUGE_VAL;
    for (const Index i : points_of(file_.body(pusher_))) {
      const double gap = normal_.dot(pose.at(point(i)) - point(i));
      first = std::min(first, gap);
      last = std::max(last, gap);
    }
    return {first, last};
  }

private:
  const SceneFile& file_;
  Index pusher_;
  Vector3<double> normal_, along_;
  double width_, speed_ = 0;

  const Vector3<double>& point(Index i) const { return file_.points[static_cast<std::size_t>(i)]; }
};

class Funnel {
public:
  Funnel(const SceneFile& file, Index pusher) : file_(file), pusher_(pusher), edge_(file, pusher) {}

  FunnelReport find(const EdgePose& box) {
    FunnelReport report;
    report.pusher = pusher_;
    report.box = box;
    carry(report);
    report.is_capture_known = report.stays;
    report.from = -capture(-1, report.is_capture_known);
    report.until = capture(1, report.is_capture_known);
    const int sides[] = {box[0] > 0 ? 3 : 1, box[1] > 0 ? 3 : 1, box[2] > 0 ? settings.angles : 1};
    const auto at = [&](int k, int side) {
      return sides[side] == 1
                 ? 0
                 : box[static_cast<std::size_t>(side)] * (2.0 * k / (sides[side] - 1) - 1);
    };
    for (int x = 0; x < sides[0]; ++x)
      for (int y = 0; y < sides[1]; ++y)
        for (int a = 0; a < sides[2]; ++a)
          report.pushes.push_back(push({at(x, 0), at(y, 1), at(a, 2)}));
    sum_up(report);
    return report;
  }

private:
  const SceneFile& file_;
  Index pusher_;
  Edge edge_;

  /// Steps until it is flush, or has turned away. `enough`: of its angle; less shows that it turns
  /// to the edge.
  FlushPush push(const EdgePose& begin, double enough = 0) {
    FlushPush result;
    result.begin = begin;
    const Pose<double> start = edge_.pose(begin);
    result.contact = edge_.reach(start).first;
    MotionRun run(file_);
    result.status = run.start();
    if (result.status != Status::running) return result;
    run.begin_strokes();
    Pose<double> edge;
    edge.position = result.contact * edge_.normal();
    run.put(pusher_, edge);
    run.begin_at(0, start, Vector6<double>::Zero());
    run.begin_strokes();
    const double first = std::abs(begin[2]), flush = settings.flush * edge_.width(),
                 step = std::max(flush, edge_.width() * std::sin(first) / settings.flush_steps);
    double gap = edge_.reach(start).second - result.contact, last = gap;
    for (int k = 0; k < settings.most_flush_steps; ++k) {
      const double angle = std::abs(Edge::angle(run.stepper().pose()));
      result.is_flush = gap <= flush || (enough > 0 && angle < enough * first);
      if (result.is_flush || angle > (1 + settings.turned_away) * first) {
        result.status = Status::solved;
        break;
      }
      const Status status = go(run, step / edge_.speed());
      if (status != Status::solved) {
        result.status = status;
        break;
      }
      const auto [near, far] = edge_.reach(run.stepper().pose());
      const double now = far - near, closes = last - gap;
      // It met the other end on the way: where, its last step says.
      result.way += now <= flush && k > 0 && closes > gap ? step * gap / closes : step;
      last = gap;
      gap = now;
    }
    result.along = edge_.along(run.stepper().pose());
    return result;
  }

  /// Flush in the scene's pose: is it carried so, and how fast does it drift along the edge?
  void carry(FunnelReport& report) {
    MotionRun run(file_);
    if (run.start() != Status::running) return;
    run.begin_strokes();
    const double whole = settings.carried * edge_.width(),
                 step = whole / settings.carried_steps / edge_.speed();
    double way = 0;
    for (int k = 0; k < settings.carried_steps && go(run, step) == Status::solved; ++k) {
      way += step * edge_.speed();
      const auto [near, far] = edge_.reach(run.stepper().pose());
      report.stays = report.stays && far - near <= settings.flush * edge_.width();
      if (!report.stays) return;
    }
    if (way > 0) report.drift = edge_.along(run.stepper().pose()) / way;
    if (std::abs(report.drift) <= settings.flush) report.drift = 0;
  }

  /// Round friction that does not settle in a step mostly does in two shorter ones; pyramids, which
  /// are off by some per cent, have the answer where it does not.
  static Status go(MotionRun& run, double h, int halvings = settings.step_halvings) {
    const MotionRun::Saved before = run.save();
    run.allow_pyramids(halvings == 0);
    const Status status = run.advance(h);
    if (status == Status::solved || halvings == 0) return status;
    run.restore(before);
    const double first = settings.first_part * h;
    const Status half = go(run, first, halvings - 1);
    return half == Status::solved ? go(run, h - first, halvings - 1) : half;
  }

  /// The largest angle to that side from which it is found to turn towards the edge.
  double capture(double sign, bool& is_known) {
    double captured = 0, beyond = right_angle;
    bool turns_away = true; // from a right angle another face comes first
    for (int k = 0; k < settings.capture_halvings; ++k) {
      const double middle = (captured + beyond) / 2;
      const FlushPush found = push({0, 0, sign * middle}, 1 - settings.turned_away);
      if (!found.is_flush) turns_away = found.status == Status::solved;
      (found.is_flush ? captured : beyond) = middle;
    }
    is_known = is_known && turns_away;
    return captured;
  }

  void sum_up(FunnelReport& report) const {
    report.is_flush = report.stays;
    double first = HUGE_VAL;
    report.along_from = HUGE_VAL;
    report.along_until = report.stop = -HUGE_VAL;
    for (const FlushPush& push : report.pushes) {
      report.is_flush = report.is_flush && push.is_flush;
      first = std::min(first, push.contact);
      report.stop = std::max(report.stop, push.contact + push.way);
    }
    for (const FlushPush& push : report.pushes) {
      const double along = push.along + report.drift * (report.stop - push.contact - push.way);
      report.along_from = std::min(report.along_from, along);
      report.along_until = std::max(report.along_until, along);
    }
    report.way = report.stop - first;
  }
};

} // namespace

std::string with_flat_edge(const std::string& text, const std::string& file_name,
                           const std::string& pusher) {
  return with_values(text, file_name, "", {pusher + ".points_on=\"object\""});
}

FunnelReport find_funnel(const SceneFile& file, Index pusher, const EdgePose& box) {
  return Funnel(file, pusher).find(box);
}

} // namespace lcpush::desktop
