// The control of the steps.
#include "lcpush/desktop/move.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/push_reports.hpp"
#include "move/motion_phases.hpp"
#include "move/motion_run.hpp"
#include "move/move_words.hpp"
#include "move/rotation.hpp"
#include "move/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

using Settings = MoveSettings;

/// Without what is undone after two steps at most: each try of a step has two, and a gap of
/// rounding opens and closes within them.
std::vector<MotionEvent> lasting(const std::vector<MotionEvent>& events) {
  std::vector<MotionEvent> kept;
  for (const MotionEvent& event : events) {
    const auto last = std::find_if(kept.rbegin(), kept.rend(), [&](const MotionEvent& other) {
      return other.point == event.point;
    });
    if (last == kept.rend() || last->from != event.to ||
        event.time - last->time > 2 * std::max(last->within, event.within))
      kept.push_back(event);
    else
      kept.erase(last.base() - 1);
  }
  return kept;
}

class Mover {
public:
  Mover(const SceneFile& file, const MoveOptions& options)
      : file_(file), options_(options),
        run_(file, options.step ? MotionRun::Order::first : MotionRun::Order::second),
        size_(object_size(file)), time_(options.time.value_or(motion_time(file))) {
    report_.tolerance = options.tolerance.value_or(Settings::tolerance * size_);
    if (!options.step) report_.error = 0;
  }

  MotionReport move() {
    report_.status = run_.start();
    if (!file_.start.isZero(0)) run_.begin_at(0, run_.stepper().pose(), file_.start);
    report_.frames.push_back(run_.frame(0));
    if (report_.status != Status::running) {
      report_.reason = Reason::none;
      return std::move(report_);
    }
    report_.status = Status::solved;
    last_ = report_.frames.back();
    next_ = options_.step.value_or(Settings::first_step * time_);
    bool goes_on = true;
    for (Index k = 1; goes_on && k < options_.frames; ++k) {
      goes_on = go_to(time_ * static_cast<double>(k) / static_cast<double>(options_.frames - 1));
      if (last_.time > report_.frames.back().time) report_.frames.push_back(last_);
    }
    if (goes_on) report_.end = MoveEnd::time;
    report_.events = lasting(report_.events);
    report_.phases = phases_.take();
    report_.jumps = jumps_.take();
    report_.by_pyramids = run_.by_pyramids();
    return std::move(report_);
  }

private:
  /// False: the motion has ended before.
  bool go_to(double target) {
    const double rounding = Settings::same_time * time_;
    while (now() < target - rounding) {
      if (options_.progress) options_.progress(now() / time_, now());
      if (!begin_strokes()) return false;
      report_.stop = stop_now(options_.stop);
      if (report_.stop != Stop::none || report_.solves >= options_.most_steps) {
        report_.end = report_.stop != Stop::none ? MoveEnd::stopped : MoveEnd::steps;
        report_.status = Status::pivot_limit;
        return false;
      }
      // Fixed steps are as long as was asked, whatever is kept: a frame is the end of one.
      const double room = std::min(options_.step ? time_ : target, next_stroke()) - now();
      // Equal steps up to there. A much shorter last one would leave no time to close the gaps of
      // second order that turning faces open.
      const double h = room / std::max(1.0, std::ceil(room / next_ - Settings::whole_steps));
      const bool went = options_.step ? fixed_step(h) : controlled_step(h);
      if (!went) return false;
      if (is_free()) {
        report_.end = MoveEnd::free;
        return false;
      }
    }
    return true;
  }

  double now() const { return run_.stepper().time(); }

  bool begin_strokes() {
    run_.begin_strokes();
    report_.body = run_.inside(Settings::inside * size_);
    if (report_.body < 0) return true;
    report_.end = MoveEnd::inside;
    report_.status = Status::bad_input;
    return false;
  }

