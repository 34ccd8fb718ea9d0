// lcpush lcp: raw linear complementarity problems.

#include "cli/certificate.hpp"
#include "cli/commands.hpp"
#include "cli/history.hpp"
#include "cli/progress.hpp"
#include "cli/raw_arguments.hpp"
#include "cli/raw_bounds.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

#include <algorithm>
#include <cstdio>

namespace lcpush::cli {
namespace {

/// --solver, --sweeps and --relaxation.
RawOptions read_options(const Arguments& arguments) {
  RawOptions options;
  options.solver = chosen_solver(arguments);
  for (const char* option : {"--sweeps", "--relaxation", "--history"})
    if (options.solver == Solver::lemke && arguments.has(option))
      throw UsageError(std::string(option) +
                       " is about sweeps: it goes with --solver gauss-seidel or hybrid");
  // Before pivots a few sweeps have to do: where they come near at all, they do so soon.
  if (options.solver == Solver::hybrid) options.sweeps.max_sweeps = 200;
  SweepOptions<double>& sweeps = options.sweeps;
  sweeps.max_sweeps = arguments.whole("--sweeps", {1}).value_or(sweeps.max_sweeps);
  sweeps.relaxation =
      arguments.number("--relaxation", 2, " (1: plain Gauss-Seidel)").value_or(sweeps.relaxation);
  return options;
}

/// "text", "json", or of a history "csv".
std::string read_format(const Arguments& arguments) {
  if (arguments.has("--history")) return arguments.format({"text", "json", "csv"});
  if (arguments.value("--format") == "csv")
    throw UsageError("--format csv is for --history; an answer is text or json");
  return arguments.format();
}

[[noreturn]] void refuse_diagonal(const Arguments& arguments, const RawProblem& problem,
                                  Index row) {
  const std::string message = "--solver gauss-seidel needs a positive diagonal, but row " +
                              std::to_string(row + 1) + " has " + shown(problem.M(row, row)) +
                              "; use lemke or hybrid";
  if (arguments.files().empty()) throw UsageError(message);
  throw InputError(arguments.files()[0] + ": " + message);
}

/// Lemke's pivots store the largest piece whole: what that will take, before it is taken.
void announce_effort(const Arguments& arguments, const RawProblem& problem) {
  constexpr Index announced = 2000;
  const Index n = largest_piece(problem);
  const std::string size = std::to_string(n) + " unknowns in one piece";
  const std::string other = "; --solver gauss-seidel stores only what is not zero";
  if (n > largest_dimension)
    throw InputError((arguments.files().empty() ? "--M" : arguments.files()[0]) + ": " + size +
                     " are too many for pivots, which take " + std::to_string(largest_dimension) +
                     other);
  if (n < announced) return;
  const double entries = static_cast<double>(n) * static_cast<double>(n);
  const bool has_free =
      std::find(problem.free.begin(), problem.free.end(), 1) != problem.free.end();
  const double bytes = 8 * entries * (has_free ? 5 : 2);
  std::fputs(wrapped("lcpush: " + size + ": pivots store " + printed("%.1f GB", bytes / 1e9) +
                         " and are mostly " + std::to_string(n / 2) + " to " +
                         std::to_string(2 * n) + printed(", each %.0f million", entries / 1e6) +
                         " multiplications" + other + "\n",
                     usual_width)
                 .c_str(),
             stderr);
}

/// Before any work.
void check_certifiable(const Arguments& arguments, const RawProblem& problem) {
  if (!arguments.has("--certify")) return;
  refuse_certificate_of_stdin(arguments);
  if (arguments.files().empty())
    throw UsageError("--certify ties its proof to files: give M and q as M.mtx q.mtx");
  if (problem.bounds.given())
    throw UsageError("--certify proves problems without boxes; leave --lo, --hi and --findex out");
  if (problem.size() > limits::rows_certified)
    throw UsageError("--certify takes at most " + std::to_string(limits::rows_certified) +
                     " rows, and M has " + std::to_string(problem.size()));
}

int run_lcp(const Arguments& arguments) {
  const std::string format = read_format(arguments);
  RawOptions options = read_options(arguments);
  const std::string solver = solver_text(options.solver);
  const RawProblem problem = read_raw_problem(arguments, arguments.files());
  check_certifiable(arguments, problem);
  if (options.solver != Solver::gauss_seidel) announce_effort(arguments, problem);
  RawAnswer answer;
  {
    Progress progress;
    options.watcher = &progress;
    answer = solve_raw(problem, options);
  }
  if (answer.bad_diagonal >= 0) refuse_diagonal(arguments, problem, answer.bad_diagonal);
  if (answer.inconsistent_row >= 0)
    throw InputError((arguments.files().empty() ? "--q" : arguments.files()[1]) + ": equality " +
                     std::to_string(answer.inconsistent_row + 1) +
                     " of --free cannot hold: what the others leave of it says 0 = something");
  std::vector<HistoryRow> rows;
  for (const SweepResidual& check : answer.history) rows.push_back({check.sweep, {check.residual}});
  if (arguments.has("--history"))
    write_output(arguments, history_text(format, solver, answer.status, {"residual"}, rows));
  else if (format == "json")
    write_output(arguments, raw_json(problem, answer, solver));
  else
    write_text(arguments, raw_text(problem, answer));
  const bool is_proved = write_certificate(arguments, [&]() -> std::optional<Certificate> {
    const auto [M, q] = read_matrices<Rational>(arguments, arguments.files());
    std::optional<Certificate> certificate = certify_raw(M, q, problem.free, answer);
    for (const std::string& path : arguments.files())
      if (certificate) certificate->add_fingerprint(read_text_file(path, limits::matrix_bytes));
    return certificate;
  });
  return answer.status == Status::solved && is_proved ? 0 : 1;
}

} // namespace

Command lcp_command() {
  return {"lcp",
          "M.mtx q.mtx | --M \"2 1; 1 2\" --q \"-5 -6\" [OPTIONS]",
          "solve a raw linear complementarity problem",
          "Finds z with w = M z + q, z >= 0, w >= 0, z'w = 0. M and q are Matrix Market files\n"
          "(- is standard input), or typed in place. Rows named by --free are equalities\n"
          "w_i = 0 with a free z_i. Or in a box: lo <= z <= hi, w >= 0 where z is at lo, <= 0\n"
          "at hi, 0 in between. ENDS and ROWS are n x 1 files or numbers, inf among them.\n"
          "Gauss-Seidel takes row by row, stores no zeros and needs a positive diagonal; hybrid\n"
          "does not, and goes on with Lemke's pivots.\n\n"
          "Example:\n  lcpush lcp --M \"2 1; 1 2\" --q \"-5 -6\"\n"
          "  lcpush lcp --M \"2 1; 1 2\" --q \"-5 -6\" --lo 0 --hi \"1 inf\"\n",
          with_common_options({
              matrix_option,
              vector_option,
              free_option,
              lo_option,
              hi_option,
              findex_option,
              solver_option,
              {"--sweeps", "N", "most sweeps (default 5000; 200 before hybrid's pivots)"},
              {"--relaxation", "W", "of the sweeps, between 0 and 2 (default 1)"},
              {"--history", "", "the residual after each check instead; also --format csv"},
              certify_option,
          }),
          2,
          run_lcp};
}

} // namespace lcpush::cli
