// Scenes read exactly: decimals as typed, and what is not exact by name.
#include "lcpush/desktop/exact_pivots.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"
#include "lcpush/mechanics/model/assemble.hpp"
#include "support/scene_text.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace lcpush;
using namespace lcpush::desktop;
using doctest::Approx;

namespace {

using Exact = SceneOf<Rational>;

Exact exactly(const std::string& text) { return parse_scene<Rational>(text, "s.toml"); }
Rational typed(const std::string& text) { return *Rational::parse(text); }
Vector3<Rational> typed(const std::string& x, const std::string& y, const std::string& z) {
  return {typed(x), typed(y), typed(z)};
}
template <class T> auto length_of(const T& x) { return static_cast<Index>(x.size()); }

std::vector<std::string> scene_paths() {
  std::vector<std::string> paths;
  const std::string folder = std::string(LCPUSH_SOURCE_DIR) + "/fixtures/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The largest difference between numbers of either scene, by their largest.
template <class Exactly, class Rounded> double difference(const Exactly& a, const Rounded& b) {
  double largest = 0, off = 0;
  for (Index i = 0; i < b.size(); ++i) {
    largest = std::max(largest, std::abs(b(i)));
    off = std::max(off, std::abs((a(i) - Rational(b(i))).value()));
  }
  return largest > 0 ? off / largest : off;
}

/// An assembly with its memory, for any scalar.
template <class S> struct OwnedAssembly {
  std::vector<Vector6<S>> wrenches;
  std::vector<ConeGroup<S>> cones;
  std::vector<SumGroup<S>> sums;
  std::vector<int> coupled;
  std::vector<S> coupling, reach, push, q;
  std::vector<Index> body;
  Scene<S> scene;
  Assembly<S> assembly;

  explicit OwnedAssembly(const SceneOf<S>& file) : scene(file.view()), assembly(memory(file)) {
    REQUIRE(assembly.assemble(scene) == Status::running);
  }

  AssemblyMemory<S> memory(const SceneOf<S>& file) {
    const std::size_t points = file.points.size(), actuators = file.actuators.size();
    const std::size_t forces = points * static_cast<std::size_t>(soft_generators(file.facets) + 2);
    const std::size_t couplings = forces * (file.drives.size() + 1);
    const std::size_t n = forces + points + actuators;
    wrenches.resize(forces);
    cones.resize(points);
    sums.resize(actuators);
    coupled.resize(couplings);
    coupling.resize(couplings);
    reach.resize(actuators);
    body.resize(points);
    for (std::vector<S>* list : {&push, &q}) list->resize(n);
    const auto all = [](auto& list) {
      return Span<typename std::decay_t<decltype(list)>::value_type>{list.data(), length_of(list)};
    };
    return {all(wrenches), all(cones), all(sums), all(coupled), all(coupling),
            all(body),     all(reach), all(push), all(q)};
  }

  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> M() {
    const Index n = assembly.layout().size;
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> M(n, n);
    fill_matrix(assembly.problem(), MatrixMap<S>(M.data(), n, n));
    return M;
  }
  VectorMap<S> right_hand_side() { return {q.data(), assembly.layout().size}; }
};

} // namespace

TEST_CASE("the circle's directions are fractions on the circle, opposite ones exact negatives") {
  CHECK(circle_cosine<Rational>(0, 8) == 1);
  CHECK(circle_cosine<Rational>(2, 8) == 0);
  CHECK(circle_cosine<Rational>(4, 8) == -1);
  for (const Index g : {4, 6, 8, 10, 12, 16, 50, 256})
    for (Index j = 0; j < g; ++j) {
      CAPTURE(j);
      CAPTURE(g);
      const Rational c = circle_cosine<Rational>(j, g), s = circle_sine<Rational>(j, g);
      CHECK(c * c + s * s == 1);
      CHECK(std::abs(c.value() - circle_cosine<double>(j, g)) < 1e-12);
      CHECK(std::abs(s.value() - circle_sine<double>(j, g)) < 1e-12);
      CHECK(circle_cosine<Rational>(j + g / 2, g) == -c);
      CHECK(circle_sine<Rational>(j + g / 2, g) == -s);
      CHECK(circle_cosine<Rational>(g - j, g) == c);
    }
}

TEST_CASE("a decimal is taken as typed") {
  const Exact scene = exactly(with(object_table, "mass = 0.2", "mass = +0.2_0") + finger_table);
  CHECK(scene.object.mass == Rational(1) / 5);
  CHECK(scene.object.mass != Rational(0.2));
  CHECK(scene.bodies[0].friction == Rational(1) / 2);
  CHECK(scene.points[0] == typed("0", "0", "1/200"));
}

TEST_CASE("the points of lines and rectangles are exact, and so are normals of a rational length") {
  const std::string rectangle = "shape = \"rectangle\"\nsize = [0.03, 0.01]\ntangent = [1, 0, 0]";
  const Exact flat = exactly(with_finger("shape = \"point\"", rectangle));
  REQUIRE(flat.points.size() == 16);
  // o = n x t = (0, -1, 0)
  CHECK(flat.points[0] == typed("-0.015", "0.005", "0.005"));
  CHECK(flat.points[1] == typed("-0.005", "0.005", "0.005"));
  CHECK(flat.points[15] == typed("0.015", "-0.005", "0.005"));
  CHECK(flat.weights[0] == Rational(1) / 64);
  CHECK(flat.weights[5] == Rational(9) / 64);
  const Exact line =
      exactly(with_finger("shape = \"point\"\ncenter = [0, 0, 0.005]",
                          "shape = \"line\"\nends = [[0.1, 0, 0], [0.2, 0, 0.1]]\npoints = 4"));
  CHECK(line.points[1] == typed("2/15", "0", "1/30"));
  const Exact slope =
      exactly("facets = 4\n" + with_finger("normal = [0, 0, -2]", "normal = [3, 4, 0]"));
  CHECK(slope.bodies[0].normal == typed("3/5", "4/5", "0"));
  CHECK(slope.bodies[0].tangent == typed("0", "0", "1"));
  CHECK(slope.inexact.empty());
  const Exact along =
      exactly("facets = 4\n" +
              with_finger("normal = [0, 0, -2]", "normal = [0.3, 0.4, 0]\ntangent = [1, 0, 0]"));
  CHECK(along.bodies[0].tangent == typed("4/5", "-3/5", "0"));
}

TEST_CASE("what is irrational is named") {
  const Exact tilted =
      exactly("facets = 4\n" + with_finger("normal = [0, 0, -2]", "normal = [1, 1, 0]"));
  REQUIRE(tilted.inexact.size() == 1);
  CHECK(tilted.inexact[0] ==
        "the normal of finger \"left\" is irrational: a fraction within 1e-12 of it is used");
  CHECK(tilted.bodies[0].normal[0] == typed("0.707106781186547"));
  CHECK(tilted.bodies[0].tangent == typed("0", "0", "1"));

  const Exact thirds =
      exactly("facets = 4\n" + with_finger("normal = [0, 0, -2]", "normal = [1, 2, 2]"));
  CHECK(thirds.bodies[0].normal == typed("1/3", "2/3", "2/3"));
  REQUIRE(thirds.inexact.size() == 1);
  CHECK(thirds.inexact[0] ==
        "the tangent of finger \"left\" is irrational: a fraction within 1e-12 of it is used");

  const Exact eight = exactly(object_table + finger_table);
  REQUIRE(irrational_directions(eight).size() == 1);
  CHECK(irrational_directions(eight)[0] == "the friction directions of 8 facets are irrational: "
                                           "fractions within 1e-12 of them are used");
  CHECK(irrational_directions(exactly(with_finger("friction = 0.5", "friction = 0"))).empty());
  CHECK(irrational_directions(exactly("facets = 6\n" + with_finger(""))).size() == 1);
  CHECK(irrational_directions(
            exactly(with_finger("friction = 0.5", "friction = 0\ntorsion_radius = 0.01")))
            .empty());
  const Exact soft = exactly("facets = 4\n" + with_finger("torsion_radius = 0.01\n"));
  REQUIRE(irrational_directions(soft).size() == 1);
  CHECK(irrational_directions(soft)[0] ==
        "the soft generators of \"left\" are irrational: fractions within 1e-12 of them are used");
}

TEST_CASE("an exact reading refuses what the other refuses, in the same words") {
  for (const std::string& text :
       {with_finger("friction = 0.5", "friction = -0.5"),
        with_finger("normal = [0, 0, -2]", "normal = [0, 0, 0]"),
        with_object("inertia = [1, -1, 1]"), with_finger("tangent = [0, 0, 1]\n"),
        with_finger("center = [0, 0, 0.005]", "center = [0, 0, 1e13]"), object_table}) {
    CAPTURE(text);
    std::string message = "accepted";
    try {
      exactly(text);
    } catch (const InputError& error) {
      message = error.what();
    }
    CHECK(message == refusal(text));
    CHECK(message != "accepted");
  }
}

TEST_CASE("a number of too many digits is refused by name") {
  const std::string digits = "0." + std::string(10001, '2');
  CHECK_THROWS_WITH_AS(exactly(with(object_table, "mass = 0.2", "mass = " + digits) + finger_table),
                       doctest::Contains("s.toml:2: object: mass is too long to be read exactly"),
                       InputError);
}

TEST_CASE("every fixture's exact scene is its double scene but for rounding") {
  for (const std::string& path : scene_paths()) {
    CAPTURE(path);
    const Exact exact = read_scene<Rational>(path);
    const SceneFile rounded = read_scene(path);
    constexpr double rounding = 1e-12;
    CHECK(difference(exact.object.inertia, rounded.object.inertia) < rounding);
    CHECK(difference(exact.gravity, rounded.gravity) < rounding);
    CHECK(exact.object.mass.value() == rounded.object.mass);
    REQUIRE(exact.points.size() == rounded.points.size());
    for (std::size_t i = 0; i < exact.points.size(); ++i)
      CHECK(difference(exact.positions[i], rounded.positions[i]) < rounding);
    REQUIRE(exact.bodies.size() == rounded.bodies.size());
    for (std::size_t b = 0; b < exact.bodies.size(); ++b) {
      CHECK(difference(exact.bodies[b].normal, rounded.bodies[b].normal) < rounding);
      CHECK(difference(exact.bodies[b].tangent, rounded.bodies[b].tangent) < rounding);
      CHECK(difference(exact.bodies[b].acceleration, rounded.bodies[b].acceleration) < rounding);
      CHECK(exact.bodies[b].friction.value() == rounded.bodies[b].friction);
    }
    REQUIRE(exact.drives.size() == rounded.drives.size());
    for (std::size_t d = 0; d < exact.drives.size(); ++d)
      CHECK(difference(exact.drives[d].twist, rounded.drives[d].twist) < rounding);
    for (std::size_t a = 0; a < exact.actuators.size(); ++a)
      CHECK(exact.actuators[a].force.value() == rounded.actuators[a].force);
    CHECK(exact.body_names == rounded.body_names);
    CHECK(rounded.inexact.empty());
  }
}

TEST_CASE("a grasp with four facets is solved exactly") {
  const std::string path =
      std::string(LCPUSH_SOURCE_DIR) + "/fixtures/scenes/straight_slide_point.toml";
  Exact file = read_scene<Rational>(path);
  file.facets = 4;
  OwnedAssembly<Rational> exact(file);
  const Problem<Rational> problem = exact.assembly.problem();
  const Index n = problem.size;
  std::vector<Rational> scalars(static_cast<std::size_t>(lemke_scalars(n)));
  std::vector<Rational> ones(static_cast<std::size_t>(n), Rational(1));
  std::vector<int> integers(static_cast<std::size_t>(lemke_integers(n)));
  Lemke<Rational> lemke({scalars.data(), lemke_scalars(n)}, {integers.data(), lemke_integers(n)});
  LemkeOptions<Rational> options;
  options.tie_rule = TieRule::lexicographic;
  options.equilibrate = false;
  options.cover = ones.data();
  REQUIRE(lemke.init(problem, options) == Status::running);
  REQUIRE(lemke.solve() == Status::solved);
  CHECK(lemke.residual().residual == 0);
}
