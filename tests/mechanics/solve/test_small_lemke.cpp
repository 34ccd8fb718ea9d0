// What a device's Lemke saves in memory changes no answer.
#include <doctest/doctest.h>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A workspace of make_small_workspace, with room for every exchange that another one has.
struct SmallWorkspace {
  AssemblySize size;
  Index exchanges;
  std::vector<unsigned char> bytes;
  Workspace<double> work;

  explicit SmallWorkspace(const Scene<double>& scene)
      : size(size_of(scene)), exchanges(size.unknowns() + 1),
        bytes(static_cast<std::size_t>(small_bytes<double>(size, size.actuators, exchanges))),
        work(make_small_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size,
                                          size.actuators, exchanges)) {}
};

/// Both answers to a push. Rounding differs, as directions are put together in another order, and
/// may decide a tie otherwise: then forces that the laws leave open differ. Returns whether none
/// do.
bool takes_the_same_path(SolvedPush<double, StructuredLemke<double>>& wide) {
  SmallWorkspace memory(wide.scene);
  Workspace<double>& work = memory.work;
  REQUIRE(work.complete);
  Assembly<double> assembly(work.assembly);
  REQUIRE(assembly.assemble(wide.scene) == Status::running);
  SmallLemke<double> lemke(work.lemke_scalars, work.lemke_integers);
  LemkeOptions<double> options;
  options.exchanges = memory.exchanges;
  PressureRun run;
  const Status status = solve_pressure(assembly, LemkeRounds{lemke, options}, work.pressure,
                                       PressureOptions<double>(), run);
  CHECK(wide.solve() == status);
  if (status != Status::solved) return wide.run.pivots == run.pivots;
  read_answer(assembly, work.pressure.z.data, work.answer, 1.0);
  double off = 0; // z is still there: a break reads it twice
  for (Index i = 0; i < work.pressure.z.size; ++i)
    off = std::max(off, std::abs(wide.memory.work.pressure.z[i] - work.pressure.z[i]));
  for (Index i = 0; i < work.answer.friction.size; ++i)
    off = std::max(off, std::abs(wide.answer().friction[i] - work.answer.friction[i]) /
                            wide.scales().force);
  CHECK(check(wide.scene, wide.scales(), work.answer, 1.0).max() <= 1e-9);
  CHECK((wide.answer().acceleration - work.answer.acceleration).norm() <=
        1e-6 * (1 + wide.answer().acceleration.norm()));
  return wide.run.pivots == run.pivots && off <= 1e-8;
}

} // namespace

TEST_CASE("short integers, shared arrays and directions that are not kept change no answer") {
  int solved = 0, same = 0;
  for (const Pressure pressure : pressures)
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      CAPTURE(seed);
      OwnedScene<double> scene =
          grasp_of<double>(pressure == Pressure::even ? Family::even : Family::plain, seed);
      scene.base.pressure = pressure;
      SolvedPush<double, StructuredLemke<double>> push(scene);
      same += takes_the_same_path(push) ? 1 : 0;
      solved += push.status == Status::solved ? 1 : 0;
    }
  CHECK(solved > 100);
  CHECK(same > 115); // of 120
}

TEST_CASE("more unknowns than short integers number are refused") {
  FactoredProblem<double> factored{};
  Problem<double> problem;
  problem.factored = &factored;
  for (const Index n : {16383, 16384}) {
    problem.size = problem.free_begin = n;
    CHECK(StructuredBasis<double>::supports(problem, TieRule::generic));
    CHECK(StructuredBasis<double, std::int16_t>::supports(problem, TieRule::generic) ==
          (n == 16383));
  }
  const AssemblySize size{1638, 1638 * 8, 4, 4};
  std::vector<unsigned char> bytes(static_cast<std::size_t>(small_bytes<double>(size, 4, 1)));
  CHECK(size.unknowns() == 16384);
  CHECK_FALSE(
      make_small_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size, 4, 1)
          .complete);
}
