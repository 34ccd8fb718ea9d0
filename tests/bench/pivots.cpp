// The cost of a pivot: `pivots [POINTS]` (default 1000 points a finger at most). Two disc
// fingers and a line pusher, 8 facets, solved cold on the structured basis, and on the dense one
// where its memory is small. One line a size and law: pivots, exchanges of the answer's basis, time
// and memory; under `pad` the first round of the pressure law.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "lcpush/lcpush.hpp"
#include "support/random_grasp.hpp"

namespace {

using namespace lcpush;

test::OwnedScene<double> disc_grasp(Index points, Pressure pressure) {
  test::OwnedScene<double> scene;
  scene.base.object.mass = 0.2;
  scene.base.object.inertia = Vector3<double>(2e-5, 1.7e-4, 1.8e-4).asDiagonal();
  scene.base.object.center_of_mass.setZero();
  scene.base.gravity = {0, -9.81, 0};
  scene.base.facets = 8;
  scene.base.pressure = pressure;
  for (const double side : {1.0, -1.0}) {
    std::vector<Vector3<double>> disc;
    for (Index i = 0; i < points; ++i) {
      constexpr double golden_angle = 2.399963229728653, radius = 0.006;
      const double r =
          radius * std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(points));
      const double angle = golden_angle * static_cast<double>(i);
      disc.push_back({0.01 + r * std::cos(angle), 0.002 + r * std::sin(angle), side * 0.005});
    }
    scene.add_body(Role::finger, {0, 0, -side}, 0.5, disc);
    scene.drive_last_body(20);
  }
  scene.add_body(Role::pusher, {1, 0, 0}, 0.3, {{-0.05, -0.015, 0}, {-0.05, 0.015, 0}});
  scene.bodies.back().acceleration << 1, 0.3, 0, 0, 0, 2;
  return scene;
}

template <class Pivots> void run(const char* basis, Index points, Pressure pressure) {
  const test::OwnedScene<double> owned = disc_grasp(points, pressure);
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
  for (int repeat = 0; repeat < (problem.size < 2000 ? 20 : 1); ++repeat) {
    const auto begin = std::chrono::steady_clock::now();
    (void)lemke.init(problem);
    status = lemke.solve();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - begin;
    if (repeat == 0 || spent.count() < best) best = spent.count();
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
