// lcp: raw linear complementarity problems.
#include "commands/history.hpp"
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::commands {
namespace {

constexpr Index sweeps_before_pivots = 200; // where they come near at all, they do so soon

RawOptions raw_options(const Values& values, Solver solver, Listener& listener) {
  RawOptions options;
  options.solver = solver;
  options.watcher = &listener;
  SweepOptions<double>& sweeps = options.sweeps;
  if (solver == Solver::hybrid) sweeps.max_sweeps = sweeps_before_pivots;
  sweeps.max_sweeps = values.whole("sweeps", {1}).value_or(sweeps.max_sweeps);
  sweeps.relaxation =
      values.number("relaxation", 2, " (1: plain Gauss-Seidel)").value_or(sweeps.relaxation);
  return options;
}

/// Pivots store the largest piece whole: what that takes is said, or refused, before it is taken.
void announce_effort(const Values& values, const RawProblem& problem, Listener& listener) {
  const Index n = largest_piece(problem);
  if (n < large_piece) return;
  const double bytes = pivot_bytes(problem),
               entries = static_cast<double>(n) * static_cast<double>(n);
  const std::string takes =
      std::to_string(n) + " unknowns in one piece: pivots store " + printed("%.1f GB", bytes / 1e9);
  const std::string other =
      "; " + values.label("solver") + " gauss-seidel stores only what is not zero";
  if (bytes > limits::memory)
    values.refuse("M", takes + ", and no command takes more than 1" + other);
  listener.announce(takes + " and are mostly " + std::to_string(n / 2) + " to " +
                    std::to_string(2 * n) + printed(", each %.0f million", entries / 1e6) +
                    " multiplications" + other);
}

Result run_lcp(const Values& values, Listener& listener) {
  if (values.has("all")) return find_all(values, listener);
  for (const char* option : {"game", "exact", "most", "verbose"})
    if (values.has(option))
      values.refuse(option, values.label(option) + " goes with " + values.label("all"));
  const Solver solver = values.solver();
  const std::string format = values.format_with_history(solver);
  const RawOptions options = raw_options(values, solver, listener);
  const auto problem = std::make_shared<RawProblem>(values.raw_problem());
  announce_infinite(*problem, listener);
  std::optional<RawAnswer> swept;
  if (!values.has("solver")) swept = sweep_large(*problem, options);
  const Solver used = swept ? Solver::gauss_seidel : solver;
  if (used != Solver::gauss_seidel) announce_effort(values, *problem, listener);
  const auto answer =
      std::make_shared<RawAnswer>(swept ? std::move(*swept) : solve_raw(*problem, options));
  if (const Index row = answer->bad_diagonal; row >= 0)
    values.refuse("M", values.label("solver") + " gauss-seidel needs a positive diagonal, but " +
                           values.row_name(row) + " has " + shown(problem->M(row, row)) +
                           "; use lemke or hybrid");
  std::vector<HistoryRow> rows;
  for (const SweepResidual& check : answer->history)
    rows.push_back({check.sweep, {check.residual}});
  return {answer->status == Status::solved,
          values.has("history") ? history_text(format, solver, answer->status, {"residual"}, rows)
          : format == "json"    ? raw_json(*problem, *answer, solver_text(used))
                                : raw_text(*problem, *answer),
          [problem, answer, &values] {
            const ExactMatrices typed = values.exact_matrices();
            return certify_raw(typed.M, typed.q, problem->free, *answer);
          }};
}

} // namespace

Command lcp_command() {
  return {
      "lcp",
      "M.mtx q.mtx | --M \"2 1; 1 2\" --q \"-5 -6\" | --all --game A B [OPTIONS]",
      "solve a raw linear complementarity problem",
      "Finds z with w = M z + q, z >= 0, w >= 0, z'w = 0. M and q are Matrix Market files\n"
      "(- is standard input), or typed in place. Rows named by --free are equalities\n"
      "w_i = 0 with a free z_i. Or in a box: lo <= z <= hi, w >= 0 where z is at lo, <= 0\n"
      "at hi, 0 in between. ENDS and ROWS are n x 1 files or numbers, inf among them.\n"
      "Gauss-Seidel takes row by row, stores no zeros and needs a positive diagonal; hybrid\n"
      "does not, and goes on with Lemke's pivots.\n\n"
      "--all finds every solution, of up to 64 unknowns, in fractions: isolated ones, segments,\n"
      "polygons .. with their vertices and directions, and says when that is all. --game takes\n"
      "what the two players get for each pair of actions: all Nash equilibria.\n\n"
      "Example:\n  lcpush lcp --M \"2 1; 1 2\" --q \"-5 -6\"\n"
      "  lcpush lcp --M \"2 1; 1 2\" --q \"-5 -6\" --lo 0 --hi \"1 inf\"\n"
      "  lcpush lcp --all --M \"1 2; 2 1\" --q \"-2 -2\" --exact\n"
      "  lcpush lcp --all --game \"2 0; 0 1\" \"1 0; 0 2\"\n",
      with_common_options(with_raw_options(
          {},
          {
              solver_option,
              {"seconds", "S", "stop after so much processor time (8); --all writes what it has",
               false, true},
              {"sweeps", "N", "most sweeps (default 5000; 200 before hybrid's pivots)"},
              {"relaxation", "W", "of the sweeps, between 0 and 2 (default 1)"},
              {"history", "", "the residual after each check instead; also --format csv"},
              certify_option,
              {"all", "",
               "every solution, of numbers as typed; --format svg draws two or three unknowns"},
              {"game", "A B", "with --all: of the game with these payoffs", true},
              {"exact", "", "with --all: the answer in fractions"},
              {"most", "N", "with --all: end at so many vertices (10000)"},
              {"verbose", "", "with --all: every row, and w; -v for short", false, true},
          })),
      run_lcp,
      {"text", "json"},
      2};
}

} // namespace lcpush::commands
