// From a mixed problem to one for Lemke: free unknowns pivoted out, redundancy named.
#include <doctest/doctest.h>

#include "lcpush/lcp/pivots/reduce.hpp"
#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A mixed problem whose free unknowns may stand anywhere.
struct Mixed {
  MatrixX<double> M;
  VectorX<double> q;
  std::vector<unsigned char> is_free;

  Index size() const { return q.size(); }
  double error(const VectorX<double>& z) const {
    // Ordered so that the free ones come last, as solution_error wants them.
    DenseLcp<double> ordered{M, q};
    std::vector<Index> order;
    for (const bool wanted : {false, true})
      for (Index i = 0; i < size(); ++i)
        if ((is_free[static_cast<std::size_t>(i)] != 0) == wanted) order.push_back(i);
    VectorX<double> x(size());
    for (Index i = 0; i < size(); ++i) {
      const Index from = order[static_cast<std::size_t>(i)];
      ordered.q[i] = q[from];
      x[i] = z[from];
      for (Index j = 0; j < size(); ++j)
        ordered.M(i, j) = M(from, order[static_cast<std::size_t>(j)]);
      if (is_free[static_cast<std::size_t>(from)] != 0) ++ordered.free_count;
    }
    return solution_error(ordered, x);
  }
};

struct ReducedRun {
  std::vector<double> scalars;
  std::vector<int> integers;
  Reduction<double> reduction;

  explicit ReducedRun(Index n)
      : scalars(static_cast<std::size_t>(reduction_scalars(n))),
        integers(static_cast<std::size_t>(reduction_integers(n))),
        reduction({scalars.data(), reduction_scalars(n)},
                  {integers.data(), reduction_integers(n)}) {}
  Status reduce(const Mixed& mixed, SingularBlock singular) {
    return reduction.init(mixed.size(), mixed.M.data(), mixed.q.data(), mixed.is_free.data(),
                          singular);
  }
  VectorX<double> solve(Index n) {
    const Problem<double>& reduced = reduction.problem();
    LemkeRun<double> run(reduced.size);
    REQUIRE(run.solve(reduced) == Status::solved);
    VectorX<double> z(n);
    reduction.recover(run.lemke.z(), z.data());
    return z;
  }
};

/// A positive definite matrix with free unknowns at odd places: a regular free block.
Mixed regular(std::uint64_t seed, Index n) {
  Random random(seed);
  const MatrixX<double> A = random_matrix(random, n, n);
  Mixed mixed{
      A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n), random_vector(random, n), {}};
  for (Index i = 0; i < n; ++i) mixed.is_free.push_back(i % 2 == 1 ? 1 : 0);
  return mixed;
}

/// A quadratic program with equalities B x = b: the block of the free multipliers is all zero.
Mixed saddle(std::uint64_t seed, Index n, Index equalities) {
  Random random(seed);
  const Index size = n + equalities;
  const MatrixX<double> A = random_matrix(random, n, n);
  const MatrixX<double> B = random_matrix(random, equalities, n);
  Mixed mixed{MatrixX<double>::Zero(size, size), random_vector(random, size), {}};
  mixed.M.topLeftCorner(n, n) = A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n);
  mixed.M.topRightCorner(n, equalities) = -B.transpose();
  mixed.M.bottomLeftCorner(equalities, n) = B;
  mixed.q.tail(equalities) = -(B * random_vector(random, n).cwiseAbs());
  for (Index i = 0; i < size; ++i) mixed.is_free.push_back(i >= n ? 1 : 0);
  return mixed;
}

} // namespace

TEST_CASE("a regular free block disappears and the recovered answer solves the mixed problem") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Index n = static_cast<Index>(2 + seed % 12);
    const Mixed mixed = regular(seed, n);
    for (const SingularBlock mode : {SingularBlock::bound, SingularBlock::exchange}) {
      ReducedRun run(n);
      REQUIRE(run.reduce(mixed, mode) == Status::solved);
      CHECK(run.reduction.problem().size == n - n / 2);
      CHECK(run.reduction.problem().free_begin == run.reduction.problem().size);
      CHECK(run.reduction.redundant_rows().size == 0);
      CHECK(mixed.error(run.solve(n)) <= 1e-9);
    }
  }
}

