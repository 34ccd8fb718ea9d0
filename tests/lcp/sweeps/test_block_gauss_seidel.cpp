// Block Gauss-Seidel on grasps as they are assembled: how many it solves, that nothing wrong is
// called solved, what each sweep keeps and how runs end.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>

#include "support/checked_sweeps.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/solved_push.hpp"
#include "support/sweep_runs.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr std::uint64_t first_seed = 6000, seeds = 100;

/// A grasp without pads' compliance and the sweeps for it.
template <class S> struct Grasp {
  SolvedPush<S> push;
  Problem<S> problem;
  BlockRun<S> run;
  SweepOptions<S> options;

  explicit Grasp(const OwnedScene<S>& scene)
      : push(literal(scene)), problem(push.assembly.problem()), run(problem) {}
  Grasp(Family family, std::uint64_t seed, S tolerance, bool accelerate = true)
      : Grasp(grasp_of<S>(family, seed)) {
    options.tolerance = tolerance;
    options.accelerate = accelerate;
  }
  static OwnedScene<S> literal(OwnedScene<S> scene) {
    if (scene.base.pressure == Pressure::pad) scene.base.pressure = Pressure::rigid;
    return scene;
  }

  Status solve(const S* start = nullptr) { return run.solve(problem, options, start); }
  /// The largest violation of a law by the sweeps' answer.
  S violation() {
    read_answer(push.assembly, run.sweeps.z(), push.memory.work.answer, S(1));
    return check(push.scene, push.scales(), push.answer(), S(1)).max();
  }
};

/// How many of the family's grasps are solved; each of them has to obey the laws.
template <class S> int solved_of(Family family, S tolerance, bool accelerate = true) {
  int solved = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    CAPTURE(seed);
    Grasp<S> grasp(family, seed, tolerance, accelerate);
    if (grasp.solve() != Status::solved) continue;
    ++solved;
    // Beside large forces, rounding's bound is all that a fine tolerance can ask for.
    const VectorX<S> z = grasp.run.z();
    const S size = std::max(S(1), tolerance < S(1e-8) ? z.cwiseAbs().maxCoeff() : S(1));
    CHECK(grasp.violation() <= S(20) * tolerance * size);
  }
  return solved;
}

/// A box pinched and pushed against a wall in front of it.
Scene3 jammed() {
  Scene3 scene = straight_slide();
  const double x = Slide().half_width;
  scene.add_body(Role::finger, {-1, 0, 0}, 0.3, {{x, -0.01, 0}, {x, 0.01, 0}});
  return scene;
}

} // namespace

TEST_CASE("float: plain and driven grasps are solved to 1e-3") {
  CHECK(solved_of<float>(Family::plain, 1e-3F) == seeds);
  CHECK(solved_of<float>(Family::jacobian, 1e-3F) == seeds);
}

TEST_CASE("plain sweeps refuse a sum of friction forces or with inertia; accelerated ones do not") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Grasp<double> plain(Family::jacobian, seed, 1e-6, false);
    CHECK(plain.solve() == Status::bad_input);
    Grasp<double> accelerated(Family::jacobian, seed, 1e-6);
    CHECK(accelerated.solve() == Status::solved);
  }
  Scene3 scene = straight_slide();
  scene.actuators[1].inertia = 0.1;
  Grasp<double> heavy(scene);
  CHECK(heavy.solve() == Status::solved);
  heavy.options.accelerate = false;
  CHECK(heavy.solve() == Status::bad_input);
}

TEST_CASE("a jam makes the forces run away: stagnated, under coarse tolerances too") {
  for (const double tolerance : {1e-5, 1e-6, 1e-9}) {
    CAPTURE(tolerance);
    Grasp<double> jam(jammed());
    jam.options.tolerance = tolerance;
    CHECK(jam.solve() == Status::stagnated);
    CHECK(jam.run.sweeps.runs_away());
  }
  Grasp<double> free_to_slide(straight_slide());
  CHECK(free_to_slide.solve() == Status::solved);
  CHECK_FALSE(free_to_slide.run.sweeps.runs_away());
}

