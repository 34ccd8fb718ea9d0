// What another language may ask: the tool's commands, and questions that a shell has otherwise.
#include "calls/questions.hpp"

#include "commands/asked_push.hpp"
#include "commands/values.hpp"
#include "formats/json_writer.hpp"
#include "formats/toml.hpp"
#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/lcp/problem.hpp"
#include "scenes/warnings_json.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {

static void write(JsonWriter& json, const TomlValue& value) {
  std::visit([&json](const auto& data) { json.value(data); }, value.data);
}

static void write(JsonWriter& json, const TomlTable& table) {
  json.begin_object();
  for (const TomlEntry& entry : table.entries) json.member(entry.key, entry.value);
  json.end_object();
}

} // namespace lcpush::desktop

namespace lcpush::calls {
namespace {

using namespace desktop;
using namespace commands;
using commands::Command;

Result describe_scene(const Values& values, Listener&) {
  const SceneFile file = values.scene(Needs::scene, Strokes::all);
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
  json.member("parameters", values.varied_scene(Needs::scene).paths());
  write_warnings(json, check_scene(file));
  return {true, json.end_object().text()};
}

/// The scene file as it is written: its keys, tables and lists of tables.
Result list_tables(const Values& values, Listener&) {
  const Document scene = values.scene_document();
  const TomlDocument document = parse_toml(scene.text, scene.name);
  JsonWriter json;
  json.begin_object();
  for (const TomlEntry& entry : document.root.entries) json.member(entry.key, entry.value);
  for (const TomlSection& section : document.sections) {
    json.key(section.name);
    section.is_array ? json.value(section.tables) : json.value(section.tables[0]);
  }
  return {true, json.end_object().text()};
}

/// The problem that solve solves under `rigid` and `even` pressure, in its scaled unknowns.
Result describe_problem(const Values& values, Listener& listener) {
  SceneFile file = values.scene(Needs::scene);
  values.take_pyramids(file, listener);
  values.refuse_unknowns(file, limits::unknowns_exported, "matrix fits into 1 GB as text");
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

Result export_files(const Values& values, Listener& listener) {
  SceneFile file = values.scene(Needs::scene);
  values.take_pyramids(file, listener);
  values.refuse_unknowns(file, limits::unknowns_exported, "files fit into 1 GB");
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

/// Of solve, or of break.
Result certify(const Values& values, Listener& listener) {
  SceneFile file = values.scene(Needs::scene);
  values.take_pyramids(file, listener);
  AskedPush asked(std::move(file), values.solver(), listener);
  if (const std::string refusal = uncertified_law(asked.file); !refusal.empty())
    values.refuse("scene", "a certificate " + refusal);
  const std::string scene = values.scene_document().text;
  std::optional<Certificate> certificate;
  if (values.has("break")) {
    const Index pusher = values.pusher(asked.file);
    values.refuse_still(asked.file);
    const BreakReport report = asked.push.find_breaking(pusher, asked.options);
    certificate = certify_break(scene, asked.file, asked.push, pusher, report);
  } else {
    if (values.has("pusher")) values.refuse("pusher", "\"pusher\" goes with \"break\"");
    const PushReport report = asked.push.solve(asked.options);
    certificate = certify_push(scene, asked.file, report);
  }
  if (certificate) return {true, certificate_json(*certificate)};
  JsonWriter none;
  none.begin_object().member("reason", "No certificate: exact numbers do not confirm what rounded "
                                       "ones show.");
  return {false, none.end_object().text()};
}

/// A question that is no command of the tool: about a scene, or about a raw problem.
Command question(const std::string& name, const std::string& about, std::vector<Option> options,
                 std::vector<std::string> formats,
                 Result (*run)(const Values& values, Listener& listener)) {
  if (about == "SCENE" && name != "certify") options.push_back(set_option);
  return {name, about, "", "", std::move(options), run, std::move(formats)};
}

std::vector<Command> all_questions() {
  const std::vector<std::string> json = {"json"}, words = {"text", "json"};
  const Option tolerance{"tolerance", "T", ""};
  return {question("scene", "SCENE", {}, json, describe_scene),
          question("tables", "SCENE", {}, json, list_tables),
          solve_command(),
          break_command(),
          sweep_command(),
          spread_command(),
          question("verify", "SCENE", {{"answer", "JSON", ""}, tolerance, verbose_option}, words,
                   verify_push),
          question("verify_motion", "SCENE", {{"motion", "FRAMES", ""}, tolerance, verbose_option},
                   words, verify_motion),
          move_command(),
          report_command(),
          cone_command(),
          hold_command(),
          plan_command(),
          design_command(),
          question("certify", "SCENE", {{"break", "", ""}, {"pusher", "NAME", ""}, solver_option},
                   json, certify),
          pivots_command(),
          question("export", "SCENE", {}, json, export_files),
          matrices_command(),
          question("problem", "SCENE", {}, json, describe_problem),
          lcp_command(),
          contacts_command(),
          question("verify_lcp", "",
                   with_raw_options({}, {{"z", "VECTOR", ""}, tolerance, verbose_option}), words,
                   verify_raw_problem)};
}

} // namespace

const std::vector<Command>& questions() {
  static const std::vector<Command> list = all_questions();
  return list;
}

} // namespace lcpush::calls
