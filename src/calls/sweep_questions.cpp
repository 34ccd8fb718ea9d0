// Questions that solve a scene many times, or show it.
#include "calls/asked_push.hpp"
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/limits.hpp"

#include <cmath>

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
  options.pivoted = [&listener] { listener.end_if_cancelled(); };
  return options;
}

/// A curve, and its scene, for each value of "each", {"path", "values"}; one without it.
std::vector<SweepCurve> curves_of(const Request& request, const VariedScene& scene,
                                  std::vector<VariedScene>& scenes) {
  const std::string given = scene.as_given().title,
                    title = given.empty() ? request.scene_name() : given;
  std::vector<SweepCurve> curves;
  if (const JsonValue* const each = request.find("each")) {
    const JsonFields& fields = request.fields();
    const auto values = fields.numbers(*each, "values", -1);
    if (!values || values->empty()) fields.refuse(*each, "\"each\" needs \"path\" and \"values\"");
    if (values->size() > limits::curves)
      fields.refuse(*each, "\"each\" has " + std::to_string(values->size()) +
                               " values; more than " + std::to_string(limits::curves) +
                               " curves cannot be told apart");
    const Parameter parameter = scene.find(fields.text(*each, "path"));
    for (const double value : *values) {
      curves.push_back(curve_at({parameter, value, value}, title));
      scenes.push_back(scene.with(parameter, value));
    }
  } else {
    curves.push_back({"", title, std::nullopt, {}});
    scenes.push_back(scene);
  }
  for (std::size_t k = 0; k < curves.size(); ++k)
    curves[k].sweep.variations = variations_of(request, scenes[k]);
  refuse_overwritten(curves);
  return curves;
}

} // namespace

Told ask_sweep(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"vary", "each", "steps", "pressure", "pusher"}));
  const std::string format = request.format({"json", "text", "full_text", "csv", "svg"});
  if (request.find("vary") == nullptr) request.refuse("vary", "is missing: what varies");
  const VariedScene scene = request.varied_scene();
  const SceneFile file = scene.as_given();
  refuse_unknowns(request, file, limits::unknowns_matrix, "matrix fits into 1 GB");
  std::vector<VariedScene> scenes;
  std::vector<SweepCurve> curves = curves_of(request, scene, scenes);
  const std::size_t varied = curves[0].sweep.variations.size();
  if (varied > 2) request.refuse("vary", "takes one number, or two for a map");
  if (varied > 1 && curves.size() > 1) request.refuse("each", "goes without a map");
  ParameterSweepOptions options =
      sweep_options(request, listener, varied > 1 ? limits::map_steps : limits::sweep_steps);
  const std::string refusal =
      too_many_samples(std::pow(options.steps, varied) * static_cast<double>(curves.size()), file);
  if (!refusal.empty()) request.refuse("steps", "is too large: " + refusal);
  bool complete = true;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto count = static_cast<double>(curves.size());
    options.progress = [&listener, count, k](double done) {
      listener.pass_on((static_cast<double>(k) + done) / count);
      listener.end_if_cancelled(); // where a neighbour's basis does, nothing pivots
    };
    options.pusher = request.pusher(scenes[k].as_given());
    curves[k].sweep = sweep_parameter(scenes[k], curves[k].sweep.variations, options);
    complete = complete && curves[k].sweep.complete;
  }
  return {complete, format == "json"  ? sweep_json(curves, check_scene(file))
                    : format == "csv" ? sweep_csv(curves)
                    : format == "svg" ? sweep_svg(curves, sweep_title(curves))
                                      : sweep_text(curves, told_as(format))};
}

Told ask_report(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"picture", "vary", "steps", "pressure", "pusher"}));
  const std::string format = request.format({"html", "svg"});
  const VariedScene scene = request.varied_scene();
  const SceneFile file = scene.as_given();
  refuse_unknowns(request, file, limits::unknowns_held, "solution fits into 1 GB");
  std::vector<Sweep> sweeps;
  if (request.find("vary") != nullptr)
    for (const Variation& variation : variations_of(request, scene)) {
      ParameterSweepOptions options = sweep_options(request, listener, limits::report_steps);
      options.progress = [&listener](double done) {
        listener.pass_on(done);
        listener.end_if_cancelled();
      };
      options.pusher = request.pusher(file);
      sweeps.push_back(sweep_parameter(scene, {variation}, options));
    }
  AskedPush asked(file, Solver::lemke, listener);
  const bool has_pusher = file.bodies.back().role == Role::pusher;
  const bool breaks = has_pusher && push_size(file.view()) > 0;
  const HoldReport hold = asked.holds_without_push();
  BreakReport breaking;
  GripReport grip;
  if (breaks) {
    breaking = asked.push.find_breaking(request.pusher(file), asked.options);
    grip = find_smallest_grip(file, hold, breaking, asked.options);
  }
  const PushReport report = asked.push.solve(asked.options); // last: its answer lives in the Push
  const PageContent content{
      asked.file,       hold, report, breaks ? &breaking : nullptr, breaks ? &grip : nullptr,
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
