// [T.10] A breaking force by finite pushes: the line through three slow ones, taken back to none.
#pragma once

#include "lcpush/mechanics/solve/breaking_answer.hpp"
#include "lcpush/mechanics/solve/pressure.hpp"

namespace lcpush {
namespace detail {

/// Round friction's linearization where everything moves so many times as slowly.
template <class S> void slow_down(LinearizedCone<S>& cone, const S& times) {
  cone.slip /= times;
  cone.body_motion /= times;
  cone.inertia *= times;
}

/// What one small push does.
template <class S> struct SmallPush {
  S sigma, normal, compliance;
  Vector6<S> wrench, acceleration;
  Residuals<S> residuals;
};

/// The line through two pushes, the second the smaller one.
template <class S> Breaking<S> line_through(const SmallPush<S>& a, const SmallPush<S>& b, S unit) {
  Breaking<S> line;
  const S span = (a.sigma - b.sigma) * unit, back = b.sigma * unit;
  line.inertia = (a.wrench - b.wrench) / span;
  line.inertia_normal = (a.normal - b.normal) / span;
  line.force = b.wrench - back * line.inertia;
  line.break_force = b.normal - back * line.inertia_normal;
  line.twist = b.acceleration / back;
  return line;
}

/// The line through two of three pushes, judged by the other: through the larger two, or, where the
/// force `curves` (round friction's is a smooth function of the push), through the smaller two.
template <class S>
Breaking<S> extrapolate(const SmallPush<S>* push, bool curves, S unit, const Scales<S>& scales) {
  Breaking<S> line = line_through(push[0], push[1], unit);
  S off = line.break_force + push[2].sigma * unit * line.inertia_normal - push[2].normal;
  if (curves) {
    off = line.break_force;
    line = line_through(push[1], push[2], unit);
    off -= line.break_force;
  }
  line.line_error = Eigen::numext::abs(off) / scales.force;
  // What is left of the acceleration when the push is taken back to 0: nothing if it holds.
  line.rest = push[2].acceleration - (push[1].acceleration - push[2].acceleration) *
                                         (push[2].sigma / (push[1].sigma - push[2].sigma));
  line.small_push = push[2].sigma * unit;
  line.residuals = push[1].residuals;
  for (const int k : {0, 2}) line.residuals.take(push[k].residuals);
  return line;
}

/// `pad`: compliance has to vanish before the push does, so the force of breaking is read off the
/// line through three finite pushes; so it is under round friction, whose slips have no direction
/// before they begin, and where the solver knows no infinitesimal push.
template <class S, class Rounds> class BreakByPushes {
public:
  BreakByPushes(Assembly<S>& assembly, const Rounds& rounds, Workspace<S>& work,
                const Body<S>& pusher, const PressureOptions<S>& options, S unit)
      : assembly_(assembly), rounds_(rounds), work_(work), pusher_(pusher), options_(options),
        unit_(unit) {}

  /// Slow pushes first. They ask for pads as stiff as they are slow, and of many points the
  /// stiffest have no answer in the digits: then faster ones.
  Status find(Breaking<S>& breaking, PressureRun& run) {
    const BreakingSettings<S> settings;
    S first = Eigen::numext::maxi(rounds_.carries_push() ? settings.first_push
                                                         : settings.first_swept_push,
                                  S(3) * smallest_push<S>());
    for (;;) {
      const Status status = find_from(first, breaking, run);
      const bool is_lost = status == Status::numerical_breakdown || status == Status::pivot_limit ||
                           status == Status::sweep_limit || status == Status::stagnated;
      if (is_lost && turns() && may_go_on() && !goes_on_)
        goes_on_ = true;
      else if (!is_lost || first * settings.step > settings.fastest_push)
        return status;
      else
        first *= settings.step;
    }
  }

private:
  Assembly<S>& assembly_;
  Rounds rounds_;
  Workspace<S>& work_;
  const Body<S>& pusher_;
  PressureOptions<S> options_;
  S unit_;
  SmallPush<S> push_[3]; // the last three
  bool goes_on_ = false; // round friction: the slower ones from the one before

  /// Do pads settle together with pyramids that turn?
  bool turns() const {
    return assembly_.scene().pressure == Pressure::pad && has_round_friction(assembly_.scene());
  }

  bool may_go_on() const {
    if (turns()) return rounds_.goes_on_turning();
    return rounds_.goes_on() && assembly_.scene().pressure == Pressure::pad;
  }

  /// Where the third push is off the line of the first two, a change of mode lies between, and
  /// where they leave a motion of their own size, one may lie below: then the line is that of
  /// smaller pushes.
  Status find_from(S size, Breaking<S>& breaking, PressureRun& run) {
    const BreakingSettings<S> settings;
    const bool is_round = has_round_friction(assembly_.scene());
    bool is_of_push = false; // what is left without a push may be the smallest push's own doing
    for (int k = 0; k < BreakingSettings<S>::most_pushes; ++k, size /= settings.step) {
      const Status status = push_next(size, k, run);
      if (status != Status::solved) return k < 3 ? status : Status::solved;
      if (k < 2) continue;
      const Breaking<S> line = extrapolate(push_, is_round, unit_, assembly_.layout().scales);
      if (k == 2 || is_of_push || line.line_error < breaking.line_error) breaking = line;
      breaking.small_push = line.small_push;
      const S rest = motion_size(breaking.rest, assembly_.layout().scales);
      is_of_push = rest > at_rest<S>() && rest <= settings.own_motion * size;
      const S part = Eigen::numext::abs(breaking.break_force) / assembly_.layout().scales.force;
      const S straight = settings.straight * Eigen::numext::maxi(settings.small_force, part);
      if (breaking.line_error <= straight && !is_of_push) break;
    }
    return Status::solved;
  }

  /// The k-th push, kept as one of the last three.
  Status push_next(S size, int k, PressureRun& run) {
    if (k > 2) {
      push_[0] = push_[1];
      push_[1] = push_[2];
    }
    const int at = Eigen::numext::mini(k, 2);
    SmallPush<S>& push = push_[at];
    const bool can_go_on = at > 0 && may_go_on();
    for (bool goes_on = can_go_on && (goes_on_ || !turns());; goes_on = false) {
      const PressureOptions<S> options =
          goes_on ? going_on(push_[at - 1].compliance) : from_nothing(size, k);
      const Status status = push_slowly(size, options, push, run);
      if (!goes_on || status == Status::solved) return status;
    }
  }

  /// Solves a push whose fastest point moves at `size` of F / m.
  Status push_slowly(S size, PressureOptions<S> options, SmallPush<S>& push, PressureRun& run) {
    const Scene<S>& scene = assembly_.scene();
    const Scales<S>& scales = assembly_.layout().scales;
    const BreakingSettings<S> settings;
    push.sigma = size * scales.acceleration / unit_;
    options.tolerance =
        Eigen::numext::maxi(S(size * Tolerances<S>().residual), settings.finest_pads);
    assembly_.push_by(push.sigma);
    rounds_.require(options.tolerance);
    PressureSolve<S, Rounds> solve(assembly_, rounds_, work_.pressure, options,
                                   work_.friction_memory(scene));
    const Status status = solve.solve();
    const PressureRun& one = solve.run();
    run.pivots += one.pivots;
    run.sweeps += one.sweeps;
    run.rounds += one.rounds;
    run.cold_restarts += one.cold_restarts;
    run.reason = one.reason;
    run.jammed = one.jammed;
    if (status != Status::solved) return status;
    push.compliance = solve.compliance();
    read_answer(assembly_, work_.pressure.z.data, work_.answer, push.sigma);
    push.wrench = body_wrench(scene, work_.answer, pusher_);
    push.normal = normal_sum(work_.answer, pusher_);
    push.acceleration = work_.answer.acceleration;
    push.residuals = check(scene, scales, work_.answer, push.sigma);
    return status;
  }

  /// Pads that yield more than a slow push moves would turn every slip away from the predicted
  /// one: where modes are predicted they begin as stiff as the push is slow, under round friction
  /// only for the slowest, as its pyramids turn with the slips. Pads under round friction get few
  /// pivots while pushes do not yet go on from each other, which then is the quicker way.
  PressureOptions<S> from_nothing(S size, int k) const {
    const BreakingSettings<S> settings;
    PressureOptions<S> options = options_;
    const bool is_slow = k > 2 || !has_round_friction(assembly_.scene());
    if (rounds_.goes_on() && is_slow && size < settings.first_push)
      options.first_compliance *= size / settings.first_push;
    const Index few = settings.pivots_an_unknown * assembly_.layout().size;
    if (turns() && may_go_on() && !goes_on_ &&
        !(options.max_pivots > 0 && options.max_pivots < few))
      options.max_pivots = few;
    return options;
  }

  /// A tenth of the push moves everything a tenth as fast, but for what inertia takes: where pads
  /// are to be as stiff beside the motion as before, they go on from the last answer, and round
  /// friction from its cones, which are made those of the slower push.
  PressureOptions<S> going_on(S compliance) {
    const BreakingSettings<S> settings;
    PressureOptions<S> options = options_;
    options.goes_on = options.keeps_cones = true;
    options.first_compliance = turns() ? compliance : compliance / settings.step;
    options.max_pivots = assembly_.layout().size; // from nothing takes no more
    for (LinearizedCone<S>& cone : work_.friction_memory(assembly_.scene()).round_cones)
      slow_down(cone, settings.step);
    (void)assembly_.assemble(assembly_.scene()); // it has fitted before
    return options;
  }
};

/// Not inlined: a device that asks for the exact limit has no stack for pushes.
template <class S, class Rounds>
[[gnu::noinline]] Status break_by_pushes(Assembly<S>& assembly, const Rounds& rounds,
                                         Workspace<S>& work, const Body<S>& pusher,
                                         const PressureOptions<S>& options, S unit,
                                         Breaking<S>& breaking, PressureRun& run) {
  return BreakByPushes<S, Rounds>(assembly, rounds, work, pusher, options, unit)
      .find(breaking, run);
}

} // namespace detail
} // namespace lcpush
