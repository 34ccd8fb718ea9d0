// lcpush spread: the answer as a set.
#include "lcpush/desktop/spread.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "text/limits.hpp"

namespace lcpush::cli {
namespace {

int run_spread(const Arguments& arguments) {
  const std::string format = arguments.format();
  SpreadOptions options;
  options.covering_vectors =
      arguments.whole("--covers", {1, limits::covers}).value_or(options.covering_vectors);
  options.enumerate = arguments.has("--enumerate");
  const SceneFile file = read_scene_argument(arguments);
  refuse_unknowns(arguments, file, limits::unknowns_spread, "faces can be bounded");
  SpreadReport report;
  {
    Progress progress;
    options.watcher = &progress;
    report = find_spread(file, options);
  }
  write_answer(arguments, format,
               format == "json" ? spread_json(file, report)
                                : spread_text(file, report, telling(arguments)),
               file);
  return report.status == Status::solved ? 0 : 1;
}

} // namespace

Command spread_command() {
  return {
      "spread",
      "SCENE.toml [OPTIONS]",
      "the answer as a set: bounds of the push, the motion and the contact forces",
      "Rigid contact often leaves forces open, and now and then the motion. This solves the\n"
      "literal laws (pressure = \"rigid\", whatever the file says) under many covering vectors,\n"
      "walks from each answer to the faces of answers next to it, and bounds every quantity\n"
      "over each face by linear programs. With --enumerate it goes through all contact modes,\n"
      "so that the bounds are those of every answer; without, of the answers that were reached.\n\n"
      "Example:\n  lcpush spread fixtures/scenes/straight_slide.toml\n",
      with_scene_options(
          {{"--covers", "N", "covering vectors of Lemke's method to start from (32)"},
           {"--enumerate", "", "all contact modes: up to 16 points, while the work allows"},
           verbose_option}),
      1,
      run_spread};
}

} // namespace lcpush::cli
