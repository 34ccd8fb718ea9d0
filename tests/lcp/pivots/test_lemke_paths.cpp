// Lemke's method pivot for pivot, in exact fractions, against the paths in fixtures/traces, which
// were computed apart from the library; and the families that take 2^n pivots.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lcpush/desktop/exact_pivots.hpp"
#include "lcpush/desktop/rational.hpp"
#include "support/textbook.hpp"

using namespace lcpush;
using namespace lcpush::test;
using desktop::Rational;

namespace {

/// "w2", "z1" or "z0", counted from 1 as the books do.
std::string variable_name(Index variable, Index n) {
  if (variable == artificial(n)) return "z0";
  return variable < n ? "w" + std::to_string(variable + 1) : "z" + std::to_string(variable - n + 1);
}

Rational fraction(const std::string& text) {
  const std::optional<Rational> value = Rational::parse(text);
  REQUIRE(value);
  return *value;
}

struct Value {
  std::string variable;
  Rational value;
};

/// A line of a path: "z0 w2  w1=3 z0=1/2", or how it ended: "ray  z1=1 z2=0 z0=4".
struct Line {
  std::string entering, leaving;
  std::vector<Value> values;
};

/// fixtures/traces/NAME.path
struct Path {
  std::string problem, end;
  TieRule rule = TieRule::lexicographic;
  VectorX<Rational> cover;
  std::vector<Line> pivots;
  std::vector<Value> result; ///< the solution, or the ray with its largest entry 1
  std::size_t repeats = 0;   ///< the pivot whose basis has come back
};

std::vector<Value> read_values(std::istream& words) {
  std::vector<Value> values;
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    REQUIRE(equals != std::string::npos);
    values.push_back({word.substr(0, equals), fraction(word.substr(equals + 1))});
  }
  return values;
}

Path read_path(const std::filesystem::path& file) {
  std::ifstream in(file);
  REQUIRE(in.good());
  Path path;
  for (std::string text; std::getline(in, text);) {
    if (text.empty() || text[0] == '%') continue;
    std::istringstream words(text);
    std::string first, second;
    words >> first;
    if (first == "problem") {
      words >> path.problem;
    } else if (first == "rule") {
      words >> second;
      REQUIRE((second == "lexicographic" || second == "first_row"));
      path.rule = second == "first_row" ? TieRule::first_row : TieRule::lexicographic;
    } else if (first == "cover") {
      std::vector<Rational> cover;
      while (words >> second) cover.push_back(fraction(second));
      path.cover = Eigen::Map<VectorX<Rational>>(cover.data(), static_cast<Index>(cover.size()));
    } else if (first == "solved" || first == "ray") {
      path.end = first;
      path.result = read_values(words);
    } else if (first == "repeats") {
      path.end = first;
      words >> path.repeats;
    } else {
      words >> second;
      path.pivots.push_back({first, second, read_values(words)});
    }
  }
  REQUIRE(!path.end.empty());
  return path;
}

/// The next pivot, or how the run ended instead. Before a ray the basis is factored once more.
template <class S> bool next_pivot(LemkeRun<S>& run) {
  const Index before = run.lemke.pivots();
  while (run.lemke.status() == Status::running && run.lemke.pivots() == before)
    (void)run.lemke.step();
  return run.lemke.pivots() > before;
}

template <class S> std::vector<int> basis(const LemkeRun<S>& run) {
  const Span<int>& basic = run.lemke.dictionary().basic;
  std::vector<int> result(basic.data, basic.data + basic.size);
  std::sort(result.begin(), result.end());
  return result;
}

/// The values are those of all basic variables.
void check_values(const LemkeRun<Rational>& run, const std::vector<Value>& expected) {
  const Dictionary<Rational>& dictionary = run.lemke.dictionary();
  const Index n = dictionary.size();
  REQUIRE(static_cast<Index>(expected.size()) == n);
  for (const Value& value : expected) {
    CAPTURE(value.variable);
    Index row = 0;
    while (row < n && variable_name(dictionary.basic[row], n) != value.variable) ++row;
    REQUIRE(row < n);
    CHECK(dictionary.values(row, 0) == value.value);
  }
}

void check_result(const LemkeRun<Rational>& run, const Path& path) {
  const bool ray = path.end == "ray";
  REQUIRE(run.lemke.status() == (ray ? Status::ray : Status::solved));
  const Index n = run.lemke.dictionary().size();
  REQUIRE(static_cast<Index>(path.result.size()) == n + (ray ? 1 : 0));
  for (Index i = 0; i < n; ++i) {
    const Value& value = path.result[static_cast<std::size_t>(i)];
    REQUIRE(value.variable == variable_name(unknown(i, n), n));
    CHECK((ray ? run.ray() : run.z())[i] == value.value);
  }
  if (ray) CHECK(run.lemke.ray_artificial() == path.result.back().value);
}

