// A seeded part of the reliability benchmark: all solved, none wrong.
#include <doctest/doctest.h>

#include <string>

#include "support/random_grasp.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// How many of the grasps are solved; every one that is called solved is checked.
template <class S>
int solved_of(std::uint64_t first, std::uint64_t count, Pressure pressure, S tolerance,
              bool planar = false) {
  int solved = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    CAPTURE(seed);
    OwnedScene<S> scene = random_grasp<S>(seed);
    scene.base.pressure = pressure;
    scene.base.planar = planar;
    SolvedPush<S> push(scene);
    if (push.solve() != Status::solved) {
      MESSAGE("seed " << seed << ": " << std::string(status_text(push.status)) << " "
                      << std::string(reason_text(push.run.reason)));
      continue;
    }
    CHECK(push.residuals.max() <= tolerance);
    ++solved;
  }
  return solved;
}

} // namespace

TEST_CASE("200 random grasps under pad: all solved, all checked") {
  CHECK(solved_of<double>(1000, 200, Pressure::pad, 1e-9) == 200);
}

TEST_CASE("planar random grasps under pad and rigid: all solved, all checked") {
  CHECK(solved_of<double>(3000, 60, Pressure::pad, 1e-9, true) == 60);
  CHECK(solved_of<double>(4000, 60, Pressure::rigid, 1e-9, true) == 60);
}

TEST_CASE("200 random grasps under rigid: all solved, all checked") {
  CHECK(solved_of<double>(2000, 200, Pressure::rigid, 1e-9) == 200);
}

TEST_CASE("100 random grasps in float: what is called solved obeys the laws to float's precision") {
  const float tolerance = 4 * Tolerances<float>().residual;
  const int pad = solved_of<float>(1, 100, Pressure::pad, tolerance);
  const int rigid = solved_of<float>(1, 100, Pressure::rigid, tolerance);
  MESSAGE("float solves " << pad << " of 100 under pad, " << rigid << " under rigid");
  CHECK(rigid >= 95);
  CHECK(pad >= 80);
}
