// Watching a run. Solvers tell a watcher of every pivot and of every check of their sweeps;
// which watcher is a template argument, so that one that does nothing costs nothing.
//
// Any class with these member functions will do:
//
//     void starts(const Lemke<S>&)      a basis to pivot from, z0 not yet in it
//     Index choose_leaving_row(const Lemke<S>&, const PendingPivot&)   before a pivot
//     void stepped(const Lemke<S>&)     after a step: its status, z0 and basis
//     void checked(const Sweeps&)       after a check of sweeps: their number, z() and residual()
#pragma once

#include "lcpush/lcp/blocking.hpp"
#include "lcpush/status.hpp"

namespace lcpush {

/// A pivot about to be made. The dictionary still shows the basis before it.
template <class Int> struct PendingPivotOf {
  Index entering;       ///< variable number of dictionary.hpp
  Index column;         ///< its column: the ratios are values / -table.col(column)
  Blocking blocking;    ///< the row that the tie rule chose, and why
  Span<const Int> tied; ///< rows that block at the same point, blocking.row among them
  bool repairs = false; ///< z0 enters: the row that needs it most leaves, not the first to fall
};
using PendingPivot = PendingPivotOf<int>;

/// Looks at nothing and changes nothing.
struct Unwatched {
  template <class L> void starts(const L&) const {}
  /// A watcher may return another of pending.tied; any other row leaves a wrong basis.
  template <class L, class Int>
  Index choose_leaving_row(const L&, const PendingPivotOf<Int>& pending) const {
    return pending.blocking.row;
  }
  template <class L> void stepped(const L&) const {}
  template <class Sweeps> void checked(const Sweeps&) const {}
};
inline constexpr Unwatched unwatched{};

} // namespace lcpush
