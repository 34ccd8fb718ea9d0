// Reliability on seeded random grasps: `random_grasps [FROM] [TO] [structured] [predicted]
// [round]` (default 0 10000, on the dense basis, cold; `predicted`: first rounds start from the
// predicted modes; `round`: friction is round). One line a pressure law and family: how many were
// solved, the worst residual of mechanics/model/check.hpp, pivots, and on how many of every tenth
// grasp four covers agree on the motion. Then the force of breaking on the first thousand.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bench/stopwatch.hpp"
#include "lcpush/lcpush.hpp"
#include "support/grasp_families.hpp"

namespace {

using namespace lcpush;

struct Solved {
  Status status;
  PressureRun run;
  double residual;
  Vector6<double> acceleration;
};

bool starts_predicted = false;
bool is_round = false;
Index turned = 0;

template <class Pivots>
Solved solve(Scene<double> scene, Workspace<double>& work, Index first_cover) {
  if (is_round) scene.round_cones = {work.round_cones.data, scene.points.size};
  const FrictionMemory<double> friction = work.friction_memory(scene);
  Assembly<double> assembly(work.assembly);
  assembly.assemble(scene);
  Pivots lemke(work.lemke_scalars, work.lemke_integers);
  LemkeRounds<double, const Unwatched, Pivots> rounds{lemke};
  rounds.options.first_cover = first_cover;
  Solved solved{};
  using Predicted = PredictedRounds<double, const Unwatched, Pivots>;
  solved.status = starts_predicted
                      ? solve_pressure(assembly, Predicted{assembly, rounds}, work.pressure, {},
                                       solved.run, friction)
                      : solve_pressure(assembly, rounds, work.pressure, {}, solved.run, friction);
  turned += solved.run.turns;
  if (solved.status != Status::solved) return solved;
  read_answer(assembly, work.pressure.z.data, work.answer, 1.0);
  solved.residual = check(scene, assembly.layout().scales, work.answer, 1.0).max();
  solved.acceleration = work.answer.acceleration / assembly.layout().scales.acceleration;
  solved.acceleration.tail<3>() *= assembly.layout().scales.length;
  return solved;
}

template <class Pivots>
void run_law(const char* name, test::Family family, Pressure pressure, unsigned from, unsigned to) {
  unsigned solved_count = 0, wrong = 0, compared = 0, agreeing = 0;
  double worst = 0;
  Index rounds = 0, cold = 0;
  std::vector<Index> pivots;
  const double begin = bench::cpu_ms();
  for (unsigned seed = from; seed < to; ++seed) {
    test::OwnedScene<double> owned = test::grasp_of<double>(family, seed);
    owned.base.pressure = pressure;
    if (is_round) owned.base.facets = 8;
    owned = owned.spread();
    const Scene<double> scene = owned.view();
    auto memory = test::workspace_for<Pivots>(scene);
    const Solved first = solve<Pivots>(scene, memory.work, 0);
    if (first.status != Status::solved) {
      std::printf("  seed %u: %s\n", seed, status_text(first.status));
      continue;
    }
    ++solved_count;
    if (!(first.residual <= 1e-9)) ++wrong;
    worst = std::max(worst, first.residual);
    rounds += first.run.rounds;
    cold += first.run.cold_restarts;
    pivots.push_back(first.run.pivots);
    if (seed % 10 != 0) continue;
    bool agree = true;
    for (Index cover = 1; cover < 4 && agree; ++cover) {
      const Solved other = solve<Pivots>(scene, memory.work, 20 * cover);
      agree = other.status == Status::solved && (other.acceleration - first.acceleration).norm() <=
                                                    1e-5 * std::max(1.0, first.acceleration.norm());
    }
    ++compared;
    if (agree) ++agreeing;
  }
  const double seconds = 1e-3 * (bench::cpu_ms() - begin);
  std::sort(pivots.begin(), pivots.end());
  const Index median = pivots.empty() ? 0 : pivots[pivots.size() / 2];
  std::printf("%-19s solved %u of %u, above 1e-9: %u, worst residual %.1e, pivots median %td max "
              "%td, rounds %.2f a grasp, cold restarts %td, covers agree %u of %u, %.1f s\n",
              name, solved_count, to - from, wrong, worst, median,
              pivots.empty() ? Index(0) : pivots.back(),
              static_cast<double>(rounds) / static_cast<double>(to - from), cold, agreeing,
              compared, seconds);
}

/// find_breaking on the same grasps: how many hold, and how straight the line to the limit is.
void run_breaking(const char* name, Pressure pressure, unsigned from, unsigned to) {
  unsigned dropped = 0, failed = 0;
  std::vector<double> line_error;
  double worst = 0;
  for (unsigned seed = from; seed < to; ++seed) {
    test::OwnedScene<double> owned = test::random_grasp<double>(seed);
    owned.base.pressure = pressure;
    const Scene<double> scene = owned.view();
    test::OwnedWorkspace<double> memory(size_of(scene));
    Assembly<double> assembly(memory.work.assembly);
    assembly.assemble(scene);
    Lemke<double> lemke(memory.work.lemke_scalars, memory.work.lemke_integers);
    Breaking<double> breaking;
    PressureRun run;
    const Index pusher = scene.bodies.size - 1;
    const Status status = find_breaking(assembly, LemkeRounds{lemke}, memory.work,
                                        scene.bodies[pusher], {}, breaking, run);
    if (status == Status::does_not_hold) {
      ++dropped;
    } else if (status != Status::solved) {
      ++failed;
      std::printf("  seed %u: %s\n", seed, status_text(status));
    } else {
      line_error.push_back(breaking.line_error);
      worst = std::max(worst, breaking.residuals.max());
    }
  }
  std::sort(line_error.begin(), line_error.end());
  const std::size_t held = line_error.size();
  std::printf("%-6s breaking: %zu held, %u did not hold, %u failed; worst residual %.1e; off the "
              "line median %.1e, max %.1e\n",
              name, held, dropped, failed, worst, held > 0 ? line_error[held / 2] : 0.0,
              held > 0 ? line_error.back() : 0.0);
}

/// All of it on one of the two bases.
template <class Pivots> void run_laws(unsigned from, unsigned to) {
  using lcpush::test::Family;
  const auto law = [](const char* name, Family family, Pressure pressure, unsigned first,
                      unsigned last) { run_law<Pivots>(name, family, pressure, first, last); };
  law("rigid", Family::plain, Pressure::rigid, from, to);
  law("pad", Family::plain, Pressure::pad, from, to);
  law("even, planar", Family::even, Pressure::even, from, to);
  const unsigned fewer = from + (to - from) / 10;
  law("soft points, pad", Family::soft, Pressure::pad, from, fewer);
  law("parallel jaw, pad", Family::parallel, Pressure::pad, from, fewer);
  law("crooked drives, pad", Family::jacobian, Pressure::pad, from, fewer);
  law("bilateral, pad", Family::bilateral, Pressure::pad, from, fewer);
  law("two pushers, pad", Family::two_pushers, Pressure::pad, from, fewer);
  law("with a stop, pad", Family::stop, Pressure::pad, from, fewer);
  law("weighted, pad", Family::weighted, Pressure::pad, from, to);
  law("weighted, rigid", Family::weighted, Pressure::rigid, from, to);
  law("locked jaws, pad", Family::locked, Pressure::pad, from, fewer);
}

} // namespace

int main(int count, char** words) {
  const auto argument = [&](int i, unsigned fallback) {
    return count > i ? static_cast<unsigned>(std::atoi(words[i])) : fallback;
  };
  const unsigned from = argument(1, 0), to = argument(2, 10000);
  using lcpush::Pressure;
  bool structured = false;
  for (int i = 3; i < count; ++i) {
    structured = structured || std::strcmp(words[i], "structured") == 0;
    is_round = is_round || std::strcmp(words[i], "round") == 0;
    starts_predicted = starts_predicted || std::strcmp(words[i], "predicted") == 0;
  }
  if (structured)
    run_laws<lcpush::StructuredLemke<double>>(from, to);
  else
    run_laws<lcpush::Lemke<double>>(from, to);
  if (structured || starts_predicted) return 0;
  const unsigned to_break = std::min(to, from + 1000);
  run_breaking("rigid", Pressure::rigid, from, to_break);
  run_breaking("pad", Pressure::pad, from, to_break);
}
