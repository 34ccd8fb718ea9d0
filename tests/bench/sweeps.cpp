// Block Gauss-Seidel measured: `sweeps [GRASPS]` (default 1000).
// First plain and accelerated sweeps on seeded random grasps under `rigid`: how many reach a scaled
// residual of 1e-6 within 5,000 of them. Then the cost of a sweep a point, from 10 points to
// 10,000.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/stopwatch.hpp"
#include "bench/wide_grasp.hpp"
#include "lcpush/lcpush.hpp"
#include "support/grasp_families.hpp"
#include "support/owned_sweeps.hpp"

namespace {

using namespace lcpush;
constexpr Index most_sweeps = 5000;
constexpr double wanted = 1e-6;

/// The sweeps used, most_sweeps if they did not suffice.
Index sweeps_of(const Assembly<double>& assembly, const AssemblySize& size, bool accelerate) {
  test::OwnedSweeps<double> owned(size);
  SweepOptions<double> options;
  options.accelerate = accelerate;
  options.check_every = 1;
  options.tolerance = wanted;
  options.max_sweeps = most_sweeps;
  if (owned.sweeps.init(assembly.problem(), options) == Status::running) (void)owned.sweeps.solve();
  return owned.sweeps.status() == Status::solved ? owned.sweeps.sweeps() : most_sweeps;
}

void compare(const char* name, bool accelerate, unsigned grasps) {
  std::vector<Index> sweeps;
  const double begin = bench::cpu_ms();
  for (unsigned seed = 0; seed < grasps; ++seed) {
    test::OwnedScene<double> owned = test::random_grasp<double>(seed);
    owned.base.pressure = Pressure::rigid;
    const Scene<double> scene = owned.view();
    test::OwnedWorkspace<double> memory(size_of(scene));
    Assembly<double> assembly(memory.work.assembly);
    assembly.assemble(scene);
    sweeps.push_back(sweeps_of(assembly, size_of(scene), accelerate));
  }
  const double seconds = 1e-3 * (bench::cpu_ms() - begin);
  const auto solved =
      std::count_if(sweeps.begin(), sweeps.end(), [](Index k) { return k < most_sweeps; });
  std::sort(sweeps.begin(), sweeps.end());
  std::printf("%-24s %4td of %4u   median %4td sweeps, 90 %% within %4td   %.1f s\n", name,
              static_cast<Index>(solved), grasps, sweeps[grasps / 2], sweeps[grasps * 9 / 10],
              seconds);
}

/// Two discs of many points and an edge: what a sweep and what a pass of Newton cost.
void cost_of_a_sweep(Index points) {
  const test::OwnedScene<double> owned = bench::disc_grasp(points / 2 - 1, 8, Pressure::rigid);
  const Scene<double> scene = owned.view();
  const AssemblySize size = size_of(scene);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(sweep_bytes<double>(size)));
  const Workspace<double> work =
      make_sweep_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size);
  Assembly<double> assembly(work.assembly);
  assembly.assemble(scene);
  BlockGaussSeidel<double> sweeps(work.sweep_scalars, work.sweep_integers);
  SweepOptions<double> options;
  options.check_every = 1 << 20;
  options.tolerance = 0;
  for (const bool accelerate : {false, true}) {
    options.accelerate = accelerate;
    options.max_sweeps = 60;
    const Index repeats = std::max<Index>(1, 20000 / points);
    Index passes = 0;
    const double begin = bench::cpu_ms();
    for (Index k = 0; k < repeats; ++k) {
      (void)sweeps.init(assembly.problem(), options);
      (void)sweeps.solve();
      passes += sweeps.sweeps();
    }
    const double ns = 1e6 * (bench::cpu_ms() - begin);
    std::printf("%s%6.0f ns a point and %s", accelerate ? "   " : "",
                ns / static_cast<double>(points * passes),
                accelerate ? "pass with Newton\n" : "sweep");
  }
}

} // namespace

int main(int count, char** words) {
  const auto grasps = static_cast<unsigned>(count > 1 ? std::atoi(words[1]) : 1000);
  std::printf("Scaled residual 1e-6 within 5,000 sweeps, rigid, random grasps 0 to %u:\n", grasps);
  compare("plain blocks", false, grasps);
  compare("Newton on what is shared", true, grasps);
  std::printf("\nCost of a sweep, 8 facets:\n");
  for (const Index points : {10, 100, 1000, 10000}) {
    std::printf("%6td points ", points);
    cost_of_a_sweep(points);
  }
}
