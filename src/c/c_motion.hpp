// Behind lcpush_advance: a motion in memory that the caller gives beside the push's own.
#pragma once

#include "lcpush/lcp/pivots/structured_lemke.hpp"
#include "lcpush/mechanics/solve/step.hpp"

namespace lcpush::c {

/// A motion with what it looks at.
template <class S> struct CMotion {
  const Scene<S> scene;
  Span<Touching> touching;
  Surroundings<S> around{};
  TimeStepper<S, SmallLemke<S>> motion;

  CMotion(const Scene<S>& its_scene, Span<Touching> its_touching, const MotionMemory<S>& memory)
      : scene(its_scene), touching(its_touching), motion(scene, around, memory) {
    around.touching = {touching.data, touching.size};
  }
  CMotion(const CMotion&) = delete;
};

template <class S> Index bytes_of_motion(const Scene<S>& scene) {
  return static_cast<Index>(sizeof(CMotion<S>)) + 2 * static_cast<Index>(alignof(CMotion<S>)) +
         scene.bodies.size * static_cast<Index>(sizeof(Touching)) +
         motion_array_bytes<S>(motion_size(scene));
}

/// Null: `arena` is too short, or the motion cannot begin.
template <class S>
CMotion<S>* begin_motion(const Scene<S>& scene, const Workspace<S>& work, Arena& arena,
                         Mistake& mistake) {
  void* const place = arena.take_bytes(static_cast<Index>(sizeof(CMotion<S>)), alignof(CMotion<S>));
  const Span<Touching> touching = arena.take<Touching>(scene.bodies.size);
  const MotionMemory<S> memory = take_motion_arrays<S>(arena, motion_size(scene), work);
  mistake = Mistake::memory_too_small;
  if (place == nullptr || !memory.work.complete) return nullptr;
  CMotion<S>* const made = new (place) CMotion<S>(scene, touching, memory);
  const Status status = made->motion.start();
  mistake = made->motion.run().mistake;
  return status == Status::running ? made : nullptr;
}

} // namespace lcpush::c
