// Questions that solve a scene many times, or show it.
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

/// "vary": an object or several of {"path", "from", "to"}.
std::vector<Variation> variations_of(const Request& request, const VariedScene& scene) {
  std::vector<Variation> list;
  const JsonArray* const given = request.fields().objects(*request.find("vary"), "list");
  if (given == nullptr || given->empty())
    request.refuse("vary", "needs a \"list\" of {\"path\", \"from\", \"to\"}");
  for (const JsonValue& entry : *given) {
    Variation variation;
    variation.parameter = scene.find(request.fields().text(entry, "path"));
    const auto from = request.fields().number(entry, "from"),
               to = request.fields().number(entry, "to");
    if (!from || !to) request.fields().refuse(entry, "a variation needs \"from\" and \"to\"");
    if (*from == *to) request.fields().refuse(entry, "\"from\" and \"to\" are the same");
    variation.from = *from;
    variation.to = *to;
    list.push_back(variation);
  }
  return list;
}

ParameterSweepOptions sweep_options(const Request& request, Listener& listener, Index most) {
  ParameterSweepOptions options;
  options.steps = request.whole("steps", 2, most).value_or(0);
  options.progress = [&listener](double done) {
    listener.pass_on(done);
    listener.end_if_cancelled(); // where a neighbour's basis does, nothing pivots
  };
  options.pivoted = [&listener] { listener.end_if_cancelled(); };
  return options;
}

} // namespace

Told ask_sweep(const std::string& text, Listener& listener) {
  const Request request(text, {"scene", "file", "format", "vary", "steps", "pressure", "pusher"});
  const std::string format = request.format({"json", "text", "full_text", "csv", "svg"});
  if (request.find("vary") == nullptr) request.refuse("vary", "is missing: what varies");
  const VariedScene scene = request.varied_scene();
  const SceneFile file = scene.as_given();
  refuse_unknowns(request, file, limits::unknowns_matrix, "matrix fits into 1 GB");
  const std::vector<Variation> variations = variations_of(request, scene);
  if (variations.size() > 2) request.refuse("vary", "takes one number, or two for a map");
  const bool is_map = variations.size() == 2;
  ParameterSweepOptions options =
      sweep_options(request, listener, is_map ? limits::map_steps : limits::sweep_steps);
  options.pusher = request.pusher(file);
  const std::string title = file.title.empty() ? request.scene_name() : file.title;
  std::vector<SweepCurve> curves{{"", title, std::nullopt, {}}};
  curves[0].sweep = sweep_parameter(scene, variations, options);
  return {curves[0].sweep.complete,
          format == "json"  ? sweep_json(curves, check_scene(file))
          : format == "csv" ? sweep_csv(curves)
          : format == "svg"
              ? sweep_svg(curves, title, {})
              : sweep_text(curves, format == "full_text" ? Telling::full : Telling::brief)};
}

Told ask_report(const std::string& text, Listener& listener) {
  const Request request(
      text, {"scene", "file", "format", "picture", "vary", "steps", "pressure", "pusher"});
  const std::string format = request.format({"html", "svg"});
  const VariedScene scene = request.varied_scene();
  const SceneFile file = scene.as_given();
  refuse_unknowns(request, file, limits::unknowns_held, "solution fits into 1 GB");
  std::vector<Sweep> sweeps;
  if (request.find("vary") != nullptr)
    for (const Variation& variation : variations_of(request, scene)) {
      ParameterSweepOptions options = sweep_options(request, listener, limits::report_steps);
      options.pusher = request.pusher(file);
      sweeps.push_back(sweep_parameter(scene, {variation}, options));
    }
  const bool has_pusher = file.bodies.back().role == Role::pusher;
  const bool breaks = has_pusher && push_size(file.view()) > 0;
  Push push(file);
  ListeningWatcher watcher(listener);
  PushOptions options;
  options.watcher = &watcher;
  const HoldReport hold = push.holds_without_push(options);
  BreakReport breaking;
  GripReport grip;
  if (breaks) {
    breaking = push.find_breaking(request.pusher(file), options);
    grip = find_smallest_grip(file, hold, breaking, options);
  }
  const PushReport report = push.solve(options); // last: its answer lives in the Push
  const PageContent content{file,
                            hold,
                            report,
                            breaks ? &breaking : nullptr,
                            breaks ? &grip : nullptr,
                            std::move(sweeps)};
  if (format == "html") return {is_solved(content), report_html(content)};
  const std::string wanted = request.text("picture", "front");
  std::vector<std::string> names;
  for (const Picture& picture : report_pictures(content)) {
    if (picture.name == wanted) return {is_solved(content), picture.svg};
    names.push_back(picture.name);
  }
  request.refuse("picture",
                 "must be " + listed(names, "or") + " for this scene, not " + quoted(wanted));
}

} // namespace lcpush::desktop
