// lcpush lcp: raw linear complementarity problems.

#include "cli/commands.hpp"
#include "cli/history.hpp"
#include "cli/progress.hpp"
#include "cli/raw_arguments.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

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

std::string reason_of(const RawAnswer& answer) {
  const std::string at = printed(" (the scaled residual is %.1e)", answer.residual);
  if (answer.status == Status::sweep_limit)
    return "the limit of sweeps was reached" + at + "; raise --sweeps";
  if (answer.status == Status::stagnated)
    return "the sweeps make no more progress" + at + "; use hybrid or lemke";
  if (answer.status == Status::ray)
    return "Lemke ended on a secondary ray under " + counted(answer.covers, "covering vector");
  if (answer.status == Status::pivot_limit) return "the limit of pivots was reached";
  return reason_text(answer.reason);
}

std::vector<std::string> basis_of(const RawAnswer& answer) {
  std::vector<std::string> basis;
  for (std::size_t i = 0; i < answer.basic.size(); ++i)
    basis.push_back((answer.basic[i] != 0 ? "z" : "w") + std::to_string(i + 1));
  return basis;
}

std::string as_json(const RawAnswer& answer, const std::string& solver) {
  const bool solved = answer.status == Status::solved;
  JsonWriter json;
  json.begin_object();
  json.member("status", status_text(answer.status)).member("solver", solver);
  json.member("pivots", answer.pivots).member("sweeps", answer.sweeps);
  json.member("covers", answer.covers).member("residual", when(solved, answer.residual));
  json.member("z", when(solved, answer.z)).member("w", when(solved, answer.w));
  json.member("basis", when(solved, basis_of(answer)));
  if (!solved) json.member("reason", reason_of(answer)).member("ray", unless_empty(answer.ray));
  json.list("redundant_rows", answer.redundant_rows, [&](Index row) { json.value(row + 1); });
  return json.end_object().text();
}

/// "12 sweeps and 3 pivots", without what was not tried.
std::string effort_of(const RawAnswer& answer) {
  const std::string sweeps = std::to_string(answer.sweeps) + " sweeps";
  const std::string pivots = std::to_string(answer.pivots) + " pivots";
  if (answer.covers == 0) return sweeps;
  return answer.history.empty() ? pivots : sweeps + " and " + pivots;
}

std::string as_text(const RawProblem& problem, const RawAnswer& answer) {
  const std::size_t n = problem.free.size();
  std::string text;
  if (answer.status != Status::solved) {
    text = "Not solved (" + std::string(status_text(answer.status)) + "): " + reason_of(answer) +
           ".\n" +
           (answer.covers == 0 ? "Sweeps: " + std::to_string(answer.sweeps)
                               : "Pivots: " + std::to_string(answer.pivots)) +
           ".\n";
    if (answer.ray.empty()) return text;
    text += "\nThe ray v (v >= 0, M v >= 0 along it up to the covering vector, largest entry 1):\n";
    for (std::size_t i = 0; i < n; ++i)
      if (answer.ray[i] != 0)
        text += "  v" + std::to_string(i + 1) + printed(" = %.9g\n", answer.ray[i]);
    return text;
  }
  text =
      "Solved in " + effort_of(answer) +
      (answer.covers > 1 ? " under " + std::to_string(answer.covers) + " covering vectors" : "") +
      "; largest scaled residual " + residual_text(answer.residual) + ".\n";
  for (const Index row : answer.redundant_rows)
    text += "Equality " + std::to_string(row + 1) + " follows from the others and was dropped.\n";
  text += "\n    i  basic" + std::string("                z                w\n");
  for (std::size_t i = 0; i < n; ++i) {
    std::string row = std::to_string(i + 1);
    row.insert(0, row.size() < 5 ? 5 - row.size() : 0, ' ');
    row += answer.basic[i] != 0 ? "  z    " : "  w    ";
    text += row + printed("%17.9g", answer.z[i]) +
            (problem.free[i] != 0 ? "             free\n" : printed("%17.9g\n", answer.w[i]));
  }
  return text;
}

int run_lcp(const Arguments& arguments) {
  const std::string format = read_format(arguments);
  RawOptions options = read_options(arguments);
  const std::string solver = solver_text(options.solver);
  const RawProblem problem = read_raw_problem(arguments, arguments.files());
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
    write_output(arguments, as_json(answer, solver));
  else
    write_text(arguments, as_text(problem, answer));
  return answer.status == Status::solved ? 0 : 1;
}

} // namespace

Command lcp_command() {
  return {"lcp",
          "M.mtx q.mtx | --M \"2 1; 1 2\" --q \"-5 -6\" [OPTIONS]",
          "solve a raw linear complementarity problem",
          "Finds z with w = M z + q, z >= 0, w >= 0, z'w = 0. M and q are Matrix Market files\n"
          "(real general, array or coordinate), or typed in place. Rows named by --free are\n"
          "equalities w_i = 0 with a free z_i. Gauss-Seidel takes row by row and needs a\n"
          "positive diagonal; hybrid does not, and goes on with Lemke's pivots.\n\n"
          "Example:\n  lcpush lcp --M \"2 1; 1 2\" --q \"-5 -6\"\n",
          with_common_options({
              {"--M", "MATRIX", "rows by semicolons, numbers by blanks"},
              {"--q", "VECTOR", "n numbers"},
              {"--free", "I,J,..", "1-based rows that are equalities with free unknowns"},
              solver_option,
              {"--sweeps", "N", "most sweeps (default 5000; 200 before hybrid's pivots)"},
              {"--relaxation", "W", "of the sweeps, between 0 and 2 (default 1)"},
              {"--history", "", "the residual after each check instead; also --format csv"},
          }),
          2,
          run_lcp};
}

} // namespace lcpush::cli
