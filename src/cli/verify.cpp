// lcpush verify: is somebody else's answer right?
#include "lcpush/desktop/verify.hpp"
#include "cli/commands.hpp"
#include "cli/raw_arguments.hpp"
#include "cli/raw_bounds.hpp"
#include "cli/scene_arguments.hpp"
#include "formats/json_fields.hpp"
#include "lcpush/desktop/trajectory.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"

namespace lcpush::cli {
namespace {

VerifyOptions verify_options(const Arguments& arguments) {
  VerifyOptions options;
  options.tolerance =
      arguments.number("--tolerance", 1, ", such as 1e-6").value_or(options.tolerance);
  return options;
}

/// The z of `lcpush lcp --json`, or of an object that has nothing else.
std::vector<double> read_z(const std::string& path) {
  const JsonValue root = parse_json(read_text_file(path, limits::answer_bytes), path);
  const JsonFields fields(path);
  if (root.as<JsonObject>() == nullptr)
    fields.refuse(root, std::string("an answer is a JSON object, got ") + root.type());
  const auto z = fields.numbers(root, "z", -1);
  if (!z) fields.refuse(root, "nothing to verify: give \"z\": [n numbers]");
  return *z;
}

int verify_raw_problem(const Arguments& arguments, const std::string& format) {
  std::vector<std::string> files = arguments.files();
  if (files.empty())
    throw UsageError("files are needed: M.mtx q.mtx ANSWER.json (or --M, --q and ANSWER.json)");
  const std::string answer = files.back();
  files.pop_back();
  const RawProblem problem = read_raw_problem(arguments, files);
  const RawVerifyReport report = verify_raw(problem, read_z(answer), verify_options(arguments));
  if (format == "json")
    write_output(arguments, verify_json(report));
  else
    write_text(arguments, verify_text(report, telling(arguments)));
  return is_valid(report.verdict) ? 0 : 1;
}

int verify_motion(const Arguments& arguments, const std::string& format) {
  constexpr double usual_tolerance = 0.01;
  if (arguments.files().size() != 1)
    throw UsageError("--trajectory needs one file beside it: SCENE.toml");
  const SceneFile file = read_scene_argument(arguments, Needs::scene, Strokes::all);
  const TrajectoryReport report = verify_trajectory(
      file, read_trajectory(*arguments.value("--trajectory"), file),
      arguments.number("--tolerance", 1, ", such as 0.01").value_or(usual_tolerance));
  write_answer(arguments, format,
               format == "json" ? trajectory_json(file, report) : trajectory_text(file, report),
               file);
  return report.verdict == TrajectoryVerdict::follows ? 0 : 1;
}

int run_verify(const Arguments& arguments) {
  const std::string format = arguments.format();
  if (arguments.has("--trajectory")) return verify_motion(arguments, format);
  if (arguments.has("--lcp") || arguments.has("--M")) return verify_raw_problem(arguments, format);
  for (const char* option : {"--q", "--free", "--lo", "--hi", "--findex"})
    if (arguments.has(option)) throw UsageError(std::string(option) + " goes with --lcp");
  if (arguments.files().size() != 2)
    throw UsageError(arguments.files().size() == 3
                         ? "three files are M.mtx q.mtx ANSWER.json: say --lcp"
                         : "two files are needed: SCENE.toml ANSWER.json");
  const VerifyOptions options = verify_options(arguments);
  const SceneFile file = read_scene_argument(arguments);
  const ForeignAnswer answer = read_foreign_answer(arguments.files()[1], file);
  const VerifyReport report = verify_answer(file, answer, options);
  const std::vector<SceneDoubt> doubts = check_scene(file);
  write_answer(arguments, format,
               format == "json" ? verify_json(report, doubts)
                                : verify_text(file, report, telling(arguments)),
               doubts);
  return is_valid(report.verdict) ? 0 : 1;
}

} // namespace

Command verify_command() {
  return {
      "verify",
      "SCENE.toml ANSWER.json | SCENE.toml --trajectory FILE | --lcp M.mtx q.mtx ANSWER.json",
      "is somebody else's answer right, and if not, why?",
      "ANSWER.json has the shape of `lcpush solve --json`, or any part of it: the forces, or\n"
      "the motion, alone; what follows is filled in. Every law is checked row by row, by code\n"
      "that solves nothing, and the answer is compared with lcpush's own. With --lcp (or --M\n"
      "and --q) it is the z of a raw problem, in a box if one is given, as for `lcpush lcp`.\n"
      "With --trajectory it is a motion, frames as of `lcpush move --json` or --format csv: each\n"
      "step is compared with the laws' own, begun where the motion is, and forces, if there are\n"
      "some, are judged by each law. Here exit status 0 means valid, 1 not.\n\n"
      "Example:\n"
      "  lcpush solve fixtures/scenes/tipping.toml --json -o answer.json\n"
      "  lcpush verify fixtures/scenes/tipping.toml answer.json\n",
      with_scene_options({
          {"--tolerance", "T", "what a row may be off by, scaled (default 1e-6)"},
          {"--trajectory", "FILE",
           "a motion, JSON or CSV; then T is a part of the fastest speed and of "
           "the largest force (0.01)"},
          {"--lcp", "", "a raw problem: M.mtx q.mtx ANSWER.json"},
          matrix_option,
          vector_option,
          free_option,
          lo_option,
          hi_option,
          findex_option,
          verbose_option,
      }),
      3,
      run_verify};
}

} // namespace lcpush::cli
