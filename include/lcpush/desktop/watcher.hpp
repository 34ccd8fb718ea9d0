// The desktop's observer of runs (lcp/trace.hpp): chosen at run time, doing nothing by default.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush::desktop {

class Watcher {
public:
  virtual ~Watcher() = default;

  virtual void starts(const Lemke<double>&) {}
  virtual Index leaves(const Lemke<double>&, const Turn& turn) { return turn.blocking.row; }
  virtual void stepped(const Lemke<double>&) {}
  /// After a step of StructuredLemke, which has no dictionary to show.
  virtual void progressed(Index /*unknowns*/, Index /*covers*/) {}
  virtual void swept(Index /*sweep*/, const double* /*z*/, double /*residual*/) {}

  template <class Sweeps> void checked(const Sweeps& solver) {
    swept(solver.sweeps(), solver.z(), solver.residual().residual);
  }
};

} // namespace lcpush::desktop
