// lcpush solve: the push that the scene prescribes.
#include "cli/certificate.hpp"
#include "cli/commands.hpp"
#include "cli/history.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "lcpush/desktop/report.hpp"

namespace lcpush::cli {
namespace {

int run_solve(const Arguments& arguments) {
  const Solver solver = chosen_solver(arguments);
  const std::string format = push_format(arguments, solver);
  const SceneFile file = read_scene_argument(arguments, Needs::scene);
  check_certifiable(arguments, file);
  Push push(file);
  HoldReport hold;
  PushReport report;
  {
    Progress progress;
    PushOptions options;
    options.solver = solver;
    options.record_history = arguments.has("--history");
    options.watcher = &progress;
    hold = push.holds_without_push(options);
    report = push.solve(options);
  }
  write_answer(arguments, format,
               arguments.has("--history")
                   ? push_history(format, solver, report.status, report.history)
               : format == "json" ? solve_json(file, hold, report)
                                  : solve_text(file, hold, report, telling(arguments)),
               file);
  const bool is_proved = write_certificate(
      arguments, [&] { return certify_push(read_scene_text(arguments.files()[0]), file, report); });
  return report.status == Status::solved && is_proved ? 0 : 1;
}

} // namespace

Command solve_command() {
  return {"solve",
          "SCENE.toml [OPTIONS]",
          "what a push does: forces, motion in the grip, contact modes",
          "Reads a scene, assembles its complementarity problem and solves it by Lemke's pivots.\n"
          "Accelerations are the object's, in the gripper's frame and SI units.\n\n"
          "Example:\n  lcpush solve fixtures/scenes/straight_slide.toml\n",
          with_scene_options({verbose_option, solver_option, history_option, certify_option}),
          1,
          run_solve};
}

} // namespace lcpush::cli
