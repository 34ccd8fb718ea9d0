// Runs Lemke's method with a recorder.
#include "lcpush/desktop/pivots.hpp"

#include <algorithm>
#include <cmath>

#include "lcpush/desktop/owned.hpp"
#include "pivots/pivot_recorder.hpp"

namespace lcpush::desktop {
namespace {

template <class S> std::vector<S> converted(const std::vector<Rational>& numbers) {
  if constexpr (std::is_same_v<S, Rational>) {
    return numbers;
  } else {
    std::vector<S> result;
    for (const Rational& x : numbers) result.push_back(x.value());
    return result;
  }
}

PivotTrace empty_trace(Index n, Index free_count, const Story& story) {
  PivotTrace trace;
  trace.size = n;
  trace.free_count = free_count;
  trace.is_physical = story.is_physical();
  for (Index variable = 0; variable <= artificial(n); ++variable)
    trace.variables.push_back({variable_name(variable, n), story.meaning(variable)});
  return trace;
}

/// Does z solve the problem without any error? Its own arithmetic, not the solver's.
bool solves_exactly(const ExactProblem& problem, const std::vector<Rational>& z,
                    const std::vector<Rational>& w) {
  const Index n = problem.M.rows, pairs = n - problem.free_count;
  for (Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (w[at] < Rational(0) || (i >= pairs && w[at] != Rational(0))) return false;
    if (i < pairs && (z[at] < Rational(0) || z[at] * w[at] != Rational(0))) return false;
  }
  return true;
}

template <class S>
std::vector<TraceNumber> all_traced(const PivotTrace& trace, const std::vector<S>& numbers) {
  std::vector<TraceNumber> result;
  for (const S& x : numbers) result.push_back(traced(trace, x));
  return result;
}

template <class S>
void take_solution(const ExactProblem& problem, const Lemke<S>& lemke, PivotTrace& trace) {
  const Index n = trace.size;
  const std::vector<S> M = converted<S>(problem.M.values);
  std::vector<S> z(lemke.z(), lemke.z() + n), w = converted<S>(problem.q.values);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      w[static_cast<std::size_t>(i)] +=
          M[static_cast<std::size_t>(j * n + i)] * z[static_cast<std::size_t>(j)];
  if constexpr (std::is_same_v<S, Rational>) {
    trace.is_proved = trace.has_fractions && solves_exactly(problem, z, w);
  } else {
    for (Index i = 0; i < n; ++i) // what a basis makes zero is zero
      if (lemke.is_basic(i)) w[static_cast<std::size_t>(i)] = 0;
  }
  trace.z = all_traced(trace, z);
  trace.w = all_traced(trace, w);
}

template <class S> void take_ray(const Lemke<S>& lemke, const Story& story, PivotTrace& trace) {
  TracedRay ray;
  ray.entering = trace.pivots.empty() ? artificial(trace.size)
                                      : complement(trace.pivots.back().leaving, trace.size);
  std::vector<double> v;
  for (Index i = 0; i < trace.size; ++i) {
    ray.v.push_back(traced(trace, lemke.ray()[i]));
    v.push_back(ray.v.back().value);
  }
  ray.v0 = traced(trace, lemke.ray_artificial());
  ray.words = story.ray_sentence(ray.entering, v);
  trace.ray = ray;
}

std::string reason_of(const PivotTrace& trace, Reason reason) {
  if (trace.cycle)
    return "the basis after pivot " + std::to_string(trace.cycle->first) + " comes back " +
           std::to_string(trace.cycle->length) + " pivots later: this rule repeats it for ever";
  if (trace.status == Status::pivot_limit) return "the limit of pivots was reached";
  if (trace.status == Status::ray) {
    const TraceValue& z0 = trace.pivots.back().z0;
    const bool passed = !z0.has_S() && z0.finite.value == 0;
    return passed ? "a secondary ray, although z0 is 0: the run has passed a solution"
                  : "a secondary ray: a variable grows without end, and z0 never reaches zero";
  }
  return reason_text(reason);
}

/// In doubles rounding decides ties: then even the lexicographic rule may come back to a basis.
void distrust(const PivotOptions& options, PivotTrace& trace) {
  if (!trace.cycle || options.rule != TieRule::lexicographic || options.choose) return;
  trace.cycle.reset();
  trace.status = Status::numerical_breakdown;
  trace.reason = "a basis came back, as rounding has decided ties; --exact decides them truly";
}

bool all_finite(const std::vector<TraceNumber>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](const TraceNumber& x) { return std::isfinite(x.value); });
}

