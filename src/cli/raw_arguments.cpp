#include "cli/raw_arguments.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"

#include <charconv>
#include <tuple>

namespace lcpush::cli {
namespace {

/// "7,8" as 1-based rows; nothing is free if the option is not given.
std::vector<unsigned char> read_free(const Arguments& arguments, Index n) {
  std::vector<unsigned char> free(static_cast<std::size_t>(n), 0);
  if (!arguments.has("--free")) return free;
  const std::string list = *arguments.value("--free");
  const char* at = list.data();
  const char* const end = at + list.size();
  for (;;) {
    Index row = 0;
    const auto [rest, error] = std::from_chars(at, end, row);
    if (error != std::errc() || row < 1 || row > n)
      throw UsageError("--free is a list of rows from 1 to " + std::to_string(n) +
                       " such as 7,8, not " + desktop::quoted(list));
    unsigned char& is_free = free[static_cast<std::size_t>(row - 1)];
    if (is_free != 0) throw UsageError("--free names row " + std::to_string(row) + " twice");
    is_free = 1;
    if (rest == end) return free;
    if (*rest != ',')
      throw UsageError("--free wants commas between rows: " + desktop::quoted(list));
    at = rest + 1;
  }
}

} // namespace

template <class S>
std::pair<MatrixOf<S>, MatrixOf<S>> read_matrices(const Arguments& arguments,
                                                  const std::vector<std::string>& files) {
  const auto M_text = arguments.value("--M"), q_text = arguments.value("--q");
  if (M_text.has_value() != q_text.has_value()) throw UsageError("--M and --q go together");
  if (M_text && !files.empty()) throw UsageError("give either files or --M and --q, not both");
  MatrixOf<S> M, q;
  std::string of_M = "--M", of_q = "--q";
  if (M_text) {
    M = parse_inline_matrix<S>(*M_text, "--M");
    q = parse_inline_vector<S>(*q_text, "--q");
  } else {
    if (files.size() != 2)
      throw UsageError("two files are needed: M.mtx q.mtx (or --M \"2 1; 1 2\" --q \"-5 -6\")");
    of_M = files[0];
    of_q = files[1];
    M = read_matrix_market<S>(of_M);
    q = read_matrix_market<S>(of_q);
  }
  const Index n = M.rows;
  if (M.cols != n)
    throw InputError(of_M + ": M must be square, but it is " + std::to_string(n) + " x " +
                     std::to_string(M.cols));
  if (q.cols != 1 || q.rows != n)
    throw InputError(of_q + ": q must be " + std::to_string(n) + " x 1 like M's rows, but it is " +
                     std::to_string(q.rows) + " x " + std::to_string(q.cols));
  return {std::move(M), std::move(q)};
}
template std::pair<ExactMatrix, ExactMatrix> read_matrices(const Arguments& arguments,
                                                           const std::vector<std::string>& files);

RawProblem read_raw_problem(const Arguments& arguments, const std::vector<std::string>& files) {
  RawProblem problem;
  std::tie(problem.M, problem.q) = read_matrices<double>(arguments, files);
  problem.free = read_free(arguments, problem.M.rows);
  return problem;
}

} // namespace lcpush::cli
