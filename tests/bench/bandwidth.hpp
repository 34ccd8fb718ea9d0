// How near a pivot of the dense dictionary is to the memory's speed: it reads and writes n (n + 1)
// numbers once, and so does a plain pass over them.
#pragma once

#include <cstdio>

#include "bench/stopwatch.hpp"
#include "lcpush/lcp/pivots/dictionary.hpp"
#include "support/random_grasp.hpp"

namespace lcpush::bench {

struct PivotSpeed {
  double pivot_us, plain_us; ///< medians
};

/// On a dictionary without zeros.
inline PivotSpeed pivot_speed(Index n) {
  std::vector<double> numbers(static_cast<std::size_t>(n * (n + 3)));
  std::vector<int> names(static_cast<std::size_t>(2 * n + 1));
  Dictionary<double> d;
  new (&d.table) MatrixMap<double>(numbers.data(), n, n + 1);
  new (&d.values) MatrixMap<double>(numbers.data() + n * (n + 1), n, 1);
  VectorMap<double> scratch(numbers.data() + n * (n + 2), n);
  d.basic = {names.data(), n};
  d.nonbasic = {names.data() + n, n + 1};
  d.reset_basis();
  test::Random random(1);
  for (double& x : numbers) x = random.uniform(0.5, 1);
  for (Index i = 0; i < n; ++i) d.table(i, i) += static_cast<double>(n);
  Index at = 0;
  std::vector<double> pivots, plain;
  const double budget = 20; // ms
  sample(
      [&] {
        d.exchange(at, at, scratch);
        at = at + 1 < n ? at + 1 : 0;
      },
      budget, pivots);
  double factor = 0.999999;
  sample(
      [&] {
        VectorMap<double>(numbers.data(), n * (n + 1)) *= factor;
        factor = 1 / factor;
      },
      budget, plain);
  return {1e3 * median(pivots), 1e3 * median(plain)};
}

inline void print_pivot_speed(Index n) {
  const PivotSpeed speed = pivot_speed(n);
  const double bytes = 16.0 * static_cast<double>(n * (n + 1)); // read and written
  std::printf("  n %5td: a pivot %9.2f us (%5.1f GB/s), a plain pass %9.2f us (%5.1f GB/s): %3.0f "
              "%% of its speed\n",
              n, speed.pivot_us, 1e-3 * bytes / speed.pivot_us, speed.plain_us,
              1e-3 * bytes / speed.plain_us, 100 * speed.plain_us / speed.pivot_us);
}

} // namespace lcpush::bench
