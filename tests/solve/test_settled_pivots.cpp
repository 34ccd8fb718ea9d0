// Wide patches whose object does not follow its pusher: where pivots begin.
#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/desktop/push.hpp"
#include "solve/settled_pivots.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

/// A bar between two discs of 200 points each, that a rough wall pushes.
SceneFile bar(const char* pressure, const char* acceleration, const char* ends, int facets = 8,
              int points = 200) {
  const auto disc = [points](const char* name, const char* z, const char* normal) {
    return std::string("[[finger]]\nname = \"") + name + "\"\nshape = \"disc\"\ncenter = [0, 0, " +
           z + "]\nnormal = [0, 0, " + normal +
           "]\nradius = 0.005\npoints = " + std::to_string(points) +
           "\nfriction = 0.5\ngrip_force = 20\n";
  };
  return parse_scene(
      std::string("facets = ") + std::to_string(facets) + "\npressure = \"" + pressure +
          "\"\ngravity = [0, -9.81, 0]\n"
          "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n" +
          disc("left", "0.005", "-1") + disc("right", "-0.005", "1") +
          "[[pusher]]\nname = \"wall\"\nshape = \"line\"\n" + ends +
          "\nnormal = [1, 0, 0]\nfriction = 0.3\nacceleration = " + acceleration + "\n",
      "bar.toml");
}
constexpr const char* oblique = "[0.1, 0.05, 0]";
constexpr const char* against_a_finger = "[0.1, 0.02, 0.03]";
constexpr const char* at_its_side = "points = 2\nends = [[-0.05, -0.01, 0], [-0.05, 0.01, 0]]";
constexpr const char* at_four_points = "points = 4\nends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]";
constexpr const char* straight = "[0.1, 0, 0]";
constexpr const char* tipping = "points = 2\nends = [[-0.05, 0.006, 0.003], [-0.05, 0.012, 0.003]]";

template <class Use> void for_each_push(const Use& use) {
  for (const char* pressure : {"pad", "rigid"})
    for (const bool tips : {false, true}) {
      CAPTURE(pressure);
      CAPTURE(tips);
      use(bar(pressure, tips ? straight : oblique, tips ? tipping : at_its_side));
    }
}

PushReport solved(Push& push, Solver solver = Solver::lemke) {
  PushOptions options;
  options.solver = solver;
  options.other_covers = 0;
  options.study_existence = false;
  return push.solve(options);
}

} // namespace

TEST_CASE("wide patches: a push that slips at its pusher, or tips, takes few pivots") {
  for_each_push([](const SceneFile& file) {
    Push push(file);
    const PushReport report = solved(push);
    REQUIRE(report.status == Status::solved);
    CHECK(report.residuals.max() <= 1e-9);
    CHECK(report.run.pivots <= 60); // a point would be 400; from the expected modes 500 to 4,000
  });
}

TEST_CASE("wide patches: fine pyramids take as few pivots as coarse ones") {
  for (const char* pressure : {"rigid", "pad"})
    for (const int facets : {16, 64, 128, 256})
      for (const char* ends : {at_its_side, at_four_points, tipping}) {
        CAPTURE(std::string(pressure));
        CAPTURE(facets);
        CAPTURE(std::string(ends));
        const SceneFile file = bar(pressure, ends == tipping ? straight : oblique, ends, facets);
        Push push(file);
        const PushReport report = solved(push);
        REQUIRE(report.status == Status::solved);
        CHECK(report.residuals.max() <= 1e-9);
        CHECK(report.run.sweeps == 0);
        CHECK(report.run.pivots <= 60); // from the expected modes: thousands at 128 facets
      }
}

TEST_CASE("wide patches: so does the force that breaks the grasp") {
  for_each_push([](const SceneFile& file) {
    Push push(file);
    PushOptions options;
    options.other_covers = 0;
    const BreakReport report = push.find_breaking(2, options);
    REQUIRE(report.status == Status::solved);
    CHECK(report.run.pivots <= 200); // three small pushes under pad
  });
}

