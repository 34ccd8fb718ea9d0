// Reliability of steps in time: `random_motions [FROM] [TO]` (default 0 1000). Each seed is a
// random grasp pushed for 200 steps of 1 ms. One line: how runs ended, pivots a step, the worst
// residual of mechanics/model/check.hpp and the deepest penetration.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/stopwatch.hpp"
#include "support/owned_motion.hpp"

namespace {

using namespace lcpush;

/// As `lcpush move --step` does: a step without an answer is tried as two of half its length.
Status advance(test::OwnedMotion<double>::Stepper& stepper, double h, int halvings, Index& split) {
  const Status status = stepper.advance(h);
  if (status == Status::solved || stepper.run().lost || halvings == 0) return status;
  ++split;
  const Status half = advance(stepper, h / 2, halvings - 1, split);
  return half == Status::solved ? advance(stepper, h / 2, halvings - 1, split) : half;
}

void run_all(unsigned from, unsigned to) {
  Index ends[16] = {}, lost = 0, cold = 0, corrections = 0, steps = 0, split = 0;
  std::vector<Index> pivots;
  double residual = 0, penetration = 0;
  const double begin = bench::cpu_ms();
  for (unsigned seed = from; seed < to; ++seed) {
    test::OwnedMotion<double> run(test::random_grasp<double>(seed));
    test::begin_random(run, seed);
    Status status = Status::solved;
    for (Index k = 0; k < 200 && status == Status::solved; ++k) {
      status = advance(*run, 1e-3, 4, split);
      const StepRun<double>& step = run->run();
      ++steps;
      if (k > 0) pivots.push_back(step.pivots);
      cold += k > 0 ? step.cold_restarts : 0;
      corrections += step.corrections;
      lost += step.lost ? 1 : 0;
      if (status != Status::solved && !step.lost)
        std::printf("seed %u step %ld: %s (%s)\n", seed, static_cast<long>(k), status_text(status),
                    reason_text(step.reason));
      if (status != Status::solved) break;
      residual = std::max(residual, step.residual);
      if (step.penetration > 1e-9)
        std::printf("seed %u step %ld: %g m deep\n", seed, static_cast<long>(k), step.penetration);
      penetration = std::max(penetration, step.penetration);
    }
    ++ends[static_cast<int>(status)];
  }
  const double ms = bench::cpu_ms() - begin;
  std::sort(pivots.begin(), pivots.end());
  std::printf("%u runs: %ld solved to the end, %ld lost, %ld ray, %ld other\n", to - from,
              static_cast<long>(ends[static_cast<int>(Status::solved)]), static_cast<long>(lost),
              static_cast<long>(ends[static_cast<int>(Status::ray)]),
              static_cast<long>(to - from) -
                  static_cast<long>(ends[static_cast<int>(Status::solved)] +
                                    ends[static_cast<int>(Status::ray)]) -
                  static_cast<long>(lost));
  std::printf("warm pivots a step: median %ld, 99 %% %ld, most %ld; cold restarts %ld, corrections "
              "%ld in %ld steps\n",
              static_cast<long>(pivots[pivots.size() / 2]),
              static_cast<long>(pivots[pivots.size() * 99 / 100]), static_cast<long>(pivots.back()),
              static_cast<long>(cold), static_cast<long>(corrections), static_cast<long>(steps));
  std::printf("residual %.1e, penetration %.1e m, %.3f ms a step; %ld steps halved\n", residual,
              penetration, ms / static_cast<double>(steps), static_cast<long>(split));
}

} // namespace

int main(int argc, char** argv) {
  const unsigned from = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 0;
  const unsigned to = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1000;
  run_all(from, to);
}