void check_path(const Path& path) {
  const DenseLcp<Rational> lcp = in_fractions(textbook(path.problem));
  const Index n = lcp.size();
  REQUIRE(path.cover.size() == n);
  LemkeRun<Rational> run(n);
  const Problem<Rational> problem = lcp.view();
  REQUIRE(run.lemke.init(problem, book_options(path.cover, path.rule)) == Status::running);
  std::vector<std::vector<int>> bases;
  std::vector<int> order; // of the rows, on which the first-row rule depends
  for (const Line& line : path.pivots) {
    CAPTURE(bases.size());
    REQUIRE(next_pivot(run));
    CHECK(variable_name(run.lemke.last_pivot().entering, n) == line.entering);
    REQUIRE(variable_name(run.lemke.last_pivot().leaving, n) == line.leaving);
    check_values(run, line.values);
    bases.push_back(basis(run));
    const Span<int>& basic = run.lemke.dictionary().basic;
    if (bases.size() == path.repeats) order.assign(basic.data, basic.data + n);
  }
  if (path.end != "repeats") {
    CHECK_FALSE(next_pivot(run));
    check_result(run, path);
    return;
  }
  // No basis but the last comes back, and that with its rows in order: so it goes on for ever.
  REQUIRE(path.repeats >= 1);
  const auto last = bases.end() - 1;
  CHECK(std::find(bases.begin(), last, *last) - bases.begin() + 1 ==
        static_cast<std::ptrdiff_t>(path.repeats));
  std::vector<std::vector<int>> others(bases.begin(), last);
  std::sort(others.begin(), others.end());
  CHECK(std::adjacent_find(others.begin(), others.end()) == others.end());
  CHECK(std::equal(order.begin(), order.end(), run.lemke.dictionary().basic.data));
  for (int turn = 0; turn < 3; ++turn)
    for (std::size_t k = path.repeats; k < path.pivots.size(); ++k) {
      REQUIRE(next_pivot(run));
      REQUIRE(variable_name(run.lemke.last_pivot().leaving, n) == path.pivots[k].leaving);
      CHECK(basis(run) == bases[k]);
    }
}

/// Chapter 6 of Murty 1988: ones on the diagonal, twos below; q_i = 2^(n - i) - 2^(n + 1), i from
/// 0.
DenseLcp<double> murty(Index n) {
  DenseLcp<double> lcp{MatrixX<double>::Identity(n, n), VectorX<double>(n)};
  lcp.M.triangularView<Eigen::StrictlyLower>().setConstant(2);
  for (Index i = 0; i < n; ++i)
    lcp.q[i] = std::ldexp(1.0, int(n - i)) - std::ldexp(1.0, int(n + 1));
  return lcp;
}

/// L L' for that matrix L; the right-hand side is ours.
DenseLcp<double> fathi(Index n) {
  const MatrixX<double> L = murty(n).M;
  DenseLcp<double> lcp{L * L.transpose(), VectorX<double>(n)};
  for (Index i = 0; i < n; ++i)
    lcp.q[i] = std::ldexp(1.0, int(2 * (n - i))) - std::ldexp(1.0, int(2 * (n + 1)));
  return lcp;
}

} // namespace

TEST_CASE("every golden path is the solver's own, pivot for pivot and value for value") {
  int paths = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/traces")) {
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    REQUIRE(entry.path().extension() == ".path");
    check_path(read_path(entry.path()));
    ++paths;
  }
  CHECK(paths >= 31);
}

TEST_CASE(
    "Murty's family, and one symmetric positive definite, take 2^n pivots and end at z1 alone") {
  for (Index n = 1; n <= 10; ++n)
    for (const DenseLcp<double>& lcp : {murty(n), fathi(n)}) {
      CAPTURE(n);
      const VectorX<Rational> ones = VectorX<Rational>::Constant(n, Rational(1));
      const DenseLcp<Rational> exact = in_fractions(lcp);
      LemkeRun<Rational> run(n);
      REQUIRE(run.solve(exact, book_options(ones, TieRule::lexicographic)) == Status::solved);
      CHECK(run.lemke.pivots() == Index(1) << n);
      CHECK(run.z()[0] == -exact.q[0] / exact.M(0, 0));
      for (Index i = 1; i < n; ++i) CHECK(run.z()[i] == Rational(0));
    }
}
