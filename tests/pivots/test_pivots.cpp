// Traces of pivots: the books' paths, the physics in words, and that tracing tells the truth.
#include <doctest/doctest.h>

#include <filesystem>

#include "lcpush/desktop/pivots.hpp"
#include "support/random_grasp.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

const std::string root = LCPUSH_SOURCE_DIR;

/// Rows of numbers as on the command line.
ExactProblem problem(const std::string& M, const std::string& q) {
  return {parse_inline_matrix<Rational>(M, "M"), parse_inline_vector<Rational>(q, "q"), 0};
}

ExactProblem textbook(const std::string& name) {
  const std::string stem = root + "/fixtures/textbook/" + name;
  return {read_matrix_market<Rational>(stem + ".M.mtx"),
          read_matrix_market<Rational>(stem + ".q.mtx"), 0};
}

PivotTrace trace_of(const ExactProblem& given, const PivotOptions& options) {
  return trace_pivots(given, options, RawStory(given.M.rows));
}

PivotOptions exactly() {
  PivotOptions options;
  options.is_exact = true;
  return options;
}

Rational fraction(const TraceNumber& x) {
  REQUIRE(!x.fraction.empty());
  return *Rational::parse(x.fraction);
}

/// A scene's trace with everything that it needs.
struct SceneTrace {
  SceneFile file;
  Push push;
  std::unique_ptr<Story> story;
  PivotTrace trace;

  explicit SceneTrace(const std::string& path, bool is_exact = true, Index facets = 4)
      : file(with_facets(read_scene(path), facets)), push(file), story(push_story(push)) {
    SceneOf<Rational> exact = read_scene<Rational>(path);
    exact.facets = facets;
    PivotOptions options;
    options.is_exact = is_exact;
    trace = trace_pivots(is_exact ? exact_problem(exact) : exact_problem(file), options, *story);
  }

  static SceneFile with_facets(SceneFile file, Index facets) {
    file.facets = facets;
    return file;
  }
};

std::vector<std::filesystem::path> files_in(const std::string& folder, const std::string& ending) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(root + "/fixtures/" + folder))
    if (entry.path().extension() == ending) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

TEST_CASE("the coin's pivots as mechanics") {
  const SceneTrace coin(root + "/fixtures/scenes/coin.toml");
  REQUIRE(coin.trace.status == Status::solved);
  CHECK(coin.trace.is_proved);
  std::vector<std::string> sentences;
  for (const TracedPivot& pivot : coin.trace.pivots) sentences.push_back(pivot.sentence);
  CHECK(
      sentences ==
      std::vector<std::string>{
          "The artificial variable z0 enters, just large enough for every law to hold with its "
          "help; table.1 touches and may press.",
          "As table.1 presses harder, thumb.1 touches and may press.",
          "As thumb.1 presses harder, the object moves along +x at table.1 as fast as it slips, so "
          "that friction along -x may act.",
          "As friction of table.1 along -x grows, table.1 reaches its friction cone and starts "
          "to slide towards +x.",
          "As table.1 slides faster, the artificial variable z0 is gone: every law holds."});
  CHECK(coin.trace.variables[5].meaning == "normal of table.1 (N)");
  CHECK(coin.trace.variables[7].meaning == "friction of table.1 along -x (N)");
  CHECK(coin.trace.variables[8].meaning == "slip of table.1 (m/s^2)");
  CHECK(coin.trace.z[4].fraction == "6");
}

TEST_CASE("all fixture scenes end as they should in fractions, their bases proved") {
  for (const auto& file : files_in("scenes", ".toml")) {
    CAPTURE(file.string());
    const SceneTrace scene(file.string());
    REQUIRE(scene.trace.status == Status::solved);
    CHECK(scene.trace.is_proved);
    CHECK(scene.trace.pivots.back().leaving == artificial(scene.trace.size));
  }
}

TEST_CASE("decimals end in the fractions' solution where it is unique") {
  for (const char* of : {"straight_slide_point", "lever", "coin", "rolling"}) {
    CAPTURE(of);
    const std::string path = root + "/fixtures/scenes/" + of + ".toml";
    const SceneTrace exact(path), decimals(path, false);
    REQUIRE(exact.trace.status == Status::solved);
    REQUIRE(decimals.trace.status == Status::solved);
    CHECK_FALSE(decimals.trace.is_proved);
    // The pusher's first normal.
    for (Index i = 0; i < exact.trace.size; ++i) {
      const Name unknown = name_of(exact.push.layout(), i);
      const bool pushes =
          unknown.meaning == Meaning::normal &&
          exact.file.bodies[static_cast<std::size_t>(exact.file.body_of(unknown.of))].role ==
              Role::pusher;
      if (!pushes) continue;
      const auto at = static_cast<std::size_t>(i);
      CHECK(decimals.trace.z[at].value == doctest::Approx(exact.trace.z[at].value).epsilon(1e-9));
    }
  }
}