TEST_CASE("a singular free block stays free under `bound` and disappears under `exchange`") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Index n = static_cast<Index>(4 + seed % 8), equalities = 2;
    const Mixed mixed = saddle(seed, n, equalities);
    ReducedRun bound(n + equalities), exchange(n + equalities);
    REQUIRE(bound.reduce(mixed, SingularBlock::bound) == Status::solved);
    CHECK(bound.reduction.problem().size - bound.reduction.problem().free_begin == equalities);
    const VectorX<double> z = bound.solve(n + equalities);
    CHECK(mixed.error(z) <= 1e-9);

    REQUIRE(exchange.reduce(mixed, SingularBlock::exchange) == Status::solved);
    const Problem<double>& reduced = exchange.reduction.problem();
    CHECK(reduced.size == n); // every pair stays, some swapped
    CHECK(reduced.free_begin == n);
    Index swapped = 0;
    for (Index k = 0; k < n; ++k) {
      const ReducedUnknown unknown = exchange.reduction.unknown_of(k);
      CHECK(unknown.index < n);
      if (unknown.swapped) ++swapped;
    }
    CHECK(swapped == equalities);
  }
}

TEST_CASE("an answer of the exchanged problem is an answer of the mixed one") {
  Index solved = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Mixed mixed = saddle(seed, 6, 2);
    ReducedRun run(8);
    REQUIRE(run.reduce(mixed, SingularBlock::exchange) == Status::solved);
    LemkeRun<double> lemke(6);
    if (lemke.solve(run.reduction.problem()) != Status::solved) continue;
    ++solved; // exchanges leave the class in which Lemke must succeed
    VectorX<double> z(8);
    run.reduction.recover(lemke.lemke.z(), z.data());
    CHECK(mixed.error(z) <= 1e-9);
  }
  CHECK(solved >= 35);
}

TEST_CASE("a redundant equality is named, and as many free unknowns are fixed at zero") {
  for (const SingularBlock mode : {SingularBlock::bound, SingularBlock::exchange}) {
    Mixed mixed = saddle(3, 5, 2);
    mixed.M.row(6) = 2 * mixed.M.row(5); // the second equality is twice the first
    mixed.M.col(6) = 2 * mixed.M.col(5);
    mixed.q[6] = 2 * mixed.q[5];
    ReducedRun run(7);
    REQUIRE(run.reduce(mixed, mode) == Status::solved);
    if (mode == SingularBlock::exchange) {
      REQUIRE(run.reduction.redundant_rows().size == 1);
      const int row = run.reduction.redundant_rows()[0];
      CHECK((row == 5 || row == 6));
      const int fixed = run.reduction.fixed_unknowns()[0];
      CHECK((fixed == 5 || fixed == 6));
    }
  }
}

TEST_CASE("a redundant equality among free unknowns is named in both modes and the rest solved") {
  for (const SingularBlock mode : {SingularBlock::bound, SingularBlock::exchange}) {
    // x_0 >= 0; rows 1 and 2 say the same about the free x_1, x_2.
    Mixed mixed{MatrixX<double>(3, 3), VectorX<double>(3), {0, 1, 1}};
    mixed.M << 2, 0, 0, 0, 1, 1, 0, 3, 3;
    mixed.q << -4, -5, -15;
    ReducedRun run(3);
    REQUIRE(run.reduce(mixed, mode) == Status::solved);
    CHECK(run.reduction.redundant_rows().size == 1);
    const VectorX<double> z = run.solve(3);
    CHECK(mixed.error(z) <= 1e-12);
    CHECK(z[run.reduction.fixed_unknowns()[0]] == 0);
  }
}

TEST_CASE("contradicting equalities are refused and one of them is named") {
  for (const SingularBlock mode : {SingularBlock::bound, SingularBlock::exchange}) {
    Mixed mixed{MatrixX<double>(3, 3), VectorX<double>(3), {0, 1, 1}};
    mixed.M << 2, 0, 0, 0, 1, 1, 0, 3, 3;
    mixed.q << -4, -5, -14;
    ReducedRun run(3);
    CHECK(run.reduce(mixed, mode) == Status::bad_input);
    const Index row = run.reduction.inconsistent_row();
    CHECK((row == 1 || row == 2));
  }
}

TEST_CASE("memory of the stated length is enough, one element less is bad input") {
  const Mixed mixed = regular(2, 5);
  for (const Index missing : {0, 1}) {
    ReducedRun run(5);
    Reduction<double> scarce({run.scalars.data(), reduction_scalars(5) - missing},
                             {run.integers.data(), reduction_integers(5)});
    const Status status =
        scarce.init(5, mixed.M.data(), mixed.q.data(), mixed.is_free.data(), SingularBlock::bound);
    CHECK(status == (missing == 0 ? Status::solved : Status::bad_input));
  }
}
