// One block of bytes, everything in it: what a push needs from scene to answer. The caller brings
// the block (static on a microcontroller, a vector on the desktop); push_bytes says how long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include "lcpush/mechanics/model/even_pressure.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "lcpush/mechanics/solve/pressure.hpp"

namespace lcpush {

/// Cuts typed arrays off the front of a block of bytes. Once it is exhausted nothing that it gave
/// may be used.
class Arena {
public:
  Arena(Span<unsigned char> bytes) : rest_(bytes) {}
  Arena(unsigned char* bytes, Index count) : rest_{bytes, count} {}

  template <class T> Span<T> take(Index count) {
    const Span<T> taken = zeros<T>(count);
    for (Index i = 0; taken.data != nullptr && i < count; ++i) new (taken.data + i) T();
    return taken;
  }
  /// The same of numbers, and of records that are all zeros when they begin: no loop for each type.
  template <class T> Span<T> zeros(Index count) {
    Span<T> taken;
    seat(taken, count);
    return taken;
  }

  /// Zeros, an array of `count` for each of the spans.
  template <class... T> void fill(Index count, Span<T>&... spans) { (seat(spans, count), ...); }

  /// Bytes of zeros at an address that `alignment` divides; null, and exhausted(), if fewer are
  /// left.
  void* take_bytes(Index count, std::size_t alignment) {
    const auto address = reinterpret_cast<std::uintptr_t>(rest_.data);
    const Index skip = static_cast<Index>((alignment - address % alignment) % alignment);
    if (count < 0 || count > rest_.size - skip) {
      exhausted_ = true;
      return nullptr;
    }
    unsigned char* const taken = rest_.data + skip;
    rest_ = {taken + count, rest_.size - skip - count};
    if (count > 0) std::memset(taken, 0, static_cast<std::size_t>(count));
    return taken;
  }

  bool exhausted() const { return exhausted_; }
  const Span<unsigned char>& rest() const { return rest_; }

private:
  Span<unsigned char> rest_;
  bool exhausted_ = false;