  /// Are velocities about to change at once?
  bool something_starts() const {
    const auto is_now = [&](double time) {
      return std::abs(time - now()) <= Settings::same_time * time_;
    };
    return std::any_of(file_.strokes.begin(), file_.strokes.end(), [&](const Stroke& stroke) {
      return is_now(stroke.from) || is_now(stroke.until);
    });
  }

  double next_stroke() const {
    double next = time_;
    for (const Stroke& stroke : file_.strokes)
      for (const double t : {stroke.from, stroke.until})
        if (t > now() * (1 + Settings::same_time)) next = std::min(next, t);
    return next;
  }

  Status solve(double h) {
    ++report_.solves;
    report_.tried = h;
    return run_.advance(h);
  }

  /// One without an answer is tried as two of half its length, and these so again: pivots that went
  /// astray once need not do so twice, and a jam is a jam however short the step.
  bool fixed_step(double h, int halvings = Settings::halvings) {
    const MotionRun::Saved before = run_.save();
    const Status status = solve(h);
    if (status != Status::solved) {
      if (run_.stepper().run().lost || halvings == 0) return fail(status);
      run_.restore(before);
      return fixed_step(h / 2, halvings - 1) && fixed_step(h / 2, halvings - 1);
    }
    if (passes_distance()) return go_last(before, h);
    keep(taken(h));
    return true;
  }

  /// A step that is solved, and may be undone.
  struct Taken {
    MotionFrame frame;
    MotionPhase phase;
    double penetration = 0, residual = 0;
  };
  Taken taken(double h) const {
    const StepRun<double>& step = run_.stepper().run();
    const MotionFrame frame = run_.frame(h);
    return {frame, phase_of(run_.describe(size_).kind, frame), step.penetration, step.residual};
  }

  /// What two steps of h / 2 lead to, beside one of h: without the error of first order that this
  /// shows, where nothing happens meanwhile.
  struct Pair {
    Taken half, end;
    double error = 0; ///< m
    bool has_event = false;
  };
  /// Where it is not solved, the pair is none.
  Status solve_pair(double h, const MotionRun::Saved& before, Pair& pair) {
    Status status = solve(h);
    if (status != Status::solved) return status;
    const MotionRun::State whole = run_.state();
    const std::vector<Touch> touches = run_.touches();
    run_.restore(before);
    status = solve_halves(h, pair);
    if (status != Status::solved) return status;
    pair.error = distance(whole.moment.pose, run_.stepper().pose());
    const bool is_smooth = !pair.has_event && run_.touches() == touches;
    if ((is_smooth && extrapolates(h, before.moment, whole, pair)) || !run_.speeds_up())
      return status;
    // At the speed of the steps' ends, a body that speeds up has gone too far.
    run_.restore(before);
    run_.set_order(MotionRun::Order::first);
    status = solve_halves(h, pair);
    run_.set_order(MotionRun::Order::second);
    return status;
  }

  Status solve_halves(double h, Pair& pair) {
    Status status = solve(h / 2);
    if (status != Status::solved) return status;
    pair.half = taken(h / 2);
    status = solve(h / 2);
    if (status != Status::solved) return status;
    pair.end = taken(h / 2);
    // What leaves its face at the end of a step is seen there, before the next one begins.
    pair.has_event = changes(last_, pair.half.frame) || changes(pair.half.frame, pair.end.frame) ||
                     turns_back(last_, pair.half.frame) ||
                     turns_back(pair.half.frame, pair.end.frame) || run_.leaves();
    return status;
  }

  bool extrapolates(double h, const MotionRun::Stepper::Moment& before,
                    const MotionRun::State& whole, Pair& pair) {
    const double way = distance(before.pose, run_.stepper().pose());
    const double slack = std::max(Settings::exact * size_, Settings::unfelt * way);
    if (!run_.extrapolate(whole, slack)) return false;
    // Of third order in h, but where velocities have changed at once.
    const Vector6<double> mean = (before.velocity + run_.stepper().velocity()) / 2;
    const Pose<double> other = moved(before.pose, mean, h);
    pair.error = std::min(pair.error, distance(other, run_.stepper().pose()));
    pair.end = taken(h / 2);
    pair.end.phase = phase_of(pair.end.phase.kind, pair.half.frame, pair.end.frame);
    return true;
  }

