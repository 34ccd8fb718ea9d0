// What both Gauss-Seidel solvers take and how they report.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/types.hpp"

namespace lcpush {

template <class S> struct SweepOptions {
  S tolerance = Tolerances<S>().residual; ///< scaled natural residual to stop at
  Index max_sweeps = 5000;
  Index check_every = 10; ///< sweeps between two residual checks
  S relaxation{1};        ///< omega of SOR, 0 < omega < 2; component-wise sweeps only
  bool accelerate = true; ///< block sweeps: go on with Newton's method on what the groups share
};

} // namespace lcpush
