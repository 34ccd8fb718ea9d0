// The arrays behind a motion, cut from one block of bytes.
#pragma once

#include <type_traits>

#include "lcpush/mechanics/model/faces.hpp"
#include "lcpush/mechanics/model/time_step.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush {

/// What a contact point does in a step.
template <class S> struct StepContact {
  Absence absence = Absence::none; ///< not none: it is no contact, and nothing else is known
  Absence ends = Absence::none;    ///< the same of the place where the step has taken it
  Mode mode = Mode::separate;
  S gap{0};                                       ///< m, at the step's end; below 0: penetration
  S normal_force{0};                              ///< N, the step's mean
  Vector3<S> friction_force = Vector3<S>::Zero(); ///< N, on the object
  S torsion{0};                                   ///< N m about the normal, soft points only
  Vector3<S> velocity =
      Vector3<S>::Zero(); ///< m/s, object's point relative to its body, at the end
  Vector3<S> position =
      Vector3<S>::Zero();                 ///< m, where it touched at the step's begin, hand's axes
  Vector3<S> normal = Vector3<S>::Zero(); ///< then
};

/// How large a motion may be.
struct MotionSize {
  AssemblySize assembly; ///< of the scene (size_of)
  Index bodies;
  Index spread_bodies = 0; ///< under even pressure: even_size's
};

template <class S> MotionSize motion_size(const Scene<S>& scene) {
  return {size_of(scene), scene.bodies.size, presses_evenly(scene) ? even_size(scene).bodies : 0};
}

template <class S> struct MotionMemory {
  // The state, and what the last step did.
  Span<Pose<S>> poses;           ///< bodies
  Span<Vector6<S>> velocities;   ///< bodies: the prescribed part, at the hand's origin
  Span<S> closings, speeds;      ///< actuators
  Span<S> next_speeds;           ///< actuators: at the step's end
  Span<StepContact<S>> contacts; ///< points
  // The scene of the present contacts.
  Span<PlacedPoint<S>> placed; ///< points
  Span<Index> from;            ///< present points: their place among all
  Span<S> true_gaps;           ///< present points
  Span<Body<S>> bodies;
  Span<Vector3<S>> points;
  Span<S> weights, gaps;
  Span<Drive<S>> drives;
  Span<Index> body_of;          ///< present bodies: their place among all
  Span<Vector6<S>> body_twists; ///< present bodies
  StepPush<S> push;
  EvenMemory<S> even;
  Span<unsigned char> active, kept; ///< unknowns of all points; of the present ones
  Workspace<S> work;
};

namespace detail {

/// Calls `take` once an array; one list for the bytes and for the arrays.
template <class S, class Take>
void for_each_motion_array(MotionMemory<S>& m, const MotionSize& size, const Take& take) {
  const AssemblySize& a = size.assembly;
  const Index p = a.points, b = size.bodies;
  take(b, m.poses), take(b, m.velocities), take(b, m.bodies), take(b, m.body_of);
  take(b, m.body_twists), take(b, m.push.bodies);
  take(a.actuators, m.closings), take(a.actuators, m.speeds), take(a.actuators, m.next_speeds);
  take(a.actuators, m.push.actuators);
  take(p, m.contacts), take(p, m.placed), take(p, m.from), take(p, m.true_gaps);
  take(p, m.points), take(p, m.weights), take(p, m.gaps), take(p, m.push.clearances);
  take(a.drives, m.drives);
  take(size.spread_bodies, m.even.bodies);
  take(size.spread_bodies > 0 ? a.actuators : 0, m.even.actuators);
  take(size.spread_bodies > 0 ? a.drives : 0, m.even.drives);
  take(a.unknowns(), m.active), take(a.unknowns(), m.kept);
}

} // namespace detail

/// Bytes that take_motion_arrays takes. O(unknowns).
template <class S> Index motion_array_bytes(const MotionSize& size) {
  Index bytes = 0;
  MotionMemory<S> none;
  detail::for_each_motion_array(none, size, [&](Index count, auto& span) {
    bytes +=
        count * static_cast<Index>(sizeof(span[0])) + static_cast<Index>(alignof(std::max_align_t));
  });
  return bytes;
}
/// Bytes that make_structured_motion_memory takes. O(unknowns); `shared` as structured_bytes says.
template <class S> Index structured_motion_bytes(const MotionSize& size, Index shared) {
  return motion_array_bytes<S>(size) + structured_bytes<S>(size.assembly, shared);
}

/// Cuts a motion's arrays out of an arena, beside a workspace that there is: the motion's while it
/// lasts. work.complete says whether both were long enough.
template <class S>
MotionMemory<S> take_motion_arrays(Arena& arena, const MotionSize& size, const Workspace<S>& work) {
  MotionMemory<S> memory;
  detail::for_each_motion_array(memory, size, [&](Index count, auto& span) {
    span = arena.take<std::remove_reference_t<decltype(span[0])>>(count);
  });
  memory.work = work;
  memory.work.complete = work.complete && !arena.exhausted();
  return memory;
}
/// The same with a workspace of its own, for a TimeStepper over StructuredLemke.
template <class S>
MotionMemory<S> make_structured_motion_memory(Arena arena, const MotionSize& size, Index shared) {
  MotionMemory<S> memory = take_motion_arrays<S>(arena, size, {});
  memory.work = make_structured_workspace<S>(arena, size.assembly, shared);
  return memory;
}

} // namespace lcpush