TEST_CASE("an actuator's bound S is carried: closing starts from -S, and no S is left at the end") {
  const SceneTrace lever(root + "/fixtures/scenes/lever.toml");
  REQUIRE(lever.trace.free_count == 1);
  bool seen = false;
  for (const TracedPivot& pivot : lever.trace.pivots)
    for (const auto& ratio : pivot.ratios) seen = seen || (ratio && ratio->has_S());
  CHECK(seen);
  for (const TraceNumber& z : lever.trace.z) CHECK(z.fraction.find('S') == std::string::npos);
  REQUIRE(lever.trace.last.has_value());
  for (std::size_t i = 0; i < lever.trace.last->rows.size(); ++i) {
    const bool is_closing = lever.trace.last->rows[i] == 2 * lever.trace.size - 1;
    CHECK(lever.trace.last->values[i].has_S() == is_closing);
  }
}

TEST_CASE("as solved: the trace has the pivots that solve counts, and ends in its basis") {
  for (const char* of : {"straight_slide", "tipping", "rolling", "jam"}) {
    CAPTURE(of);
    const SceneFile file = read_scene(root + "/fixtures/scenes/" + of + ".toml");
    Push push(file), again(file);
    const std::unique_ptr<Story> story = push_story(push);
    const PivotTrace trace = trace_solve(push, {}, *story);
    PushOptions options;
    options.other_paths = 0;
    const PushReport report = again.solve(options);
    CHECK(trace.status == report.status);
    CHECK(static_cast<Index>(trace.pivots.size()) == report.run.pivots);
    CHECK(trace.ray.has_value() == (report.status == Status::ray));
    REQUIRE(!trace.runs.empty());
    CHECK(trace.runs[0].start.rows[0] == slack(0));
    // Scaled numbers times their units are the answer in SI.
    if (report.status != Status::solved) continue;
    const TracedRun& last = trace.runs.back();
    for (std::size_t i = 0; i < trace.last->rows.size(); ++i) {
      const Index variable = trace.last->rows[i];
      if (variable < trace.size || variable == artificial(trace.size)) continue;
      const Name unknown = name_of(push.layout(), variable - trace.size);
      if (unknown.meaning != Meaning::normal) continue;
      CHECK(trace.last->values[i].finite.value * last.unit[static_cast<std::size_t>(variable)] ==
            doctest::Approx(report.answer.contacts[unknown.of].normal_force).epsilon(1e-6));
    }
  }
}

TEST_CASE("a user may choose among the ties, and what was chosen is marked") {
  PivotOptions options = exactly();
  std::size_t asked = 0;
  options.choose = [&](const PivotTrace& trace) {
    ++asked;
    const TracedPivot& pivot = trace.pivots.back();
    REQUIRE(pivot.before.has_value());
    if (pivot.ties.empty()) return pivot.row;
    const auto& rows = pivot.before->rows;
    return static_cast<Index>(std::find(rows.begin(), rows.end(), pivot.ties.front()) -
                              rows.begin());
  };
  const PivotTrace trace = trace_of(textbook("kostreva_1"), options);
  CHECK(asked == trace.pivots.size());
  CHECK(trace.pivots[0].leaving == slack(0));
  CHECK(trace.pivots[0].chosen);
}

TEST_CASE("decimals taken as typed: 0.2 is 1/5, and 1/3 is 1/3") {
  const PivotTrace trace = trace_of(problem("0.2 0; 0 1/3", "-0.1 -1"), exactly());
  REQUIRE(trace.status == Status::solved);
  CHECK(trace.z[0].fraction == "1/2");
  CHECK(trace.z[1].fraction == "3");
}

TEST_CASE("large traces leave the pivots' tableaus out and keep every start") {
  PivotOptions options = exactly();
  options.most_entries = 3 * 4; // one tableau of three rows
  const PivotTrace trace = trace_of(textbook("kostreva_1"), options);
  CHECK(trace.pivots[0].before.has_value());
  CHECK_FALSE(trace.pivots[1].before.has_value());
  CHECK(trace.runs[0].start.rows.size() == 3);
}

TEST_CASE("a ray in fractions: v, v0 and the words") {
  const PivotTrace trace = trace_of(textbook("murty_2_9"), exactly());
  REQUIRE(trace.ray.has_value());
  const ExactProblem given = textbook("murty_2_9");
  const Rational v0 = fraction(trace.ray->v0);
  for (Index i = 0; i < 3; ++i) {
    Rational u = v0;
    for (Index j = 0; j < 3; ++j)
      u += given.M(i, j) * fraction(trace.ray->v[static_cast<std::size_t>(j)]);
    CHECK(u >= Rational(0));
    CHECK(u * fraction(trace.ray->v[static_cast<std::size_t>(i)]) == Rational(0));
  }
  CHECK(trace.ray->words.find("without end") != std::string::npos);
}

TEST_CASE("a jam's ray says who squeezes whom") {
  const std::string path = root + "/fixtures/scenes/jam.toml";
  SceneFile file = read_scene(path);
  file.facets = 4;
  file.pressure = Pressure::rigid;
  Push push(file);
  const std::unique_ptr<Story> story = push_story(push);
  const PivotTrace trace = trace_pivots(exact_problem(file), exactly(), *story);
  REQUIRE(trace.status == Status::ray);
  CHECK(trace.ray->words.find("squeezes the object against stop") != std::string::npos);
}