template <class S>
PivotTrace trace_by(const ExactProblem& given, const PivotOptions& options, const Story& story) {
  const Index n = given.M.rows;
  PivotTrace trace = empty_trace(n, given.free_count, story);
  trace.has_fractions = options.is_exact && options.keeps_fractions;
  trace.rule = options.rule;

  const std::vector<S> M = converted<S>(given.M.values), q = converted<S>(given.q.values);
  std::vector<S> cover = converted<S>(options.cover);
  if (cover.empty()) cover.assign(static_cast<std::size_t>(n), S(1));
  Problem<S> problem;
  problem.size = n;
  problem.free_begin = n - given.free_count;
  problem.matrix = M.data();
  problem.q = q.data();
  LemkeOptions<S> book;
  book.cover = cover.data();
  book.equilibrate = false;
  book.tie_rule = options.rule;
  book.max_pivots = options.max_pivots;

  OwnedLemke<S> lemke(n);
  Recorder<S> recorder(trace, story, options);
  trace.status = lemke.init(problem, book);
  while (trace.status == Status::running && !trace.cycle) trace.status = lemke.step(recorder);
  if constexpr (std::is_same_v<S, double>) distrust(options, trace);
  trace.last = recorder.tableau(lemke.dictionary());
  if (trace.status == Status::solved) take_solution(given, lemke, trace);
  if (trace.status == Status::ray) take_ray(lemke, story, trace);
  if (std::is_same_v<S, double> && !all_finite(trace.z)) trace.status = Status::numerical_breakdown;
  if (trace.status != Status::solved && trace.reason.empty())
    trace.reason = reason_of(trace, lemke.reason());
  return trace;
}

/// The recorder as an observer that the desktop's solvers can be given.
class RecordingWatcher : public Watcher {
public:
  RecordingWatcher(PivotTrace& trace, const Story& story, const PivotOptions& options)
      : trace_(trace), recorder_(trace, story, options) {}

  void starts(const Lemke<double>& lemke) override { recorder_.starts(lemke); }
  Index leaves(const Lemke<double>& lemke, const PendingPivot& pending) override {
    return recorder_.leaves(lemke, pending);
  }
  void stepped(const Lemke<double>& lemke) override {
    recorder_.stepped(lemke);
    trace_.cycle.reset(); // covers and refactorisations may come back to a basis
    if (lemke.status() != Status::running) trace_.last = recorder_.tableau(lemke.dictionary());
  }

private:
  PivotTrace& trace_;
  Recorder<double> recorder_;
};

PivotTrace real_trace(Index n, Index free_count, const Story& story) {
  PivotTrace trace = empty_trace(n, free_count, story);
  trace.rule = TieRule::generic;
  trace.is_as_solved = true;
  return trace;
}

/// z from the last tableau, in the problem's units.
void take_basic_z(PivotTrace& trace) {
  trace.z.assign(static_cast<std::size_t>(trace.size), TraceNumber{});
  for (std::size_t i = 0; i < trace.last->rows.size(); ++i) {
    const Index variable = trace.last->rows[i];
    if (variable < trace.size || variable == artificial(trace.size)) continue;
    trace.z[static_cast<std::size_t>(variable - trace.size)].value =
        trace.last->values[i].finite.value *
        trace.runs.back().unit[static_cast<std::size_t>(variable)];
  }
}

} // namespace

PivotTrace trace_pivots(const ExactProblem& problem, const PivotOptions& options,
                        const Story& story) {
  return options.is_exact ? trace_by<Rational>(problem, options, story)
                          : trace_by<double>(problem, options, story);
}

PivotTrace trace_solve(Push& push, const PivotOptions& options, const Story& story) {
  const Layout<double>& layout = push.layout();
  PivotTrace trace = real_trace(layout.size, layout.actuators, story);
  RecordingWatcher watcher(trace, story, options);
  PushOptions pushing;
  pushing.other_covers = 0;
  pushing.dense = true; // to show the dictionary
  pushing.watcher = &watcher;
  const PushReport report = push.solve(pushing);
  trace.status = report.status;
  trace.reason = report.reason;
  for (TracedRun& run : trace.runs)
    for (Index i = 0; i < layout.size; ++i) {
      run.unit[static_cast<std::size_t>(slack(i))] *= row_unit(layout, i);
      run.unit[static_cast<std::size_t>(unknown(i, layout.size))] *= unknown_unit(layout, i);
    }
  if (report.status == Status::solved) take_basic_z(trace);
  if (report.status == Status::ray) {
    TracedRay ray;
    ray.entering = complement(trace.pivots.back().leaving, layout.size);
    ray.v.resize(static_cast<std::size_t>(layout.size));
    for (const NamedValue& entry : report.ray)
      ray.v[static_cast<std::size_t>(entry.unknown)] = traced(trace, entry.value);
    for (const std::string& sentence : jam_sentences(push.file(), report.jam))
      ray.words += (ray.words.empty() ? "" : "\n") + sentence;
    trace.ray = ray;
  }
  return trace;
}

PivotTrace trace_solve(const RawProblem& problem, const PivotOptions& options, const Story& story) {
  PivotTrace trace = real_trace(problem.M.rows, 0, story);
  RecordingWatcher watcher(trace, story, options);
  RawOptions solving;
  solving.watcher = &watcher;
  const RawAnswer answer = solve_raw(problem, solving);
  trace.status = answer.status;
  for (const double x : answer.z) trace.z.push_back(traced(trace, x));
  for (const double x : answer.w) trace.w.push_back(traced(trace, x));
  if (answer.status == Status::ray) {
    TracedRay ray;
    ray.entering = complement(trace.pivots.back().leaving, trace.size);
    for (const double x : answer.ray) ray.v.push_back(traced(trace, x));
    ray.words = story.ray_sentence(ray.entering, answer.ray);
    trace.ray = ray;
  }
  if (answer.status != Status::solved) trace.reason = reason_of(trace, answer.reason);
  return trace;
}

} // namespace lcpush::desktop
