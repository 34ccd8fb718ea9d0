// Questions about where pushes take the object: in time, while they stick, and by a plan.
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/plan.hpp"
#include "text/limits.hpp"

#include <chrono>

namespace lcpush::desktop {

Told ask_move(const std::string& text, Listener& listener) {
  const Request request(
      text, scene_keys({"time", "step", "tolerance", "stop_after", "frames", "most_steps"}));
  const std::string format = request.format({"json", "text", "full_text", "csv", "svg", "html"});
  const SceneFile file = request.scene(Strokes::all);
  MoveOptions options;
  options.time = request.positive("time");
  options.step = request.positive("step");
  options.tolerance = request.positive("tolerance");
  options.distance = request.positive("stop_after").value_or(options.distance);
  options.frames = request.whole("frames", 2, limits::motion_frames).value_or(options.frames);
  options.most_steps =
      request.whole("most_steps", 1, limits::motion_solves).value_or(limits::motion_solves);
  if (options.step && options.tolerance)
    request.refuse("tolerance", "chooses steps, \"step\" is a fixed one: give one of the two");
  options.progress = [&](double done, double) { listener.pass_on(done); };
  options.is_interrupted = [&] { return listener.is_cancelled(); };
  const MotionReport report = move(file, options);
  return {report.status == Status::solved, format == "json"  ? move_json(file, report)
                                           : format == "csv" ? move_csv(file, report)
                                           : format == "svg" ? move_svg(file, report)
                                           : format == "html"
                                               ? move_html(file, report)
                                               : move_text(file, report, format == "full_text")};
}

/// "twist": vx, vy and the turn about z of the object at its centre of mass.
Told ask_cone(const std::string& text, Listener&) {
  const Request request(text, scene_keys({"twist", "pusher"}));
  const std::string format = request.format({"json", "text", "full_text", "svg"});
  const SceneFile file = request.scene();
  std::optional<Vector6<double>> twist;
  if (const auto given = request.numbers("twist", 3)) {
    twist = Vector6<double>::Zero();
    (*twist)[0] = (*given)[0];
    (*twist)[1] = (*given)[1];
    (*twist)[5] = (*given)[2];
    if (twist->isZero(0)) request.refuse("twist", "is no motion: all three numbers are 0");
  }
  const ConeReport report = find_cone(file, request.pusher(file), twist);
  return {report.status == Status::solved, format == "json" ? cone_json(file, report)
                                           : format == "svg"
                                               ? cone_svg(file, report)
                                               : cone_text(file, report, told_as(format))};
}

/// "to": x, y and angle, from where the object is.
Told ask_plan(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"to", "seconds"}));
  const std::string format = request.format({"json", "text", "full_text", "html", "toml"});
  const auto to = request.numbers("to", 3);
  if (!to) request.refuse("to", "is missing: x, y and angle, in m, m and rad");
  const SceneFile file = request.scene(Strokes::all);
  const auto begin = std::chrono::steady_clock::now();
  const std::optional<double> seconds = request.positive("seconds");
  PlanOptions options;
  options.progress = [&](double done) { listener.pass_on(done); };
  options.is_interrupted = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return listener.is_cancelled() || (seconds && passed.count() > *seconds);
  };
  const PlanReport report = find_plan(request.text("scene"), request.scene_name(),
                                      {(*to)[0], (*to)[1], (*to)[2]}, options);
  if ((format == "html" || format == "toml") && report.pushes.empty())
    request.refuse("format", "shows a plan, and none was found");
  return {report.found, format == "json"   ? plan_json(file, report)
                        : format == "html" ? move_html(report.scene, report.replay)
                        : format == "toml" ? report.scene_text
                                           : plan_text(file, report, format == "full_text")};
}

} // namespace lcpush::desktop
