// lcpush report: a push as a page to look at.
#include <unistd.h>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

/// Whose breaking force is asked for, or -1: nothing pushes, or nothing moves.
Index breaking_pusher(const Arguments& arguments, const SceneFile& file) {
  const bool has_pusher = file.bodies.back().role == Role::pusher;
  const bool is_needed = arguments.has("--pusher") || arguments.has("--vary");
  if (!has_pusher && !is_needed) return -1;
  const Index pusher = chosen_pusher(arguments, file);
  return push_size(file.view()) > 0 ? pusher : -1;
}

std::vector<Sweep> swept(const Arguments& arguments, const VariedScene& scene,
                         const SceneFile& file) {
  std::vector<Variation> variations;
  for (const std::string& text : arguments.values("--vary"))
    variations.push_back(read_variation(scene, text));
  if (variations.empty() && arguments.has("--steps"))
    throw UsageError("--steps goes with --vary PATH=FROM:TO");
  ParameterSweepOptions options;
  options.steps = arguments.whole("--steps", {2, limits::report_steps}).value_or(0);
  std::vector<Sweep> sweeps;
  if (!variations.empty()) options.pusher = chosen_pusher(arguments, file);
  for (const Variation& variation : variations) {
    StatusLine line;
    options.progress = [&line](double done) { line.show_share(done); };
    sweeps.push_back(sweep_parameter(scene, {variation}, options));
  }
  return sweeps;
}

std::string one_picture(const Arguments& arguments, const PageContent& content) {
  const std::string wanted = arguments.value("--picture").value_or("front");
  std::vector<std::string> names;
  for (const Picture& picture : report_pictures(content)) {
    if (picture.name == wanted) return picture.svg;
    names.push_back(picture.name);
  }
  refuse_value("--picture", wanted, listed(names, "or") + " for this scene", names);
}

int run_report(const Arguments& arguments) {
  const std::string format = arguments.has("--format") ? arguments.format({"html", "svg"}) : "html";
  if (format == "html" && !arguments.has("--output") && isatty(STDOUT_FILENO) != 0)
    throw UsageError("a page is for a browser: say where to with -o report.html");
  if (arguments.has("--picture") && format != "svg")
    throw UsageError("--picture goes with --format svg");
  if (arguments.files().empty()) refuse_no_scene();
  const Needs needs = arguments.has("--vary") ? Needs::matrix : Needs::scene;
  VariedScene scene = read_varied_scene(arguments, arguments.files()[0], needs);
  const SceneFile file = scene.as_given();
  const Index pusher = breaking_pusher(arguments, file);
  // Before anything is solved: what is typed wrong should not take long to say.
  std::vector<Sweep> sweeps = swept(arguments, scene, file);
  Push push(file);
  HoldReport hold;
  BreakReport breaking;
  GripReport grip;
  PushReport report;
  {
    Progress progress;
    PushOptions options;
    options.watcher = &progress;
    hold = push.holds_without_push(options);
    if (pusher >= 0) {
      breaking = push.find_breaking(pusher, options);
      grip = find_smallest_grip(file, hold, breaking, options);
    }
    report = push.solve(options); // last: its answer lives in the Push
  }
  const PageContent content{file,
                            hold,
                            report,
                            pusher >= 0 ? &breaking : nullptr,
                            pusher >= 0 ? &grip : nullptr,
                            std::move(sweeps)};
  write_answer(arguments, format,
               format == "svg" ? one_picture(arguments, content) : report_html(content), file);
  return is_solved(content) ? 0 : 1;
}

} // namespace

Command report_command() {
  return {
      "report",
      "SCENE.toml [OPTIONS]",
      "one page to look at: the grasp in pictures, the answer in words, plots",
      "Writes a page for a browser that needs nothing else: the grasp in three views with forces,\n"
      "friction pyramids, contact modes and the axis that the object turns about; the answers of\n"
      "`solve` and `break` in words; contacts, residuals, and a plot for each --vary (as in\n"
      "`sweep`). A push without an answer gives a page that says why.\n\n"
      "With --format svg one picture alone: isometric, front, top or side, friction, residuals,\n"
      "sweep1, ..\n\n"
      "Examples:\n"
      "  lcpush report fixtures/scenes/pivot.toml -o report.html\n"
      "  lcpush report fixtures/scenes/pivot.toml --vary edge.friction=0:1 -o r.html\n"
      "  lcpush report fixtures/scenes/pivot.toml --format svg --picture front -o f.svg\n",
      with_scene_options(
          {{"--vary", "PATH=FROM:TO", "also a plot of a sweep; may be given several times", true},
           {"--steps", "N", "points of the sweeps, evenly spread, ends included"},
           pressure_option,
           {"--pusher", "NAME", "whose breaking force is meant, among several"},
           {"--format", "FORMAT", "html (default), or svg for one picture"},
           {"--picture", "NAME", "which one, with --format svg (front)"}}),
      1,
      run_report};
}

} // namespace lcpush::cli
