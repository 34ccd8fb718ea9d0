// Memory: the caller brings one block of Scalars and one of ints; a solver cuts what it needs off
// their front. Nothing is ever given back, nothing is ever allocated.
#pragma once

#include "lcpush/types.hpp"

namespace lcpush {

/// A member that is seated before it is used: a union, so that its owner's constructor leaves it
/// alone (two dozen empty ones take 200 bytes of a device's code).
#define LCPUSH_SEATED(Map, name)                                                                   \
  union {                                                                                          \
    Map name;                                                                                      \
  }

template <class T> class Block {
public:
  Block() = default;
  explicit Block(Span<T> memory) : rest_(memory) {}

  /// The next `count` elements, or an empty span if fewer are left (see `exhausted`).
  Span<T> take(Index count) {
    if (count > rest_.size) {
      exhausted_ = true;
      return {};
    }
    const Span<T> taken{rest_.data, count};
    rest_ = {rest_.data + count, rest_.size - count};
    return taken;
  }

  /// The next rows x columns elements become what `map` views. A Map cannot be assigned to:
  /// Eigen's documented way to re-seat one is placement new.
  template <class Map> void seat(Map& map, Index rows, Index columns = 1) {
    new (&map) Map(take(rows * columns).data, rows, columns);
  }

  bool exhausted() const { return exhausted_; }

private:
  Span<T> rest_;
  bool exhausted_ = false;
};

/// Column k, as the same type that a vector of its own has: one instance of what takes either.
template <class S> VectorMap<S> column(MatrixMap<S>& matrix, Index k) {
  return VectorMap<S>(matrix.data() + k * matrix.rows(), matrix.rows());
}

} // namespace lcpush