  /// A pair that is kept if its error allows it.
  bool controlled_step(double h) {
    const MotionRun::Saved before = run_.save();
    const bool starts = something_starts();
    Pair pair;
    const Status status = solve_pair(h, before, pair);
    if (status != Status::solved) {
      const bool leaps = run_.stepper().run().reason == Reason::leap;
      const double least = leaps ? Settings::shortest_step : Settings::event_step / 4;
      const bool goes_on = h > least * time_ || fail(status); // of the step's problem as it was
      run_.restore(before);
      next_ = h / 2;
      return goes_on;
    }
    const double share = std::max(h / time_, starts ? Settings::share_of_start : 0);
    const double allowed = report_.tolerance * share;
    const bool locates =
        pair.has_event && located_ < Settings::most_located && h > Settings::event_step * time_;
    if ((pair.error > allowed && h > Settings::shortest_step * time_) || locates) {
      if (locates) event_by_ = std::min(event_by_, before.moment.time + h);
      run_.restore(before);
      next_ = h / 2;
      return true;
    }
    // Where shorter steps pass by what a longer one has seen, it was of the step, not of the time.
    const bool passes_event = now() >= event_by_ - Settings::same_time * time_;
    if (pair.has_event || passes_event) {
      ++located_;
      event_by_ = std::numeric_limits<double>::infinity();
    }
    const bool turns =
        h <= Settings::event_step * time_ &&
        (turns_or_rests(last_, pair.half.frame) || turns_or_rests(pair.half.frame, pair.end.frame));
    if (pair.has_event && (lands() || turns) && before.moment.time > landed_ &&
        land(before, h, turns))
      return true;
    *report_.error += pair.error;
    if (passes_distance()) return go_last(before, h);
    keep(pair.half);
    keep(pair.end);
    if (pair.error < allowed / 4)
      next_ = std::min(std::max(next_, 2 * h), Settings::longest_step * time_);
    return true;
  }

  /// Has a point come down on its face since the last frame?
  bool lands() const {
    const std::vector<Touch> now = run_.touches();
    for (std::size_t i = 0; last_.step > 0 && i < now.size(); ++i)
      if (is_touching(now[i]) && !is_touching(last_.contacts[i].touch)) return true;
    return false;
  }

  /// The step ends where it comes down, turns back or comes to rest, by halving. Else a part of the
  /// blow would be left to the next one, and what friction has of it would depend on how the steps
  /// fall; and a step that slips back at its end, or sticks, would have all of its friction that
  /// way. False: it is there already, or a step has no answer.
  bool land(const MotionRun::Saved& before, double h, bool turns) {
    const MotionRun::Saved after = run_.save();
    const Index by_pyramids = run_.by_pyramids();
    double above = 0, below = h;
    const int halvings = lands() ? Settings::landing_halvings : Settings::turning_halvings;
    for (int k = 0; k < halvings; ++k) {
      const double middle = (above + below) / 2;
      run_.restore(before);
      if (solve(middle) != Status::solved) break;
      (lands() || (turns && turns_or_rests(last_, run_.frame(middle))) ? below : above) = middle;
    }
    run_.restore(before);
    run_.forget_tries(by_pyramids);
    if (above > 0 && solve(above) == Status::solved && run_.by_pyramids() == by_pyramids &&
        !passes_distance()) {
      if (turns) // at its end's speed
        *report_.error += above / 2 * speed(run_.stepper().velocity() - last_.twist);
      keep(taken(above));
      landed_ = now();
      return true;
    }
    run_.restore(after);
    run_.forget_tries(by_pyramids);
    return false;
  }

  /// Between two ends of the same step, m: of the point of the object that differs most.
  double distance(const Pose<double>& a, const Pose<double>& b) const {
    return (a.position - b.position).norm() + size_ / 2 * (a.rotation - b.rotation).norm();
  }

