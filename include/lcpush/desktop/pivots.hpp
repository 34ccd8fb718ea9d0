// A run of Lemke's method as data: every pivot with what it means. Written by `lcpush pivots` as
// text, JSON, LaTeX, SVG or the explorer's page.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/rational.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/desktop/telling.hpp"
#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush::desktop {

/// The nearest double; after exact arithmetic the fraction as well.
struct TraceNumber {
  double value = 0;
  std::string fraction; ///< "-2/7"; empty where doubles were pivoted
};

/// times_S * S + finite, where S stands for a number larger than all others.
struct TraceValue {
  TraceNumber times_S, finite;

  bool has_S() const { return times_S.value != 0; }
};

/// The dictionary of one basis: basic = values + entries * nonbasic. Variables by their numbers in
/// lcp/pivots/dictionary.hpp.
struct Tableau {
  std::vector<Index> rows, columns;
  std::vector<TraceValue> values;   ///< a row
  std::vector<TraceNumber> entries; ///< row by row

  const TraceNumber& entry(std::size_t row, std::size_t column) const {
    return entries[row * columns.size() + column];
  }
};

struct TracedPivot {
  Index entering = -1, leaving = -1;
  Index row = -1, column = -1;                   ///< of the pivot element, in the tableau before
  std::vector<std::optional<TraceValue>> ratios; ///< a row; empty where the row cannot block
  std::vector<Index> ties;                       ///< variables that block at the same point, if two
  TieBreak decided_by = TieBreak::none;
  bool chosen = false;      ///< by the user among the ties
  TraceValue z0;            ///< after the pivot
  std::vector<Index> basis; ///< after the pivot, in the rows' order
  std::size_t run = 0;
  std::string sentence;
  std::optional<Tableau> before; ///< left out of large traces

  bool is_at(std::size_t i, std::size_t j) const {
    return static_cast<Index>(i) == row && static_cast<Index>(j) == column;
  }
};

/// A start and the pivots that follow it.
struct TracedRun {
  std::string title;
  std::size_t first_pivot = 0;
  Tableau start;
  std::vector<double>
      unit; ///< a variable (2 n + 1): its number times this is in the problem's units
};

struct TracedRay {
  Index entering = -1;        ///< grows without end
  std::vector<TraceNumber> v; ///< z along the ray, largest 1
  TraceNumber v0;             ///< z0 along it
  std::string words;
};

/// After pivot `first` the basis is the one `length` pivots later: a rule without memory repeats.
struct Cycle {
  std::size_t first = 0, length = 0;
};

struct Variable {
  std::string name, meaning; ///< "z3", "normal force of left.3"
  std::string growth, end;   ///< of a Story; empty without a physical meaning
};

struct PivotTrace {
  std::string title;
  Index size = 0, free_count = 0; ///< n, and how many of the last unknowns are free
  bool has_fractions = false;     ///< numbers are exact and written as fractions
  bool prefers_decimals = false;  ///< on the page, which can show both
  TieRule rule = TieRule::lexicographic;
  bool is_physical = false;  ///< a scene's: variables mean forces and motions
  bool is_as_solved = false; ///< the real run: scaled, under generic covers, its warm rounds
  Status status = Status::running;
  std::string reason; ///< a sentence; empty when solved
  std::vector<Variable> variables;
  std::vector<TracedPivot> pivots;
  std::vector<TracedRun> runs;
  std::optional<Tableau> last;   ///< where the run ended
  std::vector<TraceNumber> z, w; ///< when solved, in the problem's units
  bool is_proved = false;        ///< z, w >= 0, z'w = 0 and w = M z + q held exactly
  std::optional<TracedRay> ray;
  std::optional<Cycle> cycle;
  std::vector<std::string> notes; ///< for people: what was not as typed, what was left out

  const std::string& name(Index variable) const {
    return variables[static_cast<std::size_t>(variable)].name;
  }
  std::vector<std::string> names(const std::vector<Index>& list) const {
    std::vector<std::string> result;
    for (const Index variable : list) result.push_back(name(variable));
    return result;
  }
};

