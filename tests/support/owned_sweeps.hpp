// Block Gauss-Seidel with its memory.
#pragma once

#include <vector>

#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush::test {

/// The sweeps' memory.
template <class S> struct OwnedSweeps {
  std::vector<S> scalars;
  std::vector<int> integers;
  BlockGaussSeidel<S> sweeps;

  explicit OwnedSweeps(const AssemblySize& size)
      : scalars(static_cast<std::size_t>(
            block_gauss_seidel_scalars(size.unknowns(), size.couplings(), size.actuators))),
        integers(static_cast<std::size_t>(
            block_gauss_seidel_integers(size.unknowns(), size.couplings(), size.actuators))),
        sweeps({scalars.data(), static_cast<Index>(scalars.size())},
               {integers.data(), static_cast<Index>(integers.size())}) {}
  OwnedSweeps(const OwnedSweeps&) = delete;
  OwnedSweeps& operator=(const OwnedSweeps&) = delete;
};

} // namespace lcpush::test
