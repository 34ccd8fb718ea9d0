// lcpush plan: pushes that take the object to another place in the grip.
#include "lcpush/desktop/plan.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/stop_signal.hpp"
#include "cli/time_limit.hpp"
#include "lcpush/desktop/input_error.hpp"

#include <cmath>

namespace lcpush::cli {
namespace {

constexpr double most_turn = 12.6; // rad

int run_plan(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json", "html", "toml"});
  const auto to = arguments.numbers("--to", 3, "x y angle (m, m and rad)");
  if (!to) throw UsageError("--to \"x y angle\" says where the object is to go, in m, m and rad");
  if (std::abs((*to)[2]) > most_turn)
    throw UsageError("--to: a turn of " + desktop::brief((*to)[2]) +
                     " rad is more than twice round; it is in rad, not in degrees");
  if (arguments.files().empty()) refuse_no_scene();
  const std::string text = read_scene_text(arguments.files()[0]);
  const std::string label = scene_label(arguments.files()[0]);
  const SceneFile file = parse_scene(text, label, Strokes::all);
  if (arguments.has("--strict")) refuse_doubts(file);
  const double seconds =
      arguments.number("--seconds", 1e6, "it is in seconds").value_or(usual_seconds);
  PlanReport report;
  {
    StatusLine line;
    PlanOptions options;
    options.progress = [&](double done) {
      if (line.is_due())
        line.show(line.seconds() + ", " + std::to_string(std::lround(100 * done)) +
                  " % of the places that are tried");
    };
    listen_for_signals();
    limit_time("plan", seconds + usual_seconds); // the replay is finished
    options.is_interrupted = [seconds] { return is_asked_to_end() || is_over(seconds); };
    report = find_plan(text, label, {(*to)[0], (*to)[1], (*to)[2]}, options);
  }
  if (format == "html" || format == "toml") {
    if (report.pushes.empty())
      throw InputError(scene_label(arguments.files()[0]) +
                       (report.found ? ": no push is needed, so there is none to show"
                                     : ": no plan was found, so there is none to show; `lcpush "
                                       "plan` without --format says how near it came"));
  }
  write_answer(arguments, format,
               format == "json"   ? plan_json(file, report)
               : format == "html" ? move_html(report.scene, report.replay)
               : format == "toml" ? report.scene_text
                                  : plan_text(file, report, arguments.has("--verbose")),
               file);
  return report.found ? 0 : 1;
}

} // namespace

Command plan_command() {
  return {
      "plan",
      "SCENE.toml --to \"X Y ANGLE\" [OPTIONS]",
      "pushes against the scene's pushers that take the object to another place",
      "Takes the scene's pushers for fixed features of the environment, against which the hand\n"
      "can push the object, each where the scene has it touch. Looks for places on the way\n"
      "that are joined by pushes in which the pusher sticks (see `lcpush cone`), the shortest\n"
      "way with few changes of pusher. The plan is replayed by `lcpush move`, and what is\n"
      "printed is where that ends.\n\n"
      "Examples:\n"
      "  lcpush plan docs/guide/square.toml --to \"-0.04 0.02 0.1\"\n"
      "  lcpush plan docs/guide/square.toml --to \"-0.04 0.02 0.1\" --format html -o p.html\n",
      with_scene_options(
          {{"--to", "\"X Y ANGLE\"",
            "where the centre of mass is to go from where it is (m), and the turn (rad)"},
           verbose_option,
           {"--seconds", "S", "search for so much processor time at most (8)"},
           {"--format", "FORMAT",
            "text (default), json, html (the replay as a page) or toml (a scene with the plan's "
            "strokes); --json for short"}}),
      1,
      run_plan};
}

} // namespace lcpush::cli
