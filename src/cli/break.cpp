// lcpush break: the force that just moves the object in the grip.
#include "chosen_pusher.hpp"
#include "commands.hpp"
#include "lcpush/host/report.hpp"
#include "progress.hpp"
#include "scene_argument.hpp"
#include "sweep_history.hpp"

namespace lcpush::cli {
namespace {

int run(const Arguments& arguments) {
  const host::Solver solver = chosen_solver(arguments);
  const std::string format = push_format(arguments, solver);
  const host::SceneFile file = read_scene_argument(arguments, Needs::scene);
  const Index pusher = chosen_pusher(arguments, file);
  if (!(push_size(file.view()) > 0))
    throw UsageError("no body of the scene moves: give a pusher an acceleration");
  host::Push push(file);
  host::HoldReport hold;
  host::BreakReport report;
  host::GripReport grip;
  {
    Progress progress;
    host::PushOptions options;
    options.solver = solver;
    options.watcher = &progress;
    hold = push.holds_without_push(options);
    options.record_history = arguments.has("--history");
    report = push.find_breaking(pusher, options);
    options.record_history = false;
    options.solver = host::Solver::lemke; // the search for the grip is its own
    if (!arguments.has("--history")) grip = host::find_smallest_grip(file, hold, report, options);
  }
  std::string text;
  if (arguments.has("--history"))
    text = push_history(format, solver, report.status, report.history);
  else
    text = format == "json" ? host::break_json(file, hold, grip, report)
                            : host::break_text(file, hold, grip, report);
  write_output(arguments, text);
  return report.status == Status::solved ? 0 : 1;
}

} // namespace

Command break_command() {
  return {
      "break",
      "SCENE.toml [OPTIONS]",
      "the force that just moves the object in the grip",
      "The limit of an ever smaller push in the scene's direction: the force at which the object\n"
      "starts to move, how it then moves, and what a faster push adds.\n\n"
      "Example:\n  lcpush break fixtures/scenes/straight_slide.toml\n",
      with_common_options({{"--pusher", "NAME", "whose normal force is meant, among several"},
                           solver_option(),
                           history_option()}),
      1,
      run};
}

} // namespace lcpush::cli
