// Lemke on the structured basis against Lemke on the whole dictionary.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A grasp's problem, with springs under its fingers if its pressure is pad.
struct Grasp {
  OwnedScene<double> owned;
  Scene<double> scene;
  OwnedWorkspace<double> memory;
  Assembly<double> assembly;

  Grasp(const OwnedScene<double>& given, double compliance)
      : owned(given.spread()), scene(owned.view()), memory(size_of(scene)),
        assembly(memory.work.assembly) {
    assembly.assemble(scene);
    for (Index i = 0; scene.pressure == Pressure::pad && i < scene.points.size; ++i)
      if (scene.bodies[assembly.layout().body[i]].role == Role::finger)
        assembly.cones()[i].compliance = compliance;
  }
  Problem<double> problem() const { return assembly.problem(); }
};

template <class Pivots> struct Run {
  std::vector<double> scalars;
  std::vector<int> integers;
  Pivots lemke;

  explicit Run(const Grasp& grasp)
      : scalars(static_cast<std::size_t>(scalars_for(grasp))),
        integers(static_cast<std::size_t>(integers_for(grasp))),
        lemke({scalars.data(), scalars_for(grasp)}, {integers.data(), integers_for(grasp)}) {}

  static constexpr bool is_structured = std::is_same_v<Pivots, StructuredLemke<double>>;
  static Index scalars_for(const Grasp& grasp) {
    const Index n = grasp.problem().size;
    const Index shared = lcpush::shared_actuators(grasp.assembly.factored());
    return is_structured ? structured_lemke_scalars(n, grasp.scene.points.size, shared)
                         : lemke_scalars(n);
  }
  static Index integers_for(const Grasp& grasp) {
    const Index n = grasp.problem().size;
    return is_structured ? structured_lemke_integers(n, grasp.scene.points.size)
                         : lemke_integers(n);
  }
};
using DenseRun = Run<Lemke<double>>;
using StructuredRun = Run<StructuredLemke<double>>;

OwnedScene<double> grasp_under(Pressure pressure, std::uint64_t seed) {
  const bool even = pressure == Pressure::even;
  OwnedScene<double> scene = grasp_of<double>(even ? Family::even : Family::plain, seed);
  scene.base.pressure = pressure;
  return scene;
}

/// Two fingers of many points.
OwnedScene<double> wide_grasp(Pressure pressure, Index points) {
  OwnedScene<double> scene = random_grasp<double>(7);
  scene.base.pressure = pressure;
  scene.bodies.clear();
  scene.points.clear();
  scene.actuators.clear();
  scene.drives.clear();
  for (const double side : {1.0, -1.0}) {
    std::vector<Vector3<double>> patch;
    for (Index i = 0; i < points; ++i) {
      const double r = 0.006 * std::sqrt((static_cast<double>(i) + 0.5) / double(points));
      patch.push_back(
          {0.01 + r * std::cos(2.4 * double(i)), r * std::sin(2.4 * double(i)), side * 0.005});
    }
    scene.add_body(Role::finger, {0, 0, -side}, 0.5, patch);
    scene.drive_last_body(20);
  }
  scene.add_body(Role::pusher, {1, 0, 0}, 0.3, {{-0.05, -0.015, 0}, {-0.05, 0.012, 0}});
  scene.bodies.back().acceleration << 1, 0.3, 0, 0, 0, 2;
  return scene;
}

/// The column of each nonbasic variable and the values, by the names of the basic variables.
template <class B>
std::map<Index, double> by_name(const B& basis, const Eigen::Ref<const Eigen::VectorXd>& column) {
  std::map<Index, double> named;
  for (Index i = 0; i < basis.dictionary.basic.size; ++i)
    named[basis.dictionary.basic[i]] = column[i];
  return named;
}

double distance(const std::map<Index, double>& a, const std::map<Index, double>& b) {
  double largest = 1, worst = 0;
  for (const auto& [name, x] : a) {
    if (b.count(name) == 0) return 1e300;
    largest = std::max(largest, std::abs(x));
    worst = std::max(worst, std::abs(x - b.at(name)));
  }
  return worst / largest;
}

