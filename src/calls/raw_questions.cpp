// Questions about a problem that is not a scene's.
#include "calls/questions.hpp"
#include "calls/request.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/desktop/verify.hpp"

#include <cmath>
#include <limits>

namespace lcpush::desktop {
namespace {

/// "M": {"rows", "row", "column", "value"}, its entries that are not zero, counted from 0, in the
/// order of rows and columns.
SparseRows matrix_of(const Request& request) {
  const JsonValue* const given = request.find("M");
  if (given == nullptr || given->as<JsonObject>() == nullptr)
    request.refuse("M", "must be an object with \"rows\", \"row\", \"column\" and \"value\"");
  const JsonFields& fields = request.fields();
  const double size = fields.number(*given, "rows").value_or(-1);
  if (!(size >= 1) || size != std::floor(size) || size > largest_sparse_dimension)
    fields.refuse(*given, "\"rows\" must be a whole number from 1 to " +
                              std::to_string(largest_sparse_dimension));
  const auto values = fields.numbers(*given, "value", -1);
  if (!values) fields.refuse(*given, "\"value\" must be an array of numbers");
  const auto count = static_cast<Index>(values->size());
  const auto rows = fields.numbers(*given, "row", count),
             columns = fields.numbers(*given, "column", count);
  if (!rows || !columns) fields.refuse(*given, "\"row\" and \"column\" must be arrays of numbers");
  SparseRows M;
  M.cols = static_cast<Index>(size);
  double last_row = 0, last_column = -1;
  for (std::size_t k = 0; k < values->size(); ++k) {
    const double i = (*rows)[k], j = (*columns)[k];
    const bool is_inside =
        i >= 0 && j >= 0 && i < size && j < size && i == std::floor(i) && j == std::floor(j);
    const bool is_next = i > last_row || (i == last_row && j > last_column);
    if (!is_inside || !is_next)
      fields.refuse(*given, "entry " + std::to_string(k) + " of \"M\" is at row " + shown(i) +
                                ", column " + shown(j) +
                                ": entries come in order, once each, counted from 0, below " +
                                shown(size));
    for (; last_row < i; ++last_row) M.end_row();
    M.add(static_cast<Index>(j), (*values)[k]);
    last_column = j;
    if (last_row < i) last_row = i;
  }
  while (M.rows() < M.cols) M.end_row();
  return M;
}

RawBounds bounds_of(const Request& request, Index n) {
  RawBounds bounds;
  if (request.find("lo") == nullptr && request.find("hi") == nullptr) return bounds;
  if (request.find("free") != nullptr)
    request.refuse("free", "goes without \"lo\" and \"hi\": a free unknown has neither end");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::size_t>(n);
  const auto lo = request.numbers_or("lo", n, -infinity),
             hi = request.numbers_or("hi", n, infinity);
  bounds.lo = lo.value_or(std::vector<double>(count, 0.0));
  bounds.hi = hi.value_or(std::vector<double>(count, infinity));
  bounds.follows.assign(count, -1);
  for (std::size_t i = 0; i < count; ++i)
    if (!(bounds.lo[i] <= bounds.hi[i]))
      request.refuse("lo", "is above \"hi\" in row " + std::to_string(i + 1) + ", counted from 1");
  return bounds;
}

RawProblem problem_of(const Request& request) {
  RawProblem problem;
  problem.M = matrix_of(request);
  const Index n = problem.size();
  const auto q = request.numbers("q", n);
  if (!q) request.refuse("q", "must be an array of " + std::to_string(n) + " numbers");
  problem.q = *q;
  problem.free.assign(static_cast<std::size_t>(n), 0);
  for (const double row : request.numbers("free").value_or(std::vector<double>())) {
    if (!(row >= 1 && row <= static_cast<double>(n)) || row != std::floor(row))
      request.refuse("free",
                     "must hold rows from 1 to " + std::to_string(n) + ", not " + shown(row));
    problem.free[static_cast<std::size_t>(row) - 1] = 1;
  }
  problem.bounds = bounds_of(request, n);
  return problem;
}

} // namespace

Told ask_lcp(const std::string& text, Listener& listener) {
  const Request request(text, {"M", "q", "free", "lo", "hi", "solver", "format"});
  const std::string format = request.format({"json", "text", "full_text"});
  const RawProblem problem = problem_of(request);
  ListeningWatcher watcher(listener);
  RawOptions options;
  options.solver = request.solver();
  if (options.solver == Solver::hybrid) options.sweeps.max_sweeps = 200;
  options.watcher = &watcher;
  const Index piece = largest_piece(problem);
  if (options.solver != Solver::gauss_seidel && piece > largest_dimension)
    request.refuse("M", "has " + std::to_string(piece) +
                            " unknowns in one piece: too many for pivots, which take " +
                            std::to_string(largest_dimension) + "; say \"gauss-seidel\"");
  const RawAnswer answer = solve_raw(problem, options);
  if (answer.bad_diagonal >= 0)
    request.refuse("solver", "gauss-seidel needs a positive diagonal, which row " +
                                 std::to_string(answer.bad_diagonal + 1) +
                                 ", counted from 1, has not; use lemke or hybrid");
  if (answer.inconsistent_row >= 0)
    request.refuse("free", "names row " + std::to_string(answer.inconsistent_row + 1) +
                               ", counted from 1, which cannot hold beside the others");
  return {answer.status == Status::solved,
          format == "json" ? raw_json(problem, answer, solver_text(options.solver))
                           : raw_text(problem, answer)};
}

Told ask_verify_lcp(const std::string& text, Listener&) {
  const Request request(text, {"M", "q", "z", "free", "lo", "hi", "tolerance", "format"});
  const std::string format = request.format({"json", "text", "full_text"});
  const RawProblem problem = problem_of(request);
  const auto z = request.numbers("z", problem.size());
  if (!z) request.refuse("z", "must be an array of " + std::to_string(problem.size()) + " numbers");
  VerifyOptions options;
  options.tolerance = request.positive("tolerance").value_or(options.tolerance);
  const RawVerifyReport report = verify_raw(problem, *z, options);
  return {is_valid(report.verdict),
          format == "json" ? verify_json(report) : verify_text(report, told_as(format))};
}

} // namespace lcpush::desktop
