// Gauss-Seidel runs that own their memory.
#pragma once

#include <vector>

#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"
#include "lcpush/lcp/sweeps/gauss_seidel.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

/// Component by component.
template <class S> struct SweepRun {
  std::vector<S> scalars;
  GaussSeidel<S> sweeps;
  Index size;

  explicit SweepRun(Index n)
      : scalars(static_cast<std::size_t>(gauss_seidel_scalars(n))),
        sweeps({scalars.data(), gauss_seidel_scalars(n)}), size(n) {}

  Status solve(const DenseLcp<S>& lcp, const SweepOptions<S>& options = {}) {
    const Status status = sweeps.init(lcp.view(), options);
    return status == Status::running ? sweeps.solve() : status;
  }
  VectorX<S> z() const { return Eigen::Map<const VectorX<S>>(sweeps.z(), size); }
};

/// Entries of all sum groups together.
template <class S> Index coupling_count(const Problem<S>& problem) {
  Index count = 0;
  for (const SumGroup<S>& sum : problem.factored->sums) count += sum.count;
  return count;
}

/// Group by group.
template <class S> struct BlockRun {
  std::vector<S> scalars;
  std::vector<int> integers;
  BlockGaussSeidel<S> sweeps;
  Index size;

  explicit BlockRun(const Problem<S>& problem)
      : scalars(static_cast<std::size_t>(block_gauss_seidel_scalars(
            problem.size, coupling_count(problem), problem.factored->sums.size))),
        integers(static_cast<std::size_t>(block_gauss_seidel_integers(
            problem.size, coupling_count(problem), problem.factored->sums.size))),
        sweeps({scalars.data(), static_cast<Index>(scalars.size())},
               {integers.data(), static_cast<Index>(integers.size())}),
        size(problem.size) {}

  Status solve(const Problem<S>& problem, const SweepOptions<S>& options = {},
               const S* start = nullptr) {
    const Status status = sweeps.init(problem, options, start);
    return status == Status::running ? sweeps.solve() : status;
  }
  VectorX<S> z() const { return Eigen::Map<const VectorX<S>>(sweeps.z(), size); }
};

} // namespace lcpush::test
