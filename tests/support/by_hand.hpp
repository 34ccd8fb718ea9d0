// Problems pivoted as docs/teach/lemke_by_hand.md does it, in fractions, and checks of the outcome
// that share no arithmetic with the pivots.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "lcpush/desktop/pivots.hpp"

namespace lcpush::test::by_hand {

using namespace lcpush::desktop;

inline const std::string fixtures = std::string(LCPUSH_SOURCE_DIR) + "/fixtures/";

using Numbers = std::vector<Rational>;

/// "1/2 -3": as on the command line.
inline Numbers numbers(const std::string& text) {
  return parse_inline_vector<Rational>(text, "test").values;
}

inline ExactProblem typed(const std::string& M, const std::string& q) {
  return {parse_inline_matrix<Rational>(M, "M"), parse_inline_vector<Rational>(q, "q"), 0};
}

inline ExactProblem textbook(const std::string& name) {
  const std::string stem = fixtures + "textbook/" + name;
  return {read_matrix_market<Rational>(stem + ".M.mtx"),
          read_matrix_market<Rational>(stem + ".q.mtx"), 0};
}

/// fixtures/`path` with `from` replaced by `to`.
inline ExactProblem scene(const std::string& path, const std::string& from = "",
                          const std::string& to = "") {
  std::ifstream in(fixtures + path);
  REQUIRE(in.good());
  std::stringstream read;
  read << in.rdbuf();
  std::string text = read.str();
  if (!from.empty()) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  }
  const SceneOf<Rational> exact = parse_scene<Rational>(text, path);
  CHECK(exact.inexact.empty());
  return exact_problem(exact);
}

struct How {
  std::string cover; ///< empty: ones
  TieRule rule = TieRule::lexicographic;
  bool z0_wins_ties = true;
};

inline PivotTrace pivoted(const ExactProblem& problem, const How& how = {}) {
  PivotOptions options;
  options.is_exact = true;
  options.rule = how.rule;
  options.z0_wins_ties = how.z0_wins_ties;
  if (!how.cover.empty()) options.cover = numbers(how.cover);
  return trace_pivots(problem, options, RawStory(problem.M.rows));
}

inline std::string name(const PivotTrace& trace, Index variable) {
  return trace.variables[static_cast<std::size_t>(variable)].name;
}

/// "z0 w2, z2 w1": what enters and what leaves.
inline std::string path_of(const PivotTrace& trace) {
  std::string text;
  for (const TracedPivot& pivot : trace.pivots)
    text +=
        (text.empty() ? "" : ", ") + name(trace, pivot.entering) + " " + name(trace, pivot.leaving);
  return text;
}

inline Rational product(const ExactProblem& problem, Index row, const Numbers& z) {
  Rational sum(0);
  for (Index j = 0; j < problem.M.cols; ++j)
    sum += problem.M.values[static_cast<std::size_t>(j * problem.M.rows + row)] *
           z[static_cast<std::size_t>(j)];
  return sum;
}

inline Rational transposed_product(const ExactProblem& problem, Index column, const Numbers& y) {
  Rational sum(0);
  for (Index i = 0; i < problem.M.rows; ++i)
    sum += problem.M.values[static_cast<std::size_t>(column * problem.M.rows + i)] *
           y[static_cast<std::size_t>(i)];
  return sum;
}

inline bool solves(const ExactProblem& problem, const Numbers& z) {
  for (Index i = 0; i < problem.M.rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Rational w = problem.q.values[at] + product(problem, i, z);
    if (z[at] < Rational(0) || w < Rational(0) || z[at] * w != Rational(0)) return false;
  }
  return true;
}

/// y >= 0 with M' y <= 0 and q' y < 0: no z >= 0 has q + M z >= 0.
inline bool proves_infeasible(const ExactProblem& problem, const Numbers& y) {
  Rational bound(0);
  for (Index j = 0; j < problem.M.cols; ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (y[at] < Rational(0) || transposed_product(problem, j, y) > Rational(0)) return false;
    bound += problem.q.values[at] * y[at];
  }
  return bound < Rational(0);
}

inline void check_solved(const ExactProblem& problem, const PivotTrace& trace,
                         const std::string& z) {
  REQUIRE(trace.status == Status::solved);
  CHECK(trace.is_proved);
  const Numbers expected = numbers(z);
  REQUIRE(expected.size() == trace.z.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(trace.z[i].fraction == expected[i].text());
  if (problem.free_count == 0) CHECK(solves(problem, expected));
}

/// The ray is the expected one, and one: v >= 0, M v + d v0 >= 0, in each pair a zero.
inline void check_ray(const ExactProblem& problem, const PivotTrace& trace, const std::string& v,
                      const std::string& v0, const std::string& cover = "") {
  REQUIRE(trace.status == Status::ray);
  REQUIRE(trace.ray.has_value());
  const Numbers expected = numbers(v);
  REQUIRE(expected.size() == trace.ray->v.size());
  CHECK(trace.ray->v0.fraction == v0);
  const Rational artificial_part = numbers(v0)[0];
  for (Index i = 0; i < problem.M.rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    CHECK(trace.ray->v[at].fraction == expected[at].text());
    const Rational d = cover.empty() ? Rational(1) : numbers(cover)[at];
    const Rational u = product(problem, i, expected) + d * artificial_part;
    CHECK(expected[at] >= Rational(0));
    CHECK(u >= Rational(0));
    CHECK(u * expected[at] == Rational(0));
  }
}

inline std::size_t ties_of(const PivotTrace& trace) {
  std::size_t count = 0;
  for (const TracedPivot& pivot : trace.pivots)
    if (!pivot.ties.empty()) ++count;
  return count;
}

inline const How by_first_row{"", TieRule::first_row, true};
inline const How z0_last{"", TieRule::lexicographic, false};

} // namespace lcpush::test::by_hand
