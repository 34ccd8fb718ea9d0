// What watchers are told, and that watching changes nothing.
#include <doctest/doctest.h>

#include <vector>

#include "lcpush/lcp/trace.hpp"
#include "support/checked_sweeps.hpp"
#include "support/dense_lcp.hpp"
#include "support/sweep_runs.hpp"
#include "support/textbook.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

LemkeOptions<double> by_the_book(const VectorX<double>& cover, TieRule rule) {
  LemkeOptions<double> options;
  options.cover = cover.data();
  options.equilibrate = false;
  options.tie_rule = rule;
  return options;
}

/// What was said before and after each pivot, compared with what the dictionary shows.
struct Diary {
  std::vector<Pivot> pivots;
  std::vector<std::vector<int>> tied;
  int starts_seen = 0, steps_seen = 0;
  Status last = Status::running;

  void starts(const Lemke<double>& lemke) {
    ++starts_seen;
    CHECK(lemke.dictionary().column_of(artificial(lemke.dictionary().size())) >= 0);
  }
  Index choose_leaving_row(const Lemke<double>& lemke, const PendingPivot& pending) {
    const Dictionary<double>& d = lemke.dictionary();
    CHECK(d.nonbasic[pending.column] == pending.entering);
    CHECK(pending.repairs == (pending.entering == artificial(d.size())));
    CHECK(pending.tied.size == pending.blocking.tied);
    pivots.push_back({pending.entering, d.basic[pending.blocking.row], pending.blocking});
    tied.emplace_back();
    for (const int row : pending.tied) tied.back().push_back(d.basic[row]);
    return pending.blocking.row;
  }
  void stepped(const Lemke<double>& lemke) {
    ++steps_seen;
    last = lemke.status();
    if (pivots.empty()) return; // q >= 0: z = 0 is the answer
    CHECK(lemke.last_pivot().entering == pivots.back().entering);
    CHECK(lemke.last_pivot().leaving == pivots.back().leaving);
  }
};

} // namespace

TEST_CASE("a watcher sees every pivot before it is made, and changes nothing") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Index n = 2 + static_cast<Index>(seed % 9);
    const MatrixX<double> A = random_matrix(random, n, n);
    const DenseLcp<double> lcp{A * A.transpose(), random_vector(random, n)};
    LemkeRun<double> watched(n), alone(n);
    Diary diary;
    REQUIRE(watched.lemke.init(lcp.view()) == Status::running);
    const Status status = watched.lemke.solve(diary);
    CHECK(status == alone.solve(lcp));
    CHECK(diary.last == status);
    CHECK(diary.starts_seen == 1);
    CHECK(static_cast<Index>(diary.pivots.size()) == alone.lemke.pivots());
    CHECK(watched.z() == alone.z());
    for (std::size_t k = 1; k < diary.pivots.size(); ++k)
      CHECK(diary.pivots[k].entering == complement(diary.pivots[k - 1].leaving, n));
  }
}

TEST_CASE("a watcher may let another of the tied rows leave") {
  struct LastTied {
    Index changed = 0;
    void starts(const Lemke<double>&) {}
    Index choose_leaving_row(const Lemke<double>&, const PendingPivot& pending) {
      if (pending.blocking.decided_by == TieBreak::artificial) return pending.blocking.row;
      Index row = pending.blocking.row;
      for (const int tied : pending.tied)
        if (tied > row) row = tied;
      changed += row != pending.blocking.row ? 1 : 0;
      return row;
    }
    void stepped(const Lemke<double>&) {}
  } last;
  const DenseLcp<double> lcp = textbook("kostreva_1");
  const VectorX<double> ones = VectorX<double>::Ones(3);
  LemkeOptions<double> options = by_the_book(ones, TieRule::first_row);
  options.max_pivots = 3;
  LemkeRun<double> run(3);
  REQUIRE(run.lemke.init(lcp.view(), options) == Status::running);
  REQUIRE(run.lemke.step(last) == Status::running);
  CHECK(last.changed == 1);
  CHECK(run.lemke.last_pivot().leaving == slack(2));
  CHECK(run.lemke.dictionary().values(2, 0) == 1);
}