TEST_CASE("wide pads: breaking begins slowly, and faster where pads would have to be stiff") {
  struct Case {
    const char* acceleration;
    int points;
    Index most_pivots;
  };
  for (const Case& asked :
       {Case{oblique, 800, 300}, Case{against_a_finger, 200, 600}}) { // 121, 407
    CAPTURE(std::string(asked.acceleration));
    const SceneFile file = bar("pad", asked.acceleration, at_four_points, 8, asked.points);
    Push push(file);
    PushOptions options;
    options.other_covers = 0;
    const BreakReport report = push.find_breaking(2, options);
    REQUIRE(report.status == Status::solved);
    CHECK(report.breaking.line_error <= 1e-6);
    CHECK(report.run.pivots <= asked.most_pivots);
  }
}

TEST_CASE(
    "wide pads: slower pushes go on from the first, and each that begins anew finds the same") {
  const SceneFile file = bar("pad", oblique, at_four_points);
  Push push(file);
  PushOptions options;
  options.other_covers = 0;
  const BreakReport report = push.find_breaking(2, options);
  REQUIRE(report.status == Status::solved);
  const Index steps = report.run.pivots + report.run.sweeps;
  CHECK(steps <= 600);
  options.lemke.first_cover = options.lemke.covers; // another opinion
  const BreakReport anew = push.find_breaking(2, options);
  REQUIRE(anew.status == Status::solved);
  CHECK(anew.run.pivots + anew.run.sweeps > 2 * steps);
  CHECK(anew.breaking.break_force == doctest::Approx(report.breaking.break_force).epsilon(1e-9));
}

TEST_CASE("wide pads: the motion is the one that sweeps find from nothing") {
  for (const std::pair<bool, int>& pushed :
       {std::pair(false, 8), std::pair(true, 8), std::pair(true, 32)}) {
    const bool tips = pushed.first;
    const int facets = pushed.second;
    CAPTURE(tips);
    CAPTURE(facets);
    const SceneFile file =
        bar("pad", tips ? straight : oblique, tips ? tipping : at_its_side, facets);
    Push by_pivots(file), by_sweeps(file);
    const PushReport first = solved(by_pivots), second = solved(by_sweeps, Solver::gauss_seidel);
    REQUIRE(first.status == Status::solved);
    REQUIRE(second.status == Status::solved);
    const Vector6<double> difference = first.answer.acceleration - second.answer.acceleration;
    CHECK(difference.norm() <= 1e-5 * second.answer.acceleration.norm());
  }
}

TEST_CASE("wide pads: a search's pivots are counted down, and none is made once they are spent") {
  const SceneFile file = bar("pad", oblique, at_its_side);
  AssembledScene scene(file.view(), file.is_round);
  const Problem<double> problem = scene.assembly.problem();
  const Index points = scene.assembly.layout().points;
  const Index shared = shared_actuators(scene.assembly.factored());
  Owned<StructuredLemke<double>> lemke(structured_lemke_scalars(problem.size, points, shared),
                                       structured_lemke_integers(problem.size, points));
  std::optional<Index> left;
  SettledPivots pivots(lemke, scene.assembly, left);
  REQUIRE(pivots.init(problem, {}) == Status::running);
  REQUIRE(pivots.solve(unwatched) == Status::solved);
  const Index needed = pivots.pivots();
  REQUIRE(needed > 10);
  left = 10;
  REQUIRE(pivots.init(problem, {}) == Status::running);
  CHECK(pivots.solve(unwatched) == Status::numerical_breakdown);
  CHECK(pivots.pivots() < 10);
  CHECK(pivots.is_spent());
  CHECK(pivots.init(problem, {}) == Status::numerical_breakdown);
  left = 2 * needed;
  REQUIRE(pivots.init(problem, {}) == Status::running);
  CHECK(pivots.solve(unwatched) == Status::solved);
  CHECK(*left >= needed - 1);
}
