// The watcher (lcp/trace.hpp) that writes a PivotTrace, for doubles and for fractions.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "lcpush/desktop/pivots.hpp"
#include "lcpush/desktop/rational.hpp"

namespace lcpush::desktop {

inline TraceNumber traced(const PivotTrace&, double x) { return {x, {}}; }
inline TraceNumber traced(const PivotTrace& trace, const Rational& x) {
  const double value = x.value();
  return {value, trace.has_fractions || !std::isfinite(value) ? x.text() : std::string()};
}

/// The desktop's solvers pivot doubles and know their watchers as Watcher.
struct UnknownWatcher {};
template <class S>
using WatcherOf = std::conditional_t<std::is_same_v<S, double>, Watcher, UnknownWatcher>;

template <class S> class RecordingWatcher : public WatcherOf<S> {
public:
  /// All outlive the watcher.
  RecordingWatcher(PivotTrace& trace, const Story& story, const PivotOptions& options)
      : trace_(trace), story_(story), options_(options), room_(options.most_entries) {}

  void starts(const Lemke<S>& lemke) {
    TracedRun run;
    run.first_pivot = trace_.pivots.size();
    run.title = title_of(lemke);
    run.start = tableau(lemke);
    run.unit.assign(static_cast<std::size_t>(2 * n() + 1), 1.0);
    for (Index i = 0; i < n(); ++i) {
      run.unit[static_cast<std::size_t>(slack(i))] = traced(trace_, lemke.slack_unit(i)).value;
      run.unit[static_cast<std::size_t>(unknown(i, n()))] =
          traced(trace_, lemke.unknown_unit(i)).value;
    }
    trace_.runs.push_back(run);
    seen_.clear();
  }

  Index choose_leaving_row(const Lemke<S>& lemke, const PendingPivot& pending) {
    if (options_.pivoted) options_.pivoted();
    const Dictionary<S>& d = lemke.dictionary();
    TracedPivot pivot;
    pivot.entering = pending.entering;
    pivot.row = pending.blocking.row;
    pivot.column = pending.column;
    pivot.leaving = d.basic[pivot.row];
    pivot.decided_by = pending.blocking.decided_by;
    pivot.run = trace_.runs.size() - 1;
    for (Index i = 0; i < d.size(); ++i) pivot.ratios.push_back(ratio(lemke, i, pending));
    if (pending.tied.size > 1) {
      for (const int row : pending.tied) pivot.ties.push_back(d.basic[row]);
      std::sort(pivot.ties.begin(), pivot.ties.end());
    }
    const auto entries = static_cast<std::size_t>(d.size() * (d.size() + 1));
    if (entries <= room_) {
      room_ -= entries;
      pivot.before = tableau(lemke);
    }
    trace_.pivots.push_back(pivot);
    is_pivoting_ = true;
    const Index row = chosen_row(pending);
    if (row != pivot.row) {
      trace_.pivots.back().row = row;
      trace_.pivots.back().leaving = d.basic[row];
      trace_.pivots.back().chosen = true;
    }
    return row;
  }

  void stepped(const Lemke<S>& lemke) {
    if (lemke.status() != Status::running) trace_.last = tableau(lemke);
    if (!is_pivoting_) return;
    is_pivoting_ = false;
    TracedPivot& pivot = trace_.pivots.back();
    const Dictionary<S>& d = lemke.dictionary();
    pivot.basis.assign(d.basic.begin(), d.basic.end());
    std::vector<bool> basic(static_cast<std::size_t>(2 * n() + 1)); // while `entering` grew
    for (const Index variable : pivot.basis) basic[static_cast<std::size_t>(variable)] = true;
    basic[static_cast<std::size_t>(pivot.leaving)] = true;
    pivot.sentence = story_.sentence(pivot, basic);
    const Index z0_row = d.row_of(artificial(n()));
    pivot.z0.finite = traced(trace_, S(0));
    if (z0_row >= 0) pivot.z0 = value(lemke, z0_row);
    std::vector<Index> key = pivot.basis;
    std::sort(key.begin(), key.end());
    key.push_back(pivot.leaving); // its complement is the next to enter
    const auto [earlier, is_new] = seen_.emplace(key, trace_.pivots.size() - 1);
    // Covers and refactorisations of the real run may come back to a basis.
    if (!is_new && lemke.status() == Status::running && !trace_.is_as_solved)
      trace_.cycle = Cycle{earlier->second, trace_.pivots.size() - 1 - earlier->second};
  }

  Tableau tableau(const Lemke<S>& lemke) const {
    const Dictionary<S>& d = lemke.dictionary();
    Tableau t;
    t.rows.assign(d.basic.begin(), d.basic.end());
    t.columns.assign(d.nonbasic.begin(), d.nonbasic.end());
    t.entries.reserve(static_cast<std::size_t>(d.size() * (d.size() + 1)));
    for (Index i = 0; i < d.size(); ++i) {
      t.values.push_back(value(lemke, i));
      for (Index j = 0; j <= d.size(); ++j) t.entries.push_back(traced(trace_, d.table(i, j)));
    }
    return t;
  }

private:
  PivotTrace& trace_;
  const Story& story_;
  const PivotOptions& options_;
  std::size_t room_; // entries of tableaus that are still kept
  bool is_pivoting_ = false;
  std::map<std::vector<Index>, std::size_t> seen_;

  /// One of the tied rows: the rule's, or the user's.
  Index chosen_row(const PendingPivot& pending) const {
    const Index row = options_.choose ? options_.choose(trace_) : pending.blocking.row;
    if (options_.z0_wins_ties || pending.blocking.decided_by != TieBreak::artificial) return row;
    Index first = -1;
    for (const int other : pending.tied)
      if (other != pending.blocking.row && (first < 0 || other < first)) first = other;
    return first;
  }

  Index n() const { return trace_.size; }
  bool has_S() const { return trace_.free_count > 0; }

  TraceValue value(const Lemke<S>& lemke, Index row) const {
    TraceValue v;
    const auto& values = lemke.dictionary().values;
    if (has_S()) v.times_S = traced(trace_, values(row, 0));
    v.finite = traced(trace_, values(row, has_S() ? 1 : 0));
    return v;
  }

  /// How far the entering variable may grow before this row blocks; for the entry of z0, how much
  /// of it the row needs.
  std::optional<TraceValue> ratio(const Lemke<S>& lemke, Index row,
                                  const PendingPivot& pending) const {
    const Dictionary<S>& d = lemke.dictionary();
    const S& rate = d.table(row, pending.column);
    if (pending.repairs ? !(S(0) < rate) || !is_negative(d, row) : !(rate < S(0))) return {};
    TraceValue v;
    if (has_S()) v.times_S = traced(trace_, S(-d.values(row, 0) / rate));
    v.finite = traced(trace_, S(-d.values(row, has_S() ? 1 : 0) / rate));
    return v;
  }

  bool is_negative(const Dictionary<S>& d, Index row) const {
    if (has_S() && !(d.values(row, 0) == S(0))) return d.values(row, 0) < S(0);
    return d.values(row, has_S() ? 1 : 0) < S(0);
  }

  std::string title_of(const Lemke<S>& lemke) const {
    const auto& basic = lemke.dictionary().basic;
    const auto z_basic = std::count_if(basic.begin(), basic.end(),
                                       [this](Index variable) { return variable >= n(); });
    const std::string cover =
        !trace_.is_as_solved ? std::string() : ", cover " + std::to_string(lemke.covers_tried());
    if (z_basic == 0) return "from z = 0" + cover;
    return "from a basis of " + std::to_string(z_basic) + " z" + cover;
  }
};

} // namespace lcpush::desktop
