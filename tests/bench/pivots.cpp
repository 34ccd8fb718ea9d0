// The cost of a pivot: `pivots [POINTS]` (default 1000 points a finger at most). Two disc
// fingers and a line pusher, 8 facets, solved cold on the structured basis, and on the dense one
// where its memory is small. One line a size and law: pivots, exchanges of the answer's basis, the
// processor's time and memory; under `pad` the first round of the pressure law.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "bench/stopwatch.hpp"
#include "bench/wide_grasp.hpp"
#include "lcpush/lcpush.hpp"

namespace {

using namespace lcpush;

template <class Pivots> void run(const char* basis, Index points, Pressure pressure) {
  const test::OwnedScene<double> owned = bench::disc_grasp(points, 8, pressure);
  const Scene<double> scene = owned.view();
  auto memory = test::workspace_for<Pivots>(scene);
  Assembly<double> assembly(memory.work.assembly);
  assembly.assemble(scene);
  for (Index i = 0; pressure == Pressure::pad && i < 2 * points; ++i)
    assembly.cones()[i].compliance = 0.01 * static_cast<double>(points);
  const Problem<double> problem = assembly.problem();
  Pivots lemke(memory.work.lemke_scalars, memory.work.lemke_integers);
  double best = 0;
  Status status = Status::running;
  for (int repeat = 0; repeat < (problem.size < 2000 ? 20 : 3); ++repeat) {
    const double begin = bench::cpu_ms();
    (void)lemke.init(problem);
    status = lemke.solve();
    const double spent = bench::cpu_ms() - begin;
    if (repeat == 0 || spent < best) best = spent;
  }
  Index basic = 0;
  for (Index i = 0; i < problem.size; ++i) basic += lemke.is_basic(i) ? 1 : 0;
  std::printf("%-6s %-10s n %6td: %s, pivots %5td, basic unknowns %5td, %10.3f ms, %8.2f us a "
              "pivot, %7.2f MB\n",
              pressure == Pressure::pad ? "pad" : "rigid", basis, problem.size, status_text(status),
              lemke.pivots(), basic, best, 1000 * best / static_cast<double>(lemke.pivots()),
              static_cast<double>(memory.bytes.size()) / 1e6);
}

} // namespace

int main(int count, char** words) {
  const Index most = count > 1 ? std::atoi(words[1]) : 1000;
  for (const Pressure pressure : {Pressure::rigid, Pressure::pad})
    for (const Index points : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000}) {
      if (points > most) break;
      if (points <= 50) run<Lemke<double>>("dense", points, pressure);
      run<StructuredLemke<double>>("structured", points, pressure);
    }
}
