// Every fixture by pivots, by sweeps and by both: the same motion, every answer checked.
#include "support/fixture_push.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace lcpush;
using namespace lcpush::test;

namespace {

desktop::PushReport solved_by(desktop::Solver solver, const desktop::SceneFile& file) {
  desktop::PushOptions options;
  options.solver = solver;
  options.other_paths = 0;
  options.explain_jams = false;
  desktop::Push push(file);
  desktop::PushReport report = push.solve(options);
  report.answer.contacts = {}; // gone with the Push; the acceleration stays
  return report;
}

std::string under(const std::string& law, const std::string& text) {
  const std::size_t at = text.find("pressure = ");
  if (at == std::string::npos) return with(text, "\ntitle", "\npressure = \"" + law + "\"\ntitle");
  return text; // a scene that names its law keeps it
}

} // namespace

TEST_CASE("on every fixture, under pad and even, sweeps and pivots find the same motion") {
  int compared = 0;
  for (const char* law : {"pad", "even"})
    for (const auto& entry :
         std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/scenes")) {
      const std::string name = entry.path().filename().string(), text = scene_text(name);
      CAPTURE(name);
      CAPTURE(law);
      if (law == std::string("even") && text.find("parallel") != std::string::npos) continue;
      if (law == std::string("even") && name == "three_finger_hand.toml") continue; // shared tendon
      const desktop::SceneFile file = desktop::parse_scene(under(law, text), name);
      const desktop::PushReport pivots = solved_by(desktop::Solver::lemke, file);
      for (const desktop::Solver solver :
           {desktop::Solver::gauss_seidel, desktop::Solver::hybrid}) {
        const desktop::PushReport other = solved_by(solver, file);
        if (name == "jam.toml") {
          CHECK(other.status != Status::solved);
          continue;
        }
        REQUIRE(pivots.status == Status::solved);
        REQUIRE(other.status == Status::solved);
        CHECK(other.residuals.max() <= 1e-9);
        if (name == "rolling_two_answers.toml") { // each finds one of the two: held, or rolling
          const double spin = other.answer.acceleration[5];
          CHECK(std::min(std::abs(spin), std::abs(spin - 5)) <= 1e-5);
          continue;
        }
        const double size = std::max(motion_size(pivots.answer.acceleration, pivots.scales), 1e-3);
        CHECK(motion_size<double>(other.answer.acceleration - pivots.answer.acceleration,
                                  pivots.scales) <= 1e-5 * size);
        ++compared;
      }
    }
  CHECK(compared >= 60);
}

TEST_CASE("the history of the sweeps falls to the laws' tolerance, family by family") {
  const desktop::SceneFile file =
      desktop::parse_scene(scene_text("straight_slide.toml"), "test.toml");
  desktop::Push push(file);
  desktop::PushOptions options;
  options.solver = desktop::Solver::gauss_seidel;
  options.record_history = true;
  const desktop::PushReport report = push.solve(options);
  REQUIRE(report.status == Status::solved);
  REQUIRE(report.history.size() > 3);
  CHECK(report.history.front().sweep == 0);
  for (std::size_t k = 1; k < report.history.size(); ++k)
    CHECK(report.history[k].sweep >= report.history[k - 1].sweep);
  CHECK(report.history.front().residuals.max() > 1e-3);
  CHECK(report.history.back().residuals.max() <= 1e-9);
}
