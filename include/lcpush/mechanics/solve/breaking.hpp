// [T.10] The instant of breaking: the force that just moves the object in the grip, and how it then
// moves. It is the limit of an infinitesimal push, sigma -> 0+ (docs/theory/theory.md, "Breaking").
#pragma once

#include "lcpush/mechanics/solve/breaking_answer.hpp"
#include "lcpush/mechanics/solve/slow_pushes.hpp"

namespace lcpush {
namespace detail {

/// `rigid` and `even`: the push is one more right-hand side, so the limit is exact.
template <class S, class Rounds>
Status break_exactly(Assembly<S>& assembly, Rounds& rounds, Workspace<S>& work,
                     const Body<S>& pusher, S unit, Breaking<S>& breaking, PressureRun& run) {
  assembly.push_by(assembly.sigma());
  PushLimit<S> limit;
  const Status status = rounds.solve_limit(assembly, work.pressure, run, limit);
  assembly.push_by(assembly.sigma());
  if (status != Status::solved) return status;
  return read_breaking(assembly, limit.z, limit.z_push, limit.valid_to, work, pusher, unit,
                       breaking, run);
}

} // namespace detail

/// Will find_breaking ask for the limit of an infinitesimal push? Pads' compliance has to vanish
/// before the push does.
template <class Rounds, class S>
bool breaks_exactly(const Rounds& rounds, const Scene<S>& scene,
                    const PressureOptions<S>& options) {
  return rounds.carries_push() && options.exact_limit && scene.pressure != Pressure::pad &&
         !has_round_friction(scene);
}

/// The push that `pusher` (a body of the scene) needs to move the object in the grip, by one of the
/// solvers of rounds.hpp. Pre: push_size(scene) > 0. Post: solved; does_not_hold (breaking.rest is
/// the motion without a push); or the solver's failure. work.answer is left at a small push: the
/// modes at breaking.
template <class S, class Rounds>
[[nodiscard]] Status find_breaking(Assembly<S>& assembly, Rounds rounds, Workspace<S>& work,
                                   const Body<S>& pusher, const PressureOptions<S>& options,
                                   Breaking<S>& breaking, PressureRun& run) {
  const S unit = push_size(assembly.scene());
  breaking = {};
  run = {};
  if (unit > S(0)) run.reason = unsupported_reason(assembly);
  if (!(unit > S(0)) || run.reason != Reason::none) return Status::bad_input;
  Status status = Status::running;
  if (breaks_exactly(rounds, assembly.scene(), options))
    status = detail::break_exactly(assembly, rounds, work, pusher, unit, breaking, run);
  else
    status = detail::break_by_pushes(assembly, rounds, work, pusher, options, unit, breaking, run);
  if (status != Status::solved) return status;
  return judge(breaking, pusher, assembly.layout().scales, run);
}

} // namespace lcpush