/// What variables are called and what pivots mean.
class Story {
public:
  virtual ~Story() = default;
  virtual bool is_physical() const { return false; }
  /// Of variable w_i, z_i or z0.
  virtual std::string meaning(Index variable) const = 0;
  /// "point left.1 presses harder": what its growth is, in the middle of a sentence; empty without
  /// a physical meaning.
  virtual std::string growth(Index) const { return {}; }
  /// What has happened when it is zero and leaves, whatever the basis.
  virtual std::string end(Index) const { return {}; }
  /// What a pivot means. `basic` says which variables are basic while the entering one grows,
  /// itself included.
  virtual std::string sentence(const TracedPivot& pivot, const std::vector<bool>& basic) const = 0;
  /// What it means that nothing blocks `entering`, v is the ray.
  virtual std::string ray_sentence(Index entering, const std::vector<double>& v) const = 0;
};

/// Variables without a physical meaning.
class RawStory : public Story {
public:
  explicit RawStory(Index n) : n_(n) {}
  std::string meaning(Index variable) const override;
  std::string sentence(const TracedPivot& pivot, const std::vector<bool>& basic) const override;
  std::string ray_sentence(Index entering, const std::vector<double>& v) const override;

private:
  Index n_;
};

/// Of a scene's problem: forces, motions and laws. `push` outlives the story.
std::unique_ptr<Story> push_story(const Push& push);

struct PivotOptions {
  bool is_exact = false;                 ///< pivots in fractions
  bool keeps_fractions = true;           ///< and writes them; false: as decimals
  TieRule rule = TieRule::lexicographic; ///< or first_row
  std::vector<Rational> cover;           ///< n numbers > 0; empty: ones
  bool z0_wins_ties = true;              ///< false shows what goes wrong without
  Index max_pivots = 10000;
  std::size_t most_entries = 400000; ///< of all tableaus together that are kept
  /// Asked before every pivot, the trace's last: the row that leaves, one of those tied.
  std::function<Index(const PivotTrace&)> choose;
  std::function<void()> pivoted; ///< called at every pivot; what it throws ends the run
};

/// w = M z + q in somebody's units; the last free_count unknowns are free.
struct ExactProblem {
  ExactMatrix M, q;
  Index free_count = 0;
};

/// A scene's problem in SI units: its first `pad` round, or the only one under rigid and even.
ExactProblem exact_problem(const SceneOf<Rational>& scene);
ExactProblem exact_problem(const SceneFile& scene); ///< the doubles' exact values

/// Lemke's method as it is taught: one cover, nothing scaled.
/// Post: solved, ray, pivot_limit, numerical_breakdown (doubles only), or running with a cycle.
PivotTrace trace_pivots(const ExactProblem& problem, const PivotOptions& options,
                        const Story& story);

/// The run that answers `lcpush solve` or `lcpush lcp`, pivot for pivot: scaled, under generic
/// covers, with every round of the pressure law.
PivotTrace trace_solve(Push& push, const PivotOptions& options, const Story& story);
PivotTrace trace_solve(const RawProblem& problem, const PivotOptions& options, const Story& story);

/// A line, a sentence and the tableau of each pivot; of more than 12 unknowns how it ended alone,
/// and of `push`, if there is one, the answer by body, unless all is to be told.
std::string pivots_text(const PivotTrace& trace, Telling telling, const Push* push);
/// One object; docs/teach/command.md describes it. `push`, if there is one, adds what is
/// drawn. Large traces come without a tableau a pivot; `tableaus` false leaves all of those out.
std::string pivots_json(const PivotTrace& trace, const Push* push, bool tableaus = true);
/// An array a basis, its pivot element boxed, for LaTeX with amsmath.
std::string pivots_latex(const PivotTrace& trace);
/// A picture: two pairs among their complementary cones, others by z0 after each pivot.
std::string pivots_svg(const PivotTrace& trace);
/// The explorer: one page that needs no network.
std::string pivots_html(const PivotTrace& trace, const Push* push);
/// One tableau with its ratios, as in pivots_text.
std::string tableau_text(const PivotTrace& trace, const Tableau& tableau, const TracedPivot* pivot);
/// "3/7", "0.25", "2 S - 1".
std::string value_text(const TraceValue& value);
/// What decided between tied rows: as JSON names it, and in words.
struct TieWords {
  const char *name, *text;
};
TieWords tie_words(const TracedPivot& pivot);

/// "w1", "z3", "z0", counted from 1.
std::string variable_name(Index variable, Index n);

} // namespace lcpush::desktop
