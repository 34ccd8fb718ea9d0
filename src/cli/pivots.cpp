// lcpush pivots: every pivot, and what it means.
#include "lcpush/desktop/pivots.hpp"
#include "cli/choose.hpp"
#include "cli/commands.hpp"
#include "cli/raw_arguments.hpp"
#include "cli/raw_bounds.hpp"
#include "cli/time_limit.hpp"
#include "pivots/explorer_text.hpp"
#include "pivots/subject.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

Pressure read_pressure(const Arguments& arguments, Pressure otherwise) {
  const auto text = arguments.value("--pressure");
  if (!text) return otherwise;
  for (const Pressure pressure : pressures)
    if (*text == pressure_text(pressure)) return pressure;
  refuse_value("--pressure", *text, desktop::listed(desktop::pressure_names(), "or"));
}

/// The scene file of the command line; the example if it names none.
struct SceneText {
  std::string text, name;
};

SceneText scene_text(const Arguments& arguments) {
  if (arguments.files().empty())
    return {*desktop::scene_called(desktop::example_scenes(), "coin"), "the example"};
  return {desktop::read_scene_text(arguments.files()[0]),
          desktop::scene_label(arguments.files()[0])};
}

desktop::PivotSubject scene_subject(const Arguments& arguments) {
  const auto [text, path] = scene_text(arguments);
  const bool as_solved = arguments.has("--as-solved");
  desktop::SceneFile file = desktop::parse_scene(text, path);
  if (!as_solved) {
    file.facets = arguments.whole("--facets", {4, 256, true}).value_or(4);
    file.pressure = read_pressure(arguments, file.pressure);
  }
  if (const std::string refusal = desktop::unknown_shares(file); !refusal.empty())
    throw UsageError("--pressure " + refusal);
  return desktop::scene_subject(std::move(file), text, path, as_solved, arguments.has("--exact"));
}

desktop::PivotSubject raw_subject(const Arguments& arguments) {
  auto [M, q] = read_matrices<desktop::Rational>(arguments, arguments.files());
  const std::string name = arguments.files().empty() ? "--M" : arguments.files()[0];
  return desktop::raw_subject({std::move(M), std::move(q), 0}, name, arguments.has("--exact"));
}

/// --cover d1,d2,..
std::vector<desktop::Rational> read_cover(const Arguments& arguments, Index n) {
  const auto text = arguments.value("--cover");
  if (!text) return {};
  const desktop::ExactMatrix cover =
      desktop::parse_inline_vector<desktop::Rational>(*text, "--cover");
  if (cover.rows != n)
    throw UsageError("--cover wants " + std::to_string(n) + " numbers, one a row, got " +
                     std::to_string(cover.rows));
  for (const desktop::Rational& d : cover.values)
    if (!(d > desktop::Rational(0))) throw UsageError("--cover wants numbers > 0, got " + d.text());
  return cover.values;
}

void refuse_combinations(const Arguments& arguments, bool is_scene) {
  if (arguments.has("--as-solved"))
    for (const char* option : {"--exact", "--cover", "--first-row", "--z0-last", "--choose",
                               "--facets", "--pressure", "--max-pivots"})
      if (arguments.has(option))
        throw UsageError(std::string("--as-solved replays what `lcpush solve` does, and ") +
                         option + " would change that; use one of them");
  for (const char* option : {"--first-row", "--z0-last"})
    if (arguments.has("--choose") && arguments.has(option))
      throw UsageError("--choose asks you for every row; " + std::string(option) +
                       " does not go with it");
  for (const char* option : {"--facets", "--pressure"})
    if (!is_scene && arguments.has(option))
      throw UsageError(std::string(option) + " is about scenes");
}

