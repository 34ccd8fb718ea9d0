// The desktop's watcher of runs (lcp/trace.hpp): chosen at run time, doing nothing by default.
#pragma once

#include "lcpush/lcp/pivots/structured_lemke.hpp"

namespace lcpush::desktop {

class Watcher {
public:
  virtual ~Watcher() = default;

  virtual void starts(const Lemke<double>&) {}
  virtual Index choose_leaving_row(const Lemke<double>&, const PendingPivot& pending) {
    return pending.blocking.row;
  }
  virtual void stepped(const Lemke<double>&) {}
  /// After a step of StructuredLemke: it has no dictionary to show, and nothing to choose from.
  virtual void progressed(Index /*unknowns*/, Index /*covers*/) {}
  void starts(const StructuredLemke<double>&) {}
  Index choose_leaving_row(const StructuredLemke<double>&, const PendingPivot& pending) {
    return pending.blocking.row;
  }
  void stepped(const StructuredLemke<double>& lemke) {
    progressed(lemke.dictionary().size(), lemke.covers_tried());
  }

  virtual void swept(Index /*sweep*/, const double* /*z*/, double /*residual*/) {}

  template <class Sweeps> void checked(const Sweeps& solver) {
    swept(solver.sweeps(), solver.z(), solver.residual().residual);
  }
};

} // namespace lcpush::desktop