  template <class T> void seat(Span<T>& span, Index count) {
    // A product that no Index holds is below 0.
    const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(T);
    span.data = static_cast<T*>(take_bytes(static_cast<Index>(bytes), alignof(T)));
    span.size = count;
  }
};

/// Integers of Lemke's: int, or as narrow as those of make_small_workspace.
struct LemkeIntegers {
  Span<int> wide;
  Span<std::int16_t> narrow;
  operator Span<int>() const { return wide; }
  operator Span<std::int16_t>() const { return narrow; }
};

/// The arrays behind one push.
template <class S> struct Workspace {
  AssemblyMemory<S> assembly;
  PressureMemory<S> pressure;
  Span<S> lemke_scalars; ///< empty in a workspace for sweeps
  LemkeIntegers lemke_integers;
  Index exchanges = 0;   ///< what lemke_scalars are for, as LemkeOptions say
  Span<S> sweep_scalars; ///< empty in a workspace for pivots
  Span<int> sweep_integers;
  Answer<S> answer;
  Span<LinearizedCone<S>> round_cones; ///< Scene::round_cones looks at them
  bool complete = false;               ///< false: the block was too small, use nothing of it

  /// What solve_pressure takes: something where the scene's friction is round.
  FrictionMemory<S> friction_memory(const Scene<S>& scene) {
    if (!has_round_friction(scene)) return {};
    return {{round_cones.data, scene.round_cones.size}, &answer};
  }
};

/// Of the arrays in a block: of the vectors that are aligned most, or of numbers of bodies.
template <class S> constexpr Index widest_alignment() {
  return static_cast<Index>(alignof(Vector6<S>) > alignof(Index) ? alignof(Vector6<S>)
                                                                 : alignof(Index));
}

namespace detail {

/// What a solver takes beside what every push needs.
struct SolverSize {
  Index scalars, integers;
  Index bytes_of_integer = sizeof(int);
};
constexpr SolverSize pivots_size(const AssemblySize& size) {
  return {lemke_scalars(size.unknowns()), lemke_integers(size.unknowns())};
}
constexpr SolverSize structured_size(const AssemblySize& size, Index shared) {
  return {structured_lemke_scalars(size.unknowns(), size.points, shared),
          structured_lemke_integers(size.unknowns(), size.points)};
}
constexpr SolverSize small_size(const AssemblySize& size, Index shared, Index exchanges) {
  return {small_lemke_scalars(size.unknowns(), size.points, shared, exchanges) - size.unknowns() -
              size.generators, // see make_small_workspace
          small_lemke_integers(size.unknowns(), size.points, shared, exchanges),
          sizeof(std::int16_t)};
}
constexpr SolverSize sweeps_size(const AssemblySize& size) {
  const Index n = size.unknowns(), couplings = size.couplings(), actuators = size.actuators;
  return {block_gauss_seidel_scalars(n, couplings, actuators),
          block_gauss_seidel_integers(n, couplings, actuators)};
}

template <class S> constexpr Index bytes_with(const SolverSize& solver, const AssemblySize& size) {
  const Index n = size.unknowns(), p = size.points;
  const Index scalars = 3 * n + size.couplings() + 2 * size.actuators + 2 * p + size.generators;
  const Index structs = size.forces() * static_cast<Index>(sizeof(Vector6<S>)) +
                        p * static_cast<Index>(sizeof(ConeGroup<S>) + sizeof(ContactAnswer<S>) +
                                               sizeof(LinearizedCone<S>)) +
                        size.actuators * static_cast<Index>(sizeof(SumGroup<S>));
  constexpr Index arrays_after_narrower_ones = 6; // what they begin at may have to be aligned
  constexpr Index alignment_slack = arrays_after_narrower_ones * widest_alignment<S>();
  return (scalars + solver.scalars) * static_cast<Index>(sizeof(S)) + structs +
         size.couplings() * static_cast<Index>(sizeof(int)) +
         solver.integers * solver.bytes_of_integer + p * static_cast<Index>(sizeof(Index)) + n +
         alignment_slack;
}

template <class S> Workspace<S> take_common(Arena& arena, const AssemblySize& size) {
  const Index n = size.unknowns(), p = size.points;
  Workspace<S> w;
  AssemblyMemory<S>& a = w.assembly;
  arena.fill(size.forces(), a.wrenches);
  arena.fill(p, a.cones, a.body, w.pressure.preload, w.pressure.compliance);
  w.round_cones = arena.take<LinearizedCone<S>>(p);
  arena.fill(n, a.push, a.q, w.pressure.active);
  arena.fill(size.actuators, a.sums, a.reach, w.answer.closing);
  arena.fill(size.couplings(), a.coupled_variable, a.coupling);
  return w;
}

/// In memory that nothing else uses.
template <class S> Workspace<S> take_alone(Arena& arena, const AssemblySize& size) {
  Workspace<S> w = take_common<S>(arena, size);
  arena.fill(size.points, w.answer.contacts);
  arena.fill(size.generators, w.answer.friction);
  arena.fill(size.unknowns(), w.pressure.z);
  return w;
}

/// What an answer needs in the solver's own scalars: first, where Lemke writes its own solution,
/// the pressure's z; last its friction and contacts.
template <class S> void answer_in_solver(Workspace<S>& w, const AssemblySize& size) {
  const Span<S>& all = w.lemke_scalars;
  w.pressure.z = {all.data, size.unknowns()};
  const Index last = size.generators * static_cast<Index>(sizeof(S)) +
                     size.points * static_cast<Index>(sizeof(ContactAnswer<S>)) +
                     static_cast<Index>(alignof(ContactAnswer<S>));
  Arena answer(reinterpret_cast<unsigned char*>(all.data + all.size) - last, last);
  answer.fill(size.points, w.answer.contacts);
  answer.fill(size.generators, w.answer.friction);
}

template <class S>
Workspace<S> take_for_pivots(Arena& arena, const AssemblySize& size, const SolverSize& solver) {
  Workspace<S> w = take_alone<S>(arena, size);
  arena.fill(solver.scalars, w.lemke_scalars);
  arena.fill(solver.integers, w.lemke_integers.wide);
  w.complete = !arena.exhausted();
  return w;
}

} // namespace detail

/// Bytes that make_workspace takes. constexpr, so that `static unsigned char memory[push_bytes..]`
/// works. Lemke's dictionary is most of it: O(unknowns^2).
template <class S> constexpr Index push_bytes(const AssemblySize& size) {
  return detail::bytes_with<S>(detail::pivots_size(size), size);
}
/// Bytes that make_structured_workspace takes: O(unknowns). `shared` is the number of actuators
/// that drive more than one point, at most all of them; under `even` pressure there is none.
template <class S> constexpr Index structured_bytes(const AssemblySize& size, Index shared) {
  return detail::bytes_with<S>(detail::structured_size(size, shared), size);
}
/// Bytes that make_small_workspace takes. `exchanges` > 0 as small_lemke_scalars says, and
/// LemkeOptions has to have them.
template <class S>
constexpr Index small_bytes(const AssemblySize& size, Index shared, Index exchanges) {
  return detail::bytes_with<S>(detail::small_size(size, shared, exchanges), size) -
         size.points * static_cast<Index>(sizeof(ContactAnswer<S>));
}
/// Bytes that make_sweep_workspace takes: O(unknowns), and (6 + actuators)^2 Scalars.
template <class S> constexpr Index sweep_bytes(const AssemblySize& size) {
  return detail::bytes_with<S>(detail::sweeps_size(size), size);
}

/// Cuts a workspace for scenes of at most this size out of an arena, or a block of bytes, of its
/// own; to be solved by Lemke's pivots.
template <class S> Workspace<S> make_workspace(Arena arena, const AssemblySize& size) {
  return detail::take_for_pivots<S>(arena, size, detail::pivots_size(size));
}
/// The same by StructuredLemke.
template <class S>
Workspace<S> make_structured_workspace(Arena arena, const AssemblySize& size, Index shared) {
  return detail::take_for_pivots<S>(arena, size, detail::structured_size(size, shared));
}
/// The same by SmallLemke, whose memory holds what stands still while it pivots: the pressure's z
/// and the answer. Who solves on has no answer any more.
template <class S>
Workspace<S> make_small_workspace(Arena arena, const AssemblySize& size, Index shared,
                                  Index exchanges) {
  const detail::SolverSize solver = detail::small_size(size, shared, exchanges);
  Workspace<S> w = detail::take_common<S>(arena, size);
  arena.fill(size.unknowns() + size.generators + solver.scalars, w.lemke_scalars);
  arena.fill(solver.integers, w.lemke_integers.narrow);
  w.exchanges = exchanges;
  w.complete =
      !arena.exhausted() && SmallBasis<S>::numbers(size.unknowns(), size.points, size.actuators);
  if (w.complete) detail::answer_in_solver(w, size);
  return w;
}
/// The same by block Gauss-Seidel.
template <class S> Workspace<S> make_sweep_workspace(Arena arena, const AssemblySize& size) {
  Workspace<S> w = detail::take_alone<S>(arena, size);
  const detail::SolverSize solver = detail::sweeps_size(size);
  arena.fill(solver.scalars, w.sweep_scalars);
  arena.fill(solver.integers, w.sweep_integers);
  w.complete = !arena.exhausted();
  return w;
}

#ifdef LCPUSH_EXTERN_TEMPLATES
extern template Workspace<double> detail::take_common<double>(Arena&, const AssemblySize&);
#endif

} // namespace lcpush
