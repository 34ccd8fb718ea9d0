// lcpush spread: the answer as a set.
#include "lcpush/desktop/spread.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_argument.hpp"
#include "formats/read_number.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

Index chosen_covers(const Arguments& arguments, Index otherwise) {
  const std::optional<std::string> word = arguments.value("--covers");
  if (!word) return otherwise;
  const std::optional<std::uint64_t> covers = desktop::whole_number(*word);
  if (!covers || *covers < 1 || *covers > desktop::limits::covers)
    throw UsageError("--covers is a whole number from 1 to " +
                     std::to_string(desktop::limits::covers) + ", not " + desktop::quoted(*word));
  return static_cast<Index>(*covers);
}

int run(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json"});
  desktop::SpreadOptions options;
  options.covers = chosen_covers(arguments, options.covers);
  options.enumerate = arguments.has("--enumerate");
  const desktop::SceneFile file = read_scene_argument(arguments);
  const Index unknowns = size_of(file.view()).unknowns();
  if (unknowns > desktop::limits::unknowns_spread)
    throw desktop::InputError(arguments.files()[0] + ": the scene has " + std::to_string(unknowns) +
                              " unknowns, more than the " +
                              std::to_string(desktop::limits::unknowns_spread) +
                              " whose faces can be bounded; use fewer points or facets");
  desktop::SpreadReport report;
  {
    Progress progress;
    options.watcher = &progress;
    report = desktop::find_spread(file, options);
  }
  write_output(arguments, format == "json" ? desktop::spread_json(file, report)
                                           : desktop::spread_text(file, report));
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
      with_common_options(
          {{"--covers", "N", "covering vectors of Lemke's method to start from (32)"},
           {"--enumerate", "", "all contact modes: up to 16 points, while the work allows"}}),
      1,
      run};
}

} // namespace lcpush::cli
