// Linear programs by Lemke: optimum, infeasibility and their proofs.
#include <cmath>

#include <doctest/doctest.h>

#include "lcpush/desktop/rational.hpp"
#include "lcpush/lcp/pivots/linear_program.hpp"
#include "support/dense_lcp.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Rational;

namespace {

template <class S> struct DenseProgram {
  MatrixX<S> A, H;
  VectorX<S> b, c;

  LinearProgram<S> view() const {
    return {c.size(), b.size(), H.rows(), A.data(), b.data(), H.data(), c.data()};
  }
};

template <class S> struct ProgramRun {
  std::vector<S> scalars;
  std::vector<int> integers;
  LinearProgramSolver<S> solver;
  Status status;

  explicit ProgramRun(const DenseProgram<S>& p, const LemkeOptions<S>& options = {})
      : scalars(
            static_cast<std::size_t>(linear_program_scalars(p.c.size(), p.b.size(), p.H.rows()))),
        integers(
            static_cast<std::size_t>(linear_program_integers(p.c.size(), p.b.size(), p.H.rows()))),
        solver({scalars.data(), static_cast<Index>(scalars.size())},
               {integers.data(), static_cast<Index>(integers.size())}),
        status(solver.solve(p.view(), options)) {}
  ProgramRun(const ProgramRun&) = delete;
  ProgramRun& operator=(const ProgramRun&) = delete;
};

template <class S> DenseProgram<S> empty_program(Index columns, Index m, Index k) {
  return {MatrixX<S>::Zero(m, columns), MatrixX<S>::Zero(k, columns), VectorX<S>::Zero(m),
          VectorX<S>::Zero(columns)};
}

} // namespace

TEST_CASE("a small program has its optimum at the vertex, exactly in fractions") {
  // minimise -3 x - 5 y with x <= 4, 2 y <= 12, 3 x + 2 y <= 18: x = 2, y = 6, cost -36.
  DenseProgram<Rational> p = empty_program<Rational>(5, 3, 0);
  p.A.row(0) << 1, 0, 1, 0, 0;
  p.A.row(1) << 0, 2, 0, 1, 0;
  p.A.row(2) << 3, 2, 0, 0, 1;
  p.b << 4, 12, 18;
  p.c << -3, -5, 0, 0, 0;
  LemkeOptions<Rational> options;
  options.equilibrate = false;
  const ProgramRun<Rational> run(p, options);
  REQUIRE(run.status == Status::solved);
  CHECK(run.solver.cost() == Rational(-36));
  CHECK(run.solver.x()[0] == Rational(2));
  CHECK(run.solver.x()[1] == Rational(6));
}

TEST_CASE("inequalities H x >= 0 hold, and bind where they must") {
  // minimise x with x - y >= 0 and y = 3.
  DenseProgram<double> p = empty_program<double>(2, 1, 1);
  p.A << 0, 1;
  p.b << 3;
  p.H << 1, -1;
  p.c << 1, 0;
  const ProgramRun<double> run(p);
  REQUIRE(run.status == Status::solved);
  CHECK(run.solver.cost() == doctest::Approx(3));
  CHECK(run.solver.equality_multipliers()[0] == doctest::Approx(1));
  CHECK(run.solver.inequality_multipliers()[0] == doctest::Approx(1));
}

TEST_CASE("equalities that follow from others, or say 0 = 0, do no harm") {
  DenseProgram<double> p = empty_program<double>(3, 4, 0);
  p.A.row(0) << 1, 1, 0;
  p.A.row(2) << 0, 1, 1;
  p.A.row(3) << 1, 2, 1;
  p.b << 1, 0, 1, 2;
  p.c << 1, 3, 1;
  const ProgramRun<double> run(p);
  REQUIRE(run.status == Status::solved);
  CHECK(run.solver.cost() == doctest::Approx(2));
}