  double gone() const {
    double most = 0;
    const Pose<double>& pose = run_.stepper().pose();
    for (const Vector3<double>& p : file_.points) most = std::max(most, (pose.at(p) - p).norm());
    return most;
  }
  bool passes_distance() const { return gone() > options_.distance; }

  /// A step so long that the distance is reached, by halving.
  bool go_last(const MotionRun::Saved& before, double h) {
    double least = 0, most = h;
    for (int k = 0; k < Settings::distance_halvings; ++k) {
      run_.restore(before);
      const double middle = (least + most) / 2;
      if (const Status status = solve(middle); status != Status::solved) return fail(status);
      (passes_distance() ? most : least) = middle;
    }
    run_.restore(before);
    if (const Status status = solve(most); status != Status::solved) return fail(status);
    keep(taken(most));
    report_.end = MoveEnd::distance;
    return false;
  }

  bool fail(Status status) {
    const bool is_lost = run_.stepper().run().lost;
    report_.status = status;
    report_.reason = run_.stepper().run().reason;
    // Where a theorem promises an answer, a ray is rounding's and no jam.
    const auto exists = [&] {
      return find_existence(file_, run_.stepper().assembly()).verdict == Existence::proved;
    };
    if (status == Status::ray && exists()) {
      report_.status = Status::numerical_breakdown;
      report_.reason = Reason::false_ray;
    }
    report_.end = is_lost                          ? MoveEnd::lost
                  : report_.reason == Reason::leap ? MoveEnd::leaps
                                                   : MoveEnd::failed;
    if (is_lost) report_.body = lost_body();
    return false;
  }

  /// The one whose points have all left their faces.
  Index lost_body() const {
    for (const Drive<double>& drive : file_.drives) {
      bool touches = false;
      for (const Index i : points_of(file_.body(drive.body))) {
        const Touch touch = last_.contacts[static_cast<std::size_t>(i)].touch;
        touches = touches || is_touching(touch);
      }
      if (!touches) return drive.body;
    }
    return file_.drives.empty() ? -1 : file_.drives.front().body;
  }

  static bool changes(const MotionFrame& from, const MotionFrame& to) {
    if (from.step == 0) return false; // nothing has been seen yet
    for (std::size_t i = 0; i < from.contacts.size(); ++i)
      if (from.contacts[i].touch != to.contacts[i].touch) return true;
    return false;
  }

  /// Does friction turn round, as that of a block does which slides up a ramp and down again? Of
  /// what is slow beside the rest, as points about which a pad turns, that is next to nothing.
  bool turns_back(const MotionFrame& from, const MotionFrame& to) const {
    if (from.step == 0) return false;
    const auto fastest = [](const MotionFrame& frame) {
      double most = 0;
      for (const PointState& point : frame.contacts)
        if (point.touch == Touch::slips) most = std::max(most, point.velocity.norm());
      return most;
    };
    const double was_fast = fastest(from), is_fast = fastest(to);
    for (std::size_t i = 0; i < from.contacts.size(); ++i) {
      const PointState &was = from.contacts[i], &is = to.contacts[i];
      if (was.touch != Touch::slips || is.touch != Touch::slips) continue;
      const bool slips_back = was.velocity.dot(is.velocity) < 0 && is.friction_force.norm() > 0 &&
                              was.velocity.norm() > Settings::slow_slip * was_fast &&
                              is.velocity.norm() > Settings::slow_slip * is_fast;
      const double e = file_.body(file_.body_of(static_cast<Index>(i))).torsion_radius;
      const auto spins = [e](const PointState& point) {
        return std::abs(point.torsion) > e * point.friction_force.norm();
      };
      if (slips_back || (was.torsion * is.torsion < 0 && spins(was) && spins(is))) return true;
    }
    return false;
  }

