// Questions about a scene.
#include "calls/asked_push.hpp"
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/matrices.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/report.hpp"
#include "lcpush/desktop/spread.hpp"
#include "lcpush/desktop/trajectory.hpp"
#include "lcpush/desktop/verify.hpp"
#include "lcpush/lcp/problem.hpp"
#include "scenes/warnings_json.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

using Keys = std::vector<std::string>;

const Keys words_and_json{"json", "text", "full_text"};

} // namespace

Told ask_scene(const std::string& text, Listener&) {
  const Request request(text, scene_keys({}));
  request.format({"json"});
  const SceneFile file = request.scene(Strokes::all);
  JsonWriter json;
  json.begin_object().member("title", file.title).member("hand", hand_text(file.hand));
  json.list("bodies", static_cast<Index>(file.bodies.size()), [&](Index b) {
    const Body<double>& body = file.body(b);
    json.begin_object()
        .member("name", file.body_name(b))
        .member("role", body.role == Role::pusher ? "pusher" : "finger")
        .member("points", body.point_count)
        .member("friction", body.friction)
        .end_object();
  });
  json.member("parameters", request.varied_scene().paths());
  write_warnings(json, check_scene(file));
  return {true, json.end_object().text()};
}

Told ask_solve(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"solver"}));
  const std::string format = request.format(words_and_json);
  AskedPush asked(request.scene(), request.solver(), listener);
  const HoldReport hold = asked.holds_without_push();
  const PushReport report = asked.push.solve(asked.options);
  return {report.status == Status::solved,
          format == "json" ? solve_json(asked.file, hold, report)
                           : solve_text(asked.file, hold, report, told_as(format))};
}

Told ask_break(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"solver", "pusher"}));
  const std::string format = request.format(words_and_json);
  AskedPush asked(request.scene(), request.solver(), listener);
  const Index pusher = request.pusher(asked.file);
  refuse_still(request, asked.file);
  const HoldReport hold = asked.holds_without_push();
  const BreakReport report = asked.push.find_breaking(pusher, asked.options);
  asked.options.solver = Solver::lemke; // the search for the grip is its own
  const GripReport grip = find_smallest_grip(asked.file, hold, report, asked.options);
  return {report.status == Status::solved,
          format == "json" ? break_json(asked.file, hold, grip, report)
                           : break_text(asked.file, hold, grip, report, told_as(format))};
}

Told ask_spread(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"break", "covers", "enumerate", "paths", "seconds"}));
  const std::string format = request.format(words_and_json);
  const SceneFile file = request.scene();
  SpreadOptions options;
  options.breaking = request.flag("break");
  options.covering_vectors =
      request.whole("covers", 1, limits::covers).value_or(options.covering_vectors);
  if (request.flag("enumerate") && request.flag("paths"))
    request.refuse("paths", "goes without \"enumerate\": all contact modes, or the paths alone");
  if (request.flag("enumerate")) options.enumeration = Enumeration::thorough;
  if (request.flag("paths")) options.enumeration = Enumeration::none;
  options.most_seconds = request.positive("seconds").value_or(0);
  if (options.breaking) refuse_still(request, file);
  refuse_unknowns(request, file, limits::unknowns_spread, "faces can be bounded");
  ListeningWatcher watcher(listener);
  options.watcher = &watcher;
  options.is_interrupted = [&] { return listener.is_cancelled(); };
  options.progress = [&](double share) { listener.pass_on(share); };
  const SpreadReport report = find_spread(file, options);
  return {report.status == Status::solved, format == "json"
                                               ? spread_json(file, report)
                                               : spread_text(file, report, told_as(format))};
}

Told ask_verify(const std::string& text, Listener&) {
  const Request request(text, scene_keys({"answer", "tolerance"}));
  const std::string format = request.format(words_and_json);
  if (request.find("answer") == nullptr)
    request.refuse("answer", "is missing: the text of a JSON object as solve gives it");
  VerifyOptions options;
  options.tolerance = request.positive("tolerance").value_or(options.tolerance);
  const SceneFile file = request.scene();
  const ForeignAnswer answer = parse_foreign_answer(request.text("answer"), "answer", file);
  const VerifyReport report = verify_answer(file, answer, options);
  return {is_valid(report.verdict), format == "json" ? verify_json(report, check_scene(file))
                                                     : verify_text(file, report, told_as(format))};
}

Told ask_verify_motion(const std::string& text, Listener&) {
  constexpr double usual_tolerance = 0.01;
  const Request request(text, scene_keys({"motion", "tolerance"}));
  const std::string format = request.format(words_and_json);
  if (request.find("motion") == nullptr)
    request.refuse("motion", "is missing: the text of frames as move gives them, JSON or CSV");
  const double tolerance = request.positive("tolerance").value_or(usual_tolerance);
  const SceneFile file = request.scene(Strokes::all);
  const TrajectoryReport report =
      verify_trajectory(file, parse_trajectory(request.text("motion"), "motion", file), tolerance);
  return {report.verdict == TrajectoryVerdict::follows,
          format == "json" ? trajectory_json(file, report) : trajectory_text(file, report)};
}

Told ask_matrices(const std::string& text, Listener&) {
  const Request request(text, scene_keys({}));
  const std::string format = request.format({"json", "text"});
  const SceneFile file = request.scene();
  const PaperMatrices matrices = paper_matrices(file);
  return {true, format == "json" ? matrices_json(matrices, check_scene(file))
                                 : matrices_text(file, matrices)};
}

/// The problem that solve solves under `rigid` and `even` pressure, in its scaled unknowns.
Told ask_problem(const std::string& text, Listener&) {
  const Request request(text, scene_keys({}));
  request.format({"json"});
  const SceneFile file = request.scene();
  refuse_unknowns(request, file, limits::unknowns_exported, "matrix fits into 1 GB as text");
  Push push(file);
  const Problem<double> problem = push.assembly().problem();
  const Index n = problem.size;
  Eigen::MatrixXd M(n, n);
  fill_matrix(problem, Eigen::Map<Eigen::MatrixXd>(M.data(), n, n));
  const Scales<double>& scales = push.layout().scales;
  JsonWriter json;
  json.begin_object();
  json.list("M", n, [&](Index i) { json.value(Eigen::VectorXd(M.row(i))); });
  json.member("q", std::vector<double>(problem.q, problem.q + n));
  json.list("names", n, [&](Index i) { json.value(push.variable_name(i)); });
  std::vector<Index> free;
  for (Index i = problem.free_begin; i < n; ++i) free.push_back(i + 1);
  json.member("free", free);
  json.key("scales")
      .begin_object()
      .member("force", scales.force)
      .member("length", scales.length)
      .member("acceleration", scales.acceleration)
      .end_object();
  return {true, json.end_object().text()};
}

} // namespace lcpush::desktop