// Beside forces of thousands of grips, everything else is small.
TEST_CASE("a wedge that Lemke proves to be one is not called solved because its forces are large") {
  for (const std::uint64_t seed : {80U, 218U, 363U, 720U, 2894U}) {
    CAPTURE(seed);
    Grasp<double> wedge(Family::stop, seed, 1e-6);
    REQUIRE(wedge.push.solve() == Status::ray);
    CHECK(wedge.solve() != Status::solved);
  }
}

TEST_CASE("every sweep keeps its sets: sums at their targets, friction within its cones") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Grasp<double> grasp(Family::plain, seed, 1e-9, false);
    const FactoredProblem<double>& factored = *grasp.problem.factored;
    Status status = grasp.run.sweeps.init(grasp.problem, grasp.options);
    for (int sweep = 0; sweep < 60 && status == Status::running; ++sweep) {
      status = grasp.run.sweeps.sweep();
      const VectorX<double> z = grasp.run.z();
      CHECK(z.head(grasp.problem.free_begin).minCoeff() >= 0);
      for (const SumGroup<double>& sum : factored.sums) {
        double total = 0;
        for (Index k = sum.first; k < sum.first + sum.count; ++k)
          total += factored.coupling[k] * z[factored.coupled_variable[k]];
        CHECK(absolute(total - sum.target) <= 1e-12);
      }
      for (const ConeGroup<double>& cone : factored.cones) {
        const double friction = z.segment(cone.variable + 1, cone.generators).sum();
        CHECK(friction <= cone.friction * z[cone.variable] + 1e-12);
      }
    }
  }
}

TEST_CASE("the limit of sweeps holds for Newton's passes, up to the last settling") {
  Grasp<double> grasp(Family::plain, first_seed, 0.0);
  grasp.options.max_sweeps = 100;
  CHECK(grasp.solve() == Status::sweep_limit);
  CHECK(grasp.run.sweeps.sweeps() >= 100);
  CHECK(grasp.run.sweeps.sweeps() < 200);
}

TEST_CASE("same input, same bits: what the memory held before does not matter") {
  for (const Family family : {Family::plain, Family::jacobian, Family::bilateral})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      Grasp<double> clean(family, seed, 1e-6), dirty(family, seed, 1e-6);
      for (double& x : dirty.run.scalars) x = std::numeric_limits<double>::quiet_NaN();
      for (int& x : dirty.run.integers) x = -12345;
      REQUIRE(clean.solve() == Status::solved);
      for (int again = 0; again < 2; ++again) {
        REQUIRE(dirty.solve() == Status::solved);
        CHECK(std::memcmp(clean.run.sweeps.z(), dirty.run.sweeps.z(),
                          static_cast<std::size_t>(clean.run.size) * sizeof(double)) == 0);
      }
    }
}

TEST_CASE("memory of the stated length is enough, one element less or a dense problem is bad") {
  Grasp<double> grasp(Family::parallel, 1, 1e-6);
  const Span<double> scalars{grasp.run.scalars.data(),
                             static_cast<Index>(grasp.run.scalars.size())};
  const Span<int> integers{grasp.run.integers.data(),
                           static_cast<Index>(grasp.run.integers.size())};
  const auto status_with = [&](Index missing_scalars, Index missing_integers) {
    BlockGaussSeidel<double> sweeps({scalars.data, scalars.size - missing_scalars},
                                    {integers.data, integers.size - missing_integers});
    return sweeps.init(grasp.problem, grasp.options);
  };
  CHECK(status_with(0, 0) == Status::running);
  CHECK(status_with(1, 0) == Status::bad_input);
  CHECK(status_with(0, 1) == Status::bad_input);
  const DenseLcp<double> dense{MatrixX<double>::Identity(2, 2), VectorX<double>::Ones(2)};
  CHECK(BlockGaussSeidel<double>(scalars, integers).init(dense.view()) == Status::bad_input);
}

TEST_CASE("nothing that touches the object is solved without a sweep") {
  const FactoredProblem<double> nothing{Matrix6<double>::Identity(), {}, {}, {}, {}, {}};
  Problem<double> problem;
  problem.factored = &nothing;
  BlockRun<double> run(problem);
  CHECK(run.solve(problem) == Status::solved);
  CHECK(run.sweeps.sweeps() == 0);
}
