// Every scene that we ship: its full form, eliminated, is its assembled problem.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "lcpush/desktop/push.hpp"
#include "support/full_elimination.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

std::vector<std::string> fixture_scenes() {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/scenes"))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

} // namespace

TEST_CASE("full = reduced on every fixture scene, and its patches count right") {
  double worst = 0;
  const std::vector<std::string> paths = fixture_scenes();
  CHECK(paths.size() >= 7);
  for (const std::string& path : paths) {
    CAPTURE(path);
    const desktop::SceneFile file = desktop::read_scene(path);
    desktop::Push push(file); // spreads the patches of an `even` scene
    FullElimination full(push.assembly());
    const double difference = full.difference();
    CHECK(difference <= 1e-12);
    worst = larger(worst, difference);
    for (Index b = 0; b < push.assembly().scene().bodies.size; ++b) {
      const Index k = push.assembly().scene().bodies[b].point_count;
      const RigidityCheck<double> check = full.rigidity(b);
      CHECK(check.holds());
      CHECK(check.rank == (k == 1 ? 0 : 3 * k - full.form.patch(b).rank - 4));
    }
  }
  MESSAGE("largest difference between full and reduced: " << worst);
}
