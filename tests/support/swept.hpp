// Sweeps of scenes in memory, for tests.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "lcpush/desktop/sweep.hpp"
#include "support/fixture_push.hpp"

namespace lcpush::test {

using namespace lcpush::desktop;

inline std::string rigid(const std::string& text) { return "pressure = \"rigid\"\n" + text; }

inline Sweep swept(const VariedScene& scene, const std::string& path, double from, double to,
                   ParameterSweepOptions options = {}) {
  return sweep_parameter(scene, {{scene.find(path), from, to}}, options);
}
/// With eight facets where it says nothing of them: exact segments are those of pyramids.
inline VariedScene with_facets(const std::string& text) {
  VariedScene scene = VariedScene::parse(text, "test.toml");
  if (scene.as_given().lines.facets == 0) scene.set_facets(8);
  return scene;
}
inline Sweep swept(const std::string& text, const std::string& path, double from, double to,
                   const ParameterSweepOptions& options = {}) {
  return swept(with_facets(text), path, from, to, options);
}

inline void check_covers(const Sweep& sweep) {
  REQUIRE(!sweep.segments.empty());
  CHECK(sweep.segments.front().from == sweep.variations[0].from);
  CHECK(sweep.segments.back().to == sweep.variations[0].to);
  CHECK(sweep.segments.back().change.is_empty());
  for (std::size_t i = 1; i < sweep.segments.size(); ++i) {
    CHECK(sweep.segments[i].from == sweep.segments[i - 1].to);
    CHECK(!sweep.segments[i - 1].change.is_empty());
  }
}

inline double breakpoint_near(const Sweep& sweep, double value) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < sweep.segments.size(); ++i)
    if (std::abs(sweep.segments[i].to - value) < std::abs(best - value))
      best = sweep.segments[i].to;
  return best;
}

} // namespace lcpush::test
