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

#include <cstdint>

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

/// One line of a trace: a pivot, or a check of sweeps (entering and leaving are -1). The bases
/// follow from the first one by the exchanges; a watcher of one's own can keep more.
template <class S> struct TraceEntry {
  Index number = 0; ///< of pivots or sweeps so far, this one included
  Index entering = -1, leaving = -1;
  Index tied = 0;
  TieBreak decided_by = TieBreak::none;
  S ratio{0};   ///< at which the leaving variable blocks
  S measure{0}; ///< z0 after the pivot, or the residual
  Status status = Status::running;
};

/// Keeps the last entries in the caller's memory: what a controller can afford to watch.
template <class S> class TraceRing {
public:
  explicit TraceRing(Span<TraceEntry<S>> memory) : memory_(memory) {}

  /// Entries kept: all that came, or as many as the memory holds.
  Index size() const { return size_; }
  /// All that came; it counts on from zero after 2^32.
  std::uint32_t seen() const { return seen_; }
  /// Entry k of those kept, the oldest first. Precondition: 0 <= k < size().
  const TraceEntry<S>& operator[](Index k) const {
    const Index at = next_ - size_ + k;
    return memory_[at < 0 ? at + memory_.size : at];
  }

  template <class L> void starts(const L&) {}
  template <class L, class Int>
  Index choose_leaving_row(const L& lemke, const PendingPivotOf<Int>& pending) {
    entry_.entering = pending.entering;
    entry_.tied = pending.tied.size;
    entry_.decided_by = pending.blocking.decided_by;
    entry_.ratio = lemke.ratio(pending.blocking.row, pending.column);
    return pending.blocking.row;
  }
  template <class L> void stepped(const L& lemke) {
    if (entry_.entering >= 0) entry_.leaving = lemke.last_pivot().leaving;
    keep(lemke.pivots(), lemke.artificial_value(), lemke.status());
  }
  template <class Sweeps> void checked(const Sweeps& solver) {
    keep(solver.sweeps(), solver.residual().residual, solver.status());
  }

private:
  Span<TraceEntry<S>> memory_;
  TraceEntry<S> entry_; // the next one
  Index next_ = 0, size_ = 0;
  std::uint32_t seen_ = 0;

  void keep(Index number, const S& measure, Status status) {
    entry_.number = number;
    entry_.measure = measure;
    entry_.status = status;
    const TraceEntry<S> entry = entry_;
    entry_ = {};
    ++seen_;
    if (memory_.size == 0) return;
    memory_[next_] = entry;
    next_ = next_ + 1 < memory_.size ? next_ + 1 : 0;
    if (size_ < memory_.size) ++size_;
  }
};

} // namespace lcpush