  /// Does what slips turn back, or the object come to rest? What would slip on the other way sticks
  /// for a step.
  bool turns_or_rests(const MotionFrame& from, const MotionFrame& to) const {
    const double was = speed(from.twist), is = speed(to.twist);
    return (from.step > 0 && was > 0 && is <= Settings::at_rest * was) || turns_back(from, to);
  }
  double speed(const Vector6<double>& twist) const {
    return twist.head<3>().norm() + size_ / 2 * twist.tail<3>().norm();
  }

  void keep(const Taken& step) {
    const MotionFrame& frame = step.frame;
    const double h = frame.step;
    for (std::size_t i = 0; last_.step > 0 && i < frame.contacts.size(); ++i)
      if (frame.contacts[i].touch != last_.contacts[i].touch)
        report_.events.push_back({frame.time - h, h, static_cast<Index>(i), last_.contacts[i].touch,
                                  frame.contacts[i].touch});
    phases_.add(step.phase);
    jumps_.add(frame.time - h, h, push_force(file_, frame.bodies).norm(), hardest(frame.bodies));
    report_.penetration = std::max(report_.penetration, step.penetration);
    report_.residual = std::max(report_.residual, step.residual);
    for (const PointState& point : frame.contacts)
      if (point.normal_force > 0)
        report_.pressed_gap = std::max(report_.pressed_gap, point.gap.value_or(0));
    if (report_.steps < 2) report_.first = frame.bodies;
    if (!report_.first.empty() && is_getting_going(frame)) report_.first.clear();
    report_.shortest = report_.steps == 0 ? h : std::min(report_.shortest, h);
    report_.longest = std::max(report_.longest, h);
    ++report_.steps;
    const Vector3<double> turn = turn_after(last_.turn, frame.pose.rotation);
    last_ = frame;
    last_.turn = turn;
    if (is_touched()) touched_ = frame.pose.position;
  }

  /// A first push that soon is another one is none that the motion takes.
  bool is_getting_going(const MotionFrame& frame) const {
    if (report_.steps > 2 && frame.time > Settings::start * time_) return false;
    const double first = push_force(file_, report_.first).norm(),
                 now = push_force(file_, frame.bodies).norm();
    return std::abs(now - first) > Settings::begun * std::max(now, first);
  }

  bool is_touched() const {
    return std::any_of(last_.contacts.begin(), last_.contacts.end(),
                       [](const PointState& point) { return is_touching(point.touch); });
  }
  /// Has nothing touched it for a long way, and is nothing to come?
  bool is_free() const {
    return (last_.pose.position - touched_).norm() > Settings::free_way * size_ &&
           std::none_of(file_.strokes.begin(), file_.strokes.end(),
                        [&](const Stroke& stroke) { return stroke.from > now(); });
  }

  const SceneFile& file_;
  const MoveOptions& options_;
  MotionRun run_;
  const double size_, time_;
  MotionReport report_;
  MotionFrame last_;
  Phases phases_{size_};
  ForceJumps jumps_;
  double next_ = 0;
  Index located_ = 0;
  double landed_ = -1;                                        ///< s, when a step ended at a face
  double event_by_ = std::numeric_limits<double>::infinity(); ///< s, until when one is to come
  Vector3<double> touched_ = Vector3<double>::Zero(); ///< m, where it was when something did
};

} // namespace

double motion_time(const SceneFile& file) {
  double last = 0;
  for (const Stroke& stroke : file.strokes)
    if (std::isfinite(stroke.until)) last = std::max(last, stroke.until);
  return last > 0 ? last : 1;
}

const char* touch_text(Touch touch) {
  constexpr const char* texts[] = {"stick",  "slide",   "separate", "beside",
                                   "behind", "no_line", "away"};
  return texts[static_cast<int>(touch)];
}

const char* move_end_text(MoveEnd end) {
  constexpr const char* texts[] = {"time",    "distance", "lost",   "inside", "steps",
                                   "stopped", "leaps",    "failed", "free"};
  return texts[static_cast<int>(end)];
}

MotionReport move(const SceneFile& file, const MoveOptions& options) {
  return Mover(file, options).move();
}

} // namespace lcpush::desktop
