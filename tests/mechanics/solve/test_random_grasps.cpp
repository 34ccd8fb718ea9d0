// A seeded part of the reliability benchmark: all solved, none wrong.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "support/grasp_families.hpp"
#include "support/solved_push.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// How many of the grasps are solved; every one that is called solved is checked.
template <class S, class Pivots = Lemke<S>>
int solved_of(std::uint64_t first, std::uint64_t count, Pressure pressure, S tolerance,
              Family family = Family::plain) {
  int solved = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    CAPTURE(seed);
    OwnedScene<S> scene = grasp_of<S>(family, seed);
    scene.base.pressure = pressure;
    SolvedPush<S, Pivots> push(scene);
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

TEST_CASE("random grasps on the structured basis: all solved, all checked") {
  using Pivots = StructuredLemke<double>;
  CHECK(solved_of<double, Pivots>(1000, 300, Pressure::pad, 1e-9) == 300);
  CHECK(solved_of<double, Pivots>(2000, 300, Pressure::rigid, 1e-9) == 300);
  CHECK(solved_of<double, Pivots>(5000, 200, Pressure::even, 1e-9, Family::even) == 200);
  for (const Family family : {Family::planar, Family::soft, Family::parallel, Family::jacobian}) {
    CAPTURE(static_cast<int>(family));
    CHECK(solved_of<double, Pivots>(3000, 60, Pressure::pad, 1e-9, family) == 60);
    CHECK(solved_of<double, Pivots>(4000, 60, Pressure::rigid, 1e-9, family) == 60);
  }
}

TEST_CASE("planar, soft, parallel and crookedly driven random grasps: all solved, all checked") {
  for (const Family family : {Family::planar, Family::soft, Family::parallel, Family::jacobian}) {
    CAPTURE(static_cast<int>(family));
    CHECK(solved_of<double>(3000, 60, Pressure::pad, 1e-9, family) == 60);
    CHECK(solved_of<double>(4000, 60, Pressure::rigid, 1e-9, family) == 60);
  }
  CHECK(solved_of<double>(5000, 100, Pressure::even, 1e-9, Family::even) == 100);
}

TEST_CASE("weighted patches and wrenches on the object: all solved, all checked") {
  CHECK(solved_of<double>(3000, 200, Pressure::pad, 1e-9, Family::weighted) == 200);
  CHECK(solved_of<double>(4000, 200, Pressure::rigid, 1e-9, Family::weighted) == 200);
  CHECK(solved_of<double, StructuredLemke<double>>(3000, 200, Pressure::pad, 1e-9,
                                                   Family::weighted) == 200);
}

TEST_CASE("locked fingers, which no theorem covers: 19 of 20 solved, the others wedge") {
  CHECK(solved_of<double>(3000, 200, Pressure::pad, 1e-9, Family::locked) >= 190);
}

TEST_CASE("bilateral pushers: solved, unless their points pull against each other without bound") {
  CHECK(solved_of<double>(3000, 60, Pressure::pad, 1e-9, Family::bilateral) >= 59);
  CHECK(solved_of<double>(4000, 60, Pressure::rigid, 1e-9, Family::bilateral) == 60);
}

TEST_CASE("a second pusher or a stop across the push: solved, but for true wedges") {
  for (const Family family : {Family::two_pushers, Family::stop}) {
    CHECK(solved_of<double>(3000, 60, Pressure::pad, 1e-9, family) >= 57);
    CHECK(solved_of<double>(4000, 60, Pressure::rigid, 1e-9, family) >= 57);
  }
}

TEST_CASE("200 random grasps under rigid: all solved, all checked") {
  CHECK(solved_of<double>(2000, 200, Pressure::rigid, 1e-9) == 200);
}

/// An answer's residual on the same scene in double precision.
double residual_in_double(const OwnedScene<double>& owned, const SolvedPush<float>& push) {
  SolvedPush<double> same(owned);
  std::vector<ContactAnswer<double>> contacts;
  for (const ContactAnswer<float>& contact : push.answer().contacts) {
    ContactAnswer<double> wide;
    wide.body = contact.body;
    wide.normal_force = static_cast<double>(contact.normal_force);
    wide.friction_force = contact.friction_force.cast<double>();
    wide.torsion = static_cast<double>(contact.torsion);
    wide.slip = static_cast<double>(contact.slip);
    wide.acceleration = contact.acceleration.cast<double>();
    contacts.push_back(wide);
  }
  std::vector<double> friction(push.answer().friction.begin(), push.answer().friction.end());
  std::vector<double> closing(push.answer().closing.begin(), push.answer().closing.end());
  const Answer<double> answer{push.answer().acceleration.cast<double>(),
                              {contacts.data(), static_cast<Index>(contacts.size())},
                              {friction.data(), static_cast<Index>(friction.size())},
                              {closing.data(), static_cast<Index>(closing.size())}};
  return check(same.scene, same.scales(), answer, 1.0).max();
}

// What a microcontroller is given: at most twelve points, four facets. As there, an answer counts
// as solved when it has passed the check of the laws too. docs/embed/embedding.md quotes this.
TEST_CASE(
    "a thousand firmware-sized random grasps in float: at least 995 solved, to 1e-4 in double") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) {
    CAPTURE(static_cast<int>(pressure));
    int solved = 0, tried = 0;
    double worst = 0;
    for (std::uint64_t seed = 1; tried < 1000; ++seed) {
      OwnedScene<float> scene = random_grasp<float>(seed);
      if (scene.points.size() > 12) continue;
      ++tried;
      CAPTURE(seed);
      scene.base.facets = 4;
      scene.base.pressure = pressure;
      SolvedPush<float> push(scene);
      if (push.solve() != Status::solved) continue;
      if (!(push.residuals.max() <= Tolerances<float>().residual)) continue;
      ++solved;
      OwnedScene<double> in_double = random_grasp<double>(seed);
      in_double.base.facets = 4;
      in_double.base.pressure = pressure;
      const double residual = residual_in_double(in_double, push);
      CHECK(residual <= 1e-4);
      worst = std::max(worst, residual);
    }
    MESSAGE("float solves " << solved << " of 1000, worst residual " << worst);
    CHECK(solved >= 995);
  }
}

TEST_CASE("100 random grasps of all sizes in float: what is called solved obeys the laws") {
  const float tolerance = 4 * Tolerances<float>().residual;
  CHECK(solved_of<float>(1, 100, Pressure::rigid, tolerance) >= 95);
  CHECK(solved_of<float>(1, 100, Pressure::pad, tolerance) >= 90);
}
