// Directions that are read say what kept ones say, whatever a cone has pivoted.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lcpush/lcp/pivots/structured/directions.hpp"
#include "support/random_grasp.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// A cone that slides or not, one that pulls as well, and one without friction; two shared
/// actuators, and one that the last cone has for itself.
struct Cones {
  static constexpr Index n = 6 + 7 + 1 + 3, shared = 2, own = n - 1;
  std::vector<Vector6<double>> wrenches;
  std::vector<ConeGroup<double>> cones;
  std::vector<SumGroup<double>> sums;
  std::vector<int> coupled;
  std::vector<double> couplings;
  FactoredProblem<double> factored;
  Problem<double> problem;
  std::vector<double> scales;
  VectorMap<double> scale;
  std::vector<double> numbers_kept, numbers_read;
  std::vector<std::int16_t> integers;
  detail::KeptDirections<double> kept;
  detail::ReadDirections<double, std::int16_t> read;
  std::vector<detail::TurnedCone<double>> turned;

  template <class T> static std::vector<T> zeros(Index size) {
    return std::vector<T>(static_cast<std::size_t>(size));
  }
  template <class T> static Span<T> all(std::vector<T>& list) {
    return {list.data(), static_cast<Index>(list.size())};
  }
  explicit Cones(Random& random)
      : cones{{0, 4, 0, 0.5, 0.1, 1}, {5, 4, 6, 0.7, 0, 2}, {11, 0, 13, 0, 0, 1}}, factored{},
        scales(zeros<double>(n)), scale(scales.data(), n),
        numbers_kept(zeros<double>(kept.scalars(n, shared))),
        numbers_read(zeros<double>(read.scalars(n, shared))),
        integers(zeros<std::int16_t>(read.integers(3, shared))) {
    for (int j = 0; j < 12; ++j) wrenches.push_back(vector(random));
    if (random.integer(0, 1) == 1) make_opposite();
    for (double& x : scales) x = random.uniform(0.5, 2);
    for (std::size_t first : {1U, 8U}) // the generators of a cone have one scale
      std::fill_n(scales.begin() + static_cast<int>(first), 4, scales[first]);
    // One sum couples forces of all cones, one those of the second alone: some of them.
    for (Index k = 0; k < shared; ++k) {
      const Index first = static_cast<Index>(couplings.size());
      for (Index i = k == 0 ? 0 : 6; i < (k == 0 ? 14 : 12); ++i)
        if (cone_slot(i) && random.integer(0, 2) > 0) {
          coupled.push_back(static_cast<int>(i));
          couplings.push_back(random.uniform(-1, 1));
        }
      sums.push_back({first, static_cast<Index>(couplings.size()) - first, 1, 0.5});
    }
    factored.wrenches = {wrenches.data(), 12};
    factored.cones = {cones.data(), 3};
    factored.sums = {sums.data(), shared};
    factored.coupled_variable = {coupled.data(), static_cast<Index>(coupled.size())};
    factored.coupling = {couplings.data(), static_cast<Index>(couplings.size())};
    problem.size = n;
    problem.free_begin = 14;
    problem.factored = &factored;
    begin(kept, numbers_kept);
    begin(read, numbers_read);
    for (Index c = 0; c < 3; ++c)
      turned.push_back({factored.cones[c], c, cone(c).variable, -1, 1, 0});
  }
  /// As those of a pyramid are: the second half of a cone's generators of the first.
  void make_opposite() {
    for (std::size_t first : {1U, 7U})
      for (std::size_t j = first; j < first + 2; ++j) wrenches[j + 2] = -wrenches[j];
  }
  static bool cone_slot(Index i) { return i != 5 && i != 12; } // no slip
  static Vector6<double> vector(Random& random) {
    Vector6<double> v;
    for (Index d = 0; d < 6; ++d) v[d] = random.uniform(-1, 1);
    return v;
  }
  template <class Directions> void begin(Directions& h, std::vector<double>& numbers) {
    Block<double> scalars(all(numbers));
    Block<std::int16_t> shorts(all(integers));
    h.carve(problem, shared, scalars, shorts);
    CHECK_FALSE(scalars.exhausted());
    CHECK_FALSE(shorts.exhausted());
    h.load(scale);
    for (Index k = 0; k < shared; ++k) h.share(k, k, scale[14 + k], scale);
  }
  const ConeGroup<double>& cone(Index c) const { return factored.cones[c]; }
  detail::TurnedCone<double>& of(Index c) { return turned[static_cast<std::size_t>(c)]; }
  const detail::TurnedCone<double>& of(Index c) const {
    return turned[static_cast<std::size_t>(c)];
  }

  void slide(Index c, Index generator) {
    kept.slide(c, generator);
    of(c).along = generator;
  }
  void press(Index c, double inverse) {
    kept.press(c, own, inverse);
    of(c).normal = own;
    of(c).normal_by = inverse;
  }
  void yield(Index c, double stiffness, double friction) {
    kept.yield(c, of(c).slip(), stiffness, friction);
    of(c).normal_by = -stiffness;
    of(c).slip_by = -stiffness * friction;
  }

  /// Slots without a direction are nobody's to ask for; `pressed` has given its own away.
  void compare(Random& random, Index pressed = -1) const {
    CHECK(kept.width() == 8);
    CHECK(read.width() == 8);
    std::vector<double> along(8), rows = zeros<double>(n), rows_read = rows;
    VectorMap<double> v(along.data(), 8), out(rows.data(), n), out_read(rows_read.data(), n);
    for (double& x : along) x = random.uniform(-1, 1);
    const auto turned_of = [&](Index c) { return of(c); };
    kept.add_dots(turned_of, v, out);
    read.add_dots(turned_of, v, out_read);
    for (Index i = 0; i < n; ++i) {
      CAPTURE(i);
      CHECK(out_read[i] == doctest::Approx(out[i]).epsilon(1e-13));
      if (i == pressed || i == 14 || i == 15 || (i == own && pressed < 0)) continue;
      const detail::TurnedCone<double>& of_slot = of(i == own ? 2 : cone_of(factored.cones, i));
      CHECK(read.dot(i, of_slot, v) == doctest::Approx(kept.dot(i, of_slot, v)).epsilon(1e-13));
      std::vector<double> sums_kept(8, 1.0), sums_read(8, 1.0);
      VectorMap<double> sum(sums_kept.data(), 8), sum_read(sums_read.data(), 8);
      kept.add(i, of_slot, 0.7, sum);
      read.add(i, of_slot, 0.7, sum_read);
      CHECK((sum - sum_read).norm() <= 1e-13);
    }
  }
};

} // namespace

TEST_CASE("directions: read from the problem they are those that are kept") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Cones cones(random);
    cones.compare(random);
    const Index along = random.integer(1, 4), pulled = random.integer(8, 11);
    SUBCASE("a cone slides, and one that pulls") {
      cones.slide(0, along);
      cones.slide(1, pulled);
      cones.compare(random);
    }
    SUBCASE("a cone's own actuator presses") {
      cones.press(2, 0.3);
      cones.compare(random, 13);
    }
    SUBCASE("a cone yields") {
      cones.yield(0, 3.0, 0.2);
      cones.compare(random);
    }
    SUBCASE("a cone slides and yields") {
      cones.slide(0, along);
      cones.yield(0, 3.0, 0.2);
      cones.compare(random);
    }
  }
}
