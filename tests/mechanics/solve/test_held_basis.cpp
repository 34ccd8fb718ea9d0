// A basis looked at without a pivot: what holds is an answer, and where pivots end, it holds.
#include <doctest/doctest.h>

#include <optional>

#include "lcpush/lcp/pivots/held_basis.hpp"
#include "support/grasp_families.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A solved push, the basis of its last round, and memory to look at it.
template <class S> struct Looked : SolvedPush<S> {
  std::vector<unsigned char> basis;
  Problem<S> problem;
  std::vector<S> scalars;
  std::vector<int> integers;
  std::optional<HeldBasis<S>> held;

  explicit Looked(const OwnedScene<S>& given) : SolvedPush<S>(given) {
    if (this->solve() != Status::solved) return;
    problem = this->assembly.problem();
    const Span<unsigned char>& active = this->memory.work.pressure.active;
    basis.assign(active.begin(), active.begin() + problem.size);
    const Index n = problem.size, cones = problem.factored->cones.size;
    scalars.resize(static_cast<std::size_t>(
        held_basis_scalars(n, cones, shared_actuators(*problem.factored))));
    integers.resize(static_cast<std::size_t>(held_basis_integers(n, cones)));
    held.emplace(Span<S>{scalars.data(), static_cast<Index>(scalars.size())},
                 Span<int>{integers.data(), static_cast<Index>(integers.size())});
  }
  Status look() { return held->look(problem, basis.data()); }
  bool passes_referee() const {
    const std::vector<S> unit(basis.size(), S(1));
    std::vector<S> w(basis.size()), scratch(2 * basis.size());
    const WorstRow<S> worst = natural_residual(
        problem, problem.q, held->z(), unit.data(),
        [&](Index i) { return i >= problem.free_begin; }, w.data(), scratch.data());
    return worst.residual <= Tolerances<S>().residual;
  }
};

OwnedScene<double> under(Pressure pressure, OwnedScene<double> scene) {
  scene.base.pressure = pressure;
  return scene;
}

} // namespace

TEST_CASE("the basis in which pivots end holds; whatever holds passes the referee") {
  int solved = 0, held = 0, exchanged = 0, held_too = 0;
  for (const Family family : {Family::plain, Family::bilateral, Family::parallel, Family::stop,
                              Family::two_pushers, Family::jacobian})
    for (const Pressure pressure : {Pressure::rigid, Pressure::pad})
      for (std::uint64_t seed = 1; seed <= seeds(20); ++seed) {
        CAPTURE(static_cast<int>(family));
        CAPTURE(seed);
        Looked<double> push(under(pressure, grasp_of<double>(family, seed)));
        if (push.status != Status::solved) continue;
        ++solved;
        if (push.look() == Status::solved) {
          ++held;
          CHECK(push.passes_referee());
          for (Index i = 0; i < push.problem.size; ++i)
            CHECK(push.held->z()[i] ==
                  doctest::Approx(push.memory.work.pressure.z[i]).epsilon(1e-6)); // pads leave 1e-7
        }
        for (unsigned char& is_basic : push.basis) {
          is_basic ^= 1;
          ++exchanged;
          if (push.look() == Status::solved) {
            ++held_too; // where a value is zero, its pair may stand either way
            CHECK(push.passes_referee());
          }
          is_basic ^= 1;
        }
      }
  CHECK(held >= solved * 99 / 100);
  CHECK(held_too <= exchanged / 1000);
}

TEST_CASE("a basis that leaves a free unknown at its bound does not hold") {
  Looked<double> push(random_grasp<double>(1));
  REQUIRE(push.look() == Status::solved);
  REQUIRE(push.problem.free_begin < push.problem.size);
  push.basis.back() = 0;
  CHECK(push.look() == Status::numerical_breakdown);
}

TEST_CASE("the limit of a vanishing push in its basis is the one that pivots end with") {
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Looked<double> push(under(Pressure::rigid, random_grasp<double>(seed)));
    const Problem<double> problem = push.assembly.breaking_problem();
    if (push.lemke.init(problem) != Status::running || push.lemke.solve() != Status::solved)
      continue;
    for (Index i = 0; i < problem.size; ++i)
      push.basis[static_cast<std::size_t>(i)] = push.lemke.is_basic(i) ? 1 : 0;
    if (push.held->look(problem, push.basis.data()) != Status::solved) continue;
    ++held;
    CHECK(push.held->valid_to() == doctest::Approx(push.lemke.valid_to()).epsilon(1e-6));
    for (Index i = 0; i < problem.size; ++i) {
      CHECK(push.held->z()[i] == doctest::Approx(push.lemke.z()[i]).epsilon(1e-8));
      CHECK(push.held->z_push()[i] == doctest::Approx(push.lemke.z_push()[i]).epsilon(1e-8));
    }
  }
  CHECK(held >= 15);
}

TEST_CASE("only a factored problem is looked at, in enough memory") {
  Looked<double> push(under(Pressure::rigid, random_grasp<double>(1)));
  REQUIRE(push.look() == Status::solved);
  Problem<double> other = push.problem;
  other.factored = nullptr;
  CHECK(push.held->look(other, push.basis.data()) == Status::bad_input);
  HeldBasis<double> narrow({push.scalars.data(), static_cast<Index>(push.scalars.size()) - 1},
                           {push.integers.data(), static_cast<Index>(push.integers.size())});
  CHECK(narrow.look(push.problem, push.basis.data()) == Status::bad_input);
}

TEST_CASE(
    "in single precision a few of a hundred bases are not solved to rounding, and none is wrong") {
  int solved = 0, held = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    CAPTURE(seed);
    Looked<float> push(random_grasp<float>(seed));
    if (push.status != Status::solved) continue;
    ++solved;
    if (push.look() != Status::solved) continue;
    ++held;
    CHECK(push.passes_referee());
  }
  CHECK(held >= solved * 95 / 100);
}
