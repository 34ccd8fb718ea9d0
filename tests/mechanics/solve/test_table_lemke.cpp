// Lemke's method on the table of a factored problem: the answers of the others, in exactly its
// memory.
#include <doctest/doctest.h>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

template <class S> struct TablePush {
  AssemblySize size;
  std::vector<unsigned char> bytes;
  Workspace<S> work;
  Assembly<S> assembly;
  TableLemke<S> lemke;
  PressureRun run;
  Status status = Status::bad_input;

  explicit TablePush(const Scene<S>& scene)
      : size(size_of(scene)), bytes(static_cast<std::size_t>(table_bytes<S>(size))),
        work(make_table_workspace<S>({bytes.data(), static_cast<Index>(bytes.size())}, size)),
        assembly(work.assembly), lemke(work.lemke_scalars, work.lemke_integers) {
    REQUIRE(work.complete);
    REQUIRE(assembly.assemble(scene) == Status::running);
  }
  TablePush(const TablePush&) = delete;
  TablePush& operator=(const TablePush&) = delete;

  void solve() {
    status = solve_pressure(assembly, LemkeRounds{lemke}, work.pressure, PressureOptions<S>(), run);
    if (status == Status::solved) read_answer(assembly, work.pressure.z.data, work.answer, S(1));
  }
  Residuals<S> residuals() const {
    return check(assembly.scene(), assembly.layout().scales, work.answer, S(1));
  }
};

template <class S> OwnedScene<S> grasp_under(Pressure pressure, Family family, std::uint64_t seed) {
  OwnedScene<S> scene = grasp_of<S>(family, seed);
  scene.base.pressure = pressure;
  return scene;
}

} // namespace

TEST_CASE("the table ends as the structured basis does, with the same motion") {
  int solved = 0, same = 0, all = 0;
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid})
    for (const Family family : {Family::plain, Family::planar, Family::soft, Family::bilateral,
                                Family::parallel, Family::two_pushers, Family::jacobian})
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        CAPTURE(static_cast<int>(family));
        SolvedPush<double, StructuredLemke<double>> push(
            grasp_under<double>(pressure, family, seed));
        TablePush<double> table(push.scene);
        table.solve();
        CHECK(push.solve() == table.status);
        ++all;
        if (table.status != Status::solved) continue;
        ++solved;
        CHECK(table.residuals().max() <= 1e-9);
        const double off = (table.work.answer.acceleration - push.answer().acceleration).norm();
        same += off <= 1e-6 * (1 + push.answer().acceleration.norm()) ? 1 : 0;
      }
  CAPTURE(all);
  CHECK(solved > 150);
  CHECK(same > solved - 4); // a rigid patch may have several
}

TEST_CASE("the table refuses what it does not know") {
  OwnedScene<double> owned = grasp_under<double>(Pressure::rigid, Family::plain, 3);
  const Scene<double> scene = owned.view();
  TablePush<double> table(scene);
  TableLemke<double>& lemke = table.lemke;
  const Problem<double> given = table.assembly.problem();
  const auto refuses = [&](const Problem<double>& problem, const LemkeOptions<double>& options,
                           Reason reason) {
    return lemke.init(problem, options) == Status::bad_input && lemke.reason() == reason;
  };
  CHECK(lemke.init(given) == Status::running);
  CHECK(refuses(table.assembly.breaking_problem(), {}, Reason::unsupported_problem));
  LemkeOptions<double> lexicographic;
  lexicographic.tie_rule = TieRule::lexicographic;
  CHECK(refuses(given, lexicographic, Reason::unsupported_problem));
  Problem<double> dense = given;
  const double one = 1;
  dense.factored = nullptr;
  dense.matrix = &one;
  dense.size = dense.free_begin = 1;
  CHECK(refuses(dense, {}, Reason::unsupported_problem));
  table.assembly.cones()[0].compliance = std::numeric_limits<double>::quiet_NaN();
  CHECK(refuses(given, {}, Reason::not_finite));
  table.assembly.cones()[0].compliance = 0;
  std::vector<double> q(given.q, given.q + given.size);
  q[1] = std::numeric_limits<double>::infinity();
  Problem<double> infinite = given;
  infinite.q = q.data();
  CHECK(refuses(infinite, {}, Reason::not_finite));

  Span<double> short_scalars{table.work.lemke_scalars.data, table_lemke_scalars(given.size) - 1};
  TableLemke<double> cramped(short_scalars, table.work.lemke_integers);
  CHECK(cramped.init(given) == Status::bad_input);
  CHECK(cramped.reason() == Reason::memory_too_small);
  Span<std::int16_t> short_integers = table.work.lemke_integers;
  short_integers.size = table_lemke_integers(given.size) - 1;
  TableLemke<double> numberless(table.work.lemke_scalars, short_integers);
  CHECK(numberless.init(given) == Status::bad_input);
  CHECK(numberless.reason() == Reason::memory_too_small);
}

TEST_CASE("the table numbers as many unknowns as short integers do") {
  CHECK(DenseBasis<double, std::int16_t>::numbers(16383));
  CHECK_FALSE(DenseBasis<double, std::int16_t>::numbers(16384));
  const AssemblySize size{1638, 1638 * 8, 4, 4};
  CHECK(size.unknowns() == 16384);
  std::vector<unsigned char> bytes(4000000);
  CHECK_FALSE(make_table_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size)
                  .complete);
}

TEST_CASE("a jam that the structured basis calls a ray is one on the table") {
  OwnedScene<double> wedge = grasp_of<double>(Family::two_pushers, 80);
  const Scene<double> between = wedge.view();
  TablePush<double> wedged(between);
  wedged.solve();
  CHECK(wedged.status == Status::ray);
  int rays = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    // Against the push stands a stop.
    OwnedScene<double> scene = grasp_under<double>(Pressure::rigid, Family::plain, seed);
    const Vector3<double> at = scene.points.back();
    scene.add_body(Role::finger, {-1, 0, 0}, 0.3, {{-at[0], at[1], at[2]}});
    SolvedPush<double, StructuredLemke<double>> push(scene);
    TablePush<double> table(push.scene);
    table.solve();
    CHECK(push.solve() == table.status);
    rays += table.status == Status::ray ? 1 : 0;
  }
  CHECK(rays > 5);
}