desktop::PivotTrace trace(const desktop::PivotSubject& subject, const Arguments& arguments) {
  if (arguments.has("--as-solved")) return desktop::trace_solve(subject);
  desktop::PivotOptions options = desktop::pivot_options(
      subject, arguments.has("--exact"), arguments.value("--format") == std::string("html"));
  // Who chooses sees the tableaus.
  if (arguments.has("--choose")) options.most_entries = desktop::PivotOptions().most_entries;
  options.rule = arguments.has("--first-row") ? TieRule::first_row : TieRule::lexicographic;
  options.z0_wins_ties = !arguments.has("--z0-last");
  options.cover = read_cover(arguments, subject.problem.M.rows);
  options.max_pivots = arguments.whole("--max-pivots", {1, 1000000}).value_or(options.max_pivots);
  if (arguments.has("--choose")) options.choose = ask_for_row;
  return desktop::trace_pivots(subject.problem, options, *subject.story);
}

int run_pivots(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json", "latex", "html"});
  const bool is_typed = arguments.has("--M") || arguments.has("--q");
  const bool is_example = arguments.files().empty() && !is_typed;
  if (is_example && format != "html")
    throw UsageError("name a scene, two files M.mtx q.mtx, or --M and --q");
  const bool is_scene = is_example || (arguments.files().size() == 1 && !is_typed);
  refuse_combinations(arguments, is_scene);
  const desktop::PivotSubject subject =
      is_scene ? scene_subject(arguments) : raw_subject(arguments);
  desktop::PivotTrace traced = trace(subject, arguments);
  desktop::finish_trace(traced, subject, arguments.has("--exact"));
  std::string text;
  if (format == "json")
    text = desktop::pivots_json(traced, subject.push.get());
  else if (format == "latex")
    text = desktop::pivots_latex(traced);
  else if (format == "html")
    text = desktop::pivots_html(traced, subject.push.get());
  else
    text = desktop::pivots_text(traced);
  if (format == "text")
    write_text(arguments, text);
  else
    write_output(arguments, text);
  return traced.status == Status::solved ? 0 : 1;
}

} // namespace

Command pivots_command() {
  return {
      "pivots",
      "SCENE.toml | M.mtx q.mtx | --M \"2 1; 1 2\" --q \"-5 -6\" [OPTIONS]",
      "watch Lemke's method pivot by pivot: text, JSON, LaTeX or a page to explore",
      "Pivots as the textbooks do: cover d = 1, nothing scaled, ties broken lexicographically. Of "
      "a\n"
      "scene it takes the first round of its pressure law, in SI units, with four facets. A row\n"
      "of a tableau says: basic variable = value + sum of entries times nonbasic variables.\n"
      "--format html without a problem shows the example of docs/teach/lemke_by_hand.md.\n\n"
      "Examples:\n  lcpush pivots --M \"2 1; 1 2\" --q \"-5 -6\" --exact\n"
      "  lcpush pivots fixtures/scenes/straight_slide_point.toml --format html -o pivots.html\n",
      with_common_options({
          {"--M", "MATRIX", "rows by semicolons, numbers (0.2 or 1/3) by blanks"},
          vector_option,
          {"--exact", "", "in fractions, decimals taken as typed; proves the final basis"},
          {"--cover", "D1,D2,..", "the covering vector, numbers > 0 (default 1 in every row)"},
          {"--first-row", "", "the first tied row leaves, which may cycle (found, exit 1)"},
          {"--z0-last", "", "z0 loses every tie instead of winning it, to see what goes wrong"},
          {"--choose", "", "asks for the leaving row of every pivot and says what is wrong"},
          {"--max-pivots", "N", "stop after so many pivots (default 10000)"},
          {"--as-solved", "", "replay what solve or lcp does: scaled, generic covers, all rounds"},
          {"--facets", "G", "sides of a scene's friction pyramids (default 4)"},
          {"--pressure", "LAW", "pad, even or rigid instead of the scene's"},
          seconds_option,
          {"--format", "NAME", "text (default), json, latex or html; --json for short"},
      }),
      2,
      run_pivots};
}

} // namespace lcpush::cli
