// Questions that show the work: proofs, pivots, the problem for other solvers.
#include "calls/asked_push.hpp"
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/certify.hpp"
#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "pivots/subject.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

Pressure pressure_of(const Request& request, Pressure otherwise) {
  if (request.find("pressure") == nullptr) return otherwise;
  const std::string wanted = request.one_of("pressure", pressure_names());
  for (const Pressure pressure : pressures)
    if (wanted == pressure_text(pressure)) return pressure;
  return otherwise;
}

PivotSubject scene_subject_of(const Request& request, bool as_solved, bool is_exact) {
  constexpr Index least_facets = 4, most_facets = 256, usual_facets = 4;
  SceneFile file = request.scene();
  if (!as_solved) {
    file.facets = request.whole("facets", least_facets, most_facets).value_or(usual_facets);
    if (file.facets % 2 != 0) request.refuse("facets", "must be even");
    file.pressure = pressure_of(request, file.pressure);
  }
  if (const std::string refusal = unknown_shares(file); !refusal.empty())
    request.refuse("pressure", refusal);
  return scene_subject(std::move(file), request.text("scene"), request.scene_name(), as_solved,
                       is_exact);
}

PivotSubject typed_subject_of(const Request& request, bool is_exact) {
  ExactMatrix M = parse_inline_matrix<Rational>(request.text("M"), "M");
  ExactMatrix q = parse_inline_vector<Rational>(request.text("q"), "q");
  if (M.cols != M.rows) request.refuse("M", "must be square");
  if (q.rows != M.rows)
    request.refuse("q", "must have a number a row of M, " + std::to_string(M.rows) + ", not " +
                            std::to_string(q.rows));
  return raw_subject({std::move(M), std::move(q), 0}, "M", is_exact);
}

} // namespace

Told ask_certify(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"break", "pusher", "solver"}));
  request.format({"json"});
  AskedPush asked(request.scene(), request.solver(), listener);
  if (const std::string refusal = uncertified_law(asked.file); !refusal.empty())
    throw InputError(request.scene_name() + ": a certificate " + refusal);
  const std::string scene = request.text("scene");
  std::optional<Certificate> certificate;
  if (request.flag("break")) {
    const Index pusher = request.pusher(asked.file);
    refuse_still(request, asked.file);
    const BreakReport report = asked.push.find_breaking(pusher, asked.options);
    certificate = certify_break(scene, asked.file, asked.push, pusher, report);
  } else {
    if (request.find("pusher") != nullptr) request.refuse("pusher", "goes with \"break\"");
    const PushReport report = asked.push.solve(asked.options);
    certificate = certify_push(scene, asked.file, report);
  }
  if (certificate) return {true, certificate_json(*certificate)};
  JsonWriter none;
  none.begin_object().member("reason", "No certificate: exact numbers do not confirm what rounded "
                                       "ones show.");
  return {false, none.end_object().text()};
}

/// Of a scene, or of "M" and "q" as they are typed in place: "2 1; 1 2" and "-5 -6", or "1/3 ..".
Told ask_pivots(const std::string& text, Listener& listener) {
  const Request request(text, scene_keys({"M", "q", "exact", "as_solved", "facets", "pressure"}));
  const std::string format = request.format({"json", "text", "latex", "html"});
  const bool is_exact = request.flag("exact"), as_solved = request.flag("as_solved");
  const bool is_scene = request.find("scene") != nullptr;
  for (const char* key : {"facets", "pressure"})
    if (request.find(key) != nullptr && (as_solved || !is_scene))
      request.refuse(key, "is about a scene that is not shown as solved");
  if (is_exact && as_solved) request.refuse("exact", "goes without \"as_solved\"");
  const PivotSubject subject = is_scene ? scene_subject_of(request, as_solved, is_exact)
                                        : typed_subject_of(request, is_exact);
  PivotOptions options =
      as_solved ? PivotOptions() : pivot_options(subject, is_exact, format == "html");
  options.pivoted = [&listener] { listener.end_if_cancelled(); };
  PivotTrace trace = as_solved ? trace_solve(subject, options)
                               : trace_pivots(subject.problem, options, *subject.story);
  finish_trace(trace, subject, is_exact);
  const Push* const push = subject.push.get();
  return {trace.status == Status::solved, format == "json"    ? pivots_json(trace, push)
                                          : format == "latex" ? pivots_latex(trace)
                                          : format == "html"  ? pivots_html(trace, push)
                                                              : pivots_text(trace)};
}

Told ask_export(const std::string& text, Listener&) {
  const Request request(text, scene_keys({}));
  request.format({"json"});
  const SceneFile file = request.scene();
  refuse_unknowns(request, file, limits::unknowns_exported, "files fit into 1 GB");
  const Export result = export_scene(file);
  JsonWriter json;
  json.begin_object().objects("files", result.files, [&](const ExportFile& one) {
    json.member("name", one.name).member("text", one.text);
  });
  json.member("absent", result.absent).member("unknowns", result.unknowns);
  json.member("free", result.free).member("units", result.units);
  json.member("fclib_refusal", result.fclib_refusal);
  return {true, json.end_object().text()};
}

} // namespace lcpush::desktop