template <class B> struct Bare {
  std::vector<double> scalars;
  std::vector<int> integers;
  B basis;
  Eigen::VectorXd row_scale, column_scale, rowsum, scratch;
  std::vector<int> target, candidates;

  Bare(const Grasp& grasp, const Run<Lemke<double>>& solved, double tie)
      : scalars(static_cast<std::size_t>(DenseRun::scalars_for(grasp) +
                                         StructuredRun::scalars_for(grasp))),
        integers(static_cast<std::size_t>(DenseRun::integers_for(grasp) +
                                          StructuredRun::integers_for(grasp))) {
    const Problem<double> problem = grasp.problem();
    const Index n = problem.size;
    Block<double> numbers({scalars.data(), static_cast<Index>(scalars.size())});
    Block<int> ints({integers.data(), static_cast<Index>(integers.size())});
    basis.carve(problem, 2, 0, numbers, ints);
    for (Eigen::VectorXd* v : {&row_scale, &column_scale, &rowsum, &scratch})
      *v = Eigen::VectorXd::Ones(n);
    CHECK(basis.scale(false, map(row_scale), map(column_scale), map(rowsum), map(scratch)) == 0);
    Eigen::VectorXd cover(n);
    for (Index i = 0; i < n; ++i) {
      cover[i] = generic_number<double>(3, i);
      basis.dictionary.values(i, 0) = problem.q[i];
      basis.dictionary.values(i, 1) = generic_number<double>(4, i);
    }
    basis.load(map(row_scale), map(column_scale), map(cover));
    for (Index i = 0; i < n; ++i)
      target.push_back(static_cast<int>(solved.lemke.is_basic(i) ? unknown(i, n) : slack(i)));
    candidates.resize(target.size());
    CHECK(basis.factor({target.data(), n}, {candidates.data(), n}, tie, map(scratch), {0, 2, 2}) ==
          0);
  }
  static VectorMap<double> map(Eigen::VectorXd& v) { return {v.data(), v.size()}; }
};

/// The worst difference of the two bases, over all columns and the values.
double difference(const OwnedScene<double>& scene) {
  const Grasp grasp(scene, 0.3);
  DenseRun run(grasp);
  REQUIRE(run.lemke.init(grasp.problem()) == Status::running);
  REQUIRE(run.lemke.solve() == Status::solved);
  const Bare<DenseBasis<double>> whole(grasp, run, 1e-20);
  Bare<StructuredBasis<double>> structured(grasp, run, 1e-20);
  double worst = 0;
  for (Index k = 0; k < 2; ++k)
    worst = std::max(
        worst, distance(by_name(whole.basis, whole.basis.dictionary.values.col(k)),
                        by_name(structured.basis, structured.basis.dictionary.values.col(k))));
  for (const int variable : whole.basis.dictionary.nonbasic) {
    const Index c = whole.basis.enter(variable), s = structured.basis.enter(variable);
    worst = std::max(worst,
                     distance(by_name(whole.basis, whole.basis.dictionary.table.col(c)),
                              by_name(structured.basis, structured.basis.dictionary.table.col(s))));
  }
  return worst;
}

} // namespace

TEST_CASE("factored from the problem, every column of the basis is the dictionary's") {
  for (const Pressure pressure : {Pressure::rigid, Pressure::even, Pressure::pad})
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      CAPTURE(static_cast<int>(pressure));
      CAPTURE(seed);
      CHECK(difference(grasp_under(pressure, seed)) < 1e-8);
    }
  for (const Family family : {Family::soft, Family::bilateral, Family::parallel, Family::jacobian})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(static_cast<int>(family));
      CAPTURE(seed);
      CHECK(difference(grasp_of<double>(family, seed)) < 1e-8);
    }
}

TEST_CASE("with springs at many loaded points, every column of the basis is the dictionary's") {
  CHECK(difference(wide_grasp(Pressure::pad, 20)) < 1e-8);
  CHECK(difference(wide_grasp(Pressure::rigid, 20)) < 1e-8);
}

