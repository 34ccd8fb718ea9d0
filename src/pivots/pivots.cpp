// Runs Lemke's method with a recording watcher.
#include "lcpush/desktop/pivots.hpp"
#include "lcpush/desktop/exact_pivots.hpp"

#include <cmath>

#include "lcpush/desktop/owned.hpp"
#include "pivots/recording_watcher.hpp"
#include "solve/owned_assembly.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// As a dense matrix in SI units.
template <class S> ExactProblem si_problem(const SceneOf<S>& file) {
  const EvenSceneOf<S> even(file.view());
  OwnedAssembly<S> owned(even.scene);
  if (file.pressure == Pressure::pad)
    owned.enter_first_round(PressureOptions<S>().first_compliance);
  const Layout<S>& layout = owned.get().layout();
  const Problem<S> problem = owned.get().problem();
  const Index n = problem.size;
  std::vector<S> M(static_cast<std::size_t>(n * n));
  fill_matrix(problem, MatrixMap<S>(M.data(), n, n));

  ExactProblem exact{{n, n, {}}, {n, 1, {}}, n - problem.free_begin};
  std::vector<S> row_units;
  for (Index i = 0; i < n; ++i) {
    row_units.push_back(row_unit(layout, i));
    exact.q.values.push_back(Rational(S(problem.q[i] * row_units.back())));
  }
  exact.M.values.reserve(M.size());
  for (Index j = 0; j < n; ++j) {
    const S unit = unknown_unit(layout, j);
    for (Index i = 0; i < n; ++i) {
      const S& entry = M[static_cast<std::size_t>(j * n + i)];
      exact.M.values.push_back(Rational(S(entry * row_units[static_cast<std::size_t>(i)] / unit)));
    }
  }
  return exact;
}

template <class S> std::vector<S> converted(const std::vector<Rational>& numbers) {
  std::vector<S> result;
  for (const Rational& x : numbers)
    if constexpr (std::is_same_v<S, Rational>)
      result.push_back(x);
    else
      result.push_back(x.value());
  return result;
}

/// Generic tie columns are the real run's.
PivotTrace empty_trace(Index n, Index free_count, TieRule rule, const Story& story) {
  PivotTrace trace;
  trace.size = n;
  trace.free_count = free_count;
  trace.rule = rule;
  trace.is_as_solved = rule == TieRule::generic;
  trace.is_physical = story.is_physical();
  for (Index variable = 0; variable <= artificial(n); ++variable)
    trace.variables.push_back({variable_name(variable, n), story.meaning(variable),
                               story.growth(variable), story.end(variable)});
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

/// The ray after the last pivot, without words.
template <class S> TracedRay& take_ray(const std::vector<S>& v, PivotTrace& trace) {
  const Index entering = trace.pivots.empty() ? artificial(trace.size)
                                              : complement(trace.pivots.back().leaving, trace.size);
  trace.ray = TracedRay{entering, all_traced(trace, v), {}, {}};
  return *trace.ray;
}

template <class S> void take_ray(const Lemke<S>& lemke, const Story& story, PivotTrace& trace) {
  TracedRay& ray = take_ray(std::vector<S>(lemke.ray(), lemke.ray() + trace.size), trace);
  std::vector<double> v;
  for (const TraceNumber& x : ray.v) v.push_back(x.value);
  ray.v0 = traced(trace, lemke.ray_artificial());
  ray.words = story.ray_sentence(ray.entering, v);
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

template <class S>
PivotTrace trace_by(const ExactProblem& given, const PivotOptions& options, const Story& story) {
  const Index n = given.M.rows;
  PivotTrace trace = empty_trace(n, given.free_count, options.rule, story);
  trace.has_fractions = options.is_exact && options.keeps_fractions;

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
  RecordingWatcher<S> watcher(trace, story, options);
  trace.status = lemke.init(problem, book);
  while (trace.status == Status::running && !trace.cycle) trace.status = lemke.step(watcher);
  if constexpr (std::is_same_v<S, double>) distrust(options, trace);
  if (!trace.last) trace.last = watcher.tableau(lemke);
  if (trace.status == Status::solved) take_solution<S>(given, lemke, trace);
  if (trace.status == Status::ray) take_ray<S>(lemke, story, trace);
  for (const TraceNumber& z : trace.z)
    if (std::is_same_v<S, double> && !std::isfinite(z.value))
      trace.status = Status::numerical_breakdown;
  if (trace.status != Status::solved && trace.reason.empty())
    trace.reason = reason_of(trace, lemke.reason());
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

ExactProblem exact_problem(const SceneOf<Rational>& scene) { return si_problem(scene); }
ExactProblem exact_problem(const SceneFile& scene) { return si_problem(scene); }

PivotTrace trace_pivots(const ExactProblem& problem, const PivotOptions& options,
                        const Story& story) {
  return options.is_exact ? trace_by<Rational>(problem, options, story)
                          : trace_by<double>(problem, options, story);
}

PivotTrace trace_solve(Push& push, const PivotOptions& options, const Story& story) {
  const Layout<double>& layout = push.layout();
  PivotTrace trace = empty_trace(layout.size, layout.actuators, TieRule::generic, story);
  RecordingWatcher<double> watcher(trace, story, options);
  PushOptions pushing;
  pushing.other_paths = 0;
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
    std::vector<double> v(static_cast<std::size_t>(layout.size));
    for (const NamedValue& entry : report.ray)
      v[static_cast<std::size_t>(entry.unknown)] = entry.value;
    take_ray(v, trace).words = joined(jam_sentences(push.file(), report.jam), "\n");
  }
  return trace;
}

PivotTrace trace_solve(const RawProblem& problem, const PivotOptions& options, const Story& story) {
  PivotTrace trace = empty_trace(problem.size(), 0, TieRule::generic, story);
  RecordingWatcher<double> watcher(trace, story, options);
  RawOptions solving;
  solving.searches = false; // one run, on all of it
  solving.watcher = &watcher;
  const RawAnswer answer = solve_raw(problem, solving);
  trace.status = answer.status;
  trace.z = all_traced(trace, answer.z);
  trace.w = all_traced(trace, answer.w);
  if (answer.status == Status::ray) {
    TracedRay& ray = take_ray(answer.ray, trace);
    ray.words = story.ray_sentence(ray.entering, answer.ray);
  }
  if (answer.status != Status::solved) trace.reason = reason_of(trace, answer.reason);
  return trace;
}

} // namespace lcpush::desktop
