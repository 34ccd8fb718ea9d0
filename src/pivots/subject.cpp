#include "pivots/subject.hpp"

#include <algorithm>

#include "lcpush/desktop/input_error.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

constexpr Index always_exact = 150; // then ties are ties, not rounding's

void refuse_size(const std::string& what, Index n, bool is_exact) {
  const auto refuse_above = [&](Index most, const std::string& why) {
    if (n > most)
      throw InputError(what + ": " + std::to_string(n) + " unknowns are more than the " +
                       std::to_string(most) + why);
  };
  refuse_above(limits::unknowns_traced, " whose pivots can be shown; use fewer points");
  if (is_exact)
    refuse_above(limits::unknowns_exact, " that fractions can be pivoted for; leave --exact out");
}

/// Is the work in fractions over in a few seconds?
bool is_short(const ExactProblem& problem) {
  constexpr std::size_t most_bits = 32000; // of the last tableau's determinants, about
  std::size_t longest = 1;
  for (const Rational& x : problem.M.values) longest = std::max(longest, x.bit_length());
  return problem.M.rows <= always_exact &&
         static_cast<std::size_t>(problem.M.rows) * longest <= most_bits;
}

HostMatrix rounded(const ExactMatrix& matrix) {
  HostMatrix nearest{matrix.rows, matrix.cols, {}};
  for (const Rational& x : matrix.values) nearest.values.push_back(x.value());
  return nearest;
}

std::string problem_note(const SceneFile& file) {
  return (file.pressure == Pressure::pad ? "The first round of the pad law, in SI units, "
                                         : "SI units, ") +
         friction_law_text(file) + ".";
}

/// What the problem's variables mean.
void tell(PivotSubject& subject, SceneFile file) {
  subject.scene = std::make_unique<SceneFile>(std::move(file));
  subject.push = std::make_unique<Push>(*subject.scene);
  subject.story = push_story(*subject.push);
}

} // namespace

PivotSubject scene_subject(SceneFile file, const std::string& text, const std::string& path,
                           bool as_solved, bool is_exact) {
  const Index n = size_of(file.view()).unknowns();
  refuse_size(path, n, is_exact);
  PivotSubject subject;
  if (is_exact || (!as_solved && n <= always_exact)) {
    SceneOf<Rational> exact = parse_scene<Rational>(text, path);
    exact.facets = file.facets;
    exact.pressure = file.pressure;
    subject.problem = exact_problem(exact);
    subject.is_short = is_short(subject.problem);
    if (is_exact) {
      subject.notes = exact.inexact;
      for (const std::string& sentence : irrational_directions(exact))
        subject.notes.push_back(sentence);
    }
  } else if (!as_solved) {
    subject.problem = exact_problem(file);
  }
  if (!as_solved) subject.notes.push_back(problem_note(file));
  tell(subject, std::move(file));
  return subject;
}

PivotSubject rounded_subject(SceneFile file, const std::string& path) {
  refuse_size(path, size_of(file.view()).unknowns(), false);
  PivotSubject subject;
  subject.problem = exact_problem(file);
  subject.notes.push_back(problem_note(file));
  tell(subject, std::move(file));
  return subject;
}

PivotSubject raw_subject(ExactProblem problem, const std::string& name, bool is_exact) {
  refuse_size(name, problem.M.rows, is_exact);
  PivotSubject subject;
  subject.is_short = is_short(problem);
  subject.story = std::make_unique<RawStory>(problem.M.rows);
  subject.problem = std::move(problem);
  return subject;
}

std::string unknown_shares(const SceneFile& file) {
  if (file.pressure != Pressure::even || (file.hand != Hand::parallel && file.hand != Hand::locked))
    return {};
  return "even does not go with " + std::string(hand_text(file.hand)) +
         " jaws: no point's share is known; write [gripper] jaws = \"independent\"";
}

PivotOptions pivot_options(const PivotSubject& subject, bool is_exact, bool is_page) {
  constexpr Index quick = 64;
  PivotOptions options;
  options.is_exact = is_exact || subject.is_short;
  options.keeps_fractions = is_exact || (is_page && subject.problem.M.rows <= quick);
  if (is_page) options.most_entries = 0; // it has no tableau but the first and the last
  return options;
}

void finish_trace(PivotTrace& trace, const PivotSubject& subject, bool is_exact) {
  if (subject.scene) trace.title = subject.scene->title;
  trace.notes = subject.notes;
  trace.prefers_decimals = trace.has_fractions && !is_exact;
}

PivotTrace trace_solve(const PivotSubject& subject, const PivotOptions& options) {
  if (subject.push) return trace_solve(*subject.push, options, *subject.story);
  RawProblem raw{rows_of(rounded(subject.problem.M)), rounded(subject.problem.q).values, {}, {}};
  raw.free.assign(raw.q.size(), 0);
  return trace_solve(raw, options, *subject.story);
}

} // namespace lcpush::desktop
