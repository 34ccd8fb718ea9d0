// A watcher that remembers when sweeps were checked.
#pragma once

#include <vector>

#include "lcpush/types.hpp"

namespace lcpush::test {

template <class S> struct CheckedSweeps {
  std::vector<Index> sweeps;
  S last{-1};

  template <class Sweeps> void checked(const Sweeps& solver) {
    sweeps.push_back(solver.sweeps());
    last = solver.residual().residual;
  }
};

} // namespace lcpush::test
