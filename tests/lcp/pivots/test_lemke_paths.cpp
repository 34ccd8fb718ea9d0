// Lemke's method pivot for pivot, in exact fractions, against the paths in fixtures/traces, which
// were computed apart from the library; and the families that take 2^n pivots.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

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

const std::filesystem::path traces = std::string(LCPUSH_SOURCE_DIR) + "/fixtures/traces";

Path golden(const std::string& name) { return read_path(traces / (name + ".path")); }

MatrixX<double> murty_triangle(Index n) {
  MatrixX<double> M = MatrixX<double>::Identity(n, n);
  M.triangularView<Eigen::StrictlyLower>().setConstant(2);
  return M;
}

/// q_i = base^(n - i) - base^(n + 1), i from 0. At base 2, chapter 6 of Murty 1988.
VectorX<double> exponential_q(Index n, int base) {
  VectorX<double> q(n);
  double power = 1;
  for (Index i = n - 1; i >= 0; --i) q[i] = power *= base;
  return q.array() - power * base;
}

DenseLcp<double> murty(Index n) { return {murty_triangle(n), exponential_q(n, 2)}; }

/// Murty's matrix made symmetric positive definite; the right-hand side is ours.
DenseLcp<double> fathi(Index n) {
  const MatrixX<double> L = murty_triangle(n);
  return {L * L.transpose(), exponential_q(n, 4)};
}

DenseLcp<double> tied(DenseLcp<double> lcp) {
  lcp.q.setConstant(-1);
  return lcp;
}

/// z0 enters for w_n; then pair n - (trailing zeros of k) changes sides in pivot k, which is the
/// reflected Gray code; z0 leaves in pivot 2^n, with z_1 alone in the basis.
template <class S> void check_gray_code_path(const DenseLcp<S>& lcp, bool ties) {
  const Index n = lcp.size();
  const VectorX<S> ones = VectorX<S>::Constant(n, S(1));
  const Problem<S> problem = lcp.view();
  LemkeRun<S> run(n);
  REQUIRE(run.lemke.init(problem, book_options(ones, TieRule::lexicographic)) == Status::running);
  REQUIRE(next_pivot(run));
  CHECK(run.lemke.last_pivot().entering == artificial(n));
  REQUIRE(run.lemke.last_pivot().leaving == slack(n - 1));
  std::vector<bool> z_left(static_cast<std::size_t>(n), true); // and not w
  z_left.back() = false;
  Index after_entry = 0;
  bool tied = run.lemke.last_pivot().blocking.tied > 1;
  while (next_pivot(run)) {
    ++after_entry;
    tied = tied || run.lemke.last_pivot().blocking.tied > 1;
    const Index k = after_entry + 1; // of all pivots
    if (k == Index(1) << n) break;
    Index pair = n - 1;
    for (Index rest = k; rest % 2 == 0; rest /= 2) --pair;
    REQUIRE(pair >= 0);
    const std::size_t p = static_cast<std::size_t>(pair);
    CAPTURE(k);
    REQUIRE(run.lemke.last_pivot().leaving == (z_left[p] ? slack(pair) : unknown(pair, n)));
    z_left[p] = !z_left[p];
  }
  CHECK(after_entry == (Index(1) << n) - 1);
  CHECK(run.lemke.last_pivot().leaving == artificial(n));
  CHECK(run.lemke.status() == Status::solved);
  CHECK(tied == ties);
  for (Index i = 0; i < n; ++i) CHECK(run.lemke.is_basic(i) == (i == 0));
  CHECK(run.z()[0] == -lcp.q[0] / lcp.M(0, 0));
}

} // namespace

TEST_CASE("every golden path is the solver's own, pivot for pivot and value for value") {
  int paths = 0;
  for (const auto& entry : std::filesystem::directory_iterator(traces)) {
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    REQUIRE(entry.path().extension() == ".path");
    check_path(read_path(entry.path()));
    ++paths;
  }
  CHECK(paths >= 31);
}

// Where nothing ties, the cover alone decides the path: there is but one that a book can print.
TEST_CASE("the book's paths meet no tie: Cottle-Pang-Stone 4.4.7, Murty 2.8, 2.9, 2.11") {
  for (const char* name :
       {"cps_4_4_7", "murty_2_8", "murty_2_9", "murty_2_11", "murty_2_11_cover_5_16"}) {
    CAPTURE(std::string(name));
    const Path path = golden(name);
    const DenseLcp<Rational> lcp = in_fractions(textbook(path.problem));
    const Problem<Rational> problem = lcp.view();
    LemkeRun<Rational> run(lcp.size());
    REQUIRE(run.lemke.init(problem, book_options(path.cover, path.rule)) == Status::running);
    while (next_pivot(run)) CHECK(run.lemke.last_pivot().blocking.tied == 1);
    CHECK(run.lemke.pivots() == static_cast<Index>(path.pivots.size()));
  }
}

