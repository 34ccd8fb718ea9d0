// pivots: every pivot, and what it means.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/pivots.hpp"
#include "pivots/subject.hpp"
#include "text/wording.hpp"

namespace lcpush::commands {
namespace {

PivotSubject read_subject(const Values& values) {
  const bool is_exact = values.has("exact"), as_solved = values.has("as-solved");
  if (values.scene_count() != 1) {
    ExactMatrices raw = values.exact_matrices();
    return raw_subject({std::move(raw.M), std::move(raw.q), 0}, raw.name, is_exact);
  }
  const Document scene = values.scene_document();
  SceneFile file = parse_scene(scene.text, scene.name);
  values.inspect(file);
  file.is_round = false; // pivots are those of a pyramid
  if (!as_solved) {
    file.facets = values.whole("facets", {4, 256, true}).value_or(4);
    if (const auto law = values.text("pressure")) {
      values.one_of("pressure", *law, pressure_names());
      for (const Pressure pressure : pressures)
        if (*law == pressure_text(pressure)) file.pressure = pressure;
    }
  }
  if (const std::string refusal = unknown_shares(file); !refusal.empty())
    values.refuse("pressure", values.label("pressure") + " " + refusal);
  return scene_subject(std::move(file), scene.text, scene.name, as_solved, is_exact);
}

/// --cover d1,d2,..
std::vector<Rational> read_cover(const Values& values, Index n) {
  const auto text = values.text("cover");
  if (!text) return {};
  const std::string label = values.label("cover");
  const ExactMatrix cover = parse_inline_vector<Rational>(*text, label);
  if (cover.rows != n)
    values.refuse("cover", label + " wants " + std::to_string(n) + " numbers, one a row, got " +
                               std::to_string(cover.rows));
  for (const Rational& d : cover.values)
    if (!(d > Rational(0))) values.refuse("cover", label + " wants numbers > 0, got " + d.text());
  return cover.values;
}

void refuse_combinations(const Values& values) {
  if (values.has("as-solved"))
    for (const char* option :
         {"exact", "cover", "first-row", "z0-last", "choose", "facets", "pressure", "max-pivots"})
      if (values.has(option))
        values.refuse(option, values.label("as-solved") +
                                  " replays what `lcpush solve` does, and " + values.label(option) +
                                  " would change that; use one of them");
  for (const char* option : {"first-row", "z0-last"})
    if (values.has("choose") && values.has(option))
      values.refuse(option, values.label("choose") + " asks you for every row; " +
                                values.label(option) + " does not go with it");
  for (const char* option : {"facets", "pressure", "set"})
    if (values.scene_count() != 1 && values.has(option))
      values.refuse(option, values.label(option) + " is about scenes");
}

PivotTrace trace(const PivotSubject& subject, const Values& values, Listener& listener,
                 bool is_page) {
  const bool as_solved = values.has("as-solved");
  PivotOptions options =
      as_solved ? PivotOptions() : pivot_options(subject, values.has("exact"), is_page);
  options.pivoted = [&listener] { listener.end_if_cancelled(); };
  if (as_solved) return trace_solve(subject, options);
  options.rule = values.has("first-row") ? TieRule::first_row : TieRule::lexicographic;
  options.z0_wins_ties = !values.has("z0-last");
  options.cover = read_cover(values, subject.problem.M.rows);
  options.max_pivots = values.whole("max-pivots", {1, 1000000}).value_or(options.max_pivots);
  if (values.has("choose")) {
    options.most_entries = PivotOptions().most_entries; // who chooses sees the tableaus
    options.choose = [&listener](const PivotTrace& run) { return listener.choose_row(run); };
  }
  return trace_pivots(subject.problem, options, *subject.story);
}

Result run_pivots(const Values& values, Listener& listener) {
  const std::string format = values.format();
  refuse_combinations(values);
  const PivotSubject subject = read_subject(values);
  PivotTrace traced = trace(subject, values, listener, format == "html");
  finish_trace(traced, subject, values.has("exact"));
  const Push* const push = subject.push.get();
  return {traced.status == Status::solved, format == "json"    ? pivots_json(traced, push)
                                           : format == "latex" ? pivots_latex(traced)
                                           : format == "svg"   ? pivots_svg(traced)
                                           : format == "html"
                                               ? pivots_html(traced, push)
                                               : pivots_text(traced, values.telling(), push)};
}

} // namespace

Command pivots_command() {
  return {
      "pivots",
      "SCENE.toml | M.mtx q.mtx | --M \"2 1; 1 2\" --q \"-5 -6\" [OPTIONS]",
      "Lemke's method pivot by pivot, as text, LaTeX, SVG or a page",
      "Pivots as the textbooks do: cover d = 1, nothing scaled, ties broken lexicographically. Of "
      "a\n"
      "scene it takes the first round of its pressure law, in SI units, with four facets. A row\n"
      "of a tableau says: basic variable = value + sum of entries times nonbasic variables.\n"
      "--format html without a problem shows the example of docs/teach/lemke_by_hand.md.\n\n"
      "Examples:\n  lcpush pivots --M \"2 1; 1 2\" --q \"-5 -6\" --exact\n"
      "  lcpush pivots fixtures/scenes/straight_slide_point.toml --format html \\\n"
      "    -o pivots.html\n",
      with_common_options({
          {"M", "MATRIX", "rows by semicolons, numbers (0.2 or 1/3) by blanks"},
          {"q", "VECTOR", "n numbers"},
          {"exact", "", "in fractions, decimals taken as typed; proves the final basis"},
          {"cover", "D1,D2,..", "the covering vector, numbers > 0 (default 1 in every row)"},
          {"first-row", "", "the first tied row leaves, which may cycle (found, exit 1)"},
          {"z0-last", "", "z0 loses every tie instead of winning it, to see what goes wrong"},
          {"choose", "", "asks for the leaving row of every pivot and says what is wrong", false,
           true},
          {"max-pivots", "N", "stop after so many pivots (default 10000)"},
          {"as-solved", "", "replay what solve or lcp does: scaled, generic covers, all rounds"},
          {"facets", "G", "sides of a scene's friction pyramids (default 4)"},
          {"pressure", "LAW", "pad, even or rigid instead of the scene's"},
          {"verbose", "", "every pivot of more than 12 unknowns too; -v for short", false, true},
          set_option,
          seconds_option,
          format_option("text (default), json, latex, svg or html; --json for short", "NAME"),
      }),
      run_pivots,
      {"text", "json", "latex", "svg", "html"},
      2};
}

} // namespace lcpush::commands