TEST_CASE("without equilibration both bases take the same pivots") {
  constexpr std::uint64_t grasps = 40;
  for (const Pressure pressure : {Pressure::rigid, Pressure::even, Pressure::pad}) {
    CAPTURE(static_cast<int>(pressure));
    int same_paths = 0;
    Index pivots = 0;
    for (std::uint64_t seed = 100; seed < 100 + grasps; ++seed) {
      CAPTURE(seed);
      const Grasp grasp(grasp_under(pressure, seed), 0.05);
      DenseRun whole(grasp);
      StructuredRun structured(grasp);
      LemkeOptions<double> options;
      options.equilibrate = false;
      REQUIRE(whole.lemke.init(grasp.problem(), options) == Status::running);
      REQUIRE(structured.lemke.init(grasp.problem(), options) == Status::running);
      bool same = true;
      while (same && whole.lemke.status() == Status::running) {
        const Status status = whole.lemke.step();
        same = structured.lemke.step() == status &&
               whole.lemke.last_pivot().entering == structured.lemke.last_pivot().entering &&
               whole.lemke.last_pivot().leaving == structured.lemke.last_pivot().leaving;
      }
      pivots += whole.lemke.pivots();
      same_paths += same ? 1 : 0;
      CHECK((whole.lemke.status() == Status::running ? whole.lemke.solve()
                                                     : whole.lemke.status()) == Status::solved);
      CHECK((structured.lemke.status() == Status::running
                 ? structured.lemke.solve()
                 : structured.lemke.status()) == Status::solved);
    }
    CHECK(pivots > 30 * static_cast<Index>(grasps));
    CHECK(same_paths >= 38);
  }
}

TEST_CASE("wide pads: both bases find the same motion, and the laws hold") {
  for (const Index points : {30, 60}) {
    CAPTURE(points);
    SolvedPush<double> whole(wide_grasp(Pressure::pad, points));
    SolvedPush<double, StructuredLemke<double>> structured(wide_grasp(Pressure::pad, points));
    REQUIRE(whole.solve() == Status::solved);
    REQUIRE(structured.solve() == Status::solved);
    CHECK(structured.residuals.max() <= 1e-9);
    const Vector6<double> difference =
        whole.answer().acceleration - structured.answer().acceleration;
    CHECK(difference.norm() <= 1e-5 * whole.answer().acceleration.norm());
  }
}

TEST_CASE("a wedge ends in a ray on both bases") {
  OwnedScene<double> scene = grasp_of<double>(Family::two_pushers, 80);
  SolvedPush<double> whole(scene);
  SolvedPush<double, StructuredLemke<double>> structured(scene);
  CHECK(whole.solve() == Status::ray);
  CHECK(structured.solve() == Status::ray);
}

TEST_CASE("what the structured basis cannot do is refused") {
  const Grasp grasp(grasp_under(Pressure::rigid, 5), 0);
  StructuredRun run(grasp);
  LemkeOptions<double> options;
  options.tie_rule = TieRule::lexicographic;
  CHECK(run.lemke.init(grasp.problem(), options) == Status::bad_input);
  CHECK(run.lemke.reason() == Reason::unsupported_problem);
  const double one = 1;
  Problem<double> dense;
  dense.size = dense.free_begin = 1;
  dense.matrix = dense.q = &one;
  CHECK(run.lemke.init(dense) == Status::bad_input);
  CHECK(run.lemke.reason() == Reason::unsupported_problem);
}

TEST_CASE("too little memory is bad input, and the memory is proportional to the unknowns") {
  const Grasp grasp(grasp_under(Pressure::rigid, 5), 0);
  StructuredRun run(grasp);
  for (const bool scalars : {true, false}) {
    StructuredLemke<double> small(
        {run.scalars.data(), StructuredRun::scalars_for(grasp) / (scalars ? 2 : 1)},
        {run.integers.data(), StructuredRun::integers_for(grasp) - (scalars ? 0 : 1)});
    CHECK(small.init(grasp.problem()) == Status::bad_input);
    CHECK(small.reason() == Reason::memory_too_small);
  }
  CHECK(structured_lemke_scalars(100000, 10000, 2) < 60 * 100000);
  CHECK(structured_lemke_integers(100000, 10000) < 10 * 100000);
}

TEST_CASE("numbers that are not finite are bad input") {
  Grasp grasp(grasp_under(Pressure::rigid, 5), 0);
  StructuredRun run(grasp);
  grasp.assembly.cones()[0].friction = std::numeric_limits<double>::infinity();
  CHECK(run.lemke.init(grasp.problem()) == Status::bad_input);
  CHECK(run.lemke.reason() == Reason::not_finite);
}