TEST_CASE("Cottle-Pang-Stone 4.4.7: the second tableau's column of z1 is the book's (0, 2, -1)") {
  const DenseLcp<Rational> lcp = in_fractions(textbook("cps_4_4_7"));
  const VectorX<Rational> ones = VectorX<Rational>::Constant(3, Rational(1));
  const Problem<Rational> problem = lcp.view();
  LemkeRun<Rational> run(3);
  REQUIRE(run.lemke.init(problem, book_options(ones, TieRule::lexicographic)) == Status::running);
  REQUIRE(next_pivot(run));
  const Dictionary<Rational>& dictionary = run.lemke.dictionary();
  const auto column = dictionary.table.col(dictionary.column_of(unknown(0, 3)));
  CHECK(column[dictionary.row_of(artificial(3))] == Rational(0));
  CHECK(column[dictionary.row_of(slack(1))] == Rational(2));
  CHECK(column[dictionary.row_of(slack(2))] == Rational(-1));
}

TEST_CASE("Kostreva's examples cycle under the first-row rule with periods 6 and 4") {
  for (const int example : {1, 2}) {
    CAPTURE(example);
    const Path path = golden("kostreva_" + std::to_string(example) + "_cycle");
    CHECK(path.rule == TieRule::first_row);
    CHECK(path.pivots.size() - path.repeats == (example == 1 ? 6 : 4));
  }
}

TEST_CASE("degenerate problems: the lexicographic rule and the first tied row part, and both end") {
  for (const char* name : {"degenerate_psd", "murty_6_4_ones", "fathi_4_ones"}) {
    CAPTURE(std::string(name));
    const Path lexicographic = golden(name), first = golden(name + std::string("_first_row"));
    CHECK(lexicographic.problem == first.problem);
    CHECK(first.rule == TieRule::first_row);
    CHECK(first.end == "solved");
    CHECK(lexicographic.end == "solved");
    CHECK(first.pivots.size() < lexicographic.pivots.size());
  }
}

TEST_CASE("Murty's family takes 2^n - 1 pivots after z0's entry, in the order of the Gray code") {
  for (Index n = 1; n <= 12; ++n) {
    CAPTURE(n);
    check_gray_code_path(in_fractions(murty(n)), false);
    check_gray_code_path(murty(n), false);
  }
}

TEST_CASE("a symmetric positive definite family takes as many, and the same ones") {
  for (Index n = 1; n <= 12; ++n) {
    CAPTURE(n);
    check_gray_code_path(in_fractions(fathi(n)), false);
  }
}

TEST_CASE("with q = -1 the lexicographic rule takes the families' path too, through ties") {
  for (Index n = 1; n <= 12; ++n) {
    CAPTURE(n);
    check_gray_code_path(in_fractions(tied(murty(n))), n > 1);
    check_gray_code_path(in_fractions(tied(fathi(n))), n > 1);
  }
}

TEST_CASE("Murty's triangle transposed: 2 pivots with q = -1, 2^n with the family's q in reverse") {
  for (Index n = 1; n <= 12; ++n) {
    CAPTURE(n);
    const VectorX<Rational> ones = VectorX<Rational>::Constant(n, Rational(1));
    DenseLcp<double> lcp = murty(n);
    lcp.M.transposeInPlace();
    for (const bool hard : {false, true}) {
      lcp.q = hard ? VectorX<double>(murty(n).q.reverse()) : VectorX<double>::Constant(n, -1);
      const DenseLcp<Rational> exact = in_fractions(lcp);
      LemkeRun<Rational> run(n);
      REQUIRE(run.solve(exact, book_options(ones, TieRule::lexicographic)) == Status::solved);
      CHECK(run.lemke.pivots() == (hard ? Index(1) << n : 2));
    }
  }
}

TEST_CASE("the families' fixtures are their members at n = 4") {
  const auto same = [](const std::string& name, const DenseLcp<double>& lcp) {
    const DenseLcp<double> file = textbook(name);
    CHECK((file.M - lcp.M).isZero(0));
    CHECK((file.q - lcp.q).isZero(0));
  };
  same("murty_6_4", murty(4));
  same("murty_6_4_ones", tied(murty(4)));
  same("fathi_4", fathi(4));
  same("fathi_4_ones", tied(fathi(4)));
}
