// The core works in its caller's memory; on the desktop that memory is vectors.
#pragma once

#include <optional>
#include <vector>

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush::desktop {

/// The core's view of a vector.
template <class T> Span<T> span_of(std::vector<T>& list) {
  return {list.data(), static_cast<Index>(list.size())};
}
template <class T> Span<const T> span_of(const std::vector<T>& list) {
  return {list.data(), static_cast<Index>(list.size())};
}

/// What a solver or a study works in.
template <class S> struct SolverMemory {
  std::vector<S> scalars;
  std::vector<int> integers;

  SolverMemory(Index scalar_count, Index integer_count)
      : scalars(static_cast<std::size_t>(scalar_count)),
        integers(static_cast<std::size_t>(integer_count)) {}
};

/// A solver with its memory.
template <class Solver, class S = double> struct Owned : SolverMemory<S>, Solver {
  Owned(Index scalar_count, Index integer_count)
      : SolverMemory<S>(scalar_count, integer_count),
        Solver(span_of(this->scalars), span_of(this->integers)) {}
  Owned(const Owned&) = delete; // the solver would look into the other's memory
  Owned& operator=(const Owned&) = delete;
};

/// `solver` in memory of at least that size.
template <class Solver>
Solver& with_room(std::optional<Owned<Solver>>& solver, Index scalars, Index integers) {
  if (!solver || span_of(solver->scalars).size < scalars ||
      span_of(solver->integers).size < integers)
    solver.emplace(scalars, integers);
  return *solver;
}

/// Lemke's pivots for up to n unknowns.
template <class S> struct OwnedLemke : Owned<Lemke<S>, S> {
  Index unknowns;

  explicit OwnedLemke(Index n)
      : Owned<Lemke<S>, S>(lemke_scalars(n), lemke_integers(n)), unknowns(n) {}
};

} // namespace lcpush::desktop
