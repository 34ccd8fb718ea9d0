// lcpush spread: the answer as a set.
#include "lcpush/desktop/spread.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/stop_signal.hpp"
#include "cli/time_limit.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "text/limits.hpp"

namespace lcpush::cli {
namespace {

constexpr double longest_enumeration = 300; // seconds

SpreadOptions spread_options(const Arguments& arguments) {
  constexpr double longest = 1e6;
  SpreadOptions options;
  options.covering_vectors =
      arguments.whole("--covers", {1, limits::covers}).value_or(options.covering_vectors);
  options.breaking = arguments.has("--break");
  if (arguments.has("--enumerate") && arguments.has("--paths"))
    throw UsageError("--enumerate or --paths: all contact modes, or the paths alone");
  if (arguments.has("--enumerate")) options.enumeration = Enumeration::thorough;
  if (arguments.has("--paths")) options.enumeration = Enumeration::none;
  options.most_seconds = arguments.number("--seconds", longest, ", in seconds").value_or(0);
  return options;
}

int run_spread(const Arguments& arguments) {
  const std::string format = arguments.format();
  SpreadOptions options = spread_options(arguments);
  const SceneFile file = read_scene_argument(arguments);
  // What was asked for at length takes it, and what is then under way is finished.
  if (arguments.has("--enumerate")) limit_time("spread", longest_enumeration);
  if (options.most_seconds > 0) limit_time("spread", options.most_seconds + usual_seconds);
  if (options.breaking && !(push_size(file.view()) > 0))
    throw UsageError("no body of the scene moves: give a pusher an acceleration");
  refuse_unknowns(arguments, file, limits::unknowns_spread, "faces can be bounded");
  SpreadReport report;
  {
    Progress progress;
    StatusLine line;
    options.watcher = &progress;
    listen_for_signals();
    options.is_interrupted = is_asked_to_end;
    options.progress = [&](double share) {
      if (line.is_due())
        line.show(line.seconds() + ", " + std::to_string(std::lround(100 * share)) +
                  " % of the work");
    };
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
  return {"spread",
          "SCENE.toml [OPTIONS]",
          "the answer as a set: bounds of the push, the motion and the contact forces",
          "Rigid contact often leaves forces open, and now and then the motion. This takes the\n"
          "literal laws (pressure = \"rigid\", whatever the file says), goes through all contact\n"
          "modes that may have an answer, and bounds every quantity over each by linear programs:\n"
          "the ranges of every answer. Where that would take long, it says \"at least\": of the\n"
          "answers next to those that many covering vectors reach. With --break the same for the\n"
          "force that breaks the grasp.\n\n"
          "Example:\n  lcpush spread fixtures/scenes/straight_slide.toml\n",
          with_scene_options(
              {{"--break", "", "the force that just moves the object, and how it begins to move"},
               {"--enumerate", "", "look longer, a minute or so, for all contact modes"},
               {"--paths", "", "only what the covering vectors reach"},
               {"--seconds", "S", "stop after that time, with what is found; so does Ctrl-C"},
               {"--covers", "N", "covering vectors of Lemke's method to start from (32)"},
               verbose_option}),
          1,
          run_spread};
}

} // namespace lcpush::cli
