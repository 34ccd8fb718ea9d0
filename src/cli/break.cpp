// lcpush break: the force that just moves the object in the grip.
#include "cli/certificate.hpp"
#include "cli/commands.hpp"
#include "cli/history.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "lcpush/desktop/report.hpp"

namespace lcpush::cli {
namespace {

int run_break(const Arguments& arguments) {
  const Solver solver = chosen_solver(arguments);
  const std::string format = push_format(arguments, solver);
  const SceneFile file = read_scene_argument(arguments, Needs::scene);
  check_certifiable(arguments, file);
  const Index pusher = chosen_pusher(arguments, file);
  if (!(push_size(file.view()) > 0))
    throw UsageError("no body of the scene moves: give a pusher an acceleration");
  Push push(file);
  HoldReport hold;
  BreakReport report;
  GripReport grip;
  {
    Progress progress;
    PushOptions options;
    options.solver = solver;
    options.watcher = &progress;
    hold = push.holds_without_push(options);
    options.record_history = arguments.has("--history");
    report = push.find_breaking(pusher, options);
    options.record_history = false;
    options.solver = Solver::lemke; // the search for the grip is its own
    if (!arguments.has("--history")) grip = find_smallest_grip(file, hold, report, options);
  }
  write_answer(arguments, format,
               arguments.has("--history")
                   ? push_history(format, solver, report.status, report.history)
               : format == "json" ? break_json(file, hold, grip, report)
                                  : break_text(file, hold, grip, report, telling(arguments)),
               file);
  const bool is_proved = write_certificate(arguments, [&] {
    return certify_break(read_scene_text(arguments.files()[0]), file, push, pusher, report);
  });
  return report.status == Status::solved && is_proved ? 0 : 1;
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
      with_scene_options({{"--pusher", "NAME", "whose normal force is meant, among several"},
                          verbose_option,
                          solver_option,
                          history_option,
                          certify_option}),
      1,
      run_break};
}

} // namespace lcpush::cli
