// lcpush move: where the object ends up.
#include "lcpush/desktop/move.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/stop_signal.hpp"
#include "cli/time_limit.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

#include <cmath>
#include <iostream>

namespace lcpush::cli {
namespace {

constexpr double longest_time = 1e6, largest_length = 1e6;

MoveOptions move_options(const Arguments& arguments, const SceneFile& file) {
  MoveOptions options;
  options.time = arguments.number("--time", longest_time, ", in seconds, such as 2.5");
  options.step = arguments.number("--step", longest_time, ", in seconds, such as 0.001");
  options.tolerance = arguments.number("--tolerance", largest_length, ", in metres, such as 1e-4");
  if (const auto way =
          arguments.number("--stop-after", largest_length, ", in metres, such as 0.03"))
    options.distance = *way;
  options.frames = arguments.whole("--frames", {2, limits::motion_frames}).value_or(options.frames);
  options.most_steps = limits::motion_solves;
  if (options.step && options.tolerance)
    throw UsageError("--step is a fixed step, --tolerance chooses steps; give one of the two");
  const double time = options.time.value_or(motion_time(file));
  if (options.step && time / *options.step > static_cast<double>(limits::motion_solves))
    throw UsageError("--step " + shown(*options.step) + " over " + shown(time) +
                     " s makes more than the " + std::to_string(limits::motion_solves) +
                     " steps that are made; ask for a longer step or less time");
  return options;
}

int run_move(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json", "csv", "svg", "html"});
  const SceneFile file = read_scene_argument(arguments, Needs::scene, Strokes::all);
  MoveOptions options = move_options(arguments, file);
  const double seconds =
      arguments.number("--seconds", longest_time, ", in seconds").value_or(usual_seconds);
  MotionReport report;
  {
    StatusLine line;
    options.progress = [&](double done, double time) {
      if (line.is_due())
        line.show(line.seconds() + ", " + std::to_string(std::lround(100 * done)) +
                  " % of the motion, at " + printed("%.3g s", time));
    };
    listen_for_signals();
    limit_time("move", seconds + usual_seconds); // a step under way is finished
    options.is_interrupted = [seconds] { return is_asked_to_end() || is_over(seconds); };
    report = move(file, options);
  }
  if (report.end == MoveEnd::stopped && !is_asked_to_end())
    std::cerr << wrapped("lcpush move: stopped after " + shown(seconds) +
                             " s of processor time; --seconds " + shown(10 * seconds) +
                             " gives it more.\n",
                         columns_of(Stream::errors));
  write_answer(arguments, format,
               format == "json"   ? move_json(file, report)
               : format == "csv"  ? move_csv(file, report)
               : format == "svg"  ? move_svg(file, report)
               : format == "html" ? move_html(file, report)
                                  : move_text(file, report, arguments.has("--verbose")),
               file);
  return report.status == Status::solved ? 0 : 1;
}

} // namespace

Command move_command() {
  return {
      "move",
      "SCENE.toml [OPTIONS]",
      "where the object ends up: the push goes on, step by step",
      "Follows the object while the pushers move on: each step in time is a push of its own, over\n"
      "the contacts as they then are. Points leave faces and come back, patches let go, a "
      "cylinder\n"
      "rolls. Pushers move with their velocity, or speed up from rest by their acceleration.\n\n"
      "Steps are halved until a step agrees with two of half the length, and where a contact\n"
      "begins to slip, sticks, parts or leaves its face. A step without an answer ends the motion\n"
      "there, and the answer says why.\n\n"
      "Examples:\n"
      "  lcpush move fixtures/scenes/pivot.toml --time 0.8\n"
      "  lcpush move fixtures/scenes/pivot.toml --format html -o pivot.html\n",
      with_scene_options(
          {{"--time", "S", "how long (to the end of the last stroke, else 1 s)"},
           {"--stop-after", "M", "end once a contact point's place on the object has gone so far"},
           {"--step", "S", "steps of this length, without control"},
           {"--tolerance", "M", "error of the whole path (a thousandth of the object's size)"},
           {"--frames", "N", "moments that are kept, evenly spread, ends included (101)"},
           verbose_option,
           {"--seconds", "S",
            "stop after so much processor time (8), with what there is; so does Ctrl-C"},
           {"--format", "FORMAT", "text (default), json, csv, svg or html; --json for short"}}),
      1,
      run_move};
}

} // namespace lcpush::cli
