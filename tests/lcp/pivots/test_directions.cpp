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
  FactoredProblem<double> problem;
  std::vector<double> scales;
  VectorMap<double> scale;
  std::vector<double> numbers_kept, numbers_read;
  std::vector<std::int16_t> integers;
  detail::KeptDirections<double> kept;
  detail::ReadDirections<double, std::int16_t> read;

  template <class T> static std::vector<T> zeros(Index size) {
    return std::vector<T>(static_cast<std::size_t>(size));
  }
  explicit Cones(Random& random)
      : cones{{0, 4, 0, 0.5, 0.1, 1}, {5, 4, 6, 0.7, 0, 2}, {11, 0, 13, 0, 0, 1}}, problem{},
        scales(zeros<double>(n)), scale(scales.data(), n),
        numbers_kept(zeros<double>(kept.scalars(n, 3, shared))),
        numbers_read(zeros<double>(read.scalars(n, 3, shared))),
        integers(zeros<std::int16_t>(read.integers(3))) {
    for (int j = 0; j < 12; ++j) wrenches.push_back(vector(random));
    if (random.integer(0, 1) == 1) make_opposite();
    for (double& x : scales) x = random.uniform(0.5, 2);
    for (std::size_t first : {1U, 8U}) // the generators of a cone have one scale
      std::fill_n(scales.begin() + static_cast<int>(first), 4, scales[first]);
    problem.wrenches = {wrenches.data(), 12};
    problem.cones = {cones.data(), 3};
    carve(kept, numbers_kept);
    carve(read, numbers_read);
    kept.load(scale);
    read.load(scale);
    for (Index i = 0; i < 14; ++i)
      for (Index k = 0; k < shared; ++k) {
        if (cone_slot(i)) both([&, x = random.uniform(-1, 1)](auto& h) { h.couple(i, k, x); });
      }
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
  template <class Directions> void carve(Directions& h, std::vector<double>& numbers) {
    Block<double> scalars({numbers.data(), static_cast<Index>(numbers.size())});
    Block<std::int16_t> shorts({integers.data(), static_cast<Index>(integers.size())});
    h.carve(problem, n, shared, scalars, shorts);
    CHECK_FALSE(scalars.exhausted());
    CHECK_FALSE(shorts.exhausted());
  }
  template <class Do> void both(const Do& act) {
    act(kept);
    act(read);
  }
  Index cone(Index i) const { return i == own ? 2 : cone_of(problem.cones, i); }

  /// Slots without a direction are nobody's to ask for; `pressed` has given its own away.
  void compare(Random& random, Index pressed = -1) const {
    CHECK(kept.width() == 8);
    CHECK(read.width() == 8);
    std::vector<double> along(8), rows = zeros<double>(n), rows_read = rows;
    VectorMap<double> v(along.data(), 8), out(rows.data(), n), out_read(rows_read.data(), n);
    for (double& x : along) x = random.uniform(-1, 1);
    kept.add_dots(v, out);
    read.add_dots(v, out_read);
    for (Index i = 0; i < n; ++i) {
      CAPTURE(i);
      CHECK(out_read[i] == doctest::Approx(out[i]).epsilon(1e-13));
      if (i == pressed || i == 14 || i == 15 || (i == own && pressed < 0)) continue;
      CHECK(read.dot(i, cone(i), v) == doctest::Approx(kept.dot(i, cone(i), v)).epsilon(1e-13));
      std::vector<double> sums(8, 1.0), sums_read(8, 1.0);
      VectorMap<double> sum(sums.data(), 8), sum_read(sums_read.data(), 8);
      kept.add(i, cone(i), 0.7, sum);
      read.add(i, cone(i), 0.7, sum_read);
      CHECK((sum - sum_read).norm() <= 1e-13);
    }
  }
};

} // namespace

TEST_CASE("directions: read from the wrenches they are those that are kept") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Cones cones(random);
    cones.compare(random);
    const Index along = random.integer(1, 4), pulled = random.integer(8, 11);
    SUBCASE("a cone slides, and one that pulls") {
      cones.both([&](auto& h) { h.slide(0, along); });
      cones.both([&](auto& h) { h.slide(1, pulled); });
      cones.compare(random);
    }
    SUBCASE("a cone's own actuator presses") {
      cones.both([](auto& h) { h.press(2, Cones::own, 0.3); });
      cones.compare(random, 13);
    }
    SUBCASE("a cone yields") {
      cones.both([](auto& h) { h.yield(0, 5, 3.0, 0.2); });
      cones.compare(random);
    }
    SUBCASE("a cone slides and yields") {
      cones.both([&](auto& h) { h.slide(0, along); });
      cones.both([&](auto& h) { h.yield(0, along, 3.0, 0.2); });
      cones.compare(random);
    }
  }
}