TEST_CASE("what is infeasible is proved so: by a contradiction, by signs, by inequalities") {
  DenseProgram<double> contradiction = empty_program<double>(2, 2, 0);
  contradiction.A << 1, 1, 2, 2;
  contradiction.b << 1, 3;
  DenseProgram<double> signs = empty_program<double>(2, 1, 0);
  signs.A << 1, 1;
  signs.b << -1;
  DenseProgram<double> inequalities = empty_program<double>(2, 2, 2); // x = y / 2 > y
  inequalities.A << 1, 0, 0, 1;
  inequalities.b << 1, 2;
  inequalities.H << 1, -1, 0, 0;
  for (const DenseProgram<double>& p : {contradiction, signs, inequalities}) {
    const ProgramRun<double> run(p);
    REQUIRE(run.status == Status::ray);
    const Eigen::Map<const VectorX<double>> nu(run.solver.equality_multipliers(), p.b.size());
    const Eigen::Map<const VectorX<double>> y(run.solver.inequality_multipliers(), p.H.rows());
    CHECK(p.b.dot(nu) == doctest::Approx(1));
    CHECK((p.A.transpose() * nu + p.H.transpose() * y).maxCoeff() <= 1e-12);
    CHECK((y.size() == 0 || y.minCoeff() >= 0));
  }
}

TEST_CASE("where every feasible point is optimal, rounding does not get in between") {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) { // c = A' nu: reduced costs are noise
    CAPTURE(seed);
    Random random(seed);
    DenseProgram<double> p = empty_program<double>(6, 1, 0);
    p.A = random_matrix(random, 1, 6);
    p.b = p.A * random_vector(random, 6).cwiseAbs();
    const VectorX<double> nu = random_vector(random, 1);
    p.c = p.A.transpose() * nu;
    const ProgramRun<double> run(p);
    REQUIRE(run.status == Status::solved);
    CHECK(std::abs(run.solver.cost() - p.b.dot(nu)) <= 1e-13);
  }
}

TEST_CASE("a cost without a lower bound is not called solved, nor infeasible") {
  DenseProgram<double> p = empty_program<double>(2, 1, 0);
  p.A << 1, -1;
  p.b << 1;
  p.c << -1, 0;
  const ProgramRun<double> run(p);
  CHECK(run.status == Status::numerical_breakdown);
}

TEST_CASE("too little memory is bad input") {
  DenseProgram<double> p = empty_program<double>(2, 1, 0);
  std::vector<double> scalars(static_cast<std::size_t>(linear_program_scalars(2, 1, 0) - 1));
  std::vector<int> integers(static_cast<std::size_t>(linear_program_integers(2, 1, 0)));
  LinearProgramSolver<double> solver({scalars.data(), static_cast<Index>(scalars.size())},
                                     {integers.data(), static_cast<Index>(integers.size())});
  CHECK(solver.solve(p.view(), {}) == Status::bad_input);
  CHECK(solver.reason() == Reason::memory_too_small);
}

TEST_CASE("random programs with an optimum that is known from its multipliers") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index columns = random.integer(2, 25), m = random.integer(1, (columns + 1) / 2);
    const Index k = random.integer(0, 8);
    DenseProgram<double> p = empty_program<double>(columns, m, k);
    p.A = random_matrix(random, m, columns);
    p.H = random_matrix(random, k, columns);
    const VectorX<double> nu = random_vector(random, m);
    VectorX<double> x = random_vector(random, columns).cwiseMax(0), y = VectorX<double>::Zero(k);
    VectorX<double> spare(columns); // reduced costs, 0 where x > 0
    for (Index j = 0; j < columns; ++j) spare[j] = x[j] > 0 ? 0 : random.uniform(0, 1);
    // Rows of H: binding ones have a price, the others slack. A multiple of x makes them so.
    for (Index i = 0; i < k && x.norm() > 0; ++i) {
      const double slack = random.integer(0, 1) == 0 ? 0.0 : random.uniform(0, 1);
      p.H.row(i) += (slack - p.H.row(i).dot(x)) / x.squaredNorm() * x.transpose();
      if (slack == 0) y[i] = random.uniform(0, 1);
    }
    p.b = p.A * x;
    p.c = p.A.transpose() * nu + p.H.transpose() * y + spare;
    const ProgramRun<double> run(p);
    REQUIRE(run.status == Status::solved);
    CHECK(run.solver.cost() == doctest::Approx(p.c.dot(x)).epsilon(1e-9));
  }
}
