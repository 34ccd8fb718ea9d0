// verify: is somebody else's answer right?
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/trajectory.hpp"
#include "lcpush/desktop/verify.hpp"

namespace lcpush::commands {
namespace {

VerifyOptions verify_options(const Values& values) {
  VerifyOptions options;
  options.tolerance = values.number("tolerance", 1, ", such as 1e-6").value_or(options.tolerance);
  return options;
}

Result run_verify(const Values& values, Listener& listener) {
  if (values.has("trajectory")) return verify_motion(values, listener);
  if ((values.has("lcp") || values.has("M")) && values.has("set"))
    values.refuse("set", values.label("set") + " is about scenes");
  if (values.has("lcp") || values.has("M")) return verify_raw_problem(values, listener);
  for (const char* option : {"q", "free", "lo", "hi", "findex"})
    if (values.has(option))
      values.refuse(option, values.label(option) + " goes with " + values.label("lcp"));
  return verify_push(values, listener);
}

} // namespace

Result verify_push(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const VerifyOptions options = verify_options(values);
  const Document answer = values.answer();
  SceneFile file = values.scene(Needs::matrix);
  const ForeignAnswer given =
      parse_foreign_answer(answer.text, answer.name, file, options.tolerance);
  if (file.is_round && file.lines.facets == 0 && given.facets) {
    file.is_round = false;
    file.facets = *given.facets;
    listener.announce("Judged by pyramids of " + std::to_string(file.facets) +
                      " facets, as the answer says.");
  }
  const VerifyReport report = verify_answer(file, given, options);
  return {is_valid(report.verdict), format == "json" ? verify_json(report, check_scene(file))
                                                     : verify_text(file, report, values.telling())};
}

Result verify_motion(const Values& values, Listener&) {
  constexpr double usual_tolerance = 0.01;
  const std::string format = values.format();
  const Document motion = values.trajectory();
  const double tolerance =
      values.number("tolerance", 1, ", such as 0.01").value_or(usual_tolerance);
  const SceneFile file = values.scene(Needs::scene, Strokes::all);
  const TrajectoryReport report =
      verify_trajectory(file, parse_trajectory(motion.text, motion.name, file), tolerance);
  return {report.verdict == TrajectoryVerdict::follows,
          format == "json" ? trajectory_json(file, report) : trajectory_text(file, report)};
}

Result verify_raw_problem(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const RawProblem problem = values.raw_problem();
  announce_infinite(problem, listener);
  const RawVerifyReport report = verify_raw(problem, values.z(problem), verify_options(values));
  return {is_valid(report.verdict),
          format == "json" ? verify_json(report) : verify_text(report, values.telling())};
}

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
      "step is computed again by the laws, from the motion's own state at its start, and the\n"
      "ends are compared; forces, if there are some, are judged by each law.\n\n"
      "The least ANSWER.json, of forces on the object (N), and the least CSV of a motion in the\n"
      "hand's frame, from 0 at the start (s, m; qw, qx, qy, qz if it turns):\n"
      "  {\"bodies\": [{\"name\": \"wall\", \"force\": [4.7, 1.2, 0]}]}\n"
      "  time,x,y,z\n\n"
      "Example:\n"
      "  lcpush solve fixtures/scenes/tipping.toml --json -o answer.json\n"
      "  lcpush verify fixtures/scenes/tipping.toml answer.json\n",
      with_scene_options(with_raw_options(
          {
              {"tolerance", "T", "what a row may be off by, scaled (default 1e-6)"},
              {"trajectory", "FILE",
               "a motion, JSON or CSV; then T is a part of the fastest speed and of "
               "the largest force (0.01)"},
              {"lcp", "", "a raw problem: M.mtx q.mtx ANSWER.json"},
          },
          {verbose_option})),
      run_verify,
      {"text", "json"},
      3,
      false,
      {},
      "0 the answer, or motion, is right, 1 it is not (the output says why)"};
}

} // namespace lcpush::commands
