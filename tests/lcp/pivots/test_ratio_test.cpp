// Which row blocks: the smallest ratio, and what decides between rows that tie.
#include <doctest/doctest.h>

#include "lcpush/lcp/pivots/ratio_test.hpp"
#include "support/owned_dictionary.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

constexpr double tie = Tolerances<double>().tie;
constexpr double smallest_pivot = Tolerances<double>().pivot;

/// n rows whose values fall at the given rates as the variable of column 0 grows. The first
/// `levels` columns of `values` are data, the others break ties.
struct Race {
  OwnedDictionary<double> dictionary;
  std::vector<int> candidates;
  Index levels;

  Race(const std::vector<double>& falling, const MatrixX<double>& values, Index data_levels)
      : dictionary(MatrixX<double>::Zero(values.rows(), values.rows() + 1), values),
        candidates(falling.size()), levels(data_levels) {
    for (std::size_t i = 0; i < falling.size(); ++i)
      dictionary.table(static_cast<Index>(i), 0) = -falling[i];
  }

  Blocking run(TieRule rule = TieRule::generic, Tolerances<double> tolerances = {}) {
    RatioTest<double> test(dictionary.d, levels, rule, tolerances,
                           {candidates.data(), static_cast<Index>(candidates.size())});
    return test.blocking_row(0);
  }
  void make_artificial(Index row) {
    dictionary.basic[static_cast<std::size_t>(row)] =
        static_cast<int>(artificial(dictionary.d.size()));
  }
};

MatrixX<double> columns(std::initializer_list<std::initializer_list<double>> rows) {
  MatrixX<double> values(static_cast<Index>(rows.size()), static_cast<Index>(rows.begin()->size()));
  Index i = 0;
  for (const auto& row : rows) {
    Index k = 0;
    for (const double x : row) values(i, k++) = x;
    ++i;
  }
  return values;
}

} // namespace

TEST_CASE("the row with the smallest ratio blocks") {
  Race race({1, 4, 2}, columns({{1}, {2}, {3}}), 1); // ratios 1, 0.5, 1.5
  const Blocking blocking = race.run();
  CHECK(blocking.row == 1);
  CHECK(blocking.tied == 1);
  CHECK(blocking.decided_by == TieBreak::none);
}

TEST_CASE("a row whose rate is noise beside its column's largest entry cannot block") {
  // Row 0 alone falls, but by less than the threshold of the rising row 1.
  Race noise({0.5 * smallest_pivot, -1}, columns({{0}, {1}}), 1);
  CHECK(noise.run().row == -1);
  Race real({2 * smallest_pivot, -1}, columns({{0}, {1}}), 1);
  CHECK(real.run().row == 0);
}

TEST_CASE("the threshold is relative: a tiny column has pivots too") {
  Race race({1e-200, 2e-200}, columns({{1}, {1}}), 1);
  CHECK(race.run().row == 1);
}

TEST_CASE("the artificial variable wins a tie, wherever it stands and whatever its pivot") {
  for (Index row = 0; row < 3; ++row)
    for (const TieRule rule : {TieRule::generic, TieRule::lexicographic, TieRule::first_row}) {
      // The tie column would choose another row: the artificial one has the largest entry in it.
      MatrixX<double> values = columns({{1, 1}, {1, 1}, {1, 1}});
      values(row, 1) = 2;
      Race race({1, 1, 1}, values, 1);
      race.make_artificial(row);
      const Blocking blocking = race.run(rule);
      CHECK(blocking.row == row);
      CHECK(blocking.tied == 3);
      CHECK(blocking.decided_by == TieBreak::artificial);
    }
}

TEST_CASE("the artificial variable does not win against a later right-hand side that decides") {
  Race race({1, 1}, columns({{0, 1}, {0, 2}}), 2);
  race.make_artificial(1);
  CHECK(race.run().row == 0);
}

TEST_CASE("right-hand sides are compared in order: a later one decides only ties of the earlier") {
  SUBCASE("the first decides alone") {
    Race race({1, 1}, columns({{1, 9, 9}, {2, 0, 0}}), 3);
    const Blocking blocking = race.run();
    CHECK(blocking.row == 0);
    CHECK(blocking.decided_by == TieBreak::none);
  }
  SUBCASE("the second decides a tie of the first") {
    Race race({1, 1, 1}, columns({{1, 2, 0}, {1, 1, 9}, {2, 0, 0}}), 3);
    const Blocking blocking = race.run();
    CHECK(blocking.row == 1);
    CHECK(blocking.tied == 1);
    CHECK(blocking.decided_by == TieBreak::right_hand_side);
  }
  SUBCASE("the third decides a tie of both") {
    Race race({1, 1}, columns({{1, 1, 5}, {1, 1, 4}}), 3);
    CHECK(race.run().row == 1);
  }
  SUBCASE("ratios, not values, are compared") {
    Race race({1, 10}, columns({{0, 1, 0}, {0, 2, 0}}), 3);
    CHECK(race.run().row == 1);
  }
}

TEST_CASE("a tie column decides before the size of the pivot does") {
  Race race({1, 8}, columns({{0, 1}, {0, 9}}), 1); // ratios in the tie column 1 and 9/8
  const Blocking blocking = race.run();
  CHECK(blocking.row == 0);
  CHECK(blocking.tied == 2);
  CHECK(blocking.decided_by == TieBreak::tie_column);
}

TEST_CASE("the first-row rule takes the first tied row, whatever the tie columns say") {
  Race race({1, 8}, columns({{0, 9}, {0, 1}}), 1);
  const Blocking blocking = race.run(TieRule::first_row);
  CHECK(blocking.row == 0);
  CHECK(blocking.decided_by == TieBreak::order);
}

TEST_CASE("the lexicographic rule takes the smallest row of the basis inverse over the rate") {
  // In the basis of all w the inverse is the identity: w_0 is perturbed most, so the later row
  // blocks first.
  Race race({1, 1}, columns({{0}, {0}}), 1);
  Blocking blocking = race.run(TieRule::lexicographic);
  CHECK(blocking.row == 1);
  CHECK(blocking.decided_by == TieBreak::lexicographic);
  // w_0 nonbasic in column 1: the table holds minus its column of the inverse.
  race.dictionary.basic = {2, 1};       // z_0, w_1
  race.dictionary.nonbasic = {3, 0, 4}; // z_1, w_0, z0
  race.dictionary.table(0, 1) = 5;      // inverse entries -5 and 7
  race.dictionary.table(1, 1) = -7;
  blocking = race.run(TieRule::lexicographic);
  CHECK(blocking.row == 0);
}

TEST_CASE("a step is never longer than the tolerance beyond the smallest ratio") {
  // Harris' danger: a large value with a large rate passes if the tolerance is not divided by it.
  Race race({1, 1e-3}, columns({{0}, {0.9 * tie}}), 1);
  const Blocking blocking = race.run();
  // Row 1 is at 900 tolerances: going there would push row 0 far below zero.
  CHECK(blocking.row == 0);
  CHECK(blocking.tied == 1);
}

TEST_CASE("the most violated row for a cover is where q/d is smallest") {
  Race race({1, 1, 1}, columns({{-1}, {-6}, {-2}}), 1);
  race.dictionary.table.col(3) << 1, 4, 1; // q/d = -1, -1.5, -2
  RatioTest<double> test(race.dictionary.d, 1, TieRule::generic, {}, {race.candidates.data(), 3});
  CHECK(test.most_violated_row(3).row == 2);
}
