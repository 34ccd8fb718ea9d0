// What Lemke on the structured basis is for, and what it refuses; its answers: test_engines.cpp.
#include <doctest/doctest.h>

#include <limits>

#include "bench/wide_grasp.hpp"
#include "support/engines.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A grasp's problem, and the structured basis for it.
struct Structured {
  OwnedScene<double> owned;
  Scene<double> scene;
  OwnedWorkspace<double> memory;
  Assembly<double> assembly;
  StructuredLemke<double> lemke;

  explicit Structured(const OwnedScene<double>& given)
      : owned(given), scene(owned.view()), memory(workspace_for<StructuredLemke<double>>(scene)),
        assembly(memory.work.assembly),
        lemke(memory.work.lemke_scalars, memory.work.lemke_integers) {
    assembly.assemble(scene);
  }
  Problem<double> problem() const { return assembly.problem(); }
};

} // namespace

TEST_CASE("wide pads: both bases find the same motion, and the laws hold") {
  for (const Index points : {20, 30}) {
    CAPTURE(points);
    const OwnedScene<double> scene = bench::disc_grasp(points, 8, Pressure::pad);
    const EnginePush<double, Engine::dense> whole(scene);
    const EnginePush<double, Engine::structured> structured(scene);
    REQUIRE(whole.status == Status::solved);
    REQUIRE(structured.status == Status::solved);
    CHECK(structured.residuals.max() <= 1e-9);
    CHECK((whole.motion() - structured.motion()).norm() <= 1e-5 * whole.motion().norm());
  }
}

TEST_CASE("what the structured basis cannot do is refused") {
  Structured grasp(random_grasp<double>(5));
  LemkeOptions<double> options;
  options.tie_rule = TieRule::lexicographic;
  CHECK(grasp.lemke.init(grasp.problem(), options) == Status::bad_input);
  CHECK(grasp.lemke.reason() == Reason::unsupported_problem);
  const double one = 1;
  Problem<double> dense;
  dense.size = dense.free_begin = 1;
  dense.matrix = dense.q = &one;
  CHECK(grasp.lemke.init(dense) == Status::bad_input);
  CHECK(grasp.lemke.reason() == Reason::unsupported_problem);
}

TEST_CASE("too little memory is bad input, and the memory is proportional to the unknowns") {
  const Structured grasp(random_grasp<double>(5));
  const Span<double> scalars = grasp.memory.work.lemke_scalars;
  const Span<int> integers = grasp.memory.work.lemke_integers;
  for (const bool few_scalars : {true, false}) {
    StructuredLemke<double> small({scalars.data, scalars.size / (few_scalars ? 2 : 1)},
                                  {integers.data, integers.size - (few_scalars ? 0 : 1)});
    CHECK(small.init(grasp.problem()) == Status::bad_input);
    CHECK(small.reason() == Reason::memory_too_small);
  }
  CHECK(structured_lemke_scalars(100000, 10000, 2) < 60 * 100000);
  CHECK(structured_lemke_integers(100000, 10000) < 10 * 100000);
}

TEST_CASE("numbers that are not finite are bad input") {
  Structured grasp(random_grasp<double>(5));
  grasp.assembly.cones()[0].friction = std::numeric_limits<double>::infinity();
  CHECK(grasp.lemke.init(grasp.problem()) == Status::bad_input);
  CHECK(grasp.lemke.reason() == Reason::not_finite);
}

TEST_CASE("more unknowns than short integers number are refused") {
  FactoredProblem<double> factored{};
  Problem<double> problem;
  problem.factored = &factored;
  for (const Index n : {16383, 16384}) {
    problem.size = problem.free_begin = n;
    CHECK(StructuredBasis<double>::supports(problem, TieRule::generic));
    CHECK(SmallBasis<double>::supports(problem, TieRule::generic) == (n == 16383));
  }
  const AssemblySize size{1638, 1638 * 8, 4, 4};
  std::vector<unsigned char> bytes(static_cast<std::size_t>(small_bytes<double>(size, 4, 1)));
  CHECK(size.unknowns() == 16384);
  CHECK_FALSE(
      make_small_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size, 4, 1)
          .complete);
}
