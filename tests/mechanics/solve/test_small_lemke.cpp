// What a device's Lemke saves in memory changes no answer.
#include <doctest/doctest.h>

#include <algorithm>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A push by SmallLemke, with room for every exchange that another one has. `shares`: the
/// pressure's z and the answer's friction stand in Lemke's memory, as make_small_workspace has
/// them.
struct SmallPush {
  AssemblySize size;
  Index exchanges;
  std::vector<unsigned char> bytes;
  Workspace<double> work;
  std::vector<double> z, friction;
  PressureRun run;
  Status status = Status::bad_input;

  SmallPush(const Scene<double>& scene, bool shares)
      : size(size_of(scene)), exchanges(size.unknowns() + 1),
        bytes(static_cast<std::size_t>(small_bytes<double>(size, size.actuators, exchanges))),
        work(make_small_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size,
                                          size.actuators, exchanges)),
        z(static_cast<std::size_t>(size.unknowns())),
        friction(static_cast<std::size_t>(size.generators)) {
    REQUIRE(work.complete);
    if (!shares) {
      work.pressure.z = {z.data(), size.unknowns()};
      work.answer.friction = {friction.data(), size.generators};
    }
    Assembly<double> assembly(work.assembly);
    REQUIRE(assembly.assemble(scene) == Status::running);
    SmallLemke<double> lemke(work.lemke_scalars, work.lemke_integers);
    LemkeOptions<double> options;
    options.exchanges = exchanges;
    status = solve_pressure(assembly, LemkeRounds{lemke, options}, work.pressure,
                            PressureOptions<double>(), run);
    if (status == Status::solved) read_answer(assembly, work.pressure.z.data, work.answer, 1.0);
  }
  SmallPush(const SmallPush&) = delete;
  SmallPush& operator=(const SmallPush&) = delete;
};

/// Bit by bit.
bool is_same(const Span<double>& one, const Span<double>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end());
}

/// Both answers to a push. Rounding differs, as directions are put together in another order, and
/// may decide a tie otherwise: then forces that the laws leave open differ. Returns whether none
/// do.
bool takes_the_same_path(SolvedPush<double, StructuredLemke<double>>& wide) {
  SmallPush small(wide.scene, true), separate(wide.scene, false);
  CHECK(small.status == separate.status);
  CHECK(small.run.pivots == separate.run.pivots);
  CHECK(wide.solve() == small.status);
  if (small.status != Status::solved) return wide.run.pivots == small.run.pivots;
  Workspace<double>& work = small.work;
  CHECK(is_same(work.pressure.z, separate.work.pressure.z)); // still there: a break reads it twice
  CHECK(is_same(work.answer.friction, separate.work.answer.friction));
  double off = 0;
  for (Index i = 0; i < work.pressure.z.size; ++i)
    off = std::max(off, std::abs(wide.memory.work.pressure.z[i] - work.pressure.z[i]));
  for (Index i = 0; i < work.answer.friction.size; ++i)
    off = std::max(off, std::abs(wide.answer().friction[i] - work.answer.friction[i]) /
                            wide.scales().force);
  CHECK(check(wide.scene, wide.scales(), work.answer, 1.0).max() <= 1e-9);
  CHECK((wide.answer().acceleration - work.answer.acceleration).norm() <=
        1e-6 * (1 + wide.answer().acceleration.norm()));
  return wide.run.pivots == small.run.pivots && off <= 1e-8;
}

} // namespace

TEST_CASE("shared arrays change no bit of an answer, directions that are not kept no answer") {
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
